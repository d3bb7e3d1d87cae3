/* SPDX-License-Identifier: MIT */
/* Planes of s and t, and their perspective in large triangles: s and t are exact every
 * TP_SPAN_STEP pixels (at multiples and at the ends of the row) and linear between.
 * src/raster/span.c alone includes this file. */
#ifndef TP_RASTER_PERSPECTIVE_H
#define TP_RASTER_PERSPECTIVE_H
#include "raster/tri_begin.h"

/* Return the plane of s or t, as tp_tri_gradient does for other quantities.  Differences
 * have up to 33 bits, in few triangles more than 32: each product has 33 + 29 bits, their
 * sum 63. */
TP_NEVER_INLINE tp_gradient gradient_far(const tp_tri *tri, int32_t at_a, int64_t d1,
                                         int64_t d2)
{
    return tp_tri_gradient_scale(tri, at_a, d1 * tri->cx1 + d2 * tri->cx2,
                                 d1 * tri->cy1 + d2 * tri->cy2, 0);
}

TP_ALWAYS_INLINE tp_gradient gradient_wide(const tp_tri *tri, int32_t at_a, int32_t at_b,
                                           int32_t at_c)
{
    const int64_t d1 = (int64_t)at_b - at_a, d2 = (int64_t)at_c - at_a;

    if (d1 == (int32_t)d1 && d2 == (int32_t)d2)
        return tp_tri_gradient(tri, at_a, (int32_t)d1, (int32_t)d2, 0);
    return gradient_far(tri, at_a, d1, d2);
}

/* Additional fraction bits of w, s w and t w. */
#define TP_PERSPECTIVE_BITS 8

/* Gradients of w = zi, scaled to 29 bits at the nearest vertex, and of s w and t w; s and
 * t are relative to the first vertex. */
typedef struct {
    tp_gradient w, sw, tw;
    uint32_t    s0, t0;
} tp_perspective;

static int32_t times_w(int32_t d, uint32_t w_q29)
{
    return (int32_t)((int64_t)d * w_q29 >> 29);
}

/* Returns tp_tri_gradient of a quantity's three values.  Called, not inlined: large triangles
 * are few. */
TP_NEVER_INLINE tp_gradient large_gradient(const tp_tri *tri, const int32_t at[3], int bits)
{
    return tp_tri_gradient(tri, at[0], at[1] - at[0], at[2] - at[0], bits);
}

static tp_perspective make_perspective(const tp_tri *tri)
{
    const tp_screen_vertex *p[3] = { tri->a, tri->b, tri->c };
    uint32_t near = p[0]->zi | p[1]->zi | p[2]->zi;
    int      shift = tp_clz(near) - 3;
    int32_t  w[3], sw[3], tw[3];

    for (int i = 0; i < 3; i++) {
        uint32_t wi = shift >= 0 ? p[i]->zi << shift : p[i]->zi >> -shift;
        w[i] = (int32_t)wi;
        sw[i] = times_w(p[i]->s - p[0]->s, wi);
        tw[i] = times_w(p[i]->t - p[0]->t, wi);
    }
    return (tp_perspective){
        .w = large_gradient(tri, w, TP_PERSPECTIVE_BITS),
        .sw = large_gradient(tri, sw, TP_PERSPECTIVE_BITS),
        .tw = large_gradient(tri, tw, TP_PERSPECTIVE_BITS),
        .s0 = (uint32_t)p[0]->s,
        .t0 = (uint32_t)p[0]->t,
    };
}

static int64_t evaluate_gradient(const tp_gradient *g, int32_t dx, int32_t dy)
{
    return g->base + g->dx * dx + g->dy * dy;
}

/* Returns s = sw / w in 16.16.  With w = n / 2^29, 1/n = r 2^shift / 2^63 and
 * TP_PERSPECTIVE_BITS more bits in sw, s = sw r 2^(shift - 42).  |sw| < 2^39 and r < 2^33;
 * the product is split into halves to stay within 64 bits. */
static uint32_t divide_by_w(int64_t sw, uint32_t r, int shift)
{
    int64_t q = (sw >> 16) * (int64_t)r
              + (int64_t)(((uint64_t)sw & 0xffff) * r >> 16);
    int     back = 26 - shift;
    return back >= 0 ? (uint32_t)(q >> back) : (uint32_t)q << -back;
}

typedef struct {
    uint32_t s, t;
} span_st;

static span_st evaluate_st(const tp_perspective *p, const tp_tri *tri, int32_t x,
                           int32_t y)
{
    int32_t dx = x - tri->x_ref, dy = y - tri->y_ref;
    int64_t w = evaluate_gradient(&p->w, dx, dy) >> TP_PERSPECTIVE_BITS;
    uint32_t n = w < 1 ? 1 : (uint32_t)w;       /* rounding may give 0 for a far w */
    int      shift = tp_clz(n);
    uint32_t r = tp_recip_norm(n << shift);

    return (span_st){
        p->s0 + divide_by_w(evaluate_gradient(&p->sw, dx, dy), r, shift),
        p->t0 + divide_by_w(evaluate_gradient(&p->tw, dx, dy), r, shift),
    };
}

static uint32_t texture_coordinate_step(uint32_t from, uint32_t to, int32_t n)
{
    return (uint32_t)((int64_t)(int32_t)(to - from) * tp_span_over[n] >> 16);
}

#endif
