/* SPDX-License-Identifier: MIT */
/* Layers, distortion, ripples and bumps in whole frames: the same for every tiling, at the
 * ends of the parameters, under parameter changes while a frame lives, and after years. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/water/water.h"
#include "frame/frame.h"
#include "world/pools.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

enum { WIDTH = 150, HEIGHT = 90, PIXELS = WIDTH * HEIGHT };

static uint64_t chance;
static test_boat pictures;              /* for its textures with odd sides */
static tp_texture wide, square;         /* 4096 x 1, 64 x 64 */

static tp_assets all_assets(void)
{
    return (tp_assets){
        .layer = { &pictures.texture[0], &pictures.texture[1], &wide },
        .distortion = &pictures.texture[1], .ripple = &pictures.texture[0],
    };
}

/* A texture that any drift changes. */
static tp_assets square_assets(void)
{
    return (tp_assets){ .layer = { &square, &square, &square }, .distortion = &square,
                        .ripple = &square };
}

static void any_map(tp_scene_map *map)
{
    map->size = chance_scale(&chance, 0.1, 1000);
    map->drift_x = chance_fx(&chance, -20, 20);
    map->drift_z = chance_fx(&chance, -20, 20);
}

/* A scene with every feature of the water, a pool and a field included. */
static tp_scene busy_scene(void)
{
    tp_scene s = scene_plain();

    s.camera.y = chance_fx(&chance, 0.5, 9);
    s.camera.pitch = chance_fx(&chance, -40, 5);
    s.water.filter = chance_int(&chance, 0, 1);
    s.water.pool_normal_strength = chance_fx(&chance, 0.1, 4);
    s.pool.cols = 32;
    s.pool.rows = 24;
    s.pool.cell = TP_FX(0.25);
    s.field.cols = 16;
    s.field.rows = 16;
    s.field.boundary = TP_EDGES_TILE;
    s.field.cell = TP_FX(0.5);
    s.pool.splash_interval = s.field.splash_interval = TP_FX_ONE / 4;
    s.pool.splash_height = s.field.splash_height = TP_FX(0.1);
    s.pool.splash_width = s.field.splash_width = TP_FX_ONE;
    for (int k = 0; k < TP_LAYERS; k++) {
        any_map(&s.layer[k].map);
        s.layer[k].saturation = chance_int(&chance, 0, 4) * TP_FX_ONE;
        s.layer[k].clamp = chance_int(&chance, 0, 1) * chance_fx(&chance, 0, 0.95);
        s.layer[k].colour = chance_int(&chance, 0, 0xffffff);
    }
    any_map(&s.distortion.map);
    any_map(&s.ripple.map);
    s.distortion.strength = chance_fx(&chance, 0, 20);
    return s;
}

static tp_world *world_of(const tp_scene *scene)
{
    const tp_assets none = { 0 };
    tp_world *world = scene_world(scene, &none);

    for (int i = 0; i < 40; i++)
        tp_world_step(&tp_program_all, world, scene, NULL);
    return world;
}

/* Draws the begun frame in tiles, without a new beginning. */
static void draw(const test_frame *f, uint32_t *picture)
{
    tp_tile tile;

    memset(picture, 0, PIXELS * sizeof *picture);
    for (uint32_t i = 0; tp_frame_draw_tile(f->frame, i, f->scratch, &tile); i++) {
        for (uint32_t y = tile.y0; y < tile.y1; y++) {
            const uint8_t *row =
                (const uint8_t *)tile.pixels + (y - tile.y0) * tile.stride;
            memcpy(picture + y * WIDTH + tile.x0, row, (tile.x1 - tile.x0) * 4);
        }
    }
    assert_true(frame_guard_holds(f->block, f->bytes));
    assert_true(frame_guard_holds(f->scratch, f->scratch_bytes));
}

