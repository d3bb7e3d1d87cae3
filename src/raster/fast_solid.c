/* SPDX-License-Identifier: MIT */
/* Solid triangles of the fast rung: they cover the same pixels as those of span.c, at a
 * lower price.
 *
 * Planes are set up in 32 bits.  s and t are affine and share a word, as do the two parts
 * of a vertex's light, so a pixel steps three words.  Triangles of a few pixels
 * have one depth, place and light; slivers change along their length alone.
 *
 * Bits: both sides of the box are at most 2^10 in 28.4 where planes are set up, so twice
 * the area is below 2^21. */
#include "raster/tri.h"

enum {
    LONGEST = 64 * 16,          /* side of the box, 28.4 */
    SMALL   = 3 * 512,          /* twice the area, 28.4: 3 square px; */
    SHORT   = 6 * 16,           /* and the extent below it */
    THIN    = 24,               /* twice the area of a sliver, by its length, 28.4 */
    REPEATS = 8 * 65536         /* of a texture along a triangle */
};

/* The three stepped words: inverse depth; s:t, 0.16 each; light, the second part in the
 * high half, both with 6 more bits. */
typedef struct {
    uint32_t zi, st, light;
} words;

/* A triangle with vertices sorted by row. */
typedef struct {
    const tp_gbuffer *tile;
    const tp_screen_vertex *a, *b, *c;
    int32_t du1, dv1, du2, dv2; /* ways from a to b and c */
    bool    long_left;          /* the edge from a to c is on the left */
    words   base, dx, dy;               /* from the pixel of a on */
    int32_t x_ref, y_ref, top, bottom;
    uint32_t mark;
} triangle;

static int32_t min3(int32_t a, int32_t b, int32_t c)
{
    const int32_t n = a < b ? a : b;
    return n < c ? n : c;
}

static int32_t max3(int32_t a, int32_t b, int32_t c)
{
    return -min3(-a, -b, -c);
}

/* -- planes -------------------------------------------------------------------------- */

/* One quantity: its value at a, what b and c have more, and its plane. */
typedef struct {
    int32_t at, d1, d2;
    uint32_t base, dx, dy;
} plane;

/* Sets dx and dy from sums of products / 2^cut; `inverse` is 2^31 / area. */
TP_ALWAYS_INLINE void set_plane(const triangle *t, plane *p, int32_t inverse, int cut)
{
    const int64_t x = ((int64_t)p->d1 * t->dv2 - (int64_t)p->d2 * t->dv1) >> cut,
                  y = ((int64_t)p->d2 * t->du1 - (int64_t)p->d1 * t->du2) >> cut;
    const int32_t dx = (int32_t)((int64_t)(int32_t)x * inverse >> (27 - cut)),
                  dy = (int32_t)((int64_t)(int32_t)y * inverse >> (27 - cut));
    const int32_t u = 16 * t->x_ref + 8 - t->a->u, v = 16 * t->y_ref + 8 - t->a->v;

    p->dx = (uint32_t)dx;
    p->dy = (uint32_t)dy;
    p->base = (uint32_t)(p->at + (int32_t)(((int64_t)dx * u + (int64_t)dy * v) >> 4));
}

/* Joins two planes in one word; a borrow of the low half moves the high one by 1. */
static uint32_t join(uint32_t high, uint32_t low)
{
    return (high << 16) + low;
}

TP_ALWAYS_INLINE plane light_plane(const triangle *t, int k)
{
    return (plane){ 64 * t->a->n[k], 64 * (t->b->n[k] - t->a->n[k]),
                    64 * (t->c->n[k] - t->a->n[k]), 0, 0, 0 };
}

/* `area`: twice the area, signed. */
static void set_planes(triangle *t, int32_t area)
{
    const int32_t inverse = INT32_MAX / area;
    const uint32_t z = t->a->zi;
    plane zi = { (int32_t)z, (int32_t)(t->b->zi - z), (int32_t)(t->c->zi - z), 0, 0, 0 },
          s = { t->a->s, t->b->s - t->a->s, t->c->s - t->a->s, 0, 0, 0 },
          r = { t->a->t, t->b->t - t->a->t, t->c->t - t->a->t, 0, 0, 0 },
          nl = light_plane(t, 0), lobe = light_plane(t, 1);

    set_plane(t, &zi, inverse, 12);
    set_plane(t, &s, inverse, 0);
    set_plane(t, &r, inverse, 0);
    set_plane(t, &nl, inverse, 0);
    set_plane(t, &lobe, inverse, 0);
    t->base = (words){ zi.base, join(s.base, r.base), join(lobe.base, nl.base) };
    t->dx = (words){ zi.dx, join(s.dx, r.dx), join(lobe.dx, nl.dx) };
    t->dy = (words){ zi.dy, join(s.dy, r.dy), join(lobe.dy, nl.dy) };
}

