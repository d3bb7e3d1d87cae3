/* SPDX-License-Identifier: MIT */
/* RGB565 with tone mapping by a table: each entry holds the RGB565 level of a channel after
 * the camera's exposure.  One look-up per channel gives the same pixels as tone mapping
 * followed by conversion. */
#ifndef TP_PIXEL_TONED_H
#define TP_PIXEL_TONED_H
#include "pixel/rgb565.h"
#include "tidepool/modules.h"

typedef struct {
    uint8_t five[256], six[256];        /* five: levels of red and blue;
                                         * six: levels of green */
} tp_rgb565_tone_map;

/* Sets entry i to the RGB565 levels of the tone-mapped channel value `tone`. */
static inline void tp_rgb565_tone_map_set(tp_rgb565_tone_map *tone_map, uint32_t i,
                                          uint32_t tone)
{
    const uint32_t pixel = tp_rgb565(tone << 16 | tone << 8 | tone);

    tone_map->five[i] = (uint8_t)(pixel & 31);
    tone_map->six[i] = (uint8_t)(pixel >> 5 & 63);
}

void tp_store_rgb565_tone_mapped(const tp_rgb565_tone_map *tone_map, uint16_t *to,
                                 const uint32_t *colours, int count);
#endif
