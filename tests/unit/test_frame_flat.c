/* SPDX-License-Identifier: MIT */
/* The per-pixel renderer of level water gives the picture of the level mesh, for any camera
 * above the water. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/tilings.h"

static uint64_t chance;
static test_boat boat;

static tp_scene calm_scene(void)
{
    tp_scene s = scene_plain();

    for (int i = 0; i < TP_WAVES; i++)
        s.wave[i].amplitude = 0;
    s.camera.near = TP_FX(0.05);
    return s;
}

/* A camera anywhere above the water; every third camera is aboard a rolling boat. */
static tp_scene any_view(bool calm)
{
    tp_scene s = calm ? calm_scene() : scene_plain();

    s.camera.x = chance_fx(&chance, -300, 300);
    s.camera.z = chance_fx(&chance, -300, 300);
    s.camera.y = chance_scale(&chance, 0.5, 200);
    s.camera.heading = chance_fx(&chance, 0, 360);
    s.camera.pitch = chance_fx(&chance, -89, 20);
    s.camera.fov = chance_fx(&chance, 20, 100);
    return s;
}

static double metres(uint32_t place)
{
    return (int32_t)place / 65536.0;
}

/* Component of the pixel's ray along a world axis, in pixels. */
static double ray_in_doubles(const tp_projection *projection, int i, int32_t right,
                             int32_t up, int32_t ahead)
{
    const double u = i % LEVEL_WIDTH + 0.5 - projection->u0 / 16.0,
                 v = projection->v0 / 16.0 - i / LEVEL_WIDTH - 0.5;
    return (projection->focal / 65536.0 * ahead + u * right + v * up) / TP_Q30_ONE;
}

/* near / depth of level water, in units of 2^-24. */
static double zi_in_doubles(const tp_projection *projection, int i)
{
    const double down = -ray_in_doubles(projection, i, projection->turn.x.y,
                                        projection->turn.y.y, projection->ahead.y);
    return 16777216.0 * projection->zi_near / projection->eye.y * down
           / (projection->focal / 65536.0);
}

/* Point where the ray of pixel i meets the level. */
static void place_in_doubles(const tp_projection *projection, int i, double place[2])
{
    const double down = -ray_in_doubles(projection, i, projection->turn.x.y,
                                        projection->turn.y.y, projection->ahead.y);
    const double reach = projection->eye.y / 65536.0 / down;

    place[0] = projection->eye.x / 65536.0
               + reach
                     * ray_in_doubles(projection, i, projection->turn.x.x,
                                      projection->turn.y.x, projection->ahead.x);
    place[1] = projection->eye.z / 65536.0
               + reach
                     * ray_in_doubles(projection, i, projection->turn.x.z,
                                      projection->turn.y.z, projection->ahead.z);
}

/* Distance of the sample's position from that point as seen by the eye, px. */
static double off_in_pixels(const tp_projection *projection, const level_shot *shot, int i)
{
    double at[2];

    place_in_doubles(projection, i, at);
    const double x = at[0] - projection->eye.x / 65536.0,
                 z = at[1] - projection->eye.z / 65536.0;
    const double h = projection->eye.y / 65536.0, way2 = x * x + z * z + h * h;
    const double ds = metres(shot->s[i]) - at[0], dt = metres(shot->t[i]) - at[1];
    const double along = (ds * x + dt * z) / sqrt(way2);
    return sqrt(fmax(0, ds * ds + dt * dt - along * along) / way2) * projection->focal
           / 65536.0;
}

