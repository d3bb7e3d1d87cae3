/* SPDX-License-Identifier: MIT */
/* Streamed lines give the same picture as stored lines, bit for bit, without any other write:
 * for any scene, tiling, renderer and number of kept bytes. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/tools.h"
#include "view/fan.h"
#include "tests/lib/tilings.h"

enum { WIDTH = TWICE_WIDTH, HEIGHT = TWICE_HEIGHT };

#define LAND_CORNER 20          /* bytes of a stored vertex of the land */

static uint64_t chance;
static test_kit kit;
static tp_program small; /* all modules, without a store */

typedef struct {
    uint32_t drawn, streamed, cut, rows, coastal, land;
} counts;

static bool is_cut(const tp_grid *grid)
{
    for (uint32_t j = 0; !grid->streams && j + 1 < grid->rows; j++)
        for (uint32_t i = grid->span[j].first; i < grid->span[j].end; i++)
            if (grid->vertex[(size_t)j * grid->cols + i].u == TP_GRID_NEEDS_CLIP)
                return true;
    return false;
}

/* Returns bytes for no line, for some lines or for all. */
static uint32_t random_kept_bytes(void)
{
    const uint32_t kept[] = { 0, random_below(&chance, 500), random_below(&chance, 9000),
                              1u << 30 };
    return kept[random_below(&chance, 4)];
}

/* Compares by the streamed frame's renderer: with a camera that looks along x it has no
 * scanlines. */
static void compare(const tp_scene *scene, const tp_assets *assets, const tp_world *world,
                    counts *count)
{
    static uint32_t picture[2][WIDTH * HEIGHT];
    const tp_config whole = { .width = WIDTH,
                              .height = HEIGHT,
                              .tile_height = HEIGHT,
                              .format = TP_FORMAT_XRGB8888 };
    const tp_config tiled = { .width = WIDTH,
                              .height = HEIGHT,
                              .tile_width = 16 * random_below(&chance, 5),
                              .tile_height = random_below(&chance, HEIGHT),
                              .format = TP_FORMAT_XRGB8888,
                              .kept_bytes = random_kept_bytes() };
    test_frame kept = frame_of(scene, assets, &whole);
    test_frame some = frame_by(&small, scene, assets, &tiled);

    for (int k = 0; k < 2; k++) {               /* second draw: memory full of the first */
        tp_frame_begin(some.frame, world);
        tp_rungs rungs = some.frame->rungs;
        rungs.visibility = some.frame->visibility;
        tp_frame_set_rungs(kept.frame, &rungs);
        tp_frame_begin(kept.frame, world);
        twice_paint(&kept, false, picture[0]);
        twice_paint(&some, chance_int(&chance, 0, 3) == 0, picture[1]);
        assert_memory_equal(picture[0], picture[1], sizeof picture[0]);
        assert_int_equal(tp_frame_stats(kept.frame).vertices,
                         tp_frame_stats(some.frame).vertices);
    }
    const tp_grid *grid = some.frame->buffers.grid;
    count->drawn++;
    if (grid->streams && some.frame->visibility <= TP_VISIBILITY_ROWS) {
        count->streamed++;
        count->cut += is_cut(kept.frame->buffers.grid);
        count->rows += some.frame->visibility == TP_VISIBILITY_ROWS;
        count->coastal += grid->dry != NULL;
        for (uint32_t i = 0; grid->dry && i < grid->rows * grid->cols; i++)
            if (grid->dry[i / 32] >> i % 32 & 1) {
                count->land++;
                break;
            }
    }
    frame_free(&kept);
    frame_free(&some);
}

static void any_scene_is_drawn_the_same(void **state)
{
    (void)state;
    counts count = { .drawn = 0 };
    const int scenes = random_rounds(300, 120);

    for (int n = 0; n < scenes; n++) {
        tp_scene scene = kit_scene(&chance, 3600, 24);
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        if (n % 4) {
            scene.floor.depth = 0;
            scene.floor.map[0] = '\0';
            scene.quality.visibility = chance_int(&chance, TP_VISIBILITY_TRIANGLES,
                                                  TP_VISIBILITY_ROWS);
        }
        scene.quality.rows = chance_int(&chance, TP_RUNG_AUTO, TP_RUNG_PAIRS);
        tp_world *world = scene_world(&scene, &assets);
        if (world)
            compare(&scene, &assets, world, &count);
        free(world);
    }
    printf("# drawn %" PRIu32 ", streamed %" PRIu32 ", with cut cells %" PRIu32
           ", coastal %" PRIu32 ", with land %" PRIu32 "\n",
           count.drawn, count.streamed, count.cut, count.coastal, count.land);
    assert_true(count.streamed > (uint32_t)scenes / 6 && count.cut > (uint32_t)scenes / 15);
    assert_true(count.coastal > (uint32_t)scenes / 30);
}

