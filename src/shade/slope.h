/* SPDX-License-Identifier: MIT */
/*
 * Unit vectors by the table of 1 / sqrt(1 + q): the surface normal from its slopes,
 * N = (-sx, 1, -sz) / sqrt(1 + sx^2 + sz^2), and the view rays of the fast stages.
 */
#ifndef TP_SHADE_SLOPE_H
#define TP_SHADE_SLOPE_H
#include "shade/shade.h"

/* Slopes of sample i, Q3.12: from the run's arrays if a stage has bent them, else from the
 * G-buffer.  `bent` is a literal. */
TP_ALWAYS_INLINE int32_t tp_slope_x(const tp_run *run, int32_t i, int bent)
{
    return bent ? run->sx[i] : (int16_t)(run->n[i] >> 16);
}

TP_ALWAYS_INLINE int32_t tp_slope_z(const tp_run *run, int32_t i, int bent)
{
    return bent ? run->sz[i] : (int16_t)(run->n[i] & 0xffff);
}

/* q = sx^2 + sz^2, Q24: two slopes of 8, the largest, make 128. */
TP_ALWAYS_INLINE uint32_t tp_slope_square(int32_t sx, int32_t sz)
{
    return (uint32_t)(sx * sx) + (uint32_t)(sz * sz);
}

#define TP_SLOPE_END 0x4000000u     /* q = 4, Q24, the end of the root table */

/* Maps q into the table: 1/sqrt(1 + q) is half of 1/sqrt(1 + (q - 3) / 4).  Returns the
 * number of halvings: 0 up to slopes of 2 (63 degrees), 3 at most. */
TP_ALWAYS_INLINE int tp_rsqrt_one_plus_reduce(uint32_t *slope_square)
{
    int times = 0;

    if (TP_WIDE) {
        const uint32_t one = TP_SLOPE_END / 4;
        times = (*slope_square >= TP_SLOPE_END) + (*slope_square >= 19 * one)
                + (*slope_square >= 79 * one);
        *slope_square = ((*slope_square + one) >> 2 * times) - one;
        return times;
    }
    for (; *slope_square >= TP_SLOPE_END; times++)
        *slope_square = (*slope_square - TP_SLOPE_END / 4 * 3) / 4;
    return times;
}

/* Returns 1/sqrt(1 + q), Q1.14, interpolated: sharp lobes would show the table's steps. */
TP_ALWAYS_INLINE int32_t tp_rsqrt_one_plus(uint32_t q)
{
    int      times = tp_rsqrt_one_plus_reduce(&q);
    int32_t i = (int32_t)(q >> 17), f = (int32_t)(q >> 10 & 0x7f);
    int32_t a = (int32_t)tp_steep_table[i], b = (int32_t)tp_steep_table[i + 1];
    return (a + ((b - a) * f >> 7)) >> times;
}

/* Returns the nearest table entry, within 0.2 %. */
TP_ALWAYS_INLINE int32_t tp_rsqrt_one_plus_nearest(uint32_t q)
{
    if (!TP_WIDE && q < TP_SLOPE_END)
        return (int32_t)tp_steep_table[(q + 0x10000) >> 17];
    int times = tp_rsqrt_one_plus_reduce(&q);
    return (int32_t)tp_steep_table[(int32_t)((q + 0x10000) >> 17)] >> times;
}

TP_ALWAYS_INLINE tp_ray tp_slope_normal(int32_t sx, int32_t sz)
{
    int32_t ny = tp_rsqrt_one_plus(tp_slope_square(sx, sz));
    return (tp_ray){ -(sx * ny >> 12), ny, -(sz * ny >> 12), 0 };
}

TP_ALWAYS_INLINE tp_ray tp_slope_run_normal(const tp_run *run, int32_t i,
                                            int bent)
{
    return tp_slope_normal(tp_slope_x(run, i, bent), tp_slope_z(run, i, bent));
}

/* -- view rays of the fast stages ---------------------------------------------------- */

/*
 * The length of a ray depends only on its position in the picture, since a camera rotation
 * keeps lengths: a table of 1 / sqrt(1 + u^2 + v^2) normalises the ray.
 */

/* The part of view rays that is equal along a row of pixels.  x, y, z: vector to the eye at
 * the picture's middle column for focal length 1, Q1.14.  square: squared distance of the
 * row from the middle row, for focal length 1, Q24. */
typedef struct {
    int32_t x, y, z;
    uint32_t square;
} tp_quick_ray_row;

/* Returns the values of pixel row y, for tp_quick_ray. */
tp_quick_ray_row tp_quick_ray_row_make(const tp_shade *shade, int32_t y);

/* tp_quick_ray_inline as a function call, for callers with few rays. */
tp_ray tp_quick_ray(const tp_shade *shade, const tp_quick_ray_row *row, int32_t sixteenths);

/* Returns sixteenths of a pixel over the focal length, Q14, clamped to -4..4. */
static inline int32_t tp_quick_over_focal(const tp_shade *shade, int32_t sixteenths)
{
    return tp_clamp((int32_t)(tp_over_focal(shade, sixteenths) >> 2), -65535, 65535);
}

/* Returns the unit vector to the eye; member l is its y in Q26. */
TP_ALWAYS_INLINE tp_ray tp_quick_ray_inline(const tp_shade *shade,
                                            const tp_quick_ray_row *row,
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