/* Sets the means of the vertices for all pixels. */
static void set_means(triangle *t)
{
    const tp_screen_vertex *a = t->a, *b = t->b, *c = t->c;
    const int32_t third = 21845;        /* of 65536 */
    const int32_t zi = ((int32_t)(b->zi - a->zi) / 4 + (int32_t)(c->zi - a->zi) / 4) / 3;
    const int32_t s = (b->s - a->s + c->s - a->s) / 3, r = (b->t - a->t + c->t - a->t) / 3;
    const int32_t nl = (a->n[0] + b->n[0] + c->n[0]) * third >> 10,
                  lobe = (a->n[1] + b->n[1] + c->n[1]) * third >> 10;

    t->base = (words){ a->zi + 4 * (uint32_t)zi,
                       join((uint32_t)(a->s + s), (uint32_t)(a->t + r)),
                       join((uint32_t)lobe, (uint32_t)nl) };
    t->dx = t->dy = (words){ 0, 0, 0 };
}

/* Returns the step per pixel of a quantity that grows by d over a sliver; `inverse` is
 * 2^31 / length. */
static uint32_t step_along(uint32_t d, int32_t inverse)
{
    return (uint32_t)((int64_t)(int32_t)d * inverse >> 27);
}

/* Sets planes that change along the longer axis of a sliver alone, from one end to the
 * other.  s and t may differ by any number of repeats. */
static void set_along(triangle *t, bool level)
{
    const tp_screen_vertex *p = t->a, *q = t->c;

    if (level) {
        p = t->b->u < p->u ? t->b : p;
        p = t->c->u < p->u ? t->c : p;
        q = t->a->u > q->u ? t->a : q;
        q = t->b->u > q->u ? t->b : q;
    }
    const int32_t inverse = INT32_MAX / (level ? q->u - p->u : q->v - p->v);
    words *to = level ? &t->dx : &t->dy;
    t->dx = t->dy = (words){ 0, 0, 0 };
    *to = (words){ step_along(q->zi - p->zi, inverse),
                   join(step_along((uint32_t)q->s - (uint32_t)p->s, inverse),
                        step_along((uint32_t)q->t - (uint32_t)p->t, inverse)),
                   join(step_along((uint32_t)(64 * (q->n[1] - p->n[1])), inverse),
                        step_along((uint32_t)(64 * (q->n[0] - p->n[0])), inverse)) };
    t->x_ref = p->u >> 4;
    t->y_ref = p->v >> 4;
    t->base = (words){ p->zi, join((uint32_t)p->s, (uint32_t)p->t),
                       join((uint32_t)(64 * p->n[1]), (uint32_t)(64 * p->n[0])) };
}

/* -- pixels -------------------------------------------------------------------------- */

TP_ALWAYS_INLINE uint32_t pack_light(uint32_t light)
{
    return (light >> 6 & 1023) | light >> 22 << 10;
}

/* Fills `count` samples from `key` on; `outlined` is a literal. */
TP_ALWAYS_INLINE void fill(const triangle *t, uint32_t *key, int32_t count, words now,
                           int outlined)
{
    const ptrdiff_t s = t->tile->s - t->tile->key, n = t->tile->n - t->tile->key,
                    outline = outlined ? t->tile->outline - t->tile->key : 0;

    for (uint32_t *end = key + count; key < end; key++) {
        const uint32_t depth = now.zi << 1 & ~(uint32_t)0xff;
        if (depth > (*key | 0xff)) {
            if (outlined && tp_is_of_outline(key + outline, s, t->mark,
                                             t->tile->outline_shift, depth)) {
                key[outline + n] |= TP_OUTLINE_HIT;
            } else {
                key[0] = depth | t->mark;
                key[s] = now.st;
                key[n] = pack_light(now.light);
            }
        }
        now.zi += t->dx.zi;
        now.st += t->dx.st;
        now.light += t->dx.light;
    }
}

TP_ALWAYS_INLINE void fill_row(const triangle *t, int32_t y, int32_t left, int32_t right,
                               int outlined)
{
    const tp_gbuffer *tile = t->tile;
    const int32_t x = left > tile->x0 ? left : tile->x0,
                  end = right < tile->x1 ? right : tile->x1;
    const uint32_t across = (uint32_t)(x - t->x_ref), down = (uint32_t)(y - t->y_ref);

    if (x >= end)
        return;
    fill(t, tile->key + (size_t)(uint32_t)(y - tile->y0) * tile->stride
                + (uint32_t)(x - tile->x0),
         end - x,
         (words){ t->base.zi + across * t->dx.zi + down * t->dy.zi,
                  t->base.st + across * t->dx.st + down * t->dy.st,
                  t->base.light + across * t->dx.light + down * t->dy.light },
         outlined);
}

