/* SPDX-License-Identifier: MIT */
/* Set-up of a triangle: rejection, sorting, edges, gradients.
 *
 * Bits: corners lie within 8192 + 2048 pixels, so differences have 19 bits in 28.4, the
 * area 2^38, a difference of 32 bits times one of 19 twice 2^52. */
#include "raster/tri.h"

static bool misses(const tp_samples *tile, const tp_corner *a, const tp_corner *b,
                   const tp_corner *c)
{
    int32_t low = a->u < b->u ? a->u : b->u, high = a->u > b->u ? a->u : b->u;

    low = low < c->u ? low : c->u;
    high = high > c->u ? high : c->u;
    int32_t first = tp_first_centre(low), end = tp_first_centre(high);
    return first >= end || first >= tile->x1 || end <= tile->x0;
}

static void sort(tp_tri *tri, const tp_corner *a, const tp_corner *b, const tp_corner *c)
{
    const tp_corner *swap;

    if (b->v < a->v) {
        swap = a;
        a = b;
        b = swap;
    }
    if (c->v < a->v) {
        swap = a;
        a = c;
        c = swap;
    }
    if (c->v < b->v) {
        swap = b;
        b = c;
        c = swap;
    }
    tri->a = a;
    tri->b = b;
    tri->c = c;
}

/* The area's reciprocal: area = norm 2^(32-lz), and a gradient per pixel is
 * 16 num / area = num r 2^(lz-91). */
static void set_area(tp_tri *tri, int64_t area)
{
    uint64_t size = (uint64_t)(area < 0 ? -area : area);
    uint32_t high = (uint32_t)(size >> 32);
    int      lz = high ? tp_clz(high) : 32 + tp_clz((uint32_t)size);

    tri->negative = area < 0;
    tri->r = tp_recip_norm((uint32_t)(size << lz >> 32));
    tri->shift = 59 - lz;
}

/* Affine s,t stray from the true ones by about a quarter of (depth ratio - 1) times the
 * triangle's extent: allowed up to a quarter of a pixel. */
static bool needs_perspective(const tp_tri *tri, int32_t width)
{
    uint32_t za = tri->a->zi, zb = tri->b->zi, zc = tri->c->zi;
    uint32_t low = za < zb ? za : zb, high = za > zb ? za : zb;
    int32_t  height = tri->c->v - tri->a->v;
    uint32_t extent = (uint32_t)(width > height ? width : height) >> 4;

    low = low < zc ? low : zc;
    high = high > zc ? high : zc;
    return (uint64_t)(high - low) * (extent + 1) > low;
}

bool tp_tri_begin(tp_tri *tri, const tp_samples *tile, const tp_corner *a,
                  const tp_corner *b, const tp_corner *c)
{
    if (misses(tile, a, b, c))
        return false;
    sort(tri, a, b, c);
    a = tri->a;
    b = tri->b;
    c = tri->c;
    int32_t top = tp_first_centre(a->v), bottom = tp_first_centre(c->v);
    tri->top = top > tile->y0 ? top : tile->y0;
    tri->bottom = bottom < tile->y1 ? bottom : tile->y1;
    if (tri->top >= tri->bottom)
        return false;
    int64_t area = tp_tri_area(a, b, c);
    if (area == 0)
        return false;
    set_area(tri, area);
    tri->long_left = area > 0;          /* then b lies right of the long edge */
    tri->middle = tp_first_centre(b->v);
    tri->length = tp_edge_of(a->u, a->v, c->u, c->v);
    if (b->v > a->v)
        tri->upper = tp_edge_of(a->u, a->v, b->u, b->v);
    if (c->v > b->v)
        tri->lower = tp_edge_of(b->u, b->v, c->u, c->v);
    tri->x_ref = a->u >> 4;
    tri->y_ref = a->v >> 4;
    int32_t wide = tp_abs(b->u - a->u), other = tp_abs(c->u - a->u);
    tri->perspective = needs_perspective(tri, wide > other ? wide : other);
    return true;
}

/* num r / 2^32, rounded down; |num| < 2^53. */
static int64_t times_high(int64_t num, uint32_t r)
{
    return (num >> 32) * (int64_t)r
         + (int64_t)(((uint64_t)num & 0xffffffffu) * r >> 32);
}

static int64_t over_area(const tp_tri *tri, int64_t num, int bits)
{
    int     shift = tri->shift - bits;
    int64_t q = times_high(tri->negative ? -num : num, tri->r);
    return shift >= 0 ? q >> shift : q * ((int64_t)1 << -shift);
}

tp_gradient tp_tri_gradient(const tp_tri *tri, int64_t at_a, int64_t at_b, int64_t at_c,
                            int bits)
{
    const tp_corner *a = tri->a, *b = tri->b, *c = tri->c;
    int64_t d1 = at_b - at_a, d2 = at_c - at_a;
    tp_gradient g;

    g.dx = over_area(tri, d1 * (c->v - a->v) - d2 * (b->v - a->v), bits);
    g.dy = over_area(tri, d2 * (b->u - a->u) - d1 * (c->u - a->u), bits);
    g.base = at_a * ((int64_t)1 << bits)
           + ((g.dx * (16 * tri->x_ref + 8 - a->u)
               + g.dy * (16 * tri->y_ref + 8 - a->v)) >> 4);
    return g;
}
