/* SPDX-License-Identifier: MIT */
/* The surface's normal from its slopes, N = (-sx, 1, -sz) / sqrt(1 + sx^2 + sz^2). */
#ifndef TP_SHADE_SLOPE_H
#define TP_SHADE_SLOPE_H
#include "shade/shade.h"

#define TP_SLOPE_END 0x4000000u     /* q of 4, where the table of roots ends */

/* Slopes Q3.12.  q = sx^2 + sz^2 in Q24 is brought into the table, as 1/sqrt(1 + q) is
 * half of 1/sqrt(1 + (q - 3) / 4), and interpolated there. */
TP_ALWAYS_INLINE tp_ray tp_slope_normal(const tp_shade *shade, int32_t sx, int32_t sz)
{
    uint32_t q = (uint32_t)(sx * sx) + (uint32_t)(sz * sz);
    int      times = 0;

    for (; q >= TP_SLOPE_END; times++)
        q = (q - TP_SLOPE_END / 4 * 3) / 4;
    const uint16_t *at = shade->steep + (q >> 17);
    int32_t ny = (at[0] + ((at[1] - at[0]) * (int32_t)(q >> 10 & 0x7f) >> 7)) >> times;
    return (tp_ray){ -(sx * ny >> 12), ny, -(sz * ny >> 12), 0 };
}

/* Of sample i: from the array once a ripple has bent them, else as sampled. */
TP_ALWAYS_INLINE tp_ray tp_slope_normal_of(const tp_shade *shade, const tp_run *run,
                                           int32_t i, int rippled)
{
    int32_t sx = rippled ? run->sx[i] : (int16_t)(run->n[i] >> 16);
    int32_t sz = rippled ? run->sz[i] : (int16_t)(run->n[i] & 0xffff);
    return tp_slope_normal(shade, sx, sz);
}
#endif
