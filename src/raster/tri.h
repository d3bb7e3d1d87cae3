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
    uint32_t r;                 /* 2^63 / the area's normalised magnitude */
    int      shift;
    bool     negative;
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
 * bits come out than went in.  Differences below 2^32, bits <= 12. */
tp_gradient tp_tri_gradient(const tp_tri *tri, int64_t at_a, int64_t at_b, int64_t at_c,
                            int bits);
#endif
