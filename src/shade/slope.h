/* SPDX-License-Identifier: MIT */
/* The surface normal from its slopes, N = (-sx, 1, -sz) / sqrt(1 + sx^2 + sz^2). */
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
TP_ALWAYS_INLINE int tp_rsqrt_one_plus_reduce(uint32_t *q)
{
    int times = 0;

    if (TP_WIDE) {
        const uint32_t one = TP_SLOPE_END / 4;
        times = (*q >= TP_SLOPE_END) + (*q >= 19 * one) + (*q >= 79 * one);
        *q = ((*q + one) >> 2 * times) - one;
        return times;
    }
    for (; *q >= TP_SLOPE_END; times++)
        *q = (*q - TP_SLOPE_END / 4 * 3) / 4;
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
                                           int rippled)
{
    return tp_slope_normal(tp_slope_x(run, i, rippled), tp_slope_z(run, i, rippled));
}
#endif
