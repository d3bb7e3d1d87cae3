/* SPDX-License-Identifier: MIT */
/* A triangle without approximation: the fill rule in exact integers, the sample values in
 * double precision. raster.h states the rule at its head. */
#ifndef TP_REFERENCE_TRIANGLE_H
#define TP_REFERENCE_TRIANGLE_H
#include <math.h>
#include "raster/raster.h"

/* The first pixel whose centre lies at or right of the edge's intersection with row y: the
 * least x with 16 x + 8 >= u0 + (u1 - u0) (16 y + 8 - v0) / (v1 - v0). */
static inline int64_t ref_edge_pixel(const tp_screen_vertex *a, const tp_screen_vertex *b,
                                     int32_t y)
{
    const int64_t dv = (int64_t)b->v - a->v, du = (int64_t)b->u - a->u;
    const int64_t sign = dv < 0 ? -1 : 1;
    const int64_t over = sign * ((a->u - 8) * dv + du * (16 * (int64_t)y + 8 - a->v));
    const int64_t by = 16 * dv * sign;
    return over >= 0 ? (over + by - 1) / by : -(-over / by);
}

/* Pixels [*left, *right) of row y inside the triangle. */
static inline void ref_fill_row(const tp_screen_vertex *const corner[3], int32_t y,
                                int64_t *left, int64_t *right)
{
    int64_t x[2] = { 0, 0 };
    int found = 0;

    for (int i = 0; i < 3; i++) {
        const tp_screen_vertex *a = corner[i], *b = corner[(i + 1) % 3];
        const int32_t top = a->v < b->v ? a->v : b->v, bottom = a->v < b->v ? b->v : a->v;
        if (top <= 16 * y + 8 && 16 * y + 8 < bottom)
            x[found++] = ref_edge_pixel(a, b, y);
    }
    *left = x[0] < x[1] ? x[0] : x[1];
    *right = x[0] < x[1] ? x[1] : x[0];
}

/* Barycentric weights of the three vertices at the centre of pixel (x, y); their sum is
 * 1. */
static inline void ref_shares(const tp_screen_vertex *const c[3], int32_t x, int32_t y,
                              double share[3])
{
    const double px = 16.0 * x + 8, py = 16.0 * y + 8;
    double sum = 0;

    for (int i = 0; i < 3; i++) {
        const tp_screen_vertex *a = c[(i + 1) % 3], *b = c[(i + 2) % 3];
        share[i] = (b->u - a->u) * (py - a->v) - (px - a->u) * (double)(b->v - a->v);
        sum += share[i];
    }
    for (int i = 0; i < 3; i++)
        share[i] /= sum;
}

/* Perspective-correct zi, s and t, and the first two numbers of the normal. */
typedef struct {
    double zi, s, t, n[3];
} ref_sample;

static inline ref_sample ref_sample_at(const tp_screen_vertex *const c[3], int32_t x,
                                       int32_t y)
{
    double share[3];
    ref_sample r = { 0 };

    ref_shares(c, x, y, share);
    for (int i = 0; i < 3; i++) {
        r.zi += share[i] * c[i]->zi;
        r.s += share[i] * c[i]->zi * c[i]->s;
        r.t += share[i] * c[i]->zi * c[i]->t;
        for (int k = 0; k < 3; k++)
            r.n[k] += share[i] * c[i]->n[k];
    }
    r.s /= r.zi;
    r.t /= r.zi;
    return r;
}
#endif
