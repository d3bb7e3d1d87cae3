/* SPDX-License-Identifier: MIT */
/* Walked water: the same picture in every tiling, with depths and without, and with points
 * that are not stored; its error; the views that it leaves to triangles. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include "frame/frame.h"
#include "frame/walk_water.h"
#include "tests/lib/frames.h"
#include "tests/lib/picture_difference.h"
#include "tests/lib/scenes.h"

enum { WIDTH = 96, HEIGHT = 64, PIXELS = WIDTH * HEIGHT };

static uint64_t chance;
static const tp_assets none = { .boat = NULL };

static tp_scene level_scene(void)
{
    tp_scene s = scene_plain();

    s.quality.visibility = TP_VISIBILITY_WALK;
    s.camera.y = chance_fx(&chance, 3, 9);
    s.camera.heading = chance_fx(&chance, -180, 180);
    s.camera.pitch = chance_fx(&chance, -25, 5);
    return s;
}

static tp_config config_of(uint32_t tile_width, uint32_t tile_height, bool depth)
{
    return (tp_config){ .width = WIDTH, .height = HEIGHT, .tile_width = tile_width,
                        .tile_height = tile_height, .format = TP_FORMAT_XRGB8888,
                        .depth = depth };
}

/* Draws the scene and returns the renderer. */
static tp_visibility draw(const tp_scene *scene, tp_config config, uint32_t *pixels)
{
    tp_world *world = scene_world(scene, &none);
    test_frame f = frame_of(scene, &none, &config);

    frame_draw_picture(&f, world, pixels);
    const tp_visibility by = f.frame->visibility;
    frame_free(&f);
    free(world);
    return by;
}

static void every_tiling_gives_the_same_bits(void **state)
{
    (void)state;
    static uint32_t whole[PIXELS], other[PIXELS];
    static const uint32_t sizes[][2] = { { 0, 1 }, { 16, 0 }, { 48, 13 }, { 0, 16 } };
    int walked = 0;

    for (int n = 0; n < 40; n++) {
        const tp_scene scene = level_scene();
        walked += draw(&scene, config_of(0, HEIGHT, false), whole) == TP_VISIBILITY_WALK;
        draw(&scene, config_of(0, HEIGHT, true), other);
        assert_memory_equal(other, whole, sizeof whole);
        draw(&scene, config_of(sizes[n % 4][0], sizes[n % 4][1], n % 5 == 0), other);
        assert_memory_equal(other, whole, sizeof whole);
    }
    printf("  %d of 40 pictures walked\n", walked);
    assert_true(walked > 20);
}

/* Draws with each number of kept bytes: none, one line's, some lines', all lines'. */
static void assert_streamed_as(const tp_scene *scene, tp_config config, uint32_t *streamed,
                               const uint32_t *stored, size_t bytes)
{
    static const uint32_t kept[] = { 0, 100, 400, 1500, 1 << 20 };

    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++) {
        config.kept_bytes = kept[i];
        draw(scene, config, streamed);
        assert_memory_equal(streamed, stored, bytes);
    }
}

/* Returns the program whose walked water is streamed. */
static const tp_program *streamed_program(void)
{
    static tp_program small;

    small = tp_program_all;
    small.method.walk = &tp_method_streamed_walk;
    return &small;
}

static void streamed_points_give_the_same_bits(void **state)
{
    (void)state;
    static uint32_t stored[PIXELS], streamed[PIXELS];
    static const uint32_t sizes[][2] = {
        { 0, 1 }, { 16, 2 }, { 48, 13 }, { 0, 16 }, { 32, 64 }, { 80, 5 },
    };
    int walked = 0;

    for (int n = 0; n < 60; n++) {
        const tp_scene scene = level_scene();
        tp_config config = config_of(sizes[n % 6][0], sizes[n % 6][1], n % 5 == 0);
        walked += draw(&scene, config_of(0, HEIGHT, false), stored) == TP_VISIBILITY_WALK;
        config.program = streamed_program();
        assert_streamed_as(&scene, config, streamed, stored, sizeof stored);
    }
    printf("  %d of 60 pictures walked\n", walked);
    assert_true(walked > 30);
}

static uint32_t evaluated;

static tp_surface_point count_point(const tp_surface *surface, const tp_fx place[2],
                                    tp_fx step[2][2])
{
    evaluated++;
    return tp_water_points.point(surface, place, step);
}

static const struct tp_water_points counted = { count_point };

/* Returns the points that the tiles of a frame evaluate. */
static uint32_t count_points(const tp_scene *scene, const tp_world *world,
                             uint32_t kept_bytes)
{
    tp_program program = *streamed_program();
    tp_config  config = config_of(16, 2, false);
    tp_tile    tile;

    program.water.points = &counted;
    config.program = &program;
    config.kept_bytes = kept_bytes;
    test_frame f = frame_by(&program, scene, &none, &config);
    tp_frame_begin(f.frame, world);
    assert_int_equal(f.frame->visibility, TP_VISIBILITY_WALK);
    evaluated = 0;
    for (uint32_t i = 0; tp_frame_draw_tile(f.frame, i, f.scratch, &tile); i++)
        ;
    frame_free(&f);
    return evaluated;
}