static tp_config cut(uint32_t tile_width, uint32_t tile_height)
{
    return (tp_config){ .width = WIDTH,
                        .height = HEIGHT,
                        .tile_width = tile_width,
                        .tile_height = tile_height,
                        .format = TP_FORMAT_XRGB8888 };
}

static void draw_new(const tp_scene *scene, const tp_assets *assets,
                     const tp_world *world, uint32_t tile_width, uint32_t tile_height,
                     uint32_t *picture)
{
    const tp_config config = cut(tile_width, tile_height);
    test_frame f = frame_of(scene, assets, &config);

    tp_frame_begin(f.frame, world);
    draw(&f, picture);
    frame_free(&f);
}

static void every_tiling_gives_the_same_bits(void **state)
{
    (void)state;
    static uint32_t whole[PIXELS], part[PIXELS];
    static const uint32_t sizes[][2] = { { 0, 1 }, { 16, 0 }, { 48, 7 }, { 64, 16 } };

    for (int n = 0; n < 25; n++) {
        tp_scene scene = busy_scene();
        tp_world *world = world_of(&scene);
        tp_assets assets = all_assets();
        if (n % 3 == 0) {                       /* the roughest scene, and 1 x 1 tiles */
            scene.distortion.strength = 20 * TP_FX_ONE;
            scene.distortion.map.size = scene.layer[2].map.size = TP_FX(0.1);
            assets.layer[1] = &pictures.texture[2];
        }
        draw_new(&scene, &assets, world, 0, 0, whole);
        for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
            draw_new(&scene, &assets, world, sizes[i][0], sizes[i][1], part);
            assert_memory_equal(part, whole, sizeof whole);
        }
        free(world);
    }
}

/* -- parameters that change ---------------------------------------------------------- */

/* A frame that has drawn with other parameters draws the same as a new frame; and each
 * parameter has an effect on the picture. */
static void numbers_may_change_while_the_frame_lives(void **state)
{
    (void)state;
    static uint32_t before[PIXELS], after[PIXELS], fresh[PIXELS];
    tp_scene scene = busy_scene();
    const tp_assets assets = square_assets();
    const tp_config config = cut(0, 0);
    scene.camera.y = 3 * TP_FX_ONE;
    scene.camera.pitch = -30 * TP_FX_ONE;
    scene.ripple.map.size = 2 * TP_FX_ONE;
    scene.distortion.map.size = 5 * TP_FX_ONE;
    for (int k = 0; k < TP_LAYERS; k++) {
        scene.layer[k] = (tp_scene_layer){ { "", 4 * TP_FX_ONE, TP_FX(0.1), TP_FX(0.2) },
                                           TP_FX_ONE, 0, 0x404040 };
    }
    int32_t *const number[] = {
        &scene.ripple.map.size, &scene.ripple.map.drift_x, &scene.ripple.map.drift_z,
        &scene.ripple.bump, &scene.layer[0].map.size, &scene.layer[0].saturation,
        &scene.layer[0].clamp, &scene.layer[0].colour, &scene.layer[1].map.drift_x,
        &scene.layer[1].clamp, &scene.layer[1].colour, &scene.layer[2].map.drift_z,
        &scene.layer[2].saturation, &scene.distortion.strength,
        &scene.distortion.map.size, &scene.distortion.map.drift_x, &scene.water.filter,
        &scene.water.pool_normal_strength,
    };
    tp_world *world = world_of(&scene);
    test_frame f = frame_of(&scene, &assets, &config);

    tp_frame_begin(f.frame, world);
    draw(&f, before);
    for (size_t i = 0; i < sizeof number / sizeof number[0]; i++) {
        const int32_t old = *number[i];
        *number[i] = old < 2 ? 1 - old + (number[i] == &scene.layer[0].clamp
                                          || number[i] == &scene.layer[1].clamp) * 9999
                             : old / 2;
        tp_frame_begin(f.frame, world);
        draw(&f, after);
        draw_new(&scene, &assets, world, 0, 0, fresh);
        assert_memory_equal(after, fresh, sizeof fresh);
        assert_memory_not_equal(after, before, sizeof before);
        *number[i] = old;
        tp_frame_begin(f.frame, world);
        draw(&f, after);
        assert_memory_equal(after, before, sizeof before);
    }
    frame_free(&f);
    free(world);
}

