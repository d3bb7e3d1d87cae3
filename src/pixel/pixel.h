/* SPDX-License-Identifier: MIT */
/* What higher ranks may call beside tidepool/pixel.h: the store of finished colours. */
#ifndef TP_PIXEL_PIXEL_H
#define TP_PIXEL_PIXEL_H
#include <stdint.h>
#include "tidepool/pixel.h"

/* Converts `count` colours 0x00RRGGBB into `row`, from the row's pixel x_in_row on; other
 * pixels of the row stay as they are, also those that share a byte.  (x, y) is the place
 * in the picture of the first one: the dither is fixed there, so no tiling shows.
 * Rows of xrgb8888 are aligned to 4 bytes, of rgb565 to 2. */
void tp_pixel_store(tp_format format, void *row, int x_in_row, int x, int y,
                    const uint32_t *colours, int count);
#endif
