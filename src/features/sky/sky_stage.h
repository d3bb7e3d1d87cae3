/* SPDX-License-Identifier: MIT */
/* Helpers shared by the stages of skies. */
#ifndef TP_SKY_STAGE_H
#define TP_SKY_STAGE_H
#include "shade/env.h"

/* Returns the colour of a sky look-up.  `hdr` is a literal: 1 adds the light above white,
 * 0 leaves it out. */
TP_ALWAYS_INLINE uint32_t tp_sky_colour(const tp_shade *shade, uint32_t light, int hdr)
{
    return hdr ? tp_light_colour(shade, light) : light & 0x00ffffffu;
}
#endif