static tp_stage stage_at(const tp_frame *frame, int i)
{
    return tp_frame_list(frame, TP_MARK_WATER)->shader[i].stage;
}

/* Values without effect, 0, 1 and white, select the plain stage. */
static void plain_layers_are_the_plain_stage(void **state)
{
    (void)state;
    tp_scene scene = scene_plain();
    const tp_assets assets = { .layer = { &pictures.texture[0] },
                               .distortion = &pictures.texture[1] };
    const tp_config config = cut(0, 0);
    tp_world *world = world_of(&scene);

    scene.distortion.strength = TP_FX_ONE;
    test_frame f = frame_of(&scene, &assets, &config);
    scene.distortion.strength = 0;
    tp_frame_begin(f.frame, world);
    assert_true(stage_at(f.frame, 0) == tp_stage_texture_linear_tinted);
    assert_true(stage_at(f.frame, 1) == tp_stage_view);
    scene.distortion.strength = TP_FX_ONE;
    scene.layer[0].saturation = 0;
    tp_frame_begin(f.frame, world);
    assert_true(stage_at(f.frame, 0) == tp_stage_bend);
    assert_true(stage_at(f.frame, 1) == tp_stage_texture_linear_graded);
    frame_free(&f);
    free(world);
}

/* -- bumps --------------------------------------------------------------------------- */

/* The mesh equals that of a scene without pools, the light does not. */
static void bumped_pools_leave_the_mesh(void **state)
{
    (void)state;
    static uint32_t bumped[PIXELS], still[PIXELS];
    tp_scene scene = busy_scene(), bare = scene;
    const tp_assets assets = all_assets();
    const tp_config config = cut(0, 0);

    bare.pool.cols = bare.field.cols = 0;
    tp_world *world = world_of(&scene), *calm = world_of(&bare);
    test_frame f = frame_of(&scene, &assets, &config);
    test_frame g = frame_of(&bare, &assets, &config);
    tp_frame_begin(f.frame, world);
    tp_frame_begin(g.frame, calm);
    assert_null(f.frame->surface.pool);
    assert_null(f.frame->surface.field);
    assert_true(f.bytes >= g.bytes + (34 * 26 + 18 * 18) * sizeof(tp_pool_slope));
    const size_t count = (size_t)f.frame->buffers.grid->cols * f.frame->buffers.grid->rows;
    for (size_t i = 0; i < count; i++) {
        const tp_grid_vertex *a = &f.frame->buffers.grid->vertex[i];
        const tp_grid_vertex *b = &g.frame->buffers.grid->vertex[i];
        if (a->u == (int32_t)0xa5a5a5a5)        /* not needed, never set */
            continue;
        assert_int_equal(a->u, b->u);
        assert_int_equal(a->zi, b->zi);
        assert_int_equal(a->slope_x, b->slope_x);
    }
    draw(&f, bumped);
    draw(&g, still);
    assert_memory_not_equal(bumped, still, sizeof still);
    frame_free(&f);
    frame_free(&g);
    free(world);
    free(calm);
}

/* A frame that was made without the pools' slope maps draws pools as heights. */
static void bumps_without_room_are_heights(void **state)
{
    (void)state;
    static uint32_t heights[PIXELS], asked[PIXELS];
    tp_scene scene = busy_scene();
    const tp_assets assets = all_assets();
    const tp_config config = cut(0, 0);

    scene.water.pool_normal_strength = 0;
    tp_world *world = world_of(&scene);
    test_frame f = frame_of(&scene, &assets, &config);
    tp_frame_begin(f.frame, world);
    draw(&f, heights);
    scene.water.pool_normal_strength = TP_FX_ONE;
    tp_frame_begin(f.frame, world);
    assert_ptr_equal(f.frame->surface.pool, tp_world_pool(world));
    draw(&f, asked);
    assert_memory_equal(asked, heights, sizeof heights);
    frame_free(&f);
    free(world);
}

