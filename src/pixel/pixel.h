/* SPDX-License-Identifier: MIT */
/* Pixels as they are stored: names of formats, reading back, checksums.  Colours inside the
 * core are 0x00RRGGBB in a uint32_t, sRGB values as stored. */
#ifndef TP_PIXEL_PIXEL_H
#define TP_PIXEL_PIXEL_H
#include "tidepool/frame.h"

const char *tp_format_name(tp_format format);           /* "xrgb8888" */
int         tp_format_bits(tp_format format);
int         tp_format_of(const char *name, uint32_t bytes);   /* -1: none is called so */

/* Pixel x of a row as 0x00RRGGBB: 565 by bit replication, grey as three equal parts. */
uint32_t tp_pixel_read(tp_format format, const void *row, int x);

/* CRC-32 (IEEE) of `bytes`, continuing from `crc` (0 to begin). */
uint32_t tp_crc32(uint32_t crc, const void *data, size_t bytes);
#endif
