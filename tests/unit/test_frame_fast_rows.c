/* SPDX-License-Identifier: MIT */
/* The fast rungs of scanline water: the same picture in every tiling, with depths and
 * without; its error; and the samples of its tiles. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include "frame/frame.h"
#include "tests/lib/frames.h"
#include "tests/lib/picture_difference.h"
#include "tests/lib/scenes.h"

enum { WIDTH = 96, HEIGHT = 64, PIXELS = WIDTH * HEIGHT };

static uint64_t chance;
static test_kit kit;

static void draw(const tp_scene *scene, const tp_assets *assets, const tp_world *world,
                 tp_config config, uint32_t *pixels)
{
    test_frame f = frame_of(scene, assets, &config);
    frame_draw_picture(&f, world, pixels);
    frame_free(&f);
}

static tp_config config_of(uint32_t tile_width, uint32_t tile_height, bool depth)
{
    return (tp_config){ .width = WIDTH, .height = HEIGHT, .tile_width = tile_width,
                        .tile_height = tile_height, .format = TP_FORMAT_XRGB8888,
                        .depth = depth };
}

/* A view over swells that rows can draw. */
static tp_scene scene_of_rows(int32_t rung)
{
    tp_scene s = scene_plain();

    s.quality.visibility = TP_VISIBILITY_ROWS;
    s.quality.rows = rung;
    s.camera.y = chance_fx(&chance, 3, 9);
    s.camera.heading = chance_fx(&chance, -60, 60);
    s.camera.pitch = chance_fx(&chance, -25, 2);
    s.grid.vertices = chance_int(&chance, 200, 3000);
    return s;
}

static void depths_and_tiles_change_no_pixel(void **state)
{
    (void)state;
    static uint32_t whole[PIXELS], other[PIXELS];
    static const uint32_t sizes[][2] = { { 0, 1 }, { 16, 0 }, { 48, 13 }, { 0, 16 } };
    int fast = 0, solids = 0;

    for (int n = 0; n < 60; n++) {
        const int32_t rung = TP_RUNG_FAST + n % 2;
        tp_scene scene = n % 3 ? scene_of_rows(rung) : kit_scene(&chance, 900, 24);
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        scene.quality.visibility = TP_VISIBILITY_ROWS;
        scene.quality.rows = rung;
        tp_world *world = scene_world(&scene, &assets);
        if (!world)
            continue;
        tp_config config = config_of(0, HEIGHT, false);
        test_frame f = frame_of(&scene, &assets, &config);
        frame_draw_picture(&f, world, whole);
        fast += f.frame->column_bits == 4 + n % 2;
        solids += f.frame->column_bits && tp_frame_has_solids(f.frame);
        frame_free(&f);
        draw(&scene, &assets, world, config_of(0, HEIGHT, true), other);
        assert_memory_equal(other, whole, sizeof whole);
        draw(&scene, &assets, world, config_of(sizes[n % 4][0], sizes[n % 4][1], n % 5 == 0),
             other);
        assert_memory_equal(other, whole, sizeof whole);
        free(world);
    }
    printf("  %d fast pictures, %d with solids\n", fast, solids);
    assert_true(fast > 10 && solids > 2);
}

/* Solids are in their box: tiles beyond it are drawn alone. */
static void solids_stay_in_their_box(void **state)
{
    (void)state;
    int tiles = 0;

    for (int n = 0; n < 120; n++) {
        tp_scene scene = kit_scene(&chance, 400, 24);
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        tp_world *world = scene_world(&scene, &assets);
        if (!world)
            continue;
        const tp_config config = config_of(0, HEIGHT, true);
        test_frame f = frame_of(&scene, &assets, &config);
        tp_tile tile;
        tp_frame_begin(f.frame, world);
        assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
        const tp_grid_box box = f.frame->solids;
        const uint32_t *key = (const uint32_t *)(const void *)f.scratch;
        for (int32_t i = 0; i < PIXELS; i++) {
            const int32_t x = i % WIDTH, y = i / WIDTH;
            if (TP_MARK(key[i]) >= TP_MARK_SOLID) {
                assert_in_range(x, box.x0 > 0 ? box.x0 : 0, box.x1);
                assert_in_range(y, box.y0 > 0 ? box.y0 : 0, box.y1);
                tiles++;
            }
        }
        frame_free(&f);
        free(world);
    }
    printf("  %d pixels of solids\n", tiles);
    assert_true(tiles > 1000);
}