/* Views where the scanline renderer is valid, or nearly so. */
static void rows_are_drawn_the_same(void **state)
{
    (void)state;
    counts count = { .drawn = 0 };
    const tp_assets none = { .boat = NULL };
    const int views = random_rounds(300, 120);

    for (int n = 0; n < views; n++) {
        tp_scene scene = scene_plain();
        scene.camera.x = chance_fx(&chance, -40, 40);
        scene.camera.z = chance_fx(&chance, -40, 40);
        scene.camera.y = chance_fx(&chance, 0.7, 12);
        scene.camera.heading = chance_fx(&chance, -60, 60) + n % 2 * 180 * TP_FX_ONE;
        scene.camera.pitch = chance_fx(&chance, -20, 0);
        scene.grid.vertices = chance_int(&chance, 64, 4000);
        scene.quality.visibility = TP_VISIBILITY_ROWS;
        scene.quality.rows = chance_int(&chance, TP_RUNG_AUTO, TP_RUNG_PAIRS);
        tp_world *world = scene_world(&scene, &none);
        compare(&scene, &none, world, &count);
        free(world);
    }
    printf("# by rows %" PRIu32 ", cut %" PRIu32 "\n", count.rows, count.cut);
    assert_true(count.rows > (uint32_t)views / 5 && count.cut > (uint32_t)views / 15);
}

/* A beach in views with land and with overhanging crests, or deeper water without them,
 * which scanlines draw. */
static void coasts_are_drawn_the_same(void **state)
{
    (void)state;
    counts count = { .drawn = 0 };
    const tp_assets none = { .boat = NULL };
    const int views = random_rounds(300, 120);

    for (int n = 0; n < views; n++) {
        tp_scene scene = scene_plain();
        const bool deep = n % 3 == 0;
        scene.floor.depth = deep ? chance_fx(&chance, 6, 20) : chance_fx(&chance, 1, 6);
        scene.floor.slope = deep ? 0 : chance_fx(&chance, 0, 0.3);
        scene.floor.heading = chance_fx(&chance, 0, 360);
        scene.surf.stretch = chance_fx(&chance, 0, 1);
        scene.camera.y = chance_fx(&chance, 2, 12);
        scene.camera.heading = chance_fx(&chance, 0, 360);
        scene.camera.pitch = chance_fx(&chance, deep ? -15 : -40, 0);
        scene.grid.vertices = chance_int(&chance, 64, 3600);
        scene.quality.visibility = chance_int(&chance, TP_VISIBILITY_TRIANGLES,
                                              TP_VISIBILITY_ROWS);
        tp_world *world = scene_world(&scene, &none);
        if (world)
            compare(&scene, &none, world, &count);
        free(world);
    }
    printf("# coastal %" PRIu32 ", with land %" PRIu32 ", by rows %" PRIu32 "\n",
           count.coastal, count.land, count.rows);
    assert_true(count.coastal > (uint32_t)views / 2 && count.land > (uint32_t)views / 4);
    assert_true(count.rows > (uint32_t)views / 10);
}

static void check_saved_bytes(bool coastal)
{
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_width = 32,
                               .tile_height = 4,
                               .format = TP_FORMAT_RGB565 };
    const tp_config streamed = config_with(&config, &small, NULL);
    tp_scene scene = scene_plain();

    scene.grid.vertices = 4096;
    scene.quality.visibility = TP_VISIBILITY_TRIANGLES;
    scene.floor.depth = coastal ? 4 * TP_FX_ONE : 0;
    const size_t saved =
        tp_frame_bytes(&config, &scene) - tp_frame_bytes(&streamed, &scene);
    const uint32_t cols = tp_fan_most_cols(4096);
    const size_t land = coastal ? 4096 * LAND_CORNER : 0;
    assert_int_equal(saved, (4096 - 2 * cols) * sizeof(tp_grid_vertex) + land);
    assert_true(tp_frame_scratch_bytes(&streamed, &scene)
                <= tp_frame_scratch_bytes(&config, &scene)
                       + tp_grid_window_bytes(cols, coastal));
}

static void what_is_not_stored_takes_no_memory(void **state)
{
    (void)state;
    check_saved_bytes(false);
    check_saved_bytes(true);
}

/* -- kept lines ---------------------------------------------------------------------- */

enum { MOST_ROWS = 200, MOST_COLS = 128 };

static uint8_t  times[MOST_ROWS][MOST_COLS];    /* evaluations of each vertex by the tiles */
static uint32_t evaluated, repeated;

static void count_row(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                      tp_grid_vertex *vertex)
{
    tp_draw_exact_waves.evaluate_row(grid, j, first, end, vertex);
    assert_true(j < MOST_ROWS && end <= MOST_COLS);
    evaluated += end - first;
    for (uint32_t i = first; i < end; i++)
        repeated += times[j][i]++ > 0;
}

static const struct tp_draw_exact_waves counted = { count_row };

