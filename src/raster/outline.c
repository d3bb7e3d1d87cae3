/* SPDX-License-Identifier: MIT */
/* Draws the edges of a mesh's outline; see the header for the samples.
 *
 * An edge closer to upright is walked by rows, any other by columns: one pixel each, the
 * pixel that the edge crosses at the row's or column's centre.  Its share there is that of
 * an edge without slant.  Rows and columns are those with centres between the edge's ends,
 * so edges in a chain meet without a gap. */
#include "raster/tri.h"

/* An edge along its longer axis, from end a to end b. */
typedef struct {
    const tp_screen_vertex *a, *b;
    bool     level;             /* true: walked by columns */
    bool     after;             /* true: the mesh lies to the right or below */
    int32_t  from, length;      /* the walked axis, 28.4 px */
    uint32_t inverse;           /* 2^31 / length */
    uint32_t st, n;             /* the fast rung: of all pixels */
} outline;

/* A pixel on the walked axis: the share of the edge, Q16, and in the fast rung the inverse
 * depth. */
typedef struct {
    int32_t  along;
    uint32_t zi;
} place;

/* Interpolates between values with a difference below 2^31; share is Q16, below 1. */
static int32_t lerp(int32_t a, int32_t b, int32_t share)
{
    return a + (int32_t)((int64_t)(b - a) * share >> 16);
}

/* Interpolates 16-bit halves of texture positions modulo 1: the low 32 bits of the product
 * suffice. */
static uint32_t lerp_st(const outline *o, uint32_t share)
{
    const uint32_t s = ((uint32_t)o->b->s - (uint32_t)o->a->s) * share >> 16,
                   t = ((uint32_t)o->b->t - (uint32_t)o->a->t) * share >> 16;

    return ((uint32_t)o->a->s + s) << 16 | (((uint32_t)o->a->t + t) & 0xffff);
}

/* Components have 10 bits, so products fit 32. */
static uint32_t lerp_normal(const outline *o, int32_t share)
{
    uint32_t n = 0;

    for (int k = 0; k < 3; k++)
        n |= ((uint32_t)(o->a->n[k] + ((o->b->n[k] - o->a->n[k]) * share >> 16)) & 1023)
             << 10 * k;
    return n;
}

/* Adds a share to one of the two sums in t.  A sum is kept off 0. */
static uint32_t add_to_sum(uint32_t t, bool level, int32_t share)
{
    const int shift = level ? 16 : 24;
    const int32_t sum = tp_clamp((int32_t)(int8_t)(t >> shift & 0xff) + share, -127, 127);

    return (t & ~(0xffu << shift)) | ((uint32_t)(sum ? sum : 1) & 0xff) << shift;
}

/* Draws the edge in the pixel at `at`; `share`: the part to its right or below, 0..128;
 * `fast` is a literal. */
TP_ALWAYS_INLINE void draw_pixel(const tp_gbuffer *tile, const outline *o, uint32_t *at,
                                 place p, int32_t share, uint32_t mark, uint32_t face,
                                 int fast)
{
    const ptrdiff_t plane = tile->s - tile->key;
    const uint32_t zi =
        fast ? p.zi : (uint32_t)lerp((int32_t)o->a->zi, (int32_t)o->b->zi, p.along);
    const uint32_t depth = zi << 1 & ~(uint32_t)0xff, old = at[0] & ~(uint32_t)0xff;
    const uint32_t wide = old >> tile->outline_shift;
    const int32_t signed_share = o->after ? share : -share;
    const uint32_t out = (o->after ? share < 62 : share > 66) ? TP_OUTLINE_OUT : 0;

    if (at[0] && TP_MARK(at[0]) == mark && depth - old + wide <= 2 * wide) {
        at[2 * plane] = add_to_sum(at[2 * plane] | out, o->level, signed_share);
        at[3 * plane] |= TP_OUTLINE_MORE;
        return;
    }
    if (at[0] && depth <= old)
        return;
    at[0] = depth | mark;
    at[plane] = fast ? o->st : lerp_st(o, (uint32_t)p.along);
    at[2 * plane] = add_to_sum(face | out, o->level, signed_share);
    at[3 * plane] = fast ? o->n : lerp_normal(o, p.along);
}