static void level_water_is_the_level_mesh(void **state)
{
    (void)state;
    const tp_assets none = { 0 };
    double most = 0, sum = 0, deep = 0;
    int    apart = 0, seen = 0;

    for (int n = 0; n < 200; n++) {
        static level_shot mesh, flat;
        tp_scene scene = any_view(true);
        level_draw(&mesh, &scene, &none, TP_VISIBILITY_TRIANGLES, 0);
        level_draw(&flat, &scene, &none, TP_VISIBILITY_FLAT, 0);
        assert_int_equal(flat.frame.frame->visibility, TP_VISIBILITY_FLAT);
        assert_int_equal(flat.frame.frame->stats.vertices, 0);
        const int differ = level_apart(&mesh, &flat);
        apart += differ;
        /* The mesh's screen vertices are rounded to 1/16 px, so a row of pixels at its edge
         * may differ. */
        assert_in_range(differ, 0, LEVEL_WIDTH);
        for (int i = 0; i < LEVEL_PIXELS; i++) {
            if (!level_is_water(&mesh, i) || !level_is_water(&flat, i))
                continue;
            const double off = off_in_pixels(&flat.frame.frame->projection, &flat, i);
            const double depth = zi_in_doubles(&flat.frame.frame->projection, i);
            most = fmax(most, off);
            sum += off;
            deep = fmax(deep, fabs(depth - (flat.key[i] >> 8) - 0.5));
            seen++;
        }
        frame_free(&mesh.frame);
        frame_free(&flat.frame);
    }
    print_message("%d of %d pixels apart; places %.3f px at the most, %.4f in the mean; "
                  "depths %.2f of 2^24 at the most\n", apart, seen, most, sum / seen, deep);
    assert_true(apart < seen / 2000);
    assert_true(most < 0.1);
    assert_true(sum / seen < 0.005);
    assert_true(deep < 2);
}

/* With waves, from a rolling camera: the slope grid and the single pixels. */
static void every_tiling_of_flat_water_is_the_same(void **state)
{
    (void)state;
    const tp_assets assets = { .boat = &boat.mesh, .layer[0] = &boat.texture[0] };
    int rolled = 0;

    for (int n = 0; n < 40; n++) {
        static level_shot whole;
        tp_scene scene = any_view(false);
        if (n % 3 == 0) {
            scene.camera.x = scene.camera.z = 0;
            level_board(&scene, 4 * TP_FX_ONE);
        }
        level_draw(&whole, &scene, &assets, TP_VISIBILITY_FLAT, 17);
        rolled += whole.frame.frame->visibility == TP_VISIBILITY_FLAT
                  && whole.frame.frame->buffers.level->rolled;
        level_compare_tilings(&whole, &scene, &assets);
        frame_free(&whole.frame);
    }
    print_message("%d pictures of 40 roll\n", rolled);
    assert_true(rolled > 3);
}

/* Depth changes by up to 1/32 over the 16 pixels between exact positions: at the middle the
 * linear position is that of a pixel 16 / 4 / 32 px away, 1/8 px. */
static void water_that_rolls_lies_where_its_rays_end(void **state)
{
    (void)state;
    const tp_assets assets = { .boat = &boat.mesh, .layer[0] = &boat.texture[0] };
    double most = 0;
    int    seen = 0;

    for (int n = 0; n < 60; n++) {
        static level_shot flat;
        tp_scene scene = any_view(false);
        scene.camera.x = scene.camera.z = 0;
        level_board(&scene, chance_scale(&chance, 3, 20));
        const uint64_t tick = random_below(&chance, 5000);
        level_draw(&flat, &scene, &assets, TP_VISIBILITY_FLAT, tick);
        const tp_frame *frame = flat.frame.frame;
        for (int i = 0; i < LEVEL_PIXELS; i++) {
            if (frame->visibility != TP_VISIBILITY_FLAT || !frame->buffers.level->rolled
                || !level_is_water(&flat, i))
                continue;
            most = fmax(most, off_in_pixels(&frame->projection, &flat, i));
            seen++;
        }
        frame_free(&flat.frame);
    }
    print_message("%d pixels, %.3f px off at the most\n", seen, most);
    assert_true(seen > 50000);
    assert_true(most < 0.14);
}

/* Slopes of waves from the slope grid compared with those of the mesh: swells low enough
 * for the same position in both, and much longer than 8 px at the viewed distance. */