static void fast_rows_are_near_triangles(void **state)
{
    (void)state;
    static uint32_t exact[PIXELS], rows[4][PIXELS];
    const tp_assets none = { .boat = NULL };
    double sum[4] = { 0 };
    int views = 0;

    for (int n = 0; n < 40; n++) {
        tp_scene scene = scene_of_rows(TP_RUNG_EXACT);
        tp_world *world = scene_world(&scene, &none);
        for (int32_t rung = TP_RUNG_EXACT; rung <= TP_RUNG_PAIRS; rung++) {
            scene.quality.rows = rung;
            draw(&scene, &none, world, config_of(0, 16, false), rows[rung]);
        }
        scene.quality.visibility = TP_VISIBILITY_TRIANGLES;
        draw(&scene, &none, world, config_of(0, 16, false), exact);
        for (int32_t rung = TP_RUNG_EXACT; rung <= TP_RUNG_PAIRS; rung++)
            sum[rung] += (double)picture_square_sum(exact, rows[rung], PIXELS);
        views++;
        free(world);
    }
    for (int32_t rung = TP_RUNG_EXACT; rung <= TP_RUNG_PAIRS; rung++)
        sum[rung] = 10 * log10(65025.0 * 3 * PIXELS * views / sum[rung]);
    printf("  against triangles: exact %.2f dB, fast %.2f dB, pairs %.2f dB\n",
           sum[TP_RUNG_EXACT], sum[TP_RUNG_FAST], sum[TP_RUNG_PAIRS]);
    assert_true(sum[TP_RUNG_FAST] > 30);
    assert_true(sum[TP_RUNG_PAIRS] > 29);
}

/* Kinds are those of the drawn picture with depths or without; depths differ where waves
 * are. */
static void samples_of_tiles_have_their_kinds(void **state)
{
    (void)state;
    const tp_assets none = { .boat = NULL };
    static tp_fx depth[2][WIDTH];
    static uint8_t kind[2][WIDTH];
    uint32_t water = 0;

    for (int n = 0; n < 20; n++) {
        tp_scene scene = scene_of_rows(TP_RUNG_FAST + n % 2);
        tp_world *world = scene_world(&scene, &none);
        const tp_config config[2] = { config_of(0, HEIGHT, false),
                                      config_of(0, HEIGHT, true) };
        test_frame f[2];
        tp_tile tile[2];
        for (int k = 0; k < 2; k++) {
            f[k] = frame_of(&scene, &none, &config[k]);
            tp_frame_begin(f[k].frame, world);
            assert_true(tp_frame_draw_tile(f[k].frame, 0, f[k].scratch, &tile[k]));
        }
        const uint32_t count = tp_frame_water_pixels(f[0].frame, f[0].scratch, &tile[0]);
        assert_int_equal(count, tp_frame_water_pixels(f[1].frame, f[1].scratch, &tile[1]));
        water += count;
        for (uint32_t y = 0; y < HEIGHT; y++) {
            for (int k = 0; k < 2; k++)
                tp_frame_sample_row(f[k].frame, f[k].scratch, &tile[k], y, depth[k], kind[k]);
            assert_memory_equal(kind[0], kind[1], sizeof kind[0]);
        }
        for (int k = 0; k < 2; k++)
            frame_free(&f[k]);
        free(world);
    }
    assert_true(water > 20 * PIXELS / 4);
}

/* The rungs need memory of their own, which a scene without them does not lay out. */
static void exact_rows_take_no_memory_for_fast_rows(void **state)
{
    (void)state;
    tp_scene scene = scene_of_rows(TP_RUNG_AUTO);
    const tp_config config = config_of(0, 16, false);
    const size_t bytes = tp_frame_bytes(&config, &scene);
    const tp_assets none = { .boat = NULL };

    scene.quality.rows = TP_RUNG_EXACT;
    assert_int_equal(tp_frame_bytes(&config, &scene), bytes);
    test_frame f = frame_of(&scene, &none, &config);
    assert_null(f.frame->buffers.fast_lines);
    scene.quality.rows = TP_RUNG_FAST;
    assert_true(tp_frame_bytes(&config, &scene) > bytes);
    tp_world *world = scene_world(&scene, &none);       /* asked for after init */
    static uint32_t pixels[PIXELS];
    frame_draw_picture(&f, world, pixels);
    assert_int_equal(f.frame->column_bits, 0);
    frame_free(&f);
    free(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depths_and_tiles_change_no_pixel),
        cmocka_unit_test(solids_stay_in_their_box),
        cmocka_unit_test(fast_rows_are_near_triangles),
        cmocka_unit_test(samples_of_tiles_have_their_kinds),
        cmocka_unit_test(exact_rows_take_no_memory_for_fast_rows),
    };
    chance = random_seed();
    kit_make(&kit, &chance);
    return cmocka_run_group_tests_name("frame/fast_rows", tests, NULL, NULL);
}
