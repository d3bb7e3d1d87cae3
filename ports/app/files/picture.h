/* SPDX-License-Identifier: MIT */
/* Pictures in memory and as PNG files. */
#ifndef TP_APP_FILES_PICTURE_H
#define TP_APP_FILES_PICTURE_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include "tidepool/frame.h"

/* A drawn picture: contiguous rows of tp_format_row_bytes(). */
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

/* Converts row y to 0x00RRGGBB, one word per pixel. */
void picture_expand_row(const picture *p, uint32_t y, uint32_t *pixels);

/* Returns the CRC-32 of the displayed colours, independent of format and machine. */
uint32_t picture_crc(const picture *p);

/* Write a PNG with palette, grey, 1 bit or RGB, of exactly the displayed colours.
 * picture_write_png: to a file that is complete or absent; returns an exit code.
 * picture_put_png: to an open file; returns 0 or an errno. */
int picture_write_png(const picture *p, const char *name);
int picture_put_png(const picture *p, FILE *to);

/* True if the file is a PNG written by picture_write_png or an animation of any version. */
bool picture_is_ours(const char *name);

/* Loads a PNG of any kind as 0xAARRGGBB, freed by the caller; sides 1..4096 px.  Returns
 * NULL after a failure; `why` gets the reason, and errno is ENOMEM if memory was
 * lacking. */
#define PICTURE_WHY 224
uint32_t *picture_load_png(const char *name, uint32_t *w, uint32_t *h,
                           char why[PICTURE_WHY]);

/* The same, but prints the reason in a message that begins with `who`, the place of the
 * name. */
uint32_t *picture_read_png(const char *name, const char *who, uint32_t *w, uint32_t *h);

/* The same as 16-bit grey: colours by their luminance, transparency ignored. */
uint16_t *picture_read_grey(const char *name, const char *who, uint32_t *w, uint32_t *h);
#endif
