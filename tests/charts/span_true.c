/* SPDX-License-Identifier: MIT */
/* Texture place of a pixel in a triangle in double precision: with barycentric weights w on
 * the screen, s = sum w zi s / sum w zi. */
#include "tests/charts/span_true.h"

#if !__STDC_HOSTED__
void span_true(const tp_gbuffer *tile, const tp_screen_vertex *a, const tp_screen_vertex *b,
               const tp_screen_vertex *c, span_draw *exact)
{
    exact(tile, a, b, c);
}
#else
#include <math.h>
#include <string.h>

enum { MOST = 640 * 480 };        /* pixels of a tile, at most */

static uint32_t before[MOST];

/* Twice the area of two vertices and a point, 28.4. */
static double area(const tp_screen_vertex *a, const tp_screen_vertex *b, double u, double v)
{
    return ((double)b->u - a->u) * (v - a->v) - (u - a->u) * ((double)b->v - a->v);
}

static uint32_t moved(int32_t from, double by)
{
    return (uint32_t)from + (uint32_t)(int32_t)lround(by);
}

/* Writes s and t of a pixel. Differences of s and t wrap, like the engine's. */
static void put(const tp_gbuffer *tile, size_t at, const tp_screen_vertex *const p[3],
                double u, double v)
{
    double sum = 0, s = 0, t = 0;

    for (int i = 0; i < 3; i++) {
        const double w = area(p[(i + 1) % 3], p[(i + 2) % 3], u, v) * p[i]->zi;
        sum += w;
        s += w * (int32_t)((uint32_t)p[i]->s - (uint32_t)p[0]->s);
        t += w * (int32_t)((uint32_t)p[i]->t - (uint32_t)p[0]->t);
    }
    tile->s[at] = moved(p[0]->s, s / sum);
    tile->t[at] = moved(p[0]->t, t / sum);
}

static int32_t least(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static int32_t most(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

void span_true(const tp_gbuffer *tile, const tp_screen_vertex *a, const tp_screen_vertex *b,
               const tp_screen_vertex *c, span_draw *exact)
{
    const tp_screen_vertex *const p[3] = { a, b, c };
    const int32_t x0 = most(least(least(a->u, b->u), c->u) >> 4, tile->x0);
    const int32_t y0 = most(least(least(a->v, b->v), c->v) >> 4, tile->y0);
    const int32_t x1 = least((most(most(a->u, b->u), c->u) >> 4) + 1, tile->x1);
    const int32_t y1 = least((most(most(a->v, b->v), c->v) >> 4) + 1, tile->y1);
    const size_t rows = (size_t)(tile->y1 - tile->y0);

    TP_ASSERT(rows * tile->stride <= MOST);
    memcpy(before, tile->key, rows * tile->stride * sizeof *before);
    exact(tile, a, b, c);
    for (int32_t y = y0; y < y1; y++)
        for (int32_t x = x0; x < x1; x++) {
            const size_t at = (size_t)(y - tile->y0) * tile->stride
                            + (size_t)(x - tile->x0);
            if (tile->key[at] != before[at])
                put(tile, at, p, 16 * x + 8, 16 * y + 8);
        }
}
#endif
