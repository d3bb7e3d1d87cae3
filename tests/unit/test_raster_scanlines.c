/* SPDX-License-Identifier: MIT */
/* Scanline water compared with a double-precision version, and in tiles of all sizes. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "tests/lib/random.h"
#include "raster/raster.h"
#include "tests/lib/frames.h"

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
static tp_row_point point_at(double u, double depth, double high)
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

static row_field any_field(bool gaps)
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
static void put_solids(test_tile *tile)
{
    const tp_gbuffer *s = &tile->samples;

    for (int32_t y = s->y0; y < s->y1; y++)
        for (int32_t x = s->x0; x < s->x1; x++)
            if ((x / 5 + y / 7) % 3 == 0)
                s->key[tile_at(tile, x, y)]
                    = (uint32_t)(0x08000000 + 0x100 * (x * y % 4000) * 300) | TP_MARK_SOLID;
}

static test_tile walked(const row_field *f, int32_t x0, int32_t y0, int32_t x1, int32_t y1,
                        bool solid)
{
    test_tile tile = tile_of(x0, y0, x1, y1, 3);
    void *memory = malloc(tp_rows_bytes((uint32_t)(x1 - x0)));
    tp_rows rows;

    if (solid)
        put_solids(&tile);
    tp_rows_begin(&rows, &tile.samples, memory, solid);
    for (uint32_t k = 0; k < f->lines; k++) {
        if (f->gap[k])
            tp_rows_restart_line(&rows, f->point[k], f->points, k % 2);
        else
            tp_rows_draw_line(&rows, f->point[k], f->points);
    }
    free(memory);
    return tile;
}

static void assert_same(const test_tile *part, const test_tile *whole)
{
    for (int32_t y = part->samples.y0; y < part->samples.y1; y++) {
        for (int32_t x = part->samples.x0; x < part->samples.x1; x++) {
            const size_t a = tile_at(part, x, y), b = tile_at(whole, x, y);
            assert_int_equal(part->samples.key[a], whole->samples.key[b]);
            if (TP_MARK(part->samples.key[a]) != TP_MARK_WATER)
                continue;
            assert_int_equal(part->samples.s[a], whole->samples.s[b]);
            assert_int_equal(part->samples.t[a], whole->samples.t[b]);
            assert_int_equal(part->samples.n[a], whole->samples.n[b]);
        }
    }
}

static void every_tile_gives_the_same_bits(void **state)
{
    (void)state;
    static const int32_t sizes[][2] = {
        { 16, HEIGHT }, { WIDTH, 1 }, { 32, 9 }, { 48, 32 }
    };

    for (int n = 0; n < 120; n++) {
        const row_field f = any_field(n % 3 == 0);
        const bool solid = n % 2;
        test_tile whole = walked(&f, 0, 0, WIDTH, HEIGHT, solid);
        const int32_t w = sizes[n % 4][0], h = sizes[n % 4][1];
        for (int32_t y = 0; y < HEIGHT; y += h) {
            for (int32_t x = 0; x < WIDTH; x += w) {
                test_tile part = walked(&f, x, y, x + w < WIDTH ? x + w : WIDTH,
                                        y + h < HEIGHT ? y + h : HEIGHT, solid);
                assert_same(&part, &whole);
                tile_free(&part);
            }
        }
        tile_free(&whole);
    }
}

/* -- the same in double precision ------------------------------------------------------ */

typedef struct {
    double v, zi, s, t, nx, nz;
} value;

/* Interpolates by a share f of the distance on the screen; texture coordinates in
 * perspective. */
static value mixed(const value *a, const value *b, double f)
{
    const double zi = a->zi + f * (b->zi - a->zi), g = f * b->zi / zi;

    return (value){ a->v + f * (b->v - a->v), zi, a->s + g * (b->s - a->s),
                    a->t + g * (b->t - a->t), a->nx + f * (b->nx - a->nx),
                    a->nz + f * (b->nz - a->nz) };
}

static value value_of(const tp_row_point *p)
{
    return (value){ p->v / 16.0, p->zi, p->s, p->t, (int16_t)(p->n >> 16),
                    (int16_t)p->n };
}

static value value_at(const row_field *f, uint32_t k, int32_t x)
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

typedef struct {
    double   place, zi, slope;  /* largest errors: pixels, shares, LSB */
    uint32_t pixels, wrong;
} raster_row_errors;

/* Error of a position in pixels down the piece: its difference over the change per row. */
static void judge(raster_row_errors *e, const test_tile *tile, int32_t x, int32_t y,
                  const value *near, const value *far)
{
    const size_t at = tile_at(tile, x, y);
    const double rows = near->v - far->v, f = (y + 0.5 - far->v) / rows;
    const value is = mixed(far, near, f);
    const uint32_t key = tile->samples.key[at], n = tile->samples.n[at];
    const double step = fmax(fabs(near->t - far->t) / rows, 600);

    e->pixels++;
    if (TP_MARK(key) != TP_MARK_WATER) {
        e->wrong++;
        return;
    }
    const double off = fabs((int32_t)tile->samples.t[at] - is.t) / step;
    e->place = off > e->place ? off : e->place;
    const double zi = fabs(TP_ZI(key) - is.zi) / is.zi;
    e->zi = zi > e->zi ? zi : e->zi;
    const double nx = fabs((int16_t)(n >> 16) - is.nx), nz = fabs((int16_t)n - is.nz);
    e->slope = fmax(e->slope, fmax(nx, nz));
}

static void lines_are_drawn_as_in_double_precision(void **state)
{
    (void)state;
    raster_row_errors e = { 0 };

    for (int n = 0; n < 200; n++) {
        const row_field f = any_field(false);
        test_tile tile = walked(&f, 0, 0, WIDTH, HEIGHT, false);
        for (int32_t x = 0; x < WIDTH; x++) {
            double  horizon = 1e9;
            value near = value_at(&f, 0, x);
            horizon = near.v;
            for (uint32_t k = 1; k < f.lines; k++) {
                const value far = value_at(&f, k, x);
                for (int32_t y = 0; y < HEIGHT; y++)     /* skips pixels at edges */
                    if (y + 0.5 > far.v + 0.02 && y + 0.5 < horizon - 0.02
                        && near.v - far.v > 0.52)
                        judge(&e, &tile, x, y, &near, &far);
                horizon = far.v < horizon ? far.v : horizon;
                near = far;
            }
            for (int32_t y = 0; y < HEIGHT; y++)
                if (y + 0.5 < horizon - 0.02)
                    e.wrong += tile.samples.key[tile_at(&tile, x, y)] != 0;
        }
        tile_free(&tile);
    }
    printf("  %u pixels: places off by %.3f pixels, 1/z by %.5f, slopes by %.1f LSB\n",
           e.pixels, e.place, e.zi, e.slope);
    assert_true(e.pixels > 200000);
    assert_int_equal(e.wrong, 0);
    assert_true(e.place < 1.5);         /* half a pixel along the line, half down */
    assert_true(e.zi < 0.008);
    assert_true(e.slope < 300);         /* slopes span 18000; 1 or 2 px */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tile_gives_the_same_bits),
        cmocka_unit_test(lines_are_drawn_as_in_double_precision),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("raster/scanlines", tests, NULL, NULL);
}
