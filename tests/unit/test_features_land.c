/* SPDX-License-Identifier: MIT */
/* Land in the picture: in front of water behind the land, behind water in front of the
 * land, the same for every tiling, and no picture of a deep floor. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/camera.h"
#include "tests/lib/tilings.h"

enum { WIDTH = 150, HEIGHT = 90 };

static uint64_t chance;
static uint32_t key[WIDTH * HEIGHT];
static const tp_assets none;
static const tp_config config = {
    .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = TP_FORMAT_XRGB8888
};

/* Still water over a floor that rises towards -z. */
static tp_scene beach(double depth, double slope)
{
    tp_scene s;

    tp_scene_level(&s);
    s.grid.vertices = 6400;
    s.floor.depth = (tp_fx)lround(depth * 65536);
    s.floor.slope = (tp_fx)lround(slope * 65536);
    return s;
}

/* Distance along the ray to the plane y = rise z + level. */
static double way_to(ref_vec eye, ref_vec way, double rise, double level)
{
    const double t = (rise * eye.z + level - eye.y) / (way.y - rise * way.z);
    return t > 0 ? t : 1e9;
}

/* First object that the ray of a pixel position meets; SKY if none, or beyond the grid. */
static uint32_t first_met(const ref_camera *c, const tp_scene *s, double u, double v)
{
    const double x = (u - c->u0) / c->focal, y = (c->v0 - v) / c->focal;
    const ref_vec way = { c->ahead.x + x * c->right.x + y * c->up.x,
                          c->ahead.y + x * c->right.y + y * c->up.y,
                          c->ahead.z + x * c->right.z + y * c->up.z };
    const double water = way_to(c->eye, way, 0, 0);
    const double land = way_to(c->eye, way, -s->floor.slope / 65536.0,
                               -s->floor.depth / 65536.0);
    const double t = water < land ? water : land;

    if (fabs(c->eye.x + t * way.x) > 78 || fabs(c->eye.z + t * way.z) > 78)
        return MARKS_SKY;
    return water < land ? MARKS_WATER : MARKS_LAND;
}

/* The first object if the same at the pixel's centre and 1.5 px all around, otherwise
 * SKY. */
static uint32_t surely_met(const ref_camera *c, const tp_scene *s, int x, int y)
{
    const uint32_t mark = first_met(c, s, x + 0.5, y + 0.5);

    for (int i = 0; i < 8; i++)
        if (first_met(c, s, x + 0.5 + 1.5 * cos(i * 0.785398),
                      y + 0.5 + 1.5 * sin(i * 0.785398)) != mark)
            return MARKS_SKY;
    return mark;
}

static void the_nearer_of_land_and_water_is_seen(void **state)
{
    (void)state;
    uint32_t seen[256] = { 0 };

    for (int n = 0; n < 30; n++) {
        tp_scene s =
            beach(chance_double(&chance, 0.5, 3), chance_double(&chance, 0.03, 0.2));
        s.camera.x = chance_fx(&chance, -30, 30);
        s.camera.z = chance_fx(&chance, -10, 60);
        s.camera.y = chance_fx(&chance, 6, 25);
        s.camera.heading = chance_fx(&chance, -60, 60);
        s.camera.pitch = chance_fx(&chance, -45, 0);
        tp_world *world = scene_world(&s, &none);
        const ref_camera c = ref_camera_make(world->eye, world->heading, world->pitch,
                                           s.camera.fov, s.camera.near, WIDTH, HEIGHT);
        marks_draw(&s, &none, world, config, key, NULL);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                const uint32_t want = surely_met(&c, &s, x, y);
                if (want != MARKS_SKY)
                    assert_int_equal(TP_MARK(key[y * WIDTH + x]), want);
                seen[want]++;
            }
        }
        free(world);
    }
    assert_true(seen[MARKS_LAND] > 1000 && seen[MARKS_WATER] > 1000);
}

/* A ridge with water behind the ridge, as a height map. */
static void a_ridge_hides_the_water_behind_it(void **state)
{
    (void)state;
    static uint16_t sample[64 * 64];
    const tp_grey map = { 64, 64, sample };
    const tp_assets assets = { .floor = &map };
    tp_scene s = beach(0, 0);

    for (int i = 0; i < 64 * 64; i++)       /* 5 m high from z = -20 to -30 m */
        sample[i] = i / 64 >= 17 && i / 64 < 22 ? 65535 : 0;
    strcpy(s.floor.map, "ridge.png");
    s.floor.map_size = 128 * TP_FX_ONE;
    s.floor.map_low = -3 * TP_FX_ONE;
    s.floor.map_high = 5 * TP_FX_ONE;
    s.camera.y = 2 * TP_FX_ONE;
    s.camera.pitch = 0;
    tp_world *world = scene_world(&s, &assets);
    marks_draw(&s, &assets, world, config, key, NULL);
    const int x = WIDTH / 2;
    assert_int_equal(TP_MARK(key[(HEIGHT - 1) * WIDTH + x]), MARKS_WATER);
    assert_int_equal(TP_MARK(key[(HEIGHT / 2) * WIDTH + x]), MARKS_LAND);
    assert_int_equal(TP_MARK(key[(HEIGHT / 2 + 2) * WIDTH + x]), MARKS_LAND);
    assert_int_equal(TP_MARK(key[x]), MARKS_SKY);
    free(world);
}

