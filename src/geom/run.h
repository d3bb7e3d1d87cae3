/* SPDX-License-Identifier: MIT */
/* Runs of grid vertices, from the swells to the picture: internal to the files of
 * geom/vertex.h. */
#ifndef TP_GEOM_RUN_H
#define TP_GEOM_RUN_H
#include "geom/vertex.h"

/* View coordinates of a run: x, y, depth, 16.16 m. */
typedef struct {
    int32_t at[3][TP_VERTEX_BATCH];
} tp_vertex_batch;

/* The inputs of a run: tables, first column, number of vertices; `still`: without waves. */
typedef struct {
    const tp_vertex_frame   *frame;
    const tp_vertex_columns *columns;
    const tp_vertex_row     *row;
    uint32_t first, count;
    bool     at_rest;
} tp_vertex_batch_input;

/* tp_batch_displace_axis: displaces a run along a view axis: from + rest + the
 * displacement by swells. tp_batch_set_slopes: computes the slopes. */
void tp_batch_displace_axis(const tp_vertex_batch_input *place, int axis,
                            const int32_t *from, int32_t rest, int32_t *to);
void tp_batch_set_slopes(const tp_vertex_batch_input *place, tp_grid_vertex *to);

/* Adds sharpened swells to undisplaced vertices, and computes the slopes. */
void tp_batch_add_sharp_swells(const tp_vertex_batch_input *place, tp_vertex_batch *run,
                               tp_grid_vertex *vertex);

/* Adds the heights and slopes of rings and pools. */
void tp_batch_add_rings_and_pools(const tp_vertex_batch_input *place, tp_vertex_batch *run,
                       tp_grid_vertex *vertex);

/* Returns sum + both products of the 16-bit halves; the same bits on every processor. */
TP_ALWAYS_INLINE int32_t tp_add_pair_products(int32_t sum, uint32_t a, uint32_t b)
{
#if defined(__ARM_FEATURE_DSP) && __ARM_FEATURE_DSP
    return __builtin_arm_smlad((int32_t)a, (int32_t)b, sum);
#else
    return sum + (int16_t)a * (int16_t)b + ((int32_t)a >> 16) * ((int32_t)b >> 16);
#endif
}

TP_ALWAYS_INLINE int16_t tp_saturated(int32_t x)
{
#if defined(__ARM_FEATURE_SAT) && __ARM_FEATURE_SAT
    return (int16_t)__builtin_arm_ssat(x, 16);
#else
    return (int16_t)tp_clamp(x, INT16_MIN, INT16_MAX);
#endif
}

#define TP_JACOBIAN_ONE (1 << 30)

/* Terms of a slope [A9]: h in Q.(15 + tilt), |h| < 2^31; J in Q2.30, between 0.048 and
 * 1.952; bxz is -Jxz. */
typedef struct {
    int32_t hx, hz, jxx, jzz, bxz;
} tp_jacobian;

/* Computes slopes by [A10], see wave/gerstner.c: num / det.  J J is Q.28; h J, below
 * 2^62.5 with both terms of a sum, is Q.(13 + tilt).  The reciprocal of a det shifted up
 * by 2..8 is 2^(34 - shift) / det.  Shifted down by tilt - 1 - shift, not negative as
 * tilt >= 9, the reciprocal takes the numerators to 16.16 for every tilt. */
TP_ALWAYS_INLINE void tp_set_slopes(const tp_jacobian *j, int tilt, bool crossed,
                                    tp_grid_vertex *to)
{
    int32_t det = j->jxx >> 2, nx = j->hx >> 2, nz = j->hz >> 2;

    if (crossed) {
        det = tp_mul_upper(j->jxx, j->jzz) - tp_mul_upper(j->bxz, j->bxz);
        nx = tp_upper((int64_t)j->hx * j->jzz + (int64_t)j->hz * j->bxz);
        nz = tp_upper((int64_t)j->hz * j->jxx + (int64_t)j->hx * j->bxz);
    }
    int     shift = tp_clz((uint32_t)det);
    TP_ASSERT(det > 0 && shift < tilt);
    int32_t r = tp_recip_rough((uint32_t)det << shift) >> (tilt - 1 - shift);
    to->slope_x = tp_saturated((tp_mul_upper(nx, r) + 8) >> 4);
    to->slope_z = tp_saturated((tp_mul_upper(nz, r) + 8) >> 4);
}
#endif
