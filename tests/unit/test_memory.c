/* SPDX-License-Identifier: MIT */
/* Memory that callers give to init functions: NULL, short or misaligned memory is refused
 * with the argument's name and without a write; NULL assets mean no assets. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "pixel/pixel.h"
#include "pool/pool.h"
#include "quality/plan.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"
#include "waves/coastal_water.h"

enum { BYTES = 1 << 20, WIDTH = 32, HEIGHT = 24 };

static const tp_config picture = {
    .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = TP_FORMAT_XRGB8888
};
static const tp_assets none;
static _Alignas(8) uint8_t memory[BYTES], before[BYTES];

static void assert_named(tp_status status, tp_status wanted, const tp_error *err,
                         const char *word)
{
    assert_int_equal(status, wanted);
    assert_int_equal(err->code, wanted);
    assert_string_equal(err->word, word);
}

static tp_status init_world(void *block, tp_error *err)
{
    const tp_scene scene = scene_plain();
    return tp_world_init(&tp_program_all, block, BYTES - 8, &scene, &none, err);
}

static tp_status init_frame(void *block, tp_error *err)
{
    const tp_scene scene = scene_plain();
    tp_frame *frame = NULL;
    return tp_frame_init(&frame, &picture, &scene, block, BYTES - 8, err);
}

static tp_status init_pool(void *block, tp_error *err)
{
    static const tp_pool_config config = {
        .cols = 16, .rows = 16, .cells = TP_CELLS_16, .courant = TP_FX(0.4), .damping = 6,
        .range = TP_FX_ONE, .cell = TP_FX_ONE,
    };
    return tp_pool_init(block, &config, err);
}

static tp_status init_coastal(void *block, tp_error *err)
{
    static const tp_coastal_config config = { .floor.depth = 4 * TP_FX_ONE };
    static const tp_wave wave = { .amplitude = TP_FX_ONE, .length = 20 * TP_FX_ONE,
                                  .speed = TP_FX_ONE };
    tp_deep_water deep;
    tp_deep_water_init(&deep, &wave, 1, TP_FX(9.81));
    return tp_coastal_init(block, &config, &deep, &wave, 1, err);
}

static tp_status init_texture(void *block, tp_error *err)
{
    static const uint32_t pixels[4] = { 1, 2, 3, 4 };
    tp_texture texture;
    return tp_texture_init(&texture, pixels, 2, 2, block, tp_texture_bytes(2, 2), err);
}

static void every_init_refuses_blocks_that_are_null_or_misaligned(void **state)
{
    (void)state;
    static const struct {
        const char *word;
        uint32_t align;
        tp_status (*init)(void *block, tp_error *err);
    } inits[] = { { "world", 8, init_world },
                  { "memory", 8, init_frame },
                  { "pool", 8, init_pool },
                  { "coastal", 8, init_coastal },
                  { "memory", 4, init_texture } };

    for (size_t i = 0; i < sizeof inits / sizeof *inits; i++) {
        tp_error err;
        memset(memory, 0xa5, sizeof memory);
        memcpy(before, memory, sizeof memory);
        assert_named(inits[i].init(NULL, &err), TP_E_NULL, &err, inits[i].word);
        for (uint32_t at = 1; at < inits[i].align; at++) {
            assert_named(inits[i].init(memory + at, &err), TP_E_ALIGN, &err,
                         inits[i].word);
            assert_int_equal(err.a, inits[i].align);
            assert_memory_equal(memory, before, sizeof memory);
        }
        assert_int_equal(inits[i].init(NULL, NULL), TP_E_NULL);
        assert_int_equal(inits[i].init(memory, &err), TP_OK);
    }
}

static tp_status world_of(size_t bytes, const tp_scene *scene, tp_error *err)
{
    return tp_world_init(NULL, (tp_world *)(void *)memory, bytes, scene, &none, err);
}

static tp_status frame_in(size_t bytes, const tp_scene *scene, tp_error *err)
{
    tp_frame *frame;
    return tp_frame_init(&frame, &picture, scene, memory, bytes, err);
}

static void check_sizes(tp_status (*init)(size_t, const tp_scene *, tp_error *),
                        const tp_scene *scene, size_t bytes)
{
    tp_error err;

    memset(memory, 0xa5, sizeof memory);
    memcpy(before, memory, sizeof memory);
    for (size_t n = 0; n < bytes; n += bytes / 16 + 1) {
        assert_int_equal(init(n, scene, &err), TP_E_NOSPACE);
        assert_int_equal(err.a, (int32_t)bytes);
        assert_int_equal(err.b, (int32_t)n);
        assert_memory_equal(memory, before, sizeof memory);
    }
    assert_int_equal(init(bytes - 1, scene, &err), TP_E_NOSPACE);
    assert_int_equal(init(bytes, scene, &err), TP_OK);
    assert_memory_equal(memory + bytes, before + bytes, sizeof memory - bytes);
}

static void too_few_bytes_are_refused(void **state)
{
    (void)state;
    const tp_scene scene = scene_plain();

    check_sizes(world_of, &scene, tp_world_bytes(NULL, &scene, &none));
    check_sizes(frame_in, &scene, tp_frame_bytes(&picture, &scene));
}

static void every_missing_argument_is_named(void **state)
{
    (void)state;
    const tp_scene scene = scene_plain();
    tp_world *const world = (tp_world *)(void *)memory;
    tp_frame *frame;
    tp_error err;

    assert_named(tp_scene_check(NULL, &err), TP_E_NULL, &err, "scene");
    assert_named(tp_world_init(&tp_program_all, world, BYTES, NULL, &none, &err),
                 TP_E_NULL, &err, "scene");
    assert_named(tp_frame_init(&frame, &picture, NULL, memory, BYTES, &err), TP_E_NULL,
                 &err, "scene");
    assert_named(tp_frame_init(NULL, &picture, &scene, memory, BYTES, &err), TP_E_NULL,
                 &err, "frame");
    assert_int_equal(tp_frame_init(&frame, NULL, &scene, memory, BYTES, &err), TP_E_SIZE);
    assert_named(tp_pool_init((tp_pool *)(void *)memory, NULL, &err), TP_E_NULL, &err,
                 "config");
    assert_int_equal(tp_pool_bytes(NULL), 0);
    assert_int_equal(tp_coastal_bytes(NULL, NULL), 0);
    assert_int_equal(tp_world_bytes(&tp_program_all, NULL, &none), 0);
    assert_int_equal(tp_frame_bytes(&picture, NULL), 0);
    assert_int_equal(tp_frame_bytes(NULL, &scene), 0);
    assert_int_equal(tp_frame_scratch_bytes(NULL, &scene), 0);
    assert_int_equal(tp_frame_scratch_bytes(&picture, NULL), 0);
    assert_int_equal(tp_world_init(NULL, world, BYTES, &scene, &none, &err), TP_OK);
    assert_false(tp_world_apply(NULL, world, NULL, &none));
}

static uint32_t frame_crc(const tp_assets *assets)
{
    const tp_scene scene = scene_plain();
    tp_world *world = scene_world(&scene, assets);
    test_frame f = frame_of(&scene, assets, &picture);
    uint32_t crc = 0;
    tp_tile  tile;

    tp_frame_begin(f.frame, world);
    for (uint32_t i = 0; tp_frame_draw_tile(f.frame, i, f.scratch, &tile); i++)
        crc = tp_crc32(crc, tile.pixels, tile.stride * (tile.y1 - tile.y0));
    frame_free(&f);
    free(world);
    return crc;
}

static void assets_of_null_are_none(void **state)
{
    (void)state;
    const tp_scene scene = scene_plain();
    const tp_plan a = tp_plan_make(&scene, NULL, WIDTH, HEIGHT);
    const tp_plan b = tp_plan_make(&scene, &none, WIDTH, HEIGHT);

    assert_int_equal(tp_world_bytes(&tp_program_all, &scene, NULL),
                     tp_world_bytes(&tp_program_all, &scene, &none));
    const tp_config without = config_with(&picture, NULL, &none);
    assert_int_equal(tp_frame_bytes(&picture, &scene), tp_frame_bytes(&without, &scene));
    assert_int_equal(frame_crc(NULL), frame_crc(&none));
    assert_memory_equal(&a.set, &b.set, sizeof a.set);
    assert_true(a.price.cost > 0 && a.price.cost == b.price.cost);
}

static void tiles_are_not_drawn_without_memory(void **state)
{
    (void)state;
    const tp_scene scene = scene_plain();
    tp_world *world = scene_world(&scene, &none);
    test_frame f = frame_of(&scene, &none, &picture);
    tp_tile tile;

    tp_frame_begin(f.frame, world);
    assert_false(tp_frame_draw_tile(f.frame, 0, NULL, &tile));
    assert_false(tp_frame_draw_tile(f.frame, 0, f.scratch + 4, &tile));
    assert_false(
        tp_frame_draw_tile_direct(f.frame, 0, f.scratch, NULL, WIDTH * 4, &tile));
    assert_false(tp_frame_draw_tile_direct(f.frame, 0, NULL, memory, WIDTH * 4, &tile));
    assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
    assert_true(
        tp_frame_draw_tile_direct(f.frame, 0, f.scratch, memory, WIDTH * 4, &tile));
    frame_free(&f);
    free(world);
}

/* The plan refuses every picture size that a frame refuses. */
static void pictures_beyond_the_sizes_are_not_planned(void **state)
{
    (void)state;
    static const uint32_t side[] = { 0, 15, 4097, UINT32_MAX };
    const tp_scene scene = scene_plain();

    for (size_t i = 0; i < sizeof side / sizeof *side; i++) {
        assert_int_equal(tp_plan_make(&scene, &none, side[i], 240).price.cost, 0);
        assert_int_equal(tp_plan_make(&scene, &none, 320, side[i]).price.cost, 0);
        assert_int_equal(tp_plan_make(&scene, &none, side[i], 240).open, 0);
    }
    assert_true(tp_plan_make(&scene, &none, 16, 4096).price.cost > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_init_refuses_blocks_that_are_null_or_misaligned),
        cmocka_unit_test(too_few_bytes_are_refused),
        cmocka_unit_test(every_missing_argument_is_named),
        cmocka_unit_test(assets_of_null_are_none),
        cmocka_unit_test(tiles_are_not_drawn_without_memory),
        cmocka_unit_test(pictures_beyond_the_sizes_are_not_planned),
    };
    return cmocka_run_group_tests_name("memory", tests, NULL, NULL);
}
