/* SPDX-License-Identifier: MIT */
/* RGB565 by a table of tones: what a camera's exposure leaves of a colour's channels, and
 * their levels, in one look each.  The pixels are those of exposed colours. */
#ifndef TP_PIXEL_TONED_H
#define TP_PIXEL_TONED_H
#include "pixel/rgb565.h"
#include "tidepool/modules.h"

typedef struct {
    uint8_t five[256], six[256];        /* levels of red and blue, and of green */
} tp_toned;

/* Channels of i become `tone`. */
static inline void tp_toned_set(tp_toned *toned, uint32_t i, uint32_t tone)
{
    const uint32_t pixel = tp_rgb565(tone << 16 | tone << 8 | tone);

    toned->five[i] = (uint8_t)(pixel & 31);
    toned->six[i] = (uint8_t)(pixel >> 5 & 63);
}

void tp_store_rgb565_toned(const tp_toned *toned, uint16_t *to, const uint32_t *colours,
                           int count);
#endif
