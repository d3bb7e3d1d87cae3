/* SPDX-License-Identifier: MIT */
/* The environment: what light comes from a direction. */
#ifndef TP_SHADE_ENV_H
#define TP_SHADE_ENV_H
#include "shade/shade.h"

/* 0xAARRGGBB from the world's direction (x, y, z), a unit vector in Q1.14 that points
 * away from the eye; below the horizon it is the horizon's. */
static inline uint32_t tp_env_at(const tp_shade *shade, int32_t x, int32_t y, int32_t z)
{
    (void)x;
    (void)z;
    return shade->sky[tp_clamp(y >> 6, 0, TP_SKY)];
}
#endif
