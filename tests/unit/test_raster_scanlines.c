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
#include "tests/lib/row_fields.h"

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
