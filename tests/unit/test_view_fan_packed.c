/* SPDX-License-Identifier: MIT */
/* Vertices of a fan by packed sines and by fewer swells: close to the exact vertices, the same
 * in every part of a row, and the same picture in every tiling. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "frame/frame.h"
#include "tests/lib/fan_rungs.h"

/* -- vertices ------------------------------------------------------------------------ */

/* Returns the part of the largest displacement that a place's error is, 1 / 65536, beyond
 * half a unit for each column. */
static int32_t place_share(const fan_sea *s, int32_t error)
{
    const tp_deep_water *d = &s->deep;
    const int64_t most = d->max_displacement > d->height ? d->max_displacement : d->height;
    const int64_t over = (int64_t)error - s->grid.cols / 2 - 6;

    return over <= 0 ? 0 : (int32_t)(over * 65536 / (most + 1));
}

/* Returns the errors over 40 seas of 0 to 6 swells. */
static errors errors_of(const struct tp_draw_fast_waves *by, bool plain_normals)
{
    errors e = { 0 };

    for (int n = 0; n < 40; n++) {
        fan_sea s;
        fan_sea_lay_out(&s, n % 7, &chance);
        s.grid.plain_normals = plain_normals;
        for (uint32_t j = 0; j < s.grid.rows; j += 3) {
            e.place = 0;
            compare_row(&s, by, j, 2048, &e); /* slopes up to 1/2 */
            raise(&e.share, place_share(&s, e.place));
        }
        free(s.block);
    }
    assert_true(e.count > 7000 && e.steep < e.count / 3);
    return e;
}

/* Returns the rms of the slopes' errors, 1 / 4096. */
static int32_t rms(const errors *e)
{
    return (int32_t)tp_isqrt64(e->squares / (2 * (e->count - e->steep)));
}

static void report(const char *name, const errors *e)
{
    printf("  %s: places within %d / 65536 of the waves, slopes %d / 4096, rms %d\n", name,
           (int)e->share, (int)e->slope, (int)rms(e));
}

/* The bounds are 1.3 times the largest of 120 runs: slopes 9, places by the table 392, plain
 * normals 241; steep random seas vary much. */
static void packed_vertices_are_close_to_the_exact_ones(void **state)
{
    (void)state;
    const errors e = errors_of(&tp_draw_packed_waves.by, false);
    report("packed", &e);
    assert_in_range(e.share, 0, 16);
    assert_in_range(e.slope, 0, 12);
}

static void table_vertices_err_by_the_table_step(void **state)
{
    (void)state;
    const errors e = errors_of(&tp_draw_table_waves.by, false);
    report("table", &e);
    assert_in_range(e.share, 1, 510);
    assert_in_range(rms(&e), 0, 4);
}

static void plain_normals_leave_places_as_they_are(void **state)
{
    (void)state;
    const errors e = errors_of(&tp_draw_packed_waves.by, true);
    report("plain normals", &e);
    assert_in_range(e.share, 0, 16);
    assert_in_range(rms(&e), 1, 313);
}

static void level_water_has_no_slopes(void **state)
{
    static tp_grid_vertex row[MOST];

    (void)state;
    for (int n = 0; n < 20; n++) {
        fan_sea s;
        fan_sea_lay_out(&s, 0, &chance);
        s.grid.waves = n & 1 ? &tp_draw_table_waves.by : &tp_draw_packed_waves.by;
        s.grid.plain_normals = n & 2;
        for (uint32_t j = 0; j < s.grid.rows; j += 5) {
            tp_fan_evaluate_row(&s.grid, j, 0, s.grid.cols, row);
            for (uint32_t i = 0; i < s.grid.cols; i++)
                assert_true(row[i].slope_x == 0 && row[i].slope_z == 0);
        }
        free(s.block);
    }
}

static void parts_of_a_row_have_the_same_bits(void **state)
{
    (void)state;
    for (int n = 0; n < 30; n++) {
        fan_sea s;
        fan_sea_lay_out(&s, 1 + n % 6, &chance);
        s.grid.waves = n & 1 ? &tp_draw_table_waves.by : &tp_draw_packed_waves.by;
        s.grid.plain_normals = n & 2;
        s.grid.large = n & 4 ? &tp_draw_large_waves : NULL;
        s.grid.half_px = 1;
        check_parts_of_rows(&s);
        free(s.block);
    }
}

/* -- fewer swells -------------------------------------------------------------------- */

/* Lays out a fan over six swells, every second of them low. */
static void lay_out_low(fan_sea *s)
{
    fan_sea_lay_out(s, 6, &chance);
    for (uint32_t i = 1; i < s->deep.count; i += 2) {
        tp_swell *w = &s->deep.swell[i];
        w->amplitude /= 32;
        w->orbit_x /= 32;
        w->orbit_z /= 32;
    }
}

/* Returns a swell's displacement in the picture at a row, 1/65536 px; -1: behind the eye. */
static int64_t displacement_px(const fan_sea *s, uint32_t j, const tp_swell *w)
{
    const tp_projection *p = &s->v.projection;
    const tp_fan_row *row = &s->grid.fan->row[j];
    const int32_t half = (int32_t)(s->grid.cols / 2);
    tp_view_vertex at;

    tp_projection_view_vertex(
        p, (tp_vec3){ row->x + row->step_x * half, 0, row->z + row->step_z * half }, &at);
    int32_t most = w->amplitude;
    raise(&most, tp_abs(w->orbit_x));
    raise(&most, tp_abs(w->orbit_z));
    return at.depth <= p->near ? -1 : (int64_t)most * (p->focal >> 8) * 256 / at.depth;
}