/* Fills the rows from y to `stop`; `along` is on row y.  Returns `along` on row `stop`. */
TP_ALWAYS_INLINE tp_edge fill_rows(const triangle *t, int32_t y, int32_t stop,
                                   tp_edge along, tp_edge other, int outlined)
{
    tp_edge_advance(&other, y);
    for (; y < stop; y++) {
        if (t->long_left)
            fill_row(t, y, along.pixel, other.pixel, outlined);
        else
            fill_row(t, y, other.pixel, along.pixel, outlined);
        tp_edge_step(&along);
        tp_edge_step(&other);
    }
    return along;
}

TP_ALWAYS_INLINE void fill_triangle(const triangle *t, int outlined)
{
    const tp_screen_vertex *a = t->a, *b = t->b, *c = t->c;
    const int32_t middle = tp_first_centre(b->v);
    tp_edge along = tp_edge_begin(a->u, a->v, c->u, c->v);
    int32_t y = t->top;

    tp_edge_advance(&along, y);
    if (y < middle) {
        const int32_t stop = middle < t->bottom ? middle : t->bottom;
        along = fill_rows(t, y, stop, along, tp_edge_begin(a->u, a->v, b->u, b->v),
                          outlined);
        y = stop;
    }
    if (y < t->bottom)
        fill_rows(t, y, t->bottom, along, tp_edge_begin(b->u, b->v, c->u, c->v), outlined);
}

/* -- the triangle -------------------------------------------------------------------- */

static bool is_below(int32_t a, int32_t b, int32_t c, int32_t most)
{
    return (int64_t)max3(a, b, c) - min3(a, b, c) < most;
}

/* True if affine s and t are within about 1.5 pixels, by the rule of tp_tri_begin. */
static bool is_affine(const tp_screen_vertex *a, const tp_screen_vertex *b,
                      const tp_screen_vertex *c, int32_t extent)
{
    const int32_t za = (int32_t)a->zi, zb = (int32_t)b->zi, zc = (int32_t)c->zi,
                  low = min3(za, zb, zc), high = max3(za, zb, zc);

    return is_below(a->s, b->s, c->s, REPEATS) && is_below(a->t, b->t, c->t, REPEATS)
           && (uint64_t)(uint32_t)(high - low) * (uint32_t)((extent >> 4) + 1)
              <= 6 * (uint64_t)(uint32_t)low;
}

/* Sorts the vertices of a front side by row. */
static void sort(triangle *t, const tp_screen_vertex *a, const tp_screen_vertex *b,
                 const tp_screen_vertex *c)
{
    tp_tri sorted;

    t->long_left = sort_by_row_flips_winding(&sorted, a, b, c);
    t->a = sorted.a, t->b = sorted.b, t->c = sorted.c;
    t->du1 = t->b->u - t->a->u, t->dv1 = t->b->v - t->a->v;
    t->du2 = t->c->u - t->a->u, t->dv2 = t->c->v - t->a->v;
    t->x_ref = t->a->u >> 4, t->y_ref = t->a->v >> 4;
}

bool tp_tri_solid_fast(const tp_gbuffer *tile, const tp_screen_vertex *a,
                       const tp_screen_vertex *b, const tp_screen_vertex *c, uint32_t mark)
{
    const int32_t left = min3(a->u, b->u, c->u), right = max3(a->u, b->u, c->u),
                  above = min3(a->v, b->v, c->v), below = max3(a->v, b->v, c->v),
                  wide = right - left, high = below - above,
                  extent = wide > high ? wide : high;
    const int32_t top = tp_first_centre(above), bottom = tp_first_centre(below);
    triangle t = { .tile = tile, .mark = mark, .top = top > tile->y0 ? top : tile->y0,
                   .bottom = bottom < tile->y1 ? bottom : tile->y1 };

    if (t.top >= t.bottom || tp_first_centre(right) <= tile->x0
        || tp_first_centre(left) >= tile->x1)
        return true;
    const int64_t area = -tp_tri_twice_area(a, b, c);
    if (area <= 0)
        return true;
    const bool sliver = area < (int64_t)THIN * extent;
    if (!sliver && (extent > LONGEST || !is_affine(a, b, c, extent)))
        return false;
    sort(&t, a, b, c);
    if (area < SMALL && extent < SHORT)
        set_means(&t);
    else if (sliver)
        set_along(&t, wide > high);
    else
        set_planes(&t, (int32_t)(t.long_left ? area : -area));
    if (tile->outline)
        fill_triangle(&t, 1);
    else
        fill_triangle(&t, 0);
    return true;
}
