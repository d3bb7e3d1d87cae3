/* SPDX-License-Identifier: MIT */
/* Where an edge crosses the rows of pixels. */
#ifndef TP_RASTER_EDGE_H
#define TP_RASTER_EDGE_H
#include "base/base.h"
#include "tidepool/fx.h"

/* First row whose centre lies at or below v, and likewise for columns: ceil(v - 1/2). */
TP_ALWAYS_INLINE int32_t tp_first_centre(int32_t v_28_4)
{
    return (v_28_4 + 7) >> 4;
}

/* x of the crossing with row y is (x + slope (y - row)), in Q16.16 pixels less half a
 * pixel, so that its ceiling is the first pixel to the right. */
typedef struct {
    int32_t row;                /* first row of the edge */
    int32_t x;                  /* there */
    int32_t slope;              /* pixels a row, Q16.16 */
} tp_edge;

/* du / dv in Q16.16: a 32-bit division for edges of up to 1024 pixels across (one
 * instruction where there is a divider), else by reciprocal.  Slopes beyond +-16384
 * pixels a row only occur where the edge crosses one row's centre at the most; the
 * clamp then moves the crossing within the edge's own ends. */
TP_ALWAYS_INLINE int32_t tp_edge_slope(int32_t du, int32_t dv)
{
    if (du < 1 << 14 && du > -(1 << 14))
        return du * 65536 / dv;
    int     shift = tp_clz((uint32_t)dv);
    int64_t r = tp_recip_norm((uint32_t)dv << shift);       /* 2^63 / (dv 2^shift) */
    int64_t slope = du * r >> (47 - shift);
    int64_t most = (int64_t)1 << 30;

    return (int32_t)(slope > most ? most : slope < -most ? -most : slope);
}

/* From the upper end (u0, v0) to the lower (u1, v1), v0 < v1. */
TP_ALWAYS_INLINE tp_edge tp_edge_of(int32_t u0, int32_t v0, int32_t u1, int32_t v1)
{
    int32_t slope = tp_edge_slope(u1 - u0, v1 - v0);
    tp_edge e;

    e.row = tp_first_centre(v0);
    e.slope = slope;
    e.x = (int32_t)((int64_t)(u0 - 8) * 4096 + ((int64_t)slope * (16 * e.row + 8 - v0) >> 4));
    return e;
}
#endif
