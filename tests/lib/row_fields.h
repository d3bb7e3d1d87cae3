/* SPDX-License-Identifier: MIT */
/* Random fields of lines of water for the scanline rasterizers, and their values in double
 * precision. */
#ifndef TP_TESTS_LIB_ROW_FIELDS_H
#define TP_TESTS_LIB_ROW_FIELDS_H
#include <math.h>
#include "raster/raster.h"
#include "tests/lib/frames.h"
#include "tests/lib/random.h"

enum { WIDTH = 96, HEIGHT = 80, LINES = 30, POINTS = 24 };

static uint64_t chance;

/* A field seen from above: lines at growing depths, with points displaced up and down. */
typedef struct {
    uint32_t lines, points;
    tp_row_point point[LINES][POINTS];
    bool     gap[LINES];        /* nothing is drawn before the line */
} row_field;

/* Depth d is 1 / zi of a plane with its horizon at row 4; s is proportional to u d, t to
 * d. */
static inline tp_row_point point_at(double u, double depth, double high)
{
    const double s = (u - WIDTH / 2) * depth / 60;

    return (tp_row_point){
        .u = (int32_t)lround(16 * u), .v = (int32_t)lround(16 * (4 + (220 - high) / depth)),
        .zi = (uint32_t)lround(2147483648.0 / depth),
        .s = (int32_t)lround(65536 * s), .t = (int32_t)lround(-65536 * depth),
        .n = (uint32_t)chance_int(&chance, -9000, 9000) << 16
           | (uint16_t)chance_int(&chance, -9000, 9000),
    };
}

static inline row_field any_field(bool gaps)
{
    row_field f = { .lines = 4 + random_below(&chance, LINES - 3),
                    .points = 2 + random_below(&chance, POINTS - 1) };
    double depth = chance_double(&chance, 1.2, 2.2);
    double wild = chance_double(&chance, 0, 40);

    for (uint32_t k = 0; k < f.lines; k++) {
        double u = -1 - chance_double(&chance, 0, 90);
        const double wide = (WIDTH + 2 - u) / (f.points - 1) * 1.1 + 0.2;
        for (uint32_t i = 0; i < f.points; i++) {
            const double high = chance_double(&chance, -wild, wild);
            f.point[k][i] = point_at(u, depth * chance_double(&chance, 1, 1.02), high);
            u += chance_double(&chance, 0.7, 1) * wide;
        }
        if (f.point[k][f.points - 1].u < 16 * (WIDTH + 1))
            f.point[k][f.points - 1].u = 16 * (WIDTH + 1);
        f.gap[k] = k == 0 || (gaps && random_below(&chance, 6) == 0);
        depth *= chance_double(&chance, 1.03, 1.4);
    }
    return f;
}

/* Samples in the tile before the water, the same in every tile. */
static inline void put_solids(test_tile *tile)
{
    const tp_gbuffer *s = &tile->samples;

    for (int32_t y = s->y0; y < s->y1; y++)
        for (int32_t x = s->x0; x < s->x1; x++)
            if ((x / 5 + y / 7) % 3 == 0)
                s->key[tile_at(tile, x, y)]
                    = (uint32_t)(0x08000000 + 0x100 * (x * y % 4000) * 300) | TP_MARK_SOLID;
}

/* -- in double precision ------------------------------------------------------------- */

typedef struct {
    double v, zi, s, t, nx, nz;
} value;

/* Interpolates by a share f of the distance on the screen; texture coordinates in
 * perspective. */
static inline value mixed(const value *a, const value *b, double f)
{
    const double zi = a->zi + f * (b->zi - a->zi), g = f * b->zi / zi;

    return (value){ a->v + f * (b->v - a->v), zi, a->s + g * (b->s - a->s),
                    a->t + g * (b->t - a->t), a->nx + f * (b->nx - a->nx),
                    a->nz + f * (b->nz - a->nz) };
}

static inline value value_of(const tp_row_point *p)
{
    return (value){ p->v / 16.0, p->zi, p->s, p->t, (int16_t)(p->n >> 16),
                    (int16_t)p->n };
}

static inline value value_at(const row_field *f, uint32_t k, int32_t x)
{
    for (uint32_t i = 1; i < f->points; i++) {
        const tp_row_point *a = &f->point[k][i - 1], *b = &f->point[k][i];
        if (a->u <= 16 * x + 8 && 16 * x + 8 < b->u) {
            const value va = value_of(a), vb = value_of(b);
            return mixed(&va, &vb, (16 * x + 8 - a->u) / (double)(b->u - a->u));
        }
    }
    abort();
}
#endif