/* Slopes are computed when the frame begins. */
static void the_world_may_move_on_while_tiles_are_drawn(void **state)
{
    (void)state;
    static uint32_t before[PIXELS], after[PIXELS];
    const tp_scene scene = busy_scene();
    const tp_assets assets = all_assets();
    const tp_config config = cut(0, 0);
    tp_world *world = world_of(&scene);
    test_frame f = frame_of(&scene, &assets, &config);

    tp_frame_begin(f.frame, world);
    draw(&f, before);
    for (int i = 0; i < 30; i++)
        tp_world_step(&tp_program_all, world, &scene, NULL);
    draw(&f, after);
    assert_memory_equal(after, before, sizeof before);
    frame_free(&f);
    free(world);
}

/* -- years --------------------------------------------------------------------------- */

/* Repeats drifted since tick 0 compared with long double, up to 30 years: positions are
 * truncated to 16.16, the drift per tick to Q48. */
static void pictures_drift_for_years(void **state)
{
    (void)state;
    const tp_assets assets = all_assets();
    const tp_config config = cut(0, 0);
    double worst = 0;

    for (int n = 0; n < 60; n++) {
        tp_scene scene = busy_scene();
        tp_world *world = world_of(&scene);
        test_frame f = frame_of(&scene, &assets, &config);
        world->tick = random_next(&chance) % (30ull * 366 * 86400 * 60);
        world->lag = chance_int(&chance, 0, 65536);
        tp_frame_begin(f.frame, world);
        const tp_ripple *ripple = tp_frame_module_memory(f.frame, TP_RIPPLE_ID);
        const tp_layer *layer = &ripple->layer;
        const long double time = (long double)f.frame->drawn.time / 65536 / 60;
        const long double way = scene.ripple.map.drift_x * time;        /* 16.16 m */
        const long double repeats = -way * layer->per_metre / 4294967296.0L;
        const double want = (double)(repeats - floorl(repeats));
        double off = fabs(layer->drift_s / 4294967296.0 - want);
        off = fmin(off, 1 - off) * scene.ripple.map.size;       /* 1/65536 m */
        worst = fmax(worst, off);
        assert_true(off <= 1.5 + (double)world->tick / 4294967296.0);
        frame_free(&f);
        free(world);
    }
    printf("    after years        off by %.3f of 1/65536 m at the most\n", worst);
}

int main(void)
{
    static uint32_t pixels[4096];
    static uint32_t mem[2][8192];

    chance = random_seed();
    boat_make(&pictures, &chance);
    for (int i = 0; i < 4096; i++)
        pixels[i] = (uint32_t)random_next(&chance);
    if (tp_texture_init(&wide, pixels, 4096, 1, mem[0], tp_texture_bytes(4096, 1), NULL)
            != TP_OK
        || tp_texture_init(&square, pixels, 64, 64, mem[1], tp_texture_bytes(64, 64),
                           NULL)
               != TP_OK)
        return 1;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tiling_gives_the_same_bits),
        cmocka_unit_test(numbers_may_change_while_the_frame_lives),
        cmocka_unit_test(plain_layers_are_the_plain_stage),
        cmocka_unit_test(bumped_pools_leave_the_mesh),
        cmocka_unit_test(bumps_without_room_are_heights),
        cmocka_unit_test(the_world_may_move_on_while_tiles_are_drawn),
        cmocka_unit_test(pictures_drift_for_years),
    };
    return cmocka_run_group_tests_name("frame/layers", tests, NULL, NULL);
}
