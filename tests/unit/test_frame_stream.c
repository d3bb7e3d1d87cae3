/* SPDX-License-Identifier: MIT */
/* Streamed grid vertices give the same picture as stored vertices, bit for bit, without any
 * other write: for any scene, tiling and renderer. */
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
                              .format = TP_FORMAT_XRGB8888 };
    test_frame kept = frame_of(scene, assets, &whole);
    test_frame some = frame_by(&small, scene, assets, &tiled);

    for (int k = 0; k < 2; k++) {               /* second draw: memory full of the first */
        tp_frame_begin(some.frame, world);
        tp_rungs rungs = some.frame->rungs;
        rungs.visibility = some.frame->visibility;
        tp_frame_set_rungs(kept.frame, &rungs);
        tp_frame_begin(kept.frame, world);
        twice_paint(&kept, false, picture[0]);
        twice_paint(&some, false, picture[1]);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_scene_is_drawn_the_same),
        cmocka_unit_test(rows_are_drawn_the_same),
        cmocka_unit_test(coasts_are_drawn_the_same),
        cmocka_unit_test(what_is_not_stored_takes_no_memory),
    };
    chance = 20;
    kit_make(&kit, &chance);
    small = tp_program_all;
    small.method.triangles = &tp_method_streamed;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
