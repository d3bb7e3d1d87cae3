/* SPDX-License-Identifier: MIT */
/* Rasterizes the rows of a triangle into samples.
 *
 * The fill loop is written once and compiled three times: for water, with 32-bit
 * positions s and t and a pair of slopes as normal; for solids; and for lids, with depth
 * only. s and t are affine in small triangles and follow raster/perspective.h in large
 * triangles. */
#include "raster/perspective.h"

enum { WATER, SOLID, LID };

/* A quantity along a row; its 32 bits may wrap, like phases. */
typedef struct {
    uint32_t now, step;
} walker;

typedef struct {
    uint32_t *key, *s_out, *t_out, *n_out;
    int32_t   count;
    uint32_t  mark;
    walker    zi, s, t, n0, n1, n2;
    uint32_t  face;             /* solids only */
    uint32_t  pattern;          /* solids: bit x & 3 set: the pixel is drawn */
    int32_t   x;
    ptrdiff_t outline;          /* solids: from keys to keys of outlines; 0: none */
    uint8_t   window;           /* see tp_gbuffer.outline_shift */
} span;

/* Normals are stepped in the high bits of a word: 16 bits for a slope, 10 for a solid's
 * normal, which is scaled by 64 first. */
#define NORMAL_SHIFT 16
#define SOLID_SCALE  64

TP_ALWAYS_INLINE uint32_t pack_normal(const span *sp, int kind)
{
    if (kind == SOLID)
        return sp->n0.now >> 22 | (sp->n1.now >> 22) << 10 | (sp->n2.now >> 22) << 20;
    return (sp->n0.now & 0xffff0000u) | sp->n1.now >> 16;
}

/* A lid writes depth only; the sample keeps its stencil. */
TP_ALWAYS_INLINE void fill_depth_only(const span *sp)
{
    uint32_t zi = sp->zi.now, *key = sp->key;

    for (int32_t i = 0; i < sp->count; i++, zi += sp->zi.step) {
        uint32_t depth = zi << 1 & ~(uint32_t)0xff;
        if (depth > (key[i] | 0xff) && TP_MARK(key[i]) != TP_MARK_SKY)
            key[i] = depth | TP_MARK(key[i]);
    }
}

static void advance_span(span *sp)
{
    sp->zi.now += sp->zi.step;
    sp->s.now += sp->s.step;
    sp->t.now += sp->t.step;
    sp->n0.now += sp->n0.step;
    sp->n1.now += sp->n1.step;
    sp->n2.now += sp->n2.step;
}

/* Fills a span of a solid, without the pixels of its outlines. */
static __attribute__((noinline)) void fill_beside_outlines(span *sp)
{
    for (int32_t i = 0; i < sp->count; i++, advance_span(sp)) {
        uint32_t *key = sp->key + i, *outline = key + sp->outline;
        const uint32_t depth = sp->zi.now << 1 & ~(uint32_t)0xff;
        if (depth <= (*key | 0xff) || !(sp->pattern >> ((sp->x + i) & 3) & 1))
            continue;
        if (tp_is_of_outline(outline, sp->s_out - sp->key, sp->mark, sp->window, depth)) {
            outline[sp->n_out - sp->key] |= TP_OUTLINE_HIT;
            continue;
        }
        *key = depth | sp->mark;
        sp->s_out[i] = sp->s.now << 16 | (sp->t.now & 0xffff);
        sp->t_out[i] = sp->face;
        sp->n_out[i] = pack_normal(sp, SOLID);
    }
}

