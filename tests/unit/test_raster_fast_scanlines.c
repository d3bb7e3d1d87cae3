/* SPDX-License-Identifier: MIT */
/* Fast scanline water: in tiles of all sizes, with keys and without, and compared with a
 * double-precision version. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "raster/fast_scanlines.h"
#include "tests/lib/row_fields.h"

typedef struct {
    int32_t x0, y0, x1, y1;
} tile_box;

/* A line's depth is that of its middle. */
static tp_line_scale scale_of(const row_field *f, uint32_t k)
{
    const tp_row_point *p = f->point[k];
    return (tp_line_scale){ p[f->points / 2].zi, 300 + (int32_t)k, -40 };
}

/* A drawn tile; without keys, its rows and whether it has holes. */
typedef struct {
    test_tile     tile;
    tp_water_rows found;
    bool          holes;
    uint8_t       water[WIDTH * HEIGHT];
} drawn;

static drawn walk(const row_field *f, tile_box box, int column_bits, bool keyed,
                  bool solid)
{
    drawn d = { .tile = tile_of(box.x0, box.y0, box.x1, box.y1, 3) };
    void *memory = malloc(tp_fast_rows_bytes((uint32_t)(box.x1 - box.x0), column_bits));
    tp_fast_rows rows;

    if (solid)
        put_solids(&d.tile);
    tp_fast_rows_begin(&rows, &d.tile.samples, memory, column_bits, keyed);
    rows.solid = solid;
    for (uint32_t k = 0; k < f->lines; k++) {
        const tp_line_scale scale[2] = { scale_of(f, k), scale_of(f, k > 0 ? k - 1 : 0) };
        tp_fast_rows_begin_line(&rows, scale);
        for (uint32_t i = 1; i < f->points; i++)
            tp_fast_rows_lay(&rows, &f->point[k][i - 1], &f->point[k][i]);
        tp_fast_rows_end_line(&rows, !f->gap[k] ? TP_LINE_ON
                                     : k % 2    ? TP_LINE_BEHIND_TRIANGLES
                                                : TP_LINE_BEHIND_GAP);
    }
    d.found = tp_fast_rows_found(&rows);
    d.holes = rows.holes;
    for (int32_t y = box.y0; y < box.y1; y++)
        for (int32_t x = box.x0; x < box.x1; x++)
            d.water[y * WIDTH + x] = tp_fast_rows_is_water(&rows, x, y);
    free(memory);
    return d;
}

static const tile_box whole_box = { 0, 0, WIDTH, HEIGHT };

