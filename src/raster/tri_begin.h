/* SPDX-License-Identifier: MIT */
/*
 * Triangle set-up: rejection, sorting, edges.  One copy serves all kinds of triangles of a
 * file.  The copy is static, so that compilers see that no other code keeps the triangle: a
 * function of another file costs 1.6 % of the instructions of storm.
 */
#ifndef TP_RASTER_TRI_BEGIN_H
#define TP_RASTER_TRI_BEGIN_H
#include "raster/tri.h"

TP_ALWAYS_INLINE bool is_outside_tile_columns(const tp_gbuffer *tile,
                                              const tp_screen_vertex *a,
                                              const tp_screen_vertex *b,
                                              const tp_screen_vertex *c)
{
    int32_t low = a->u < b->u ? a->u : b->u, high = a->u > b->u ? a->u : b->u;

    low = low < c->u ? low : c->u;
    high = high > c->u ? high : c->u;
    int32_t first = tp_first_centre(low), end = tp_first_centre(high);
    return first >= end || first >= tile->x1 || end <= tile->x0;
}

TP_ALWAYS_INLINE int32_t max_int32(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

/* dx of a quantity is 16 (d1 dv2 - d2 dv1) / area per px; dy likewise with du.  The four
 * factors dv r / 2^k keep 28 or 29 bits in the largest factor.  With
 * 1/area = r 2^(lz - 95), a gradient is their sum of products / 2^(91 - lz - k).  The
 * exponent is at least 16: with the largest difference in 2^m..2^(m+1), k is m + 4, and lz
 * is at most 63 and, since a sliver's area is smaller, 79 - 2m.
 *
 * Each factor has an error of 2^-27 of the largest factor, so at the other end of the
 * triangle a value has an error of up to 5 x 2^-27 of its range times length / thickness.
 * Slivers thinner than 1/65536 of their length take all values from their upper vertex:
 * an extrapolated depth could put a sliver in front of everything.  Factors of slivers are 0. */
TP_ALWAYS_INLINE void set_gradient_factors(tp_tri *tri, int64_t area)
{
    const tp_screen_vertex *a = tri->a, *b = tri->b, *c = tri->c;
    int32_t  du1 = b->u - a->u, dv1 = b->v - a->v, du2 = c->u - a->u, dv2 = c->v - a->v;
    int32_t  most = max_int32(max_int32(tp_abs(du1), tp_abs(du2)), dv2);
    uint64_t size = (uint64_t)(area < 0 ? -area : area);
    TP_ASSERT(size > 0 && size >> 39 == 0);
    uint32_t high = (uint32_t)(size >> 32);
    int      lz = high ? tp_clz(high) : 32 + tp_clz((uint32_t)size);
    int      k = 35 - tp_clz((uint32_t)most);
    int64_t  r = tp_recip_norm((uint32_t)(size << lz >> 32));

    if ((uint64_t)most * (uint32_t)most >> 16 > size)       /* a sliver? */
        r = 0;
    if (area < 0)
        r = -r;
    tri->cx1 = (int32_t)(dv2 * r >> k);
    tri->cx2 = (int32_t)(-dv1 * r >> k);
    tri->cy1 = (int32_t)(-du2 * r >> k);
    tri->cy2 = (int32_t)(du1 * r >> k);
    TP_ASSERT(r == 0 || 91 - lz - k >= TP_LEAST_SHIFT);
    tri->shift = max_int32(91 - lz - k, TP_LEAST_SHIFT);
}

/* True if s and t need perspective.  Affine s and t deviate by about a quarter of (depth
 * ratio - 1) times the triangle's extent; a quarter of a pixel is allowed. */
TP_ALWAYS_INLINE bool needs_perspective(const tp_tri *tri, int32_t width)
{
    uint32_t za = tri->a->zi, zb = tri->b->zi, zc = tri->c->zi;
    uint32_t low = za < zb ? za : zb, high = za > zb ? za : zb;
    int32_t  height = tri->c->v - tri->a->v;
    uint32_t extent = (uint32_t)(width > height ? width : height) >> 4;

    low = low < zc ? low : zc;
    high = high > zc ? high : zc;
    return (uint64_t)(high - low) * (extent + 1) > low;
}

/* Moves an edge to row y, if that is further down. */
TP_NEVER_INLINE void advance_edge(tp_edge *e, int32_t y)
{
    tp_edge_advance(e, y);
}

TP_ALWAYS_INLINE void set_edge(tp_edge *e, const tp_screen_vertex *p,
                               const tp_screen_vertex *q, int32_t top)
{
    *e = tp_edge_begin(p->u, p->v, q->u, q->v);
    if (top > e->row)
        advance_edge(e, top);
}

/* Sets up a triangle. False: no pixel centre of the tile can be inside. */
TP_NEVER_INLINE bool tp_tri_begin(tp_tri *tri, const tp_gbuffer *tile,
                                  const tp_screen_vertex *a, const tp_screen_vertex *b,
                                  const tp_screen_vertex *c)
{
    if (is_outside_tile_columns(tile, a, b, c))
        return false;
    bool odd = sort_by_row_flips_winding(tri, a, b, c);
    a = tri->a;
    b = tri->b;
    c = tri->c;
    int32_t top = tp_first_centre(a->v), bottom = tp_first_centre(c->v);
    tri->top = top > tile->y0 ? top : tile->y0;
    tri->bottom = bottom < tile->y1 ? bottom : tile->y1;
    if (tri->top >= tri->bottom)
        return false;
    TP_ASSERT(tp_screen_vertex_in_guard_band(a) && tp_screen_vertex_in_guard_band(b)
              && tp_screen_vertex_in_guard_band(c));
    int64_t area = tp_tri_twice_area(a, b, c);
    if (area == 0 || (tile->front_only && (area > 0) != odd))
        return false;
    set_gradient_factors(tri, area);
    tri->long_left = area > 0;          /* b is right of the long edge */
    tri->middle = tp_first_centre(b->v);
    set_edge(&tri->length, a, c, tri->top);
    if (tri->top < tri->middle)
        set_edge(&tri->upper, a, b, tri->top);
    if (tri->middle < tri->bottom)
        set_edge(&tri->lower, b, c, tri->top);
    tri->x_ref = a->u >> 4;
    tri->y_ref = a->v >> 4;
    tri->off_u = 16 * tri->x_ref + 8 - a->u;
    tri->off_v = 16 * tri->y_ref + 8 - a->v;
    int32_t wide = tp_abs(b->u - a->u), other = tp_abs(c->u - a->u);
    tri->perspective = needs_perspective(tri, wide > other ? wide : other);
    return true;
}

#endif
