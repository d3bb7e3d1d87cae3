/* SPDX-License-Identifier: MIT */
/* Stored pixels: names of formats, conversion back to colours, checksums.  A colour inside
 * the core is 0x00RRGGBB in a uint32_t; the channels are sRGB values. */
#ifndef TP_PIXEL_PIXEL_H
#define TP_PIXEL_PIXEL_H
#include "tidepool/frame.h"

const char *tp_format_name(tp_format format);           /* e.g. "xrgb8888" */
int         tp_format_bits(tp_format format);
int         tp_format_find(const char *name, uint32_t bytes);   /* -1: no such name */

/* Returns pixel x of a row as 0x00RRGGBB.  565 is expanded by bit replication; a grey fills
 * all three channels. */
uint32_t tp_pixel_read(tp_format format, const void *row, int x);

/* CRC-32 (IEEE) of `bytes`, continued from `crc` (0 to begin). */
uint32_t tp_crc32(uint32_t crc, const void *data, size_t bytes);
#endif
