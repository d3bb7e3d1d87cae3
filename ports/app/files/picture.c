/* SPDX-License-Identifier: MIT */
/* Colours and CRC of drawn pictures. */
#include "picture.h"
#include <string.h>
#include "pixel/pixel.h"

void picture_expand_row(const picture *p, uint32_t y, uint32_t *pixels)
{
    const uint8_t *row = picture_row(p, y);
    if (p->format == TP_FORMAT_XRGB8888) {
        memcpy(pixels, row, p->width * sizeof *pixels);
        return;
    }
    for (uint32_t x = 0; x < p->width; x++)
        pixels[x] = tp_pixel_read(p->format, row, (int)x);
}

uint32_t picture_crc(const picture *p)
{
    uint32_t crc = 0;
    for (uint32_t y = 0; y < p->height; y++)
        crc = tp_crc32_pixels(crc, p->format, picture_row(p, y), (int)p->width);
    return crc;
}