TP_ALWAYS_INLINE void fill_span(span *sp, int kind)
{
    uint32_t *key = sp->key, *s = sp->s_out, *t = sp->t_out, *n = sp->n_out;
    const bool solid = kind == SOLID;

    if (kind == LID) {
        fill_depth_only(sp);
        return;
    }
    if (solid && sp->outline) {
        fill_beside_outlines(sp);
        return;
    }
    for (int32_t i = 0; i < sp->count; i++) {
        uint32_t depth = sp->zi.now << 1 & ~(uint32_t)0xff;
        if (depth > (key[i] | 0xff)
            && (!solid || (sp->pattern >> ((sp->x + i) & 3) & 1))) {
            key[i] = depth | sp->mark;
            s[i] = solid ? sp->s.now << 16 | (sp->t.now & 0xffff) : sp->s.now;
            t[i] = solid ? sp->face : sp->t.now;
            n[i] = pack_normal(sp, kind);
        }
        sp->zi.now += sp->zi.step;
        sp->s.now += sp->s.step;
        sp->t.now += sp->t.step;
        sp->n0.now += sp->n0.step;
        sp->n1.now += sp->n1.step;
        if (solid)
            sp->n2.now += sp->n2.step;
    }
}

/* -- rows ---------------------------------------------------------------------------- */

/* A plane modulo 2^32. */
typedef struct {
    uint32_t base, dx, dy;
} plane;

TP_ALWAYS_INLINE plane cut_gradient(tp_gradient g)
{
    return (plane){ (uint32_t)g.base, (uint32_t)g.dx, (uint32_t)g.dy };
}

typedef struct {
    const tp_tri *tri;
    plane zi, s, t, n[3];       /* s, t: for affine triangles */
    tp_perspective persp;
    uint32_t mark, face, pattern_rows;
} span_painter;

/* Returns the value at (dx, dy) from the triangle's reference pixel, modulo 2^32. */
TP_ALWAYS_INLINE walker make_walker(const plane *p, uint32_t dx, uint32_t dy)
{
    return (walker){ p->base + p->dx * dx + p->dy * dy, p->dx };
}

/* Fills pixels [x, end) of a span at x and moves the span past them. */
TP_ALWAYS_INLINE void fill_pixels(span *sp, int32_t x, int32_t end, int kind)
{
    sp->x = x;
    sp->count = end - x;
    fill_span(sp, kind);
    sp->key += sp->count;
    sp->s_out += sp->count;
    sp->t_out += sp->count;
    sp->n_out += sp->count;
}

/* Fills pixels [x, end) of row y; the triangle covers the row from `left` to `right`. */
TP_ALWAYS_INLINE void fill_perspective(const span_painter *p, span *sp, int32_t y,
                                       int32_t left, int32_t right, int32_t x,
                                       int32_t end, int kind)
{
    int32_t from = x & -TP_SPAN_STEP;

    from = from > left ? from : left;
    span_st a = evaluate_st(&p->persp, p->tri, from, y);
    while (x < end) {
        int32_t next = (from | (TP_SPAN_STEP - 1)) + 1;
        int32_t to = next < right ? next : right - 1;
        int32_t stop = next < end ? next : end;
        span_st   b = to > from ? evaluate_st(&p->persp, p->tri, to, y) : a;
        sp->s.step = texture_coordinate_step(a.s, b.s, to - from);
        sp->t.step = texture_coordinate_step(a.t, b.t, to - from);
        sp->s.now = a.s + sp->s.step * (uint32_t)(x - from);
        sp->t.now = a.t + sp->t.step * (uint32_t)(x - from);
        fill_pixels(sp, x, stop, kind);
        x = from = stop;
        a = b;
    }
}

/* Fills a row from `left` to `right`, clipped to the tile. */
TP_ALWAYS_INLINE void fill_row(const span_painter *p, const tp_gbuffer *tile, int32_t y,
                               int32_t left, int32_t right, int kind, int exact)
{
    int32_t x = left > tile->x0 ? left : tile->x0;
    int32_t end = right < tile->x1 ? right : tile->x1;

    if (x >= end)
        return;
    size_t   at = (size_t)(uint32_t)(y - tile->y0) * tile->stride
                + (uint32_t)(x - tile->x0);
    uint32_t dx = (uint32_t)(x - p->tri->x_ref), dy = (uint32_t)(y - p->tri->y_ref);
    span sp = {
        .key = tile->key + at, .s_out = tile->s + at, .t_out = tile->t + at,
        .n_out = tile->n + at, .mark = p->mark, .x = x, .count = end - x,
        .zi = make_walker(&p->zi, dx, dy),
        .n0 = make_walker(&p->n[0], dx, dy),
        .n1 = make_walker(&p->n[1], dx, dy),
    };
    if (kind == SOLID) {
        sp.n2 = make_walker(&p->n[2], dx, dy);
        sp.face = p->face;
        sp.outline = tile->outline ? tile->outline - tile->key : 0;
        sp.window = tile->outline_shift;
        sp.pattern = p->pattern_rows >> 4 * (y & 3) & 15;
    }
    if (exact) {
        fill_perspective(p, &sp, y, left, right, x, end, kind);
    } else {
        sp.s = make_walker(&p->s, dx, dy);
        sp.t = make_walker(&p->t, dx, dy);
        fill_span(&sp, kind);
    }
}

