/* SPDX-License-Identifier: MIT */
/* A triangle set up for its rows: edges, and a plane for each quantity. */
#ifndef TP_RASTER_TRI_H
#define TP_RASTER_TRI_H
#include "raster/edge.h"
#include "raster/raster.h"

/* Sorted by rows, with what all planes share. */
typedef struct {
    const tp_corner *a, *b, *c; /* v ascending */
    int32_t  top, bottom;       /* rows, already cut to the tile */
    int32_t  middle;            /* row from which the lower short edge holds */
    bool     long_left;
    tp_edge  length, upper, lower;
    int32_t  x_ref, y_ref;      /* pixel of corner a: planes count from here */
    int32_t  off_u, off_v;      /* from the corner to that pixel's centre, 28.4 */
    int32_t  cx1, cx2, cy1, cy2;/* a gradient is (d1 cx1 + d2 cx2) / 2^shift, ... */
    int      shift;
    bool     perspective;       /* s and t need it; else affine is within 1/4 pixel */
} tp_tri;

/* False: no pixel centre of the tile can be inside. */
bool tp_tri_begin(tp_tri *tri, const tp_samples *tile, const tp_corner *a,
                  const tp_corner *b, const tp_corner *c);

/* value(x, y) = base + dx (x - x_ref) + dy (y - y_ref) at pixel centres. */
typedef struct {
    int64_t base, dx, dy;
} tp_gradient;

/* Of a quantity with these values at the three sorted corners; `bits` more fraction
 * bits come out than went in.  Differences up to 2^32, bits <= 12.
 * Each product has 33 + 29 bits, their sum 63. */
TP_ALWAYS_INLINE tp_gradient tp_tri_gradient(const tp_tri *tri, int64_t at_a,
                                             int64_t at_b, int64_t at_c, int bits)
{
    int64_t d1 = at_b - at_a, d2 = at_c - at_a;
    int     shift = tri->shift - bits;
    tp_gradient g = { 0, d1 * tri->cx1 + d2 * tri->cx2, d1 * tri->cy1 + d2 * tri->cy2 };

    if (shift >= 0) {
        g.dx >>= shift;
        g.dy >>= shift;
    } else {                    /* slivers below 1/32 of a square pixel */
        g.dx = (int64_t)((uint64_t)g.dx << -shift);
        g.dy = (int64_t)((uint64_t)g.dy << -shift);
    }
    g.base = at_a * ((int64_t)1 << bits)
           + ((g.dx * tri->off_u + g.dy * tri->off_v) >> 4);
    return g;
}
#endif