static void enough_bytes_evaluate_each_line_once_a_strip(void **state)
{
    (void)state;
    tp_scene scene = level_scene();
    scene.camera.y = 6 * TP_FX_ONE;
    scene.camera.pitch = -12 * TP_FX_ONE;
    tp_world *world = scene_world(&scene, &none);
    const uint32_t streamed = count_points(&scene, world, 0);
    const uint32_t some = count_points(&scene, world, 150);
    const uint32_t all = count_points(&scene, world, 1 << 20);
    tp_config whole = config_of(16, HEIGHT, false);
    whole.program = streamed_program();
    test_frame f = frame_by(whole.program, &scene, &none, &whole);

    tp_frame_begin(f.frame, world);
    printf("  %" PRIu32 " points, %" PRIu32 ", %" PRIu32 "\n", streamed, some, all);
    assert_true(streamed > some && some > all);
    assert_true(all <= 2 * (WIDTH / 16) * f.frame->buffers.walk->lines);
    frame_free(&f);
    free(world);
}

/* Rows of tall pictures are stored in units of several pixels. */
static void tall_pictures_may_be_streamed(void **state)
{
    (void)state;
    enum { TALL = 700, NARROW = 48 };
    static uint32_t stored[NARROW * TALL], streamed[NARROW * TALL];
    tp_scene  scene = level_scene();
    tp_config config = config_of(16, 9, false);

    scene.camera.pitch = -12 * TP_FX_ONE;
    scene.camera.y = 6 * TP_FX_ONE;
    config.width = NARROW;
    config.height = TALL;
    assert_int_equal(draw(&scene, config, stored), TP_VISIBILITY_WALK);
    config.program = streamed_program();
    assert_int_equal(draw(&scene, config, streamed), TP_VISIBILITY_WALK);
    assert_memory_equal(streamed, stored, sizeof stored);
}

/* A stored point takes 8 bytes, a streamed point one. */
static void streamed_points_take_an_eighth(void **state)
{
    (void)state;
    const tp_scene scene = level_scene();
    tp_config config = config_of(16, 2, false);
    const size_t stored = tp_frame_bytes(&config, &scene);

    config.program = streamed_program();
    const size_t streamed = tp_frame_bytes(&config, &scene);
    const size_t points = (HEIGHT / 8 + HEIGHT / 64 + 48) * (WIDTH / 16 + 1);
    assert_true(streamed + 7 * points < stored);
}

/* A picture of odd width has no pairs of columns. */
static void pairs_of_columns_take_half_the_scratch(void **state)
{
    (void)state;
    const tp_scene scene = level_scene();
    tp_config config = config_of(16, 2, false);
    const size_t pairs = tp_frame_scratch_bytes(&config, &scene);

    config.width = WIDTH + 1;
    assert_int_equal(tp_frame_scratch_bytes(&config, &scene) - pairs,
                     tp_fast_rows_bytes(16, 5));
}

static void walked_water_is_near_triangles(void **state)
{
    (void)state;
    static uint32_t walked[PIXELS], exact[PIXELS];
    double sum = 0;
    int count = 0;

    for (int n = 0; n < 40; n++) {
        tp_scene scene = level_scene();
        scene.grid.vertices = 2000;
        if (draw(&scene, config_of(0, 16, false), walked) != TP_VISIBILITY_WALK)
            continue;
        scene.quality.visibility = TP_VISIBILITY_TRIANGLES;
        draw(&scene, config_of(0, 16, false), exact);
        sum += (double)picture_square_sum(walked, exact, PIXELS);
        count++;
    }
    const double db = 10 * log10(65025.0 * 3 * PIXELS * count / sum);
    printf("  %.2f dB against triangles in %d views\n", db, count);
    assert_true(count > 20 && db > 22);
}

/* Swells near the eye, a roll, pools and rings are not walked; neither is a sea without
 * memory for it. */
static void other_views_are_left_to_triangles(void **state)
{
    (void)state;
    static uint32_t pixels[PIXELS];
    tp_scene scene = level_scene();

    scene.camera.pitch = -6 * TP_FX_ONE;
    scene.camera.y = 6 * TP_FX_ONE;
    assert_int_equal(draw(&scene, config_of(0, 16, false), pixels), TP_VISIBILITY_WALK);
    tp_scene low = scene;
    low.camera.y = low.wave[0].amplitude / 2;
    assert_int_equal(draw(&low, config_of(0, 16, false), pixels), TP_VISIBILITY_TRIANGLES);
    tp_scene pool = scene;
    pool.pool.cols = pool.pool.rows = 32;
    assert_int_equal(draw(&pool, config_of(0, 16, false), pixels), TP_VISIBILITY_TRIANGLES);
    tp_scene steep = scene;
    steep.camera.pitch = -80 * TP_FX_ONE;
    assert_int_equal(draw(&steep, config_of(0, 16, false), pixels), TP_VISIBILITY_TRIANGLES);
}

static void a_view_of_the_sky_alone_has_no_water(void **state)
{
    (void)state;
    static uint32_t pixels[PIXELS], triangles[PIXELS];
    tp_scene scene = level_scene();

    scene.camera.pitch = 50 * TP_FX_ONE;
    draw(&scene, config_of(0, 16, false), pixels);
    scene.quality.visibility = TP_VISIBILITY_TRIANGLES;
    draw(&scene, config_of(0, 16, false), triangles);
    assert_memory_equal(pixels, triangles, sizeof pixels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tiling_gives_the_same_bits),
        cmocka_unit_test(streamed_points_give_the_same_bits),
        cmocka_unit_test(enough_bytes_evaluate_each_line_once_a_strip),
        cmocka_unit_test(tall_pictures_may_be_streamed),
        cmocka_unit_test(streamed_points_take_an_eighth),
        cmocka_unit_test(pairs_of_columns_take_half_the_scratch),
        cmocka_unit_test(walked_water_is_near_triangles),
        cmocka_unit_test(other_views_are_left_to_triangles),
        cmocka_unit_test(a_view_of_the_sky_alone_has_no_water),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("frame/walk", tests, NULL, NULL);
}