/* Fills all rows of a triangle; the flags are literals. */
TP_ALWAYS_INLINE void fill_triangle_rows(const span_painter *p, const tp_gbuffer *tile,
                                         int kind, int exact)
{
    const tp_tri *tri = p->tri;
    int32_t  y = tri->top;
    tp_edge  along = tri->length;

    for (int half = 0; half < 2; half++) {
        int32_t stop = half == 0 && tri->middle < tri->bottom ? tri->middle
                                                              : tri->bottom;
        if (y >= stop)
            continue;
        tp_edge other = half == 0 && y < tri->middle ? tri->upper : tri->lower;
        for (; y < stop; y++) {
            const int32_t left = tri->long_left ? along.pixel : other.pixel;
            const int32_t right = tri->long_left ? other.pixel : along.pixel;
            fill_row(p, tile, y, left, right, kind, exact);
            tp_edge_step(&along);
            tp_edge_step(&other);
        }
    }
}

/* Depths are below 2^31. */
TP_ALWAYS_INLINE plane depth_plane(const tp_tri *tri)
{
    const uint32_t a = tri->a->zi;
    TP_ASSERT((a | tri->b->zi | tri->c->zi) >> 31 == 0);
    return cut_gradient(tp_tri_gradient(tri, a, (int32_t)(tri->b->zi - a),
                                        (int32_t)(tri->c->zi - a), 0));
}

/* Returns the plane of a normal's component, times `scale`; `exact` as for
 * fill_triangle_rows. */
TP_ALWAYS_INLINE plane normal_plane(const tp_tri *tri, int i, int scale, int exact)
{
    const int32_t at[3] = { scale * tri->a->n[i], scale * tri->b->n[i],
                            scale * tri->c->n[i] };
    if (exact)
        return cut_gradient(large_gradient(tri, at, NORMAL_SHIFT));
    return cut_gradient(tp_tri_gradient(tri, at[0], at[1] - at[0], at[2] - at[0],
                                        NORMAL_SHIFT));
}

TP_ALWAYS_INLINE void set_depth_and_st_planes(span_painter *p, bool exact)
{
    const tp_tri *tri = p->tri;

    p->zi = depth_plane(tri);
    if (exact) {
        p->persp = make_perspective(tri);
    } else {
        p->s = cut_gradient(gradient_wide(tri, tri->a->s, tri->b->s, tri->c->s));
        p->t = cut_gradient(gradient_wide(tri, tri->a->t, tri->b->t, tri->c->t));
    }
}

void tp_tri_water(const tp_gbuffer *tile, const tp_screen_vertex *a,
                  const tp_screen_vertex *b, const tp_screen_vertex *c)
{
    tp_tri  tri;
    span_painter p;

    if (!tp_tri_begin(&tri, tile, a, b, c))
        return;
    const bool exact = TP_SPAN_STEP && tri.perspective;
    p.tri = &tri;
    p.mark = TP_MARK_WATER;
    set_depth_and_st_planes(&p, exact);
    p.n[0] = normal_plane(&tri, 0, 1, 0);
    p.n[1] = normal_plane(&tri, 1, 1, 0);
    if (exact)
        fill_triangle_rows(&p, tile, WATER, 1);
    else
        fill_triangle_rows(&p, tile, WATER, 0);
}

