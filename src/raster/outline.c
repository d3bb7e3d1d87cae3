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
} outline;

static int64_t lerp(int64_t a, int64_t b, int32_t share_q16)
{
    return a + ((b - a) * share_q16 >> 16);
}

static uint32_t lerp_normal(const outline *o, int32_t share)
{
    uint32_t n = 0;

    for (int k = 0; k < 3; k++)
        n |= ((uint32_t)lerp(o->a->n[k], o->b->n[k], share) & 1023) << 10 * k;
    return n;
}

/* Adds a share to one of the two sums in t.  A sum is kept off 0. */
static uint32_t add_to_sum(uint32_t t, bool level, int32_t share)
{
    const int shift = level ? 16 : 24;
    const int32_t sum = tp_clamp((int32_t)(int8_t)(t >> shift & 0xff) + share, -127, 127);

    return (t & ~(0xffu << shift)) | ((uint32_t)(sum ? sum : 1) & 0xff) << shift;
}

/* Draws the edge in the pixel at `at`; `share`: the part to its right or below, 0..128. */
static void draw_pixel(const tp_gbuffer *tile, const outline *o, uint32_t *at,
                       int32_t along, int32_t share, uint32_t mark, uint32_t face)
{
    const ptrdiff_t plane = tile->s - tile->key;
    const uint32_t zi = (uint32_t)lerp(o->a->zi, o->b->zi, along);
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
    at[plane] = (uint32_t)lerp(o->a->s, o->b->s, along) << 16
              | ((uint32_t)lerp(o->a->t, o->b->t, along) & 0xffff);
    at[2 * plane] = add_to_sum(face | out, o->level, signed_share);
    at[3 * plane] = lerp_normal(o, along);
}

/* Returns where the edge crosses the centre of row or column i of the other axis, 1/256
 * px; *along is set to the share of the edge, Q16. */
static int32_t cross(const outline *o, int32_t i, int32_t *along)
{
    const int32_t a = o->level ? o->a->v : o->a->u, b = o->level ? o->b->v : o->b->u;

    *along = (int32_t)((uint32_t)(16 * i + 8 - o->from) * o->inverse >> 15);
    return (int32_t)lerp(16 * a, 16 * b, *along);
}

/* Draws the edge where it crosses the centre of row or column i. */
static void draw_crossing(const tp_gbuffer *tile, const outline *o, int32_t i,
                          uint32_t mark, uint32_t face)
{
    int32_t along;
    const int32_t at = cross(o, i, &along), x = o->level ? i : at >> 8,
                  y = o->level ? at >> 8 : i;

    if (x >= tile->x0 && x < tile->x1 && y >= tile->y0 && y < tile->y1)
        draw_pixel(tile, o, tile->outline + (size_t)(uint32_t)(y - tile->y0) * tile->stride
                                + (uint32_t)(x - tile->x0),
                   along, (256 - (at & 255)) >> 1, mark, face);
}

void tp_outline_draw_edge(const tp_gbuffer *tile, const tp_screen_vertex *a,
                          const tp_screen_vertex *b, uint32_t mark, uint32_t face)
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
    for (; first < end; first++)
        draw_crossing(tile, &o, first, mark, face);
}

void tp_outline_begin(tp_gbuffer *tile)
{
    const uint32_t rows = (uint32_t)(tile->y1 - tile->y0);

    tile->outline = tile->key + 4 * (tile->s - tile->key);
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
