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

/* From the upper end (u0, v0) to the lower (u1, v1), v0 < v1.  Slopes beyond +-16384
 * pixels a row only occur where the edge crosses one row's centre at the most; the
 * clamp then moves the crossing within the edge's own ends. */
TP_ALWAYS_INLINE tp_edge tp_edge_of(int32_t u0, int32_t v0, int32_t u1, int32_t v1)
{
    uint32_t dv = (uint32_t)(v1 - v0);
    int      shift = tp_clz(dv);
    int64_t  r = tp_recip_norm(dv << shift);            /* 2^63 / (dv 2^shift) */
    int64_t  slope = ((int64_t)(u1 - u0) * r) >> (47 - shift);
    tp_edge  e;

    if (slope > (int64_t)1 << 30)
        slope = (int64_t)1 << 30;
    if (slope < -((int64_t)1 << 30))
        slope = -((int64_t)1 << 30);
    e.row = tp_first_centre(v0);
    e.slope = (int32_t)slope;
    e.x = (int32_t)((int64_t)(u0 - 8) * 4096 + (slope * (16 * e.row + 8 - v0) >> 4));
    return e;
}

/* The first pixel at or right of the crossing with row y. */
TP_ALWAYS_INLINE int32_t tp_edge_pixel(const tp_edge *e, int32_t y)
{
    return (int32_t)(((int64_t)e->x + (int64_t)e->slope * (y - e->row) + 0xffff) >> 16);
}
#endif
