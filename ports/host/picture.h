/* SPDX-License-Identifier: MIT */
/* Pictures in memory and as PNG files. */
#ifndef HOST_PICTURE_H
#define HOST_PICTURE_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include "tidepool/frame.h"

/* A drawn picture: rows of tp_format_row_bytes(), one after the other. */
typedef struct {
    tp_format format;
    uint32_t  width, height;
    size_t    row_bytes;
    uint8_t  *rows;
} picture;

static inline const uint8_t *picture_row(const picture *p, uint32_t y)
{
    return p->rows + y * p->row_bytes;
}

/* Row y as 0x00RRGGBB, one a pixel. */
void picture_expand_row(const picture *p, uint32_t y, uint32_t *pixels);

/* CRC-32 of the shown colours, whatever the format and the machine. */
uint32_t picture_crc(const picture *p);

/* As palette, grey, 1-bit or RGB PNG of exactly the shown colours: into a file that is
 * whole or not there (an exit code), or into one that is open (0 or errno). */
int picture_write_png(const picture *p, const char *name);
int picture_put_png(const picture *p, FILE *to);

/* A PNG that picture_write_png or an animation has written, of any version. */
bool picture_is_ours(const char *name);

/* The pixels of a PNG of any kind as 0xAARRGGBB, to free; sides 1..4096.  NULL: it could
 * not be had, `why` tells, and errno is ENOMEM where memory was lacking. */
#define PICTURE_WHY 224
uint32_t *picture_load_png(const char *name, uint32_t *w, uint32_t *h,
                           char why[PICTURE_WHY]);

/* The same, and NULL said why in a message that begins with `who`, which named the file. */
uint32_t *picture_read_png(const char *name, const char *who, uint32_t *w, uint32_t *h);

/* The same as greys of 16 bits; colours by their luminance, transparency ignored. */
uint16_t *picture_read_grey(const char *name, const char *who, uint32_t *w, uint32_t *h);
#endif
