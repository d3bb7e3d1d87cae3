/* SPDX-License-Identifier: MIT */
/* Helpers that the stages of skies share. */
#ifndef TP_SKY_STAGE_H
#define TP_SKY_STAGE_H
#include "shade/env.h"

/* `hdr` is a literal: light beyond white is added, or left out. */
TP_ALWAYS_INLINE uint32_t tp_sky_colour(const tp_shade *shade, uint32_t light, int hdr)
{
    return hdr ? tp_light_colour(shade, light) : light & 0x00ffffffu;
}
#endif