/* A swell below the limit leaves the row; above twice the limit the row has the filter's
 * weight, to the bit: a sea of such swells has the bits of `all`. */
static void swells_leave_where_they_move_no_pixel(void **state)
{
    uint32_t left = 0, kept = 0, between = 0;

    (void)state;
    for (int n = 0; n < 40; n++) {
        fan_sea s;
        lay_out_low(&s);
        s.grid.large = &tp_draw_large_waves;
        s.grid.half_px = n & 1 ? 2 : 1;
        const int64_t limit = s.grid.half_px * (TP_FX_ONE / 2);
        for (uint32_t j = 0; j < s.grid.rows; j++) {
            const tp_fan_row *row = &s.grid.fan->row[j];
            const tp_fx least = tp_fan_row_least(&s.grid, row);
            for (uint32_t i = 0; i < s.deep.count; i++) {
                const tp_swell *w = &s.deep.swell[i];
                const tp_fx by = tp_fan_row_large_weight(&s.grid, row, least, w);
                const tp_fx all = tp_fan_row_weight(s.grid.fan, row, w);
                const int64_t px = displacement_px(&s, j, w);
                assert_in_range(by, 0, all);
                if (px < 0 || px > limit * 21 / 10) {
                    assert_int_equal(by, all);
                    kept++;
                } else if (px < limit * 9 / 10) {
                    assert_int_equal(by, 0);
                    left += all > 0;
                } else {
                    between += by < all;
                }
            }
        }
        free(s.block);
    }
    printf("  %u left, %u kept, %u between\n", (unsigned)left, (unsigned)kept,
           (unsigned)between);
    assert_true(left > 100 && kept > 100 && between > 10);
}

/* What leaves the geometry is variance of slopes. */
static void swells_left_out_are_slope_variance(void **state)
{
    uint32_t more = 0;

    (void)state;
    for (int n = 0; n < 60; n++) {
        fan_sea s;
        lay_out_low(&s);
        for (uint32_t j = 0; j < s.grid.rows; j++) {
            const tp_fan_row *row = &s.grid.fan->row[j];
            s.grid.large = NULL;
            const tp_slope_variance all = tp_fan_row_variance(&s.grid, row, 0);
            s.grid.large = &tp_draw_large_waves;
            s.grid.half_px = 2;
            const tp_slope_variance few = tp_fan_row_variance(&s.grid, row, 0);
            assert_true(few.left >= all.left && few.along + few.across + 64
                                                    >= all.along + all.across);
            more += few.left > all.left;
        }
        free(s.block);
    }
    printf("  %u rows have more\n", (unsigned)more);
    assert_true(more > 50);
}

/* -- pictures ------------------------------------------------------------------------ */

/* A scene with rungs by the bits of n. */
static tp_scene scene_of_rungs(int n)
{
    tp_scene s = scene_of_swells(n);

    s.water.rough = 1;
    s.quality.sine = n & 4 ? TP_RUNG_FAST : TP_RUNG_EXACT;
    s.quality.normals = n & 8 ? TP_RUNG_FAST : TP_RUNG_EXACT;
    s.quality.geometry = n % 3 + 1;
    return s;
}

/* The pictures in tiles, and the rms of their difference from the exact ones. */
static void tiles_change_no_pixel(void **state)
{
    uint64_t sum = 0;

    (void)state;
    for (int n = 0; n < PICTURES; n++) {
        const tp_scene scene = scene_of_rungs(n);
        tp_scene plain = scene;
        plain.quality.sine = plain.quality.normals = plain.quality.geometry = TP_RUNG_EXACT;
        sum += check_tiles(n, &plain, &scene);
    }
    assert_in_range(mean_square(sum), 1, 20000);
}

/* Renderers without a fan have no such rungs: their pictures are the exact ones. */
static void level_renderers_draw_the_exact_picture(void **state)
{
    static const int32_t level[] = { TP_VISIBILITY_FLAT, TP_VISIBILITY_PROJECTED,
                                     TP_VISIBILITY_WALK };
    static uint32_t exact[PIXELS], fast[PIXELS];
    const tp_assets none = { 0 };
    int count = 0;

    (void)state;
    for (int n = 0; n < 3; n++) {
        tp_scene scene = scene_plain();
        scene.quality.visibility = level[n];
        scene.camera.y = TP_FX(9);
        scene.camera.pitch = TP_FX(-10);
        tp_world *world = scene_world(&scene, &none);
        assert_non_null(world);
        const bool drawn = draw(&scene, world, 0, HEIGHT, exact) == (tp_visibility)level[n];
        scene.quality.sine = scene.quality.normals = scene.quality.geometry = TP_RUNG_FAST;
        draw(&scene, world, 0, HEIGHT, fast);
        if (drawn)
            assert_memory_equal(fast, exact, sizeof exact);
        count += drawn;
        free(world);
    }
    assert_true(count >= 2);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(packed_vertices_are_close_to_the_exact_ones),
        cmocka_unit_test(table_vertices_err_by_the_table_step),
        cmocka_unit_test(plain_normals_leave_places_as_they_are),
        cmocka_unit_test(level_water_has_no_slopes),
        cmocka_unit_test(parts_of_a_row_have_the_same_bits),
        cmocka_unit_test(swells_leave_where_they_move_no_pixel),
        cmocka_unit_test(swells_left_out_are_slope_variance),
        cmocka_unit_test(tiles_change_no_pixel),
        cmocka_unit_test(level_renderers_draw_the_exact_picture),
    };
    return cmocka_run_group_tests_name("view/fan_packed", tests, NULL, NULL);
}
