/* SPDX-License-Identifier: MIT */
/* Bilinear look-up in a planar map of half the picture's size. */
#ifndef TP_SHADE_HALF_H
#define TP_SHADE_HALF_H
#include "shade/shade.h"

/* Returns a pixel of the map; 0 outside of the map's box. */
static inline uint32_t tp_half_pixel(const tp_half *half, int32_t i, int32_t j)
{
    if (i < half->x0 || i >= half->x1 || j < half->y0 || j >= half->y1)
        return 0;
    return half->colour[(size_t)(uint32_t)(j - half->y0)
                        * (uint32_t)(half->x1 - half->x0) + (uint32_t)(i - half->x0)];
}

/* Samples the map at (u, v) of the whole picture, 28.4.  The result is premultiplied by
 * its alpha, because uncovered pixels are 0. */
static inline uint32_t tp_half_sample(const tp_half *half, int32_t u, int32_t v)
{
    int32_t i = (u - 16) >> 5, j = (v - 16) >> 5;
    uint32_t fu = (uint32_t)(u - 16) & 31, fv = (uint32_t)(v - 16) & 31;

    if (i < half->x0 - 1 || i >= half->x1 || j < half->y0 - 1 || j >= half->y1)
        return 0;
    return tp_argb_mix_32(
        tp_argb_mix_32(tp_half_pixel(half, i, j), tp_half_pixel(half, i + 1, j), fu),
        tp_argb_mix_32(tp_half_pixel(half, i, j + 1),
                         tp_half_pixel(half, i + 1, j + 1), fu), fv);
}
#endif