static void long_waves_have_the_slopes_of_the_mesh(void **state)
{
    (void)state;
    const tp_assets none = { 0 };
    double most = 0, sum = 0;
    int    seen = 0;

    for (int n = 0; n < 60; n++) {
        static level_shot mesh, flat;
        tp_scene scene = any_view(true);
        for (int i = 0; i < 2; i++)
            scene.wave[i] = (tp_wave){ .amplitude = TP_FX(0.02), .steepness = 0,
                                       .length = chance_fx(&chance, 10, 16),
                                       .heading = chance_fx(&chance, 0, 360),
                                       .exponent = 1 };
        scene.camera.y = chance_fx(&chance, 3, 8);
        scene.camera.pitch = chance_fx(&chance, -85, -60);
        scene.camera.fov = chance_fx(&chance, 30, 60);
        scene.grid.vertices = 8100;
        level_draw(&mesh, &scene, &none, TP_VISIBILITY_TRIANGLES, 90);
        level_draw(&flat, &scene, &none, TP_VISIBILITY_FLAT, 90);
        assert_int_equal(flat.frame.frame->visibility, TP_VISIBILITY_FLAT);
        for (int i = 0; i < LEVEL_PIXELS; i++) {
            if (!level_is_water(&mesh, i) || !level_is_water(&flat, i))
                continue;
            const double off =
                hypot((int16_t)(mesh.n[i] >> 16) - (int16_t)(flat.n[i] >> 16),
                      (int16_t)mesh.n[i] - (int16_t)flat.n[i]);
            most = fmax(most, off);
            sum += off * off;
            seen++;
        }
        frame_free(&mesh.frame);
        frame_free(&flat.frame);
    }
    print_message("slopes of %d pixels: %.1f of 4096 at the most, rms %.2f\n", seen, most,
                  sqrt(sum / seen));
    assert_true(seen > 100000);
    assert_true(most < 30);
    assert_true(sqrt(sum / seen) < 3);
}

/* Water that the flat renderer cannot show is drawn by triangles. */
static void water_that_is_not_level_goes_by_triangles(void **state)
{
    (void)state;
    const tp_assets none = { 0 };
    static level_shot shot;

    for (int n = 0; n < 6; n++) {
        tp_scene scene = scene_plain();
        const tp_visibility want = n == 0 ? TP_VISIBILITY_FLAT : TP_VISIBILITY_TRIANGLES;
        if (n == 1)
            scene.camera.y = TP_FX(1.1);            /* crests are 1.2 m high */
        if (n == 2)
            scene.camera.y = -2 * TP_FX_ONE;
        if (n == 3)
            scene.pool.cols = scene.pool.rows = 16;
        if (n == 4)
            scene.wind.strength = TP_FX_ONE;
        if (n == 5)
            scene.floor.depth = 4 * TP_FX_ONE;
        const tp_config config = { .width = LEVEL_WIDTH,
                                   .height = LEVEL_HEIGHT,
                                   .tile_height = LEVEL_HEIGHT,
                                   .format = TP_FORMAT_XRGB8888 };
        scene.quality.visibility = TP_VISIBILITY_FLAT;
        shot.frame = frame_of(&scene, &none, &config);
        tp_world *world = scene_world(&scene, &none);
        tp_frame_begin(shot.frame.frame, world);
        assert_int_equal(shot.frame.frame->visibility, want);
        free(world);
        frame_free(&shot.frame);
    }
}

/* A camera that descends to calm water gets the same picture on both sides of the renderer
 * switch. */
static void nothing_jumps_at_the_border(void **state)
{
    (void)state;
    const tp_assets none = { 0 };
    int ways[2] = { 0, 0 };

    for (int n = 0; n < 12; n++) {
        static level_shot mesh, flat;
        tp_scene scene = calm_scene();
        scene.camera.y = TP_LEVEL_HEIGHT + (n - 6) * 256;
        level_draw(&mesh, &scene, &none, TP_VISIBILITY_TRIANGLES, 0);
        level_draw(&flat, &scene, &none, TP_VISIBILITY_FLAT, 0);
        ways[flat.frame.frame->visibility == TP_VISIBILITY_FLAT]++;
        assert_true(level_colour_apart(&mesh, &flat) < 0.5);
        frame_free(&mesh.frame);
        frame_free(&flat.frame);
    }
    assert_true(ways[0] > 0 && ways[1] > 0);
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(level_water_is_the_level_mesh),
        cmocka_unit_test(every_tiling_of_flat_water_is_the_same),
        cmocka_unit_test(water_that_rolls_lies_where_its_rays_end),
        cmocka_unit_test(long_waves_have_the_slopes_of_the_mesh),
        cmocka_unit_test(water_that_is_not_level_goes_by_triangles),
        cmocka_unit_test(nothing_jumps_at_the_border),
    };
    return cmocka_run_group_tests_name("frame/flat", tests, NULL, NULL);
}
