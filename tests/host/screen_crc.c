/* SPDX-License-Identifier: MIT */
/* Prints the CRC-32 of a part of a frame buffer's memory, counted as by `tidepool render
 * --hash`.  The description is the one of the fake frame buffer (screen_fake.c).
 *
 * screen_crc FILE "DESCRIPTION" FIRST_LINE X Y WIDTH HEIGHT [p8|l8] */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "pixel/pixel.h"

enum { BITS = 2, LINE = 3, RED = 6, NUMBERS = 16 };

/* Widens `length` bits to 8 by repeating them. */
static uint32_t widen(uint32_t pixel, uint32_t offset, uint32_t length)
{
    const uint32_t value = pixel >> offset & ((1u << length) - 1);
    uint32_t wide = 0, bits = 0;
    for (; bits < 8; bits += length)
        wide = wide << length | value;
    return wide >> (bits - 8) & 255;
}

static uint32_t colour(const uint8_t *at, const uint32_t *n, const char *table)
{
    uint32_t pixel = 0;
    memcpy(&pixel, at, n[BITS] / 8);            /* on a little-endian machine */
    if (table)
        return strcmp(table, "p8") == 0 ? tp_palette[pixel] : pixel * 0x010101u;
    return widen(pixel, n[RED], n[RED + 1]) << 16
         | widen(pixel, n[RED + 2], n[RED + 3]) << 8
         | widen(pixel, n[RED + 4], n[RED + 5]);
}

int main(int argc, char **argv)
{
    uint32_t n[NUMBERS] = { 0 }, part[5], crc = 0;
    static uint8_t memory[1 << 24];
    if (argc < 8)
        return 2;
    char *text = argv[2];
    for (int i = 0; i < NUMBERS; i++)
        n[i] = (uint32_t)strtoul(text, &text, 10);
    for (int i = 0; i < 5; i++)
        part[i] = (uint32_t)strtoul(argv[3 + i], NULL, 10);
    FILE *file = fopen(argv[1], "rb");
    if (!file || fread(memory, 1, sizeof memory, file) < n[LINE])
        return 3;
    fclose(file);
    for (uint32_t y = 0; y < part[4]; y++)
        for (uint32_t x = 0; x < part[3]; x++) {
            const size_t at = (size_t)(part[0] + part[2] + y) * n[LINE]
                            + (size_t)(part[1] + x) * n[BITS] / 8;
            const uint32_t rgb = colour(memory + at, n, argc > 8 ? argv[8] : NULL);
            crc = tp_crc32_pixels(crc, TP_FORMAT_XRGB8888, &rgb, 1);
        }
    printf("%08x\n", (unsigned)crc);
    return 0;
}
