/* SPDX-License-Identifier: MIT */
/* A picture's CRC from its tiles, in whatever order they come: that of the pixels row by
 * row, as tp_crc32_pixels goes on from one row to the next. */
#ifndef SUM_H
#define SUM_H
#include "tidepool/frame.h"

/* Begins with 0; the sum so far, with a tile more. */
uint32_t sum_tile(uint32_t sum, const tp_config *config, const tp_tile *tile);
#endif