/* Draws the edge where it crosses the centre of row or column i. */
TP_ALWAYS_INLINE void draw_crossing(const tp_gbuffer *tile, const outline *o, int32_t i,
                                    place p, uint32_t mark, uint32_t face, int fast)
{
    const int32_t a = o->level ? o->a->v : o->a->u, b = o->level ? o->b->v : o->b->u;
    const int32_t at = lerp(16 * a, 16 * b, p.along), x = o->level ? i : at >> 8,
                  y = o->level ? at >> 8 : i;

    if (x >= tile->x0 && x < tile->x1 && y >= tile->y0 && y < tile->y1)
        draw_pixel(tile, o, tile->outline + (size_t)(uint32_t)(y - tile->y0) * tile->stride
                                + (uint32_t)(x - tile->x0),
                   p, (256 - (at & 255)) >> 1, mark, face, fast);
}

/* Draws the pixels from `first` on.  The fast rung steps the depth from the edge's first
 * pixel on, so that every tile has the same bits. */
TP_ALWAYS_INLINE void draw_pixels(const tp_gbuffer *tile, outline *o, int32_t first,
                                  int32_t end, uint32_t mark, uint32_t face, int fast)
{
    const uint32_t begin = (uint32_t)(16 * first + 8 - o->from);
    const uint32_t step = fast ? (uint32_t)((int64_t)(int32_t)(o->b->zi - o->a->zi)
                                            * o->inverse >> 27) : 0;
    const uint32_t start = (uint32_t)(16 * tp_first_centre(o->from) + 8 - o->from);
    uint32_t along = begin * o->inverse,
             zi = o->a->zi + (uint32_t)((int64_t)(int32_t)step * start >> 4)
                  + step * ((begin - start) >> 4);

    if (fast) {
        o->st = lerp_st(o, 0x8000);
        o->n = lerp_normal(o, 0x8000);
    }
    for (; first < end; first++, along += 16 * o->inverse, zi += step)
        draw_crossing(tile, o, first, (place){ (int32_t)(along >> 15), zi }, mark, face,
                      fast);
}

TP_ALWAYS_INLINE void draw_edge(const tp_gbuffer *tile, const tp_screen_vertex *a,
                                const tp_screen_vertex *b, uint32_t mark, uint32_t face,
                                int fast)
{
    TP_ASSERT(tp_screen_vertex_in_guard_band(a) && tp_screen_vertex_in_guard_band(b));
    const bool level = tp_abs(b->u - a->u) > tp_abs(b->v - a->v);
    const bool turned = level ? b->u < a->u : b->v < a->v;
    outline o = { .a = turned ? b : a, .b = turned ? a : b, .level = level,
                  .after = level == turned };

    o.from = level ? o.a->u : o.a->v;
    o.length = (level ? o.b->u : o.b->v) - o.from;
    int32_t first = tp_first_centre(o.from), end = tp_first_centre(o.from + o.length);
    const int32_t low = level ? tile->x0 : tile->y0, high = level ? tile->x1 : tile->y1;
    first = first > low ? first : low;
    end = end < high ? end : high;
    if (first >= end)
        return;
    o.inverse = 0x7fffffffu / (uint32_t)o.length;
    draw_pixels(tile, &o, first, end, mark, face, fast);
}

void tp_outline_draw_edge(const tp_gbuffer *tile, const tp_screen_vertex *a,
                          const tp_screen_vertex *b, uint32_t mark, uint32_t face)
{
    draw_edge(tile, a, b, mark, face, 0);
}

void tp_outline_draw_edge_fast(const tp_gbuffer *tile, const tp_screen_vertex *a,
                               const tp_screen_vertex *b, uint32_t mark, uint32_t face)
{
    draw_edge(tile, a, b, mark, face, 1);
}

void tp_outline_begin(tp_gbuffer *tile, int32_t x0, int32_t x1)
{
    const uint32_t rows = (uint32_t)(tile->y1 - tile->y0);

    tile->outline = tile->key + 4 * (tile->s - tile->key);
    tile->outline_x0 = x0 > tile->x0 ? x0 : tile->x0;
    tile->outline_x1 = x1 < tile->x1 ? x1 + 1 : tile->x1;
    memset(tile->outline, 0, (size_t)rows * tile->stride * sizeof *tile->outline);
}

static uint32_t share_of_sum(int32_t sum)
{
    return (uint32_t)(2 * sum + (sum > 0 ? 0 : 256));
}

/* The same edges may be a thin rope or two surfaces that meet or overlap in the pixel.
 * Surfaces cover the pixel's centre though it lies outside of one of the edges. */
uint32_t tp_outline_share(uint32_t t, uint32_t n)
{
    if (t & TP_OUTLINE_OUT && n & TP_OUTLINE_HIT)
        return 256;
    return share_of_sum((int8_t)(t >> 24)) * share_of_sum((int8_t)(t >> 16 & 0xff)) >> 8;
}
