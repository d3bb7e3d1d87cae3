/* SPDX-License-Identifier: MIT */
/* Vertices of a fan in 32 bits: close to those in 64 bits, the same in every part of a row,
 * and the same picture in every tiling. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "tests/lib/fans.h"
#include "tests/lib/frames.h"
#include "tests/lib/picture_difference.h"
#include "tests/lib/scenes.h"

enum { WIDTH = 96, HEIGHT = 64, PIXELS = WIDTH * HEIGHT, MOST = FAN_MOST };

static uint64_t chance;

typedef struct {
    int32_t place, slope;
    uint32_t steep, count;
} errors;

/* Raises the errors of row j: places in view space, slopes up to 1. */
static void compare_row(fan_sea *s, uint32_t j, errors *to)
{
    static tp_view_vertex a[MOST], b[MOST];
    static tp_grid_vertex m[MOST], n[MOST];
    const uint32_t cols = s->grid.cols;

    s->grid.fast = NULL;
    tp_fan_make_view_vertices(&s->grid, j, 0, cols, a);
    tp_fan_evaluate_row(&s->grid, j, 0, cols, m);
    s->grid.fast = &tp_draw_fast_waves;
    tp_fan_make_view_vertices(&s->grid, j, 0, cols, b);
    tp_fan_evaluate_row(&s->grid, j, 0, cols, n);
    for (uint32_t i = 0; i < cols; i++) {
        raise(&to->place, distance(a[i].x, b[i].x));
        raise(&to->place, distance(a[i].y, b[i].y));
        raise(&to->place, distance(a[i].depth, b[i].depth));
        to->count++;
        if (distance(m[i].slope_x, 0) > 4096 || distance(m[i].slope_z, 0) > 4096) {
            to->steep++;
            continue;
        }
        raise(&to->slope, distance(m[i].slope_x, n[i].slope_x));
        raise(&to->slope, distance(m[i].slope_z, n[i].slope_z));
    }
}

/* Places within 6 / 65536 m, slopes up to 1 within 4 / 4096; measured: 4 and 2. */
static void vertices_are_those_of_64_bits(void **state)
{
    errors e = { 0 };

    (void)state;
    for (int n = 0; n < 60; n++) {
        fan_sea s;
        fan_sea_lay_out(&s, n % 7, &chance);
        for (uint32_t j = 0; j < s.grid.rows; j += 3)
            compare_row(&s, j, &e);
        free(s.block);
    }
    printf("  %u vertices, %u steep; places within %d / 65536 m, slopes %d / 4096\n",
           (unsigned)e.count, (unsigned)e.steep, (int)e.place, (int)e.slope);
    assert_true(e.count > 10000 && e.steep < e.count / 4);
    assert_in_range(e.place, 0, 6);
    assert_in_range(e.slope, 0, 4);
}

static void parts_of_a_row_have_the_same_bits(void **state)
{
    static tp_grid_vertex whole[MOST], part[MOST];

    (void)state;
    for (int n = 0; n < 30; n++) {
        fan_sea s;
        fan_sea_lay_out(&s, 1 + n % 6, &chance);
        s.grid.fast = &tp_draw_fast_waves;
        const uint32_t cols = s.grid.cols, cut = (uint32_t)chance_int(&chance, 0, (int)cols);
        for (uint32_t j = 0; j < s.grid.rows; j += 7) {
            memset(whole, 0, sizeof whole);
            memset(part, 0, sizeof part);
            tp_fan_evaluate_row(&s.grid, j, 0, cols, whole);
            tp_fan_evaluate_row(&s.grid, j, cut, cols, part);
            tp_fan_evaluate_row(&s.grid, j, 0, cut, part);
            assert_memory_equal(part, whole, sizeof whole);
        }
        free(s.block);
    }
}

/* -- pictures ------------------------------------------------------------------------ */

static void draw(const tp_scene *scene, const tp_world *world, uint32_t wide, uint32_t high,
                 uint32_t *pixels)
{
    const tp_assets none = { 0 };
    const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_width = wide,
                               .tile_height = high, .format = TP_FORMAT_XRGB8888 };
    test_frame f = frame_of(scene, &none, &config);

    frame_draw_picture(&f, world, pixels);
    frame_free(&f);
}

static tp_scene scene_of_waves(int n)
{
    tp_scene s = scene_plain();

    s.quality.visibility = n & 1 ? TP_VISIBILITY_ROWS : TP_VISIBILITY_TRIANGLES;
    s.wind.strength = n & 2 ? TP_FX(0.2) : 0;
    s.camera.y = chance_fx(&chance, 3, 9);
    s.camera.pitch = chance_fx(&chance, -25, 2);
    s.grid.vertices = chance_int(&chance, 200, 3000);
    return s;
}

/* The pictures with fast waves: rms of the difference from the exact ones below 2 levels. */
static void tiles_change_no_pixel(void **state)
{
    static uint32_t exact[PIXELS], whole[PIXELS], other[PIXELS];
    const tp_assets none = { 0 };
    uint64_t sum = 0;

    (void)state;
    for (int n = 0; n < 24; n++) {
        tp_scene scene = scene_of_waves(n);
        tp_world *world = scene_world(&scene, &none);
        assert_non_null(world);
        draw(&scene, world, 0, HEIGHT, exact);
        scene.quality.waves = TP_RUNG_FAST;
        draw(&scene, world, 0, HEIGHT, whole);
        draw(&scene, world, n % 3 ? 32 : 0, n % 2 ? 16 : 13, other);
        assert_memory_equal(other, whole, sizeof whole);
        sum += picture_square_sum(exact, whole, PIXELS);
        free(world);
    }
    const uint64_t mean = sum * 100 / (24 * 3 * (uint64_t)PIXELS);
    printf("  mean square %u / 100 levels\n", (unsigned)mean);
    assert_in_range(mean, 1, 400);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_are_those_of_64_bits),
        cmocka_unit_test(parts_of_a_row_have_the_same_bits),
        cmocka_unit_test(tiles_change_no_pixel),
    };
    return cmocka_run_group_tests_name("view/fan_fast", tests, NULL, NULL);
}
