/* SPDX-License-Identifier: MIT */
/* Pictures of a fan: water without a hole up to the horizon from any height, the same in
 * every tile, and steady under a camera that moves a little. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "tests/lib/tilings.h"

enum { WIDTH = 160, HEIGHT = 120, PIXELS = WIDTH * HEIGHT };

static uint64_t chance;
static const tp_assets none;
static const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT,
                                  .format = TP_FORMAT_XRGB8888 };
static uint32_t key[PIXELS], picture[3][PIXELS];

static tp_scene fan_scene(double height, double pitch)
{
    tp_scene s = scene_plain();

    s.grid.vertices = 2500;
    s.camera.y = (tp_fx)(height * 65536);
    s.camera.pitch = (tp_fx)(pitch * 65536);
    s.camera.heading = chance_fx(&chance, -180, 180);
    s.camera.x = chance_fx(&chance, -8000, 8000);
    s.camera.z = chance_fx(&chance, -8000, 8000);
    if (random_below(&chance, 3) == 0)
        s.wind.strength = TP_FX(0.2);
    return s;
}

static void draw(const tp_scene *scene, uint32_t *pixels)
{
    tp_world *world = scene_world(scene, &none);

    assert_non_null(world);
    marks_draw(scene, &none, world, config, key, pixels);
    free(world);
}

/* Row below which every pixel is water: the dip of the water's end at 16 km, and the
 * crests, which only raise the water. */
static int last_sky_row(const tp_scene *s)
{
    const double degree = 3.14159265358979 / 180 / 65536;
    const double dip = atan(s->camera.y / 65536.0 / 15800);
    const double half = tan(s->camera.fov * degree / 2);
    const double row = HEIGHT / 2.0 * (1 + tan(s->camera.pitch * degree + dip) / half);

    return s->camera.pitch < -45 * TP_FX_ONE || row < -1 ? -1 : (int)ceil(row) + 1;
}

static void check_filled(const tp_scene *scene)
{
    const int above = last_sky_row(scene);

    draw(scene, NULL);
    for (int y = above < 0 ? 0 : above; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            assert_int_equal(TP_MARK(key[y * WIDTH + x]), MARKS_WATER);
    for (int y = 0; y < above - HEIGHT / 3; y++)
        assert_int_equal(TP_MARK(key[y * WIDTH]), MARKS_SKY);
}

static void water_has_no_hole_from_any_height(void **state)
{
    static const double heights[] = { 2, 14, 50, 150, 1000 };
    static const double pitches[] = { 0, -8, -22, -60, -89 };

    (void)state;
    for (int n = 0; n < 100; n++) {
        tp_scene s = fan_scene(heights[n % 5], pitches[n / 5 % 5]);
        s.quality.visibility = n / 25 % 2 ? TP_VISIBILITY_ROWS : TP_VISIBILITY_TRIANGLES;
        check_filled(&s);
    }
}

static void fans_are_drawn_the_same_in_tiles(void **state)
{
    static const uint32_t size[][2] = { { WIDTH, 16 }, { 48, 40 }, { 16, 120 } };

    (void)state;
    for (int n = 0; n < 60; n++) {
        tp_scene s = fan_scene(chance_double(&chance, 0.2, 60),
                               chance_double(&chance, -80, 10));
        s.grid.vertices = chance_int(&chance, 1, 3000);
        s.quality.visibility = n % 2 ? TP_VISIBILITY_ROWS : TP_VISIBILITY_TRIANGLES;
        tp_world *world = scene_world(&s, &none);
        marks_assert_tiled(&s, &none, world, config, size, 3, key);
        free(world);
    }
}

/* A fan over a coast keeps rows of displaced points; every frame begins them anew. */
static void a_fan_over_a_coast_is_drawn_again_the_same(void **state)
{
    (void)state;
    for (int n = 0; n < 12; n++) {
        tp_scene s = fan_scene(chance_double(&chance, 2, 60),
                               chance_double(&chance, -60, 0));
        s.floor.depth = chance_fx(&chance, 1, 6);
        tp_world *world = scene_world(&s, &none);
        test_frame f = frame_of(&s, &none, &config);
        assert_non_null(world);
        frame_draw_picture(&f, world, picture[0]);
        frame_draw_picture(&f, world, picture[1]);
        assert_memory_equal(picture[0], picture[1], sizeof picture[0]);
        frame_free(&f);
        free(world);
    }
}

/* Water over a floor keeps all swells at each rung of quality.geometry, so none of them
 * makes the water rougher; open water differs. */
static void a_coast_keeps_all_swells(void **state)
{
    int differ = 0;

    (void)state;
    for (int n = 0; n < 12; n++) {
        tp_scene s = fan_scene(chance_double(&chance, 4, 30),
                               chance_double(&chance, -30, -5));
        s.floor.depth = n % 2 ? 0 : chance_fx(&chance, 2, 6);
        s.water.rough = 1;
        s.water.reflection = TP_FX(0.9);
        tp_world *world = scene_world(&s, &none);
        assert_non_null(world);
        for (int k = 0; k < 2; k++) {
            s.quality.geometry = k ? TP_RUNG_PAIRS : TP_RUNG_EXACT;     /* largest, all */
            test_frame f = frame_of(&s, &none, &config);
            frame_draw_picture(&f, world, picture[k]);
            frame_free(&f);
        }
        const bool same = memcmp(picture[0], picture[1], sizeof picture[0]) == 0;
        assert_true(same || n % 2);
        differ += !same;
        free(world);
    }
    assert_true(differ >= 4);
}

/* -- a camera that moves a little ---------------------------------------------------- */

static int channel(int k, int i, int shift)
{
    return (int)(picture[k][i] >> shift & 255);
}

/* Returns the mean second difference of a pixel, levels, over steps of 0.15 m. */
static double change(tp_scene s)
{
    double sum = 0;

    for (int k = 0; k < 3; k++) {
        draw(&s, picture[k]);
        s.camera.x += TP_FX(0.15);
    }
    for (int i = 0; i < PIXELS; i++)
        for (int shift = 0; shift < 24; shift += 8)
            sum += abs(channel(0, i, shift) - 2 * channel(1, i, shift)
                       + channel(2, i, shift));
    return sum / (3.0 * PIXELS);
}

/* A fan slides under the water with the camera; with the filter its pictures change no more
 * than those of a grid so dense that it holds the waves. */
static void a_small_step_changes_no_more_than_with_a_dense_grid(void **state)
{
    double fan = 0, dense = 0;

    (void)state;
    for (int n = 0; n < 12; n++) {
        tp_scene s = fan_scene(chance_double(&chance, 2, 6),
                               chance_double(&chance, -15, -5));
        s.quality.visibility = TP_VISIBILITY_TRIANGLES;
        fan += change(s);
        s.grid.vertices = 65536;
        dense += change(s);
    }
    printf("# change by a step: fan %.3f, dense grid %.3f levels\n", fan / 12, dense / 12);
    assert_true(fan <= dense);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(water_has_no_hole_from_any_height),
        cmocka_unit_test(fans_are_drawn_the_same_in_tiles),
        cmocka_unit_test(a_fan_over_a_coast_is_drawn_again_the_same),
        cmocka_unit_test(a_coast_keeps_all_swells),
        cmocka_unit_test(a_small_step_changes_no_more_than_with_a_dense_grid),
    };
    return cmocka_run_group_tests_name("frame/fan", tests, NULL, NULL);
}
