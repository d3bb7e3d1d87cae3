/* SPDX-License-Identifier: MIT */
/* The pixel formats that a frame can be drawn in.
 *
 * Colours inside the core are 0x00RRGGBB in a uint32_t, sRGB values as stored.  The last
 * three formats are dithered by an ordered 8x8 pattern fixed to the picture. */
#ifndef TP_PIXEL_H
#define TP_PIXEL_H
#include <stddef.h>
#include <stdint.h>
#include "tidepool/language.h"

TP_BEGIN_C

/* name, bits a pixel, what it is */
#define TP_FORMAT_LIST(X) \
    X(XRGB8888, xrgb8888, 32, "0x00RRGGBB in a native uint32_t") \
    X(RGB565,   rgb565,   16, "native uint16_t, red high") \
    X(RGB565BE, rgb565be, 16, "high byte first, as SPI panels take it") \
    X(P8,       p8,        8, "index into tp_palette()") \
    X(L8,       l8,        8, "grey, 255 is white") \
    X(I1,       i1,        1, "a bit a pixel, high bit left, 1 is white")

typedef enum {
#define X(name, word, bits, text) TP_FORMAT_##name,
    TP_FORMAT_LIST(X)
#undef X
    TP_FORMAT_COUNT
} tp_format;

const char *tp_format_name(tp_format format);           /* "xrgb8888" */
int         tp_format_bits(tp_format format);
int         tp_format_of(const char *name, uint32_t bytes);   /* -1: none is called so */

/* Bytes of a row of `width` pixels, rounded up to whole bytes. */
size_t tp_format_row_bytes(tp_format format, int width);

/* A picture of one number a pixel, row by row: heights of a sea floor, masks of walls. */
typedef struct {
    uint32_t cols, rows;
    const uint16_t *sample;     /* 0 black, 65535 white */
} tp_grey;

/* 256 colours 0x00RRGGBB: 6 reds x 7 greens x 6 blues, then four greys. */
const uint32_t *tp_palette(void);

/* Pixel x of a row as 0x00RRGGBB: 565 by bit replication, grey as three equal parts. */
uint32_t tp_pixel_read(tp_format format, const void *row, int x);

/* CRC-32 (IEEE) of `bytes`, continuing from `crc` (0 to begin). */
uint32_t tp_crc32(uint32_t crc, const void *data, size_t bytes);

/* The same over `count` pixels of a row from x = 0, each as its four bytes of
 * 0x00RRGGBB, low byte first: equal on every machine, byte order and format apart. */
uint32_t tp_crc32_pixels(uint32_t crc, tp_format format, const void *row, int count);

TP_END_C
#endif
