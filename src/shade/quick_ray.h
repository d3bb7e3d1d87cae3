/* SPDX-License-Identifier: MIT */
/* View rays of the fast stages.  The length of a ray depends only on its position in the
 * picture, since a camera rotation keeps lengths: a table of 1 / sqrt(1 + u^2 + v^2)
 * normalises the ray. */
#ifndef TP_SHADE_QUICK_RAY_H
#define TP_SHADE_QUICK_RAY_H
#include "shade/shade.h"
#include "shade/slope.h"

/* View vector of a row of pixels: x, y, z at the picture's middle column for focal length
 * 1, Q1.14, and the squared distance of the row from the middle row, Q24. */
typedef struct {
    int32_t x, y, z;
    uint32_t square;
} tp_quick_row;

tp_quick_row tp_quick_row_make(const tp_shade *shade, int32_t y);

/* tp_quick_ray_inline as a function call, for callers with few rays. */
tp_ray tp_quick_ray(const tp_shade *shade, const tp_quick_row *row, int32_t sixteenths);

/* Returns sixteenths of a pixel over the focal length, Q14, clamped to -4..4. */
static inline int32_t tp_quick_over_focal(const tp_shade *shade, int32_t sixteenths)
{
    return tp_clamp((int32_t)(tp_over_focal(shade, sixteenths) >> 2), -65535, 65535);
}

/* Returns the unit vector to the eye; member l is its y in Q26. */
TP_ALWAYS_INLINE tp_ray tp_quick_ray_inline(const tp_shade *shade, const tp_quick_row *row,
                                        int32_t sixteenths)
{
    const tp_view_axes *a = &shade->world;
    int32_t  u = tp_quick_over_focal(shade, sixteenths - shade->u0);
    uint32_t q = row->square + ((uint32_t)u * (uint32_t)u >> 4);
    int32_t  unit = tp_rsqrt_one_plus(q);
    int32_t  y = (row->y - (u * (a->right.y >> 16) >> 14)) * unit;

    return (tp_ray){ (row->x - (u * (a->right.x >> 16) >> 14)) * unit >> 14, y >> 14,
                     (row->z - (u * (a->right.z >> 16) >> 14)) * unit >> 14, y >> 2 };
}
#endif