/* Draws strips of a scene; returns how often the tiles evaluate a vertex anew in its strip. */
static uint32_t count_repeats(const tp_scene *scene, const tp_world *world,
                              const tp_program *program, uint32_t kept_bytes)
{
    const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_width = 32,
                               .tile_height = 4, .kept_bytes = kept_bytes };
    test_frame f = frame_by(program, scene, NULL, &config);
    const uint32_t down = f.frame->down, strips = f.frame->across;
    tp_tile tile;

    tp_frame_begin(f.frame, world);
    evaluated = repeated = 0;
    for (uint32_t x = 0; x < strips; x++) {
        memset(times, 0, sizeof times);
        for (uint32_t y = 0; y < down; y++) {
            tp_frame_draw_tile(f.frame, kept_bytes ? x * down + y : y * strips + x,
                               f.scratch, &tile);
            assert_int_equal(tile.x0, x * 32);
            assert_int_equal(tile.y0, y * 4);
        }
    }
    frame_free(&f);
    return repeated;
}

static void enough_bytes_evaluate_each_vertex_once_a_strip(void **state)
{
    (void)state;
    tp_program program = small;
    program.draw.exact_waves = &counted;

    for (int n = 0; n < 20; n++) {
        tp_scene scene = scene_plain();
        scene.camera.y = chance_fx(&chance, 2, 9);
        scene.camera.pitch = chance_fx(&chance, -20, -5);
        scene.grid.vertices = 1200;
        scene.quality.visibility = n % 2 ? TP_VISIBILITY_ROWS : TP_VISIBILITY_TRIANGLES;
        tp_world *world = scene_world(&scene, NULL);
        const uint32_t none = count_repeats(&scene, world, &program, 0);
        const uint32_t all = evaluated - none;
        const uint32_t some = count_repeats(&scene, world, &program, 2500);
        assert_true(none > all / 4 && some < none);
        assert_int_equal(count_repeats(&scene, world, &program, 1 << 20), 0);
        assert_int_equal(evaluated, all);
        free(world);
    }
}

/* Two frames that draw in turns into one scratch do not take each other's lines. */
static void kept_lines_belong_to_a_frame(void **state)
{
    (void)state;
    static uint32_t picture[2][WIDTH * HEIGHT];
    const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_width = 16,
                               .tile_height = 8, .kept_bytes = 4000 };
    tp_scene scene[2] = { scene_plain(), scene_plain() };
    test_frame f[2];
    tp_world *world[2];
    tp_tile   tile;

    scene[1].camera.x = 3 * TP_FX_ONE;
    for (int k = 0; k < 2; k++) {
        scene[k].grid.vertices = 600;
        world[k] = scene_world(&scene[k], NULL);
        f[k] = frame_by(&small, &scene[k], NULL, &config);
        frame_draw_picture(&f[k], world[k], picture[k]);
        tp_frame_begin(f[k].frame, world[k]);
    }
    assert_memory_not_equal(picture[0], picture[1], sizeof picture[0]);
    for (uint32_t i = 0; i < 2 * tp_frame_tiles(f[0].frame); i++) {
        assert_true(tp_frame_draw_tile(f[i % 2].frame, i / 2, f[0].scratch, &tile));
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            assert_memory_equal((const uint8_t *)tile.pixels + (y - tile.y0) * tile.stride,
                                &picture[i % 2][y * WIDTH + tile.x0],
                                (tile.x1 - tile.x0) * sizeof(uint32_t));
    }
    for (int k = 0; k < 2; k++) {
        free(world[k]);
        frame_free(&f[k]);
    }
}

/* Returns the scratch of a program, in bytes beyond that without kept bytes. */
static size_t bytes_for(const tp_program *program, uint32_t kept_bytes)
{
    tp_scene scene = scene_plain();
    tp_config config = { .width = WIDTH, .height = HEIGHT, .program = program };

    scene.grid.vertices = 600;
    const size_t without = tp_frame_scratch_bytes(&config, &scene);
    config.kept_bytes = kept_bytes;
    return tp_frame_scratch_bytes(&config, &scene) - without;
}

static void only_streamed_lines_take_kept_bytes(void **state)
{
    (void)state;
    tp_program lacking = small;
    lacking.draw.kept_lines = NULL;
    const uint32_t rows = tp_fan_most_rows(600);

    assert_int_equal(bytes_for(&small, 1001), 1008);
    assert_int_equal(bytes_for(&small, UINT32_MAX),
                     tp_kept_lines_bytes(rows, tp_grid_kept_row_bytes(0))
                         + 600 * sizeof(tp_grid_vertex));
    assert_int_equal(bytes_for(&lacking, 1000), 0);
    assert_int_equal(bytes_for(&tp_program_all, 1000), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_scene_is_drawn_the_same),
        cmocka_unit_test(rows_are_drawn_the_same),
        cmocka_unit_test(coasts_are_drawn_the_same),
        cmocka_unit_test(what_is_not_stored_takes_no_memory),
        cmocka_unit_test(enough_bytes_evaluate_each_vertex_once_a_strip),
        cmocka_unit_test(kept_lines_belong_to_a_frame),
        cmocka_unit_test(only_streamed_lines_take_kept_bytes),
    };
    chance = 20;
    kit_make(&kit, &chance);
    small = tp_program_all;
    small.method.triangles = &tp_method_streamed;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
