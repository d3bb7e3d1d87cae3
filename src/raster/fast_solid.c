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
    SHORT   = 8 * 16,           /* side of the box of a small triangle, 28.4, */
    CENTRES = 9,                /* and number of pixels in it */
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
    ptrdiff_t to_s, to_n, to_outline;   /* from a key to words of the other planes */
    int     window;             /* see tp_gbuffer.outline_shift */
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
    p->base = (uint32_t)p->at + (uint32_t)(((int64_t)dx * u + (int64_t)dy * v) >> 4);
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
static uint32_t find_length_step(uint32_t d, int32_t inverse)
{
    return (uint32_t)((int64_t)(int32_t)d * inverse >> 27);
}

/* Sets planes that change along the longer axis of a sliver alone, from one end to the
 * other.  s and t may differ by any number of repeats. */
static void set_length_planes(triangle *t, bool level)
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
    *to = (words){ find_length_step(q->zi - p->zi, inverse),
                   join(find_length_step((uint32_t)q->s - (uint32_t)p->s, inverse),
                        find_length_step((uint32_t)q->t - (uint32_t)p->t, inverse)),
                   join(find_length_step((uint32_t)(64 * (q->n[1] - p->n[1])), inverse),
                        find_length_step((uint32_t)(64 * (q->n[0] - p->n[0])), inverse)) };
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
    const ptrdiff_t s = t->to_s, n = t->to_n, outline = t->to_outline;
    const words step = t->dx;
    const uint32_t mark = t->mark;

    for (uint32_t *end = key + count; key < end; key++) {
        const uint32_t depth = now.zi << 1 & ~(uint32_t)0xff;
        if (depth > (*key | 0xff)) {
            if (outlined && tp_is_of_outline(key + outline, s, mark, t->window, depth)) {
                key[outline + n] |= TP_OUTLINE_HIT;
            } else {
                key[0] = depth | mark;
                key[s] = now.st;
                key[n] = pack_light(now.light);
            }
        }
        now.zi += step.zi;
        now.st += step.st;
        now.light += step.light;
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
        const int32_t left = t->long_left ? along.pixel : other.pixel;
        const int32_t right = t->long_left ? other.pixel : along.pixel;
        fill_row(t, y, left, right, outlined);
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

/* -- triangles of a few pixels ------------------------------------------------------- */

/* The pixels of a box that may be covered, clipped to the tile. */
typedef struct {
    int32_t x0, y0, x1, y1;
} pixels;

/* Twice the area between an edge and a pixel's centre: not negative inside.  A centre on
 * the edge belongs to the triangle on its right, or below. */
typedef struct {
    int32_t at, dx, dy;
} side;

/* Coordinates are within 2^8 of the box's corner, so products are below 2^18. */
TP_ALWAYS_INLINE side make_side(const tp_screen_vertex *p, const tp_screen_vertex *q,
                                int32_t x, int32_t y)
{
    const int32_t du = q->u - p->u, dv = q->v - p->v;
    const bool open = dv > 0 || (dv == 0 && du < 0);

    return (side){ du * (16 * y + 8 - p->v) - dv * (16 * x + 8 - p->u) - open, -16 * dv,
                   16 * du };
}

TP_ALWAYS_INLINE void fill_box(const triangle *t, const pixels *box, int outlined)
{
    const tp_gbuffer *tile = t->tile;
    uint32_t *row = tile->key + (size_t)(uint32_t)(box->y0 - tile->y0) * tile->stride
                  + (uint32_t)(box->x0 - tile->x0);
    side ac = make_side(t->a, t->c, box->x0, box->y0),
         cb = make_side(t->c, t->b, box->x0, box->y0),
         ba = make_side(t->b, t->a, box->x0, box->y0);

    for (int32_t y = box->y0; y < box->y1; y++, row += tile->stride) {
        int32_t e = ac.at, f = cb.at, g = ba.at;
        for (int32_t i = 0; i < box->x1 - box->x0; i++) {
            if ((e | f | g) >= 0)
                fill(t, row + i, 1, t->base, outlined);
            e += ac.dx;
            f += cb.dx;
            g += ba.dx;
        }
        ac.at += ac.dy;
        cb.at += cb.dy;
        ba.at += ba.dy;
    }
}

/* -- the triangle -------------------------------------------------------------------- */

static bool spans_less(int32_t a, int32_t b, int32_t c, int32_t most)
{
    return (int64_t)max3(a, b, c) - min3(a, b, c) < most;
}

/* True if affine s and t are within about 1.5 pixels, by the rule of tp_tri_begin. */
static bool is_affine(const tp_screen_vertex *a, const tp_screen_vertex *b,
                      const tp_screen_vertex *c, int32_t extent)
{
    const int32_t za = (int32_t)a->zi, zb = (int32_t)b->zi, zc = (int32_t)c->zi,
                  low = min3(za, zb, zc), high = max3(za, zb, zc);

    return spans_less(a->s, b->s, c->s, REPEATS) && spans_less(a->t, b->t, c->t, REPEATS)
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

static void draw_small(triangle *t, const pixels *box)
{
    set_means(t);
    if (t->tile->outline)
        fill_box(t, box, 1);
    else
        fill_box(t, box, 0);
}

static void draw_large(triangle *t, int64_t area, int32_t wide, int32_t high)
{
    sort(t, t->a, t->b, t->c);
    if (area < (int64_t)THIN * (wide > high ? wide : high))
        set_length_planes(t, wide > high);
    else
        set_planes(t, (int32_t)(t->long_left ? area : -area));
    if (t->tile->outline)
        fill_triangle(t, 1);
    else
        fill_triangle(t, 0);
}

bool tp_tri_solid_fast(const tp_gbuffer *tile, const tp_screen_vertex *a,
                       const tp_screen_vertex *b, const tp_screen_vertex *c, uint32_t mark)
{
    const int32_t left = min3(a->u, b->u, c->u), right = max3(a->u, b->u, c->u),
                  above = min3(a->v, b->v, c->v), below = max3(a->v, b->v, c->v),
                  wide = right - left, high = below - above,
                  extent = wide > high ? wide : high;
    const pixels box = { tp_first_centre(left), tp_first_centre(above),
                         tp_first_centre(right), tp_first_centre(below) };
    const pixels seen = { box.x0 > tile->x0 ? box.x0 : tile->x0,
                          box.y0 > tile->y0 ? box.y0 : tile->y0,
                          box.x1 < tile->x1 ? box.x1 : tile->x1,
                          box.y1 < tile->y1 ? box.y1 : tile->y1 };

    if (seen.x0 >= seen.x1 || seen.y0 >= seen.y1)
        return true;
    const int64_t area = -tp_tri_twice_area(a, b, c);
    if (area <= 0)
        return true;
    triangle t;
    t.tile = tile, t.mark = mark, t.window = tile->outline_shift;
    t.a = a, t.b = b, t.c = c;
    t.top = seen.y0, t.bottom = seen.y1;
    t.to_s = tile->s - tile->key, t.to_n = tile->n - tile->key;
    t.to_outline = tile->outline ? tile->outline - tile->key : 0;
    if (extent <= SHORT && (box.x1 - box.x0) * (box.y1 - box.y0) <= CENTRES) {
        draw_small(&t, &seen);
        return true;
    }
    if (area >= (int64_t)THIN * extent
        && (extent > LONGEST || !is_affine(a, b, c, extent)))
        return false;
    draw_large(&t, area, wide, high);
    return true;
}