static void nothing_of_a_deep_floor_is_drawn(void **state)
{
    (void)state;
    for (int n = 0; n < 12; n++) {
        tp_scene s = beach(50, 0.002);
        s.wave[0].amplitude = TP_FX(0.5);
        s.wave[0].length = 20 * TP_FX_ONE;
        s.camera.y = n % 3 ? chance_fx(&chance, 1, 60) : -5 * TP_FX_ONE;
        s.camera.pitch = chance_fx(&chance, -89, 20);
        s.camera.heading = chance_fx(&chance, 0, 360);
        tp_world *world = scene_world(&s, &none);
        marks_draw(&s, &none, world, config, key, NULL);
        assert_int_equal(marks_count(key, WIDTH * HEIGHT, MARKS_LAND), 0);
        free(world);
    }
}

static void every_tiling_gives_the_same_bits(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = { { 0, 1 }, { 0, 7 }, { 16, 0 }, { 16, 16 },
                                         { 48, 31 } };
    uint32_t land = 0;

    for (int n = 0; n < 16; n++) {
        tp_scene s = beach(chance_double(&chance, 0.5, 6), chance_double(&chance, 0.05, 1));
        s.grid.vertices = 1600;
        s.wave[0].amplitude = TP_FX(0.3);
        s.wave[0].length = 15 * TP_FX_ONE;
        s.floor.heading = chance_fx(&chance, -90, 90);
        s.camera.x = chance_fx(&chance, -50, 50);
        s.camera.z = chance_fx(&chance, -20, 50);
        s.camera.y = chance_fx(&chance, -4, 20);
        s.camera.pitch = chance_fx(&chance, -50, 10);
        s.camera.heading = chance_fx(&chance, -180, 180);
        tp_world *world = scene_world(&s, &none);
        marks_assert_tiled(&s, &none, world, config, sizes, sizeof sizes / sizeof *sizes,
                           key);
        land += marks_count(key, WIDTH * HEIGHT, MARKS_LAND);
        free(world);
    }
    assert_true(land > 1000);
}

/* Cells with both shallow and deep corners are drawn whole in every band of rows: seen from
 * below, past the water's edge. */
static void a_slope_into_the_deep_is_the_same_in_all_bands(void **state)
{
    (void)state;
    static const uint32_t bands[][2] = { { 0, 1 }, { 0, 4 }, { 0, 7 }, { 0, 10 },
                                         { 0, 13 }, { 0, 16 }, { 0, 19 } };
    tp_scene s = beach(4, 1);

    s.grid.vertices = 144;
    s.camera.z = 6 * TP_FX_ONE;
    s.camera.y = -5 * TP_FX_ONE;
    s.camera.pitch = 10 * TP_FX_ONE;
    tp_world *world = scene_world(&s, &none);
    marks_assert_tiled(&s, &none, world, config, bands, sizeof bands / sizeof *bands, key);
    assert_true(marks_count(key, WIDTH * HEIGHT, MARKS_LAND) > 100);
    free(world);
}

/* Waves on a beach: the land that the fast rung of solids leaves out is hidden by water.
 * The marks of 1000 pictures were the same. */
static void the_fast_rung_leaves_out_hidden_land_alone(void **state)
{
    (void)state;
    static uint32_t exact[WIDTH * HEIGHT];
    uint32_t land = 0;

    for (int n = 0; n < 12; n++) {
        tp_scene s =
            beach(chance_double(&chance, 0, 3), chance_double(&chance, 0.03, 0.2));
        for (int k = 0; k < 2; k++)
            s.wave[k] = (tp_wave){ .amplitude = chance_fx(&chance, 0.05, 0.7),
                                   .length = chance_fx(&chance, 6, 40),
                                   .heading = chance_fx(&chance, -70, 70),
                                   .phase = chance_fx(&chance, 0, 360),
                                   .speed = TP_FX_ONE, .exponent = 1 };
        s.camera.x = chance_fx(&chance, -30, 30);
        s.camera.z = chance_fx(&chance, -10, 40);
        s.camera.y = chance_fx(&chance, 2, 20);
        s.camera.heading = chance_fx(&chance, -120, 120);
        s.camera.pitch = chance_fx(&chance, -45, 0);
        tp_world *world = scene_world(&s, &none);
        marks_draw(&s, &none, world, config, exact, NULL);
        s.quality.solids = TP_RUNG_FAST;
        marks_draw(&s, &none, world, config, key, NULL);
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            assert_int_equal(TP_MARK(key[i]), TP_MARK(exact[i]));
        land += marks_count(key, WIDTH * HEIGHT, MARKS_LAND);
        free(world);
    }
    assert_true(land > 1000);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_nearer_of_land_and_water_is_seen),
        cmocka_unit_test(a_ridge_hides_the_water_behind_it),
        cmocka_unit_test(nothing_of_a_deep_floor_is_drawn),
        cmocka_unit_test(every_tiling_gives_the_same_bits),
        cmocka_unit_test(a_slope_into_the_deep_is_the_same_in_all_bands),
        cmocka_unit_test(the_fast_rung_leaves_out_hidden_land_alone),
    };
    return cmocka_run_group_tests_name("features/land", tests, NULL, NULL);
}
