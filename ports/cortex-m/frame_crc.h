/* SPDX-License-Identifier: MIT */
/* CRC of a picture from its tiles in any order; equal to tp_crc32_pixels continued over
 * all rows from top to bottom. */
#ifndef TP_CORTEX_M_FRAME_CRC_H
#define TP_CORTEX_M_FRAME_CRC_H
#include "tidepool/frame.h"

/* Returns `sum`, 0 at first, with one more tile included. */
uint32_t frame_crc_add_tile(uint32_t sum, const tp_config *config, const tp_tile *tile);
#endif