static void assert_same(const drawn *part, const drawn *whole, bool keys)
{
    const tp_gbuffer *s = &part->tile.samples;

    for (int32_t y = s->y0; y < s->y1; y++) {
        for (int32_t x = s->x0; x < s->x1; x++) {
            const size_t a = tile_at(&part->tile, x, y), b = tile_at(&whole->tile, x, y);
            if (keys)
                assert_int_equal(s->key[a], whole->tile.samples.key[b]);
            if (TP_MARK(whole->tile.samples.key[b]) != TP_MARK_WATER)
                continue;
            assert_int_equal(s->s[a], whole->tile.samples.s[b]);
            assert_int_equal(s->t[a], whole->tile.samples.t[b]);
            assert_int_equal(s->n[a], whole->tile.samples.n[b]);
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
        const int bits = 4 + n / 2 % 2;
        drawn whole = walk(&f, whole_box, bits, true, solid);
        const int32_t w = sizes[n % 4][0], h = sizes[n % 4][1];
        for (int32_t y = 0; y < HEIGHT; y += h) {
            for (int32_t x = 0; x < WIDTH; x += w) {
                const tile_box box = { x, y, x + w < WIDTH ? x + w : WIDTH,
                                            y + h < HEIGHT ? y + h : HEIGHT };
                drawn part = walk(&f, box, bits, true, solid);
                assert_same(&part, &whole, true);
                tile_free(&part.tile);
            }
        }
        tile_free(&whole.tile);
    }
}

/* Without keys the water reaches down from the limit; rows beyond both bounds are alike. */
static void tiles_without_keys_have_the_same_samples(void **state)
{
    (void)state;
    int holes = 0, sky = 0, water = 0;

    for (int n = 0; n < 200; n++) {
        const row_field f = any_field(n % 4 == 0);
        const int32_t y0 = chance_int(&chance, 0, HEIGHT - 9);
        const tile_box box = { n % 2 * 32, y0, WIDTH, y0 + 1 + n % 8 };
        drawn with = walk(&f, box, 4 + n / 2 % 2, true, false);
        drawn without = walk(&f, box, 4 + n / 2 % 2, false, false);
        holes += without.holes;
        for (int32_t y = box.y0; !without.holes && y < box.y1; y++) {
            sky += y < without.found.sky_end;
            water += y >= without.found.water_begin;
            for (int32_t x = box.x0; x < box.x1; x++) {
                const size_t at = tile_at(&with.tile, x, y);
                const bool is = TP_MARK(with.tile.samples.key[at]) == TP_MARK_WATER;
                assert_int_equal(without.water[y * WIDTH + x], is);
                assert_true(y >= without.found.sky_end || !is);
                assert_true(y < without.found.water_begin || is);
                assert_int_equal(without.tile.samples.key[at], 0);
            }
        }
        if (!without.holes)
            assert_same(&without, &with, false);
        tile_free(&with.tile);
        tile_free(&without.tile);
    }
    printf("  %d tiles with holes, %d rows of sky, %d of water\n", holes, sky, water);
    assert_true(holes > 3 && sky > 20 && water > 20);
}

/* A gap above the lower edge of a tile is a hole; a line below the tile is none. */
static void a_tile_without_lines_is_sky(void **state)
{
    (void)state;
    row_field f = any_field(false);
    const tile_box top = { 0, 0, WIDTH, 2 };

    f.lines = 0;
    drawn none = walk(&f, whole_box, 4, false, false);
    assert_false(none.holes);
    assert_int_equal(none.found.sky_end, HEIGHT);
    assert_int_equal(none.found.water_begin, HEIGHT);
    tile_free(&none.tile);
    f.lines = 1;
    drawn below = walk(&f, top, 5, false, false);
    assert_false(below.holes);
    assert_int_equal(below.found.sky_end, 2);
    tile_free(&below.tile);
}

/* Largest errors: shares of the way between the lines, of 1/z, LSB. */
typedef struct {
    double   place, zi, slope;
    uint32_t pixels, wrong;
} errors;

static void judge(errors *e, const test_tile *tile, int32_t x, int32_t y, const value *near,
                  const value *far)
{
    const size_t at = tile_at(tile, x, y);
    const double rows = near->v - far->v, f = (y + 0.5 - far->v) / rows;
    const value is = mixed(far, near, f);
    const uint32_t key = tile->samples.key[at], n = tile->samples.n[at];

    e->pixels++;
    e->wrong += TP_MARK(key) != TP_MARK_WATER;
    const double off = fabs((int32_t)tile->samples.t[at] - is.t)
                     / fmax(fabs(near->t - far->t), fabs(is.t) / 16);
    e->place = fmax(e->place, off);
    e->zi = fmax(e->zi, fabs(TP_ZI(key) - is.zi) / is.zi);
    e->slope = fmax(e->slope, fmax(fabs((int16_t)(n >> 16) - is.nx),
                                   fabs((int16_t)n - is.nz)));
}

static void lines_are_drawn_as_in_double_precision(void **state)
{
    (void)state;
    errors e = { .pixels = 0 };

    for (int n = 0; n < 200; n++) {
        const row_field f = any_field(false);
        drawn d = walk(&f, whole_box, 4, true, false);
        for (int32_t x = 0; x < WIDTH; x++) {
            value  near = value_at(&f, 0, x);
            double horizon = near.v;
            for (uint32_t k = 1; k < f.lines; k++) {
                const value far = value_at(&f, k, x);
                for (int32_t y = 0; y < HEIGHT; y++)     /* skips pixels at edges */
                    if (y + 0.5 > far.v + 0.02 && y + 0.5 < horizon - 0.02
                        && near.v - far.v > 0.52)
                        judge(&e, &d.tile, x, y, &near, &far);
                horizon = far.v < horizon ? far.v : horizon;
                near = far;
            }
        }
        tile_free(&d.tile);
    }
    printf("  %u pixels: places off by %.3f of the way between lines, 1/z by %.5f, slopes by "
           "%.1f LSB\n", e.pixels, e.place, e.zi, e.slope);
    assert_true(e.pixels > 200000);
    assert_int_equal(e.wrong, 0);
    assert_true(e.place < 0.08);
    assert_true(e.zi < 0.008);
    assert_true(e.slope < 300);         /* slopes span 18000; 1 or 2 px */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tile_gives_the_same_bits),
        cmocka_unit_test(tiles_without_keys_have_the_same_samples),
        cmocka_unit_test(a_tile_without_lines_is_sky),
        cmocka_unit_test(lines_are_drawn_as_in_double_precision),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("raster/fast_scanlines", tests, NULL, NULL);
}
