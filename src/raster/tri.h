/* SPDX-License-Identifier: MIT */
/*
 * A triangle's constants, sorting, and a plane for each quantity.  The code is inline,
 * because small triangles spend half of their time here and in tri_begin.h.
 *
 * Bits: vertices lie within 8192 + 2048 px.  Differences have 19 bits in 28.4, the area
 * 2^38; a 32-bit difference times a 19-bit difference, twice, is below 2^52.
 */
#ifndef TP_RASTER_TRI_H
#define TP_RASTER_TRI_H
#include <stdint.h>
#include "raster/raster.h"

/* -- perspective --------------------------------------------------------------------- */

/*
 * TP_SPAN_STEP is the distance in px between perspective-exact s and t along a row; between
 * exact positions s and t are linear.  A power of two up to 32, or 0: s and t are affine in
 * all triangles.  The charts compare the values; pictures depend on the choice.
 */

#ifndef TP_SPAN_STEP
#define TP_SPAN_STEP 16
#endif
_Static_assert(TP_SPAN_STEP >= 0 && TP_SPAN_STEP <= 32
               && (TP_SPAN_STEP & (TP_SPAN_STEP - 1)) == 0, "a power of two, or 0");

/* 65536 / n, n: pixels between two exact positions. */
#if TP_SPAN_STEP > 16
static const uint32_t tp_span_over[33] = {
    0, 65536, 32768, 21845, 16384, 13107, 10923, 9362, 8192, 7282, 6554, 5958, 5461, 5041,
    4681, 4369, 4096, 3855, 3641, 3449, 3277, 3121, 2979, 2849, 2731, 2621, 2521, 2427,
    2341, 2260, 2185, 2114, 2048,
};
#else
static const uint32_t tp_span_over[17] = {
    0, 65536, 32768, 21845, 16384, 13107, 10923, 9362, 8192, 7282, 6554, 5958, 5461, 5041,
    4681, 4369, 4096,
};
#endif

/* -- a triangle ---------------------------------------------------------------------- */

/* Least tp_tri.shift: a plane has up to this many fraction bits more than its quantity. */
#define TP_LEAST_SHIFT 16

/* A triangle with vertices sorted by row, and the constants shared by all planes. */
typedef struct {
    const tp_screen_vertex *a, *b, *c; /* vertices, v ascending */
    int32_t  top, bottom;       /* rows, clipped to the tile */
    int32_t  middle;            /* first row of the lower short edge */
    bool     long_left;
    tp_edge  length;            /* the long edge, on row `top` */
    tp_edge  upper, lower;      /* short edges, on their first rows in the tile, if any */
    int32_t  x_ref, y_ref;      /* pixel of vertex a, the origin of all planes */
    int32_t  off_u, off_v;      /* from the vertex to that pixel's centre, 28.4 */
    int32_t  cx1, cx2, cy1, cy2;/* gradient: (d1 cx1 + d2 cx2) / 2^shift, likewise cy */
    int      shift;             /* TP_LEAST_SHIFT..62 */
    bool     perspective;       /* true if affine s, t err by more than 1/4 px */
} tp_tri;

/* A plane: value(x, y) = base + dx (x - x_ref) + dy (y - y_ref) at pixel centres. */
typedef struct {
    int64_t base, dx, dy;
} tp_gradient;

/* Returns the plane of a quantity from its value at a and its sums of products in x and y.
 * The result has `bits` more fraction bits than the input. */
TP_ALWAYS_INLINE tp_gradient tp_tri_gradient_scale(const tp_tri *tri, int64_t at_a,
                                                   int64_t dx, int64_t dy, int bits)
{
    const int   shift = tri->shift - bits;
    TP_ASSERT(bits <= TP_LEAST_SHIFT && shift >= 0);
    tp_gradient g = { 0, dx >> shift, dy >> shift };

    g.base = at_a * ((int64_t)1 << bits)
           + ((g.dx * tri->off_u + g.dy * tri->off_v) >> 4);
    return g;
}

/* Returns the plane of a quantity with this value at a, and d1 and d2 more at b and c.
 * Each product has 32 + 29 bits; `bits` <= TP_LEAST_SHIFT. */
TP_ALWAYS_INLINE tp_gradient tp_tri_gradient(const tp_tri *tri, int64_t at_a, int32_t d1,
                                             int32_t d2, int bits)
{
    return tp_tri_gradient_scale(
        tri, at_a, (int64_t)d1 * tri->cx1 + (int64_t)d2 * tri->cx2,
        (int64_t)d1 * tri->cy1 + (int64_t)d2 * tri->cy2, bits);
}

/* True if a vertex is inside the guard band.  The centre of the band is up to half a
 * picture from the corner; another pixel allows for rounding in the projection. */
static inline bool tp_screen_vertex_in_guard_band(const tp_screen_vertex *c)
{
    const int32_t most = 16 * ((1 << TP_GUARD_LOG2) + 2048 + 1);
    return tp_abs(c->u) <= most && tp_abs(c->v) <= most;
}

/* -- set-up -------------------------------------------------------------------------- */

/* Sorts the vertices by row, from the top down.  Returns true if the sorted order turns
 * the other way round, which changes the sign of the area. */
TP_ALWAYS_INLINE bool sort_by_row_flips_winding(tp_tri *tri,
                                                const tp_screen_vertex *a,
                                                const tp_screen_vertex *b,
                                                const tp_screen_vertex *c)
{
    const tp_screen_vertex *swap;
    bool odd = false;

    if (b->v < a->v) {
        swap = a;
        a = b;
        b = swap;
        odd = !odd;
    }
    if (c->v < a->v) {
        swap = a;
        a = c;
        c = swap;
        odd = !odd;
    }
    if (c->v < b->v) {
        swap = b;
        b = c;
        c = swap;
        odd = !odd;
    }
    tri->a = a;
    tri->b = b;
    tri->c = c;
    return odd;
}

/* True if a sample of this depth belongs to the outline at `key`, whose planes are `plane`
 * words apart.  A surface bends towards the viewer from its outline on, so the nearer side
 * of the window is wider.  Outside of a single edge the sample lies behind the outline. */
static inline bool tp_is_of_outline(const uint32_t *key, ptrdiff_t plane, uint32_t mark,
                                    int window, uint32_t depth)
{
    const uint32_t at = key[0] & ~(uint32_t)0xff, wide = at >> window;

    return key[0] && TP_MARK(key[0]) == mark && depth - at + wide / 4 <= wide / 2
           && (key[3 * plane] & TP_OUTLINE_MORE
               || tp_outline_share(key[2 * plane], 0) >= 128);
}

#endif