/* Returns the rows of a 4x4 ordered pattern with `opacity` of 16 bits set. */
static uint32_t dither_pattern(int opacity)
{
    static const uint8_t order[16] = { 0, 8, 2, 10, 12, 4, 14, 6,
                                       3, 11, 1, 9, 15, 7, 13, 5 };
    uint32_t rows_of_bits = 0;

    for (int i = 0; i < 16; i++)
        rows_of_bits |= (uint32_t)(order[i] < opacity) << i;
    return rows_of_bits;
}

/* True if s or t differs between the vertices.  Equal ones need no perspective. */
static bool has_st(const tp_screen_vertex *a, const tp_screen_vertex *b,
                   const tp_screen_vertex *c)
{
    return a->s != b->s || a->s != c->s || a->t != b->t || a->t != c->t;
}

/* Draws a solid triangle that is set up; `exact` is a literal. */
TP_ALWAYS_INLINE void draw_solid(const tp_tri *tri, const tp_gbuffer *tile, uint32_t mark,
                                 uint32_t face, int opacity, int exact)
{
    span_painter p;

    p.tri = tri;
    p.mark = mark;
    p.face = face;
    p.pattern_rows = opacity < 16 ? dither_pattern(opacity) : 0xffff;
    set_depth_and_st_planes(&p, exact);
    p.n[0] = normal_plane(tri, 0, SOLID_SCALE, exact);
    p.n[1] = normal_plane(tri, 1, SOLID_SCALE, exact);
    p.n[2] = normal_plane(tri, 2, SOLID_SCALE, exact);
    fill_triangle_rows(&p, tile, SOLID, exact);
}

/* Draws a triangle unless it is wide and the tile can draw wide ones; then returns false. */
TP_NEVER_INLINE bool draw_affine_solid(const tp_gbuffer *tile, const tp_screen_vertex *a,
                                       const tp_screen_vertex *b, const tp_screen_vertex *c,
                                       uint32_t mark, uint32_t face, int opacity)
{
    tp_tri tri;

    if (!tp_tri_begin(&tri, tile, a, b, c))
        return true;
    const bool wide = TP_SPAN_STEP && tri.perspective && has_st(a, b, c);
    if (wide && tile->draw_wide)
        return false;
    if (wide && tile->dropped)
        ++*tile->dropped;
    draw_solid(&tri, tile, mark, face, opacity, 0);
    return true;
}

/* Sets the triangle up again: a pointer to the set-up from another function would slow down
 * the small triangles, which are most. */
void tp_tri_solid_wide(const tp_gbuffer *tile, const tp_screen_vertex *a,
                       const tp_screen_vertex *b, const tp_screen_vertex *c, uint32_t mark,
                       uint32_t face, int opacity)
{
    tp_tri tri;

    if (tp_tri_begin(&tri, tile, a, b, c))
        draw_solid(&tri, tile, mark, face, opacity, 1);
}

void tp_tri_solid(const tp_gbuffer *tile, const tp_screen_vertex *a,
                  const tp_screen_vertex *b, const tp_screen_vertex *c, uint32_t mark,
                  uint32_t face, int opacity)
{
    TP_ASSERT(mark >= TP_MARK_SOLID && mark <= 0xff && opacity >= 0);

    if (!draw_affine_solid(tile, a, b, c, mark, face, opacity))
        tile->draw_wide(tile, a, b, c, mark, face, opacity);
}

void tp_tri_depth_only(const tp_gbuffer *tile, const tp_screen_vertex *a,
                       const tp_screen_vertex *b, const tp_screen_vertex *c)
{
    tp_tri tri = { 0 };

    if (!tp_tri_begin(&tri, tile, a, b, c))
        return;
    span_painter p = { .tri = &tri, .zi = depth_plane(&tri) };
    fill_triangle_rows(&p, tile, LID, 0);
}

void tp_gbuffer_clear(const tp_gbuffer *tile)
{
    TP_ASSERT(tile->x0 < tile->x1 && tile->y0 < tile->y1);
    TP_ASSERT((uint32_t)(tile->x1 - tile->x0) <= tile->stride);
    uint32_t rows_of_tile = (uint32_t)(tile->y1 - tile->y0);
    memset(tile->key, 0, (size_t)rows_of_tile * tile->stride * sizeof *tile->key);
}
