/* SPDX-License-Identifier: MIT */
/* Rays of the fast stages.  A ray's length depends on its place in the picture alone, since
 * turning the camera keeps lengths: a table of 1 / sqrt(1 + u^2 + v^2) makes it a unit
 * vector. */
#ifndef TP_SHADE_QUICK_RAY_H
#define TP_SHADE_QUICK_RAY_H
#include "shade/shade.h"
#include "shade/slope.h"

/* The view of a row of pixels: x, y, z at the picture's middle column, focal length 1,
 * Q1.14, and the square of the row's distance from the middle row, Q24. */
typedef struct {
    int32_t x, y, z;
    uint32_t square;
} tp_quick_row;

tp_quick_row tp_quick_row_at(const tp_shade *shade, int32_t y);

/* tp_quick_ray_at as a function: for callers that need few rays. */
tp_ray tp_quick_ray(const tp_shade *shade, const tp_quick_row *row, int32_t sixteenths);

/* Q14 of so many sixteenths of a pixel over the focal length: 4 at the most. */
static inline int32_t tp_quick_over_focal(const tp_shade *shade, int32_t sixteenths)
{
    return tp_clamp((int32_t)(tp_over_focal(shade, sixteenths) >> 2), -65535, 65535);
}

/* The unit vector to the eye; l is its y in Q26. */
TP_ALWAYS_INLINE tp_ray tp_quick_ray_at(const tp_shade *shade, const tp_quick_row *row,
                                        int32_t sixteenths)
{
    const tp_view_axes *a = &shade->world;
    int32_t  u = tp_quick_over_focal(shade, sixteenths - shade->u0);
    uint32_t q = row->square + ((uint32_t)u * (uint32_t)u >> 4);
    int32_t  unit = tp_steep(q);
    int32_t  y = (row->y - (u * (a->right.y >> 16) >> 14)) * unit;

    return (tp_ray){ (row->x - (u * (a->right.x >> 16) >> 14)) * unit >> 14, y >> 14,
                     (row->z - (u * (a->right.z >> 16) >> 14)) * unit >> 14, y >> 2 };
}
#endif
