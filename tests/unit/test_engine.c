/* SPDX-License-Identifier: MIT */
/* The engine object: draws the same as its parts do alone, in one block of the stated
 * size. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "pixel/pixel.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"
#include "tidepool/tidepool.h"

enum { WIDTH = 64, HEIGHT = 48, TICKS = 20 };

static const tp_config config = { .width = WIDTH, .height = HEIGHT };

static tp_engine *open_engine(const tp_config *c, const tp_scene *scene, uint8_t **block)
{
    const size_t bytes = tp_engine_bytes(c, scene);
    tp_engine *engine = NULL;

    assert_true(bytes > 0);
    *block = frame_block(bytes);
    assert_int_equal(tp_engine_init(&engine, c, scene, *block, bytes, NULL), TP_OK);
    assert_true(frame_guard_holds(*block, bytes));
    return engine;
}

static uint32_t picture_of(tp_engine *engine)
{
    uint32_t crc = 0, rows = 0;
    tp_tile  tile;

    tp_engine_begin(engine);
    while (tp_engine_next_tile(engine, &tile)) {
        assert_int_equal(tile.y0, rows);
        crc = tp_crc32(crc, tile.pixels, tile.stride * (tile.y1 - tile.y0));
        rows = tile.y1;
    }
    assert_int_equal(rows, HEIGHT);
    assert_false(tp_engine_next_tile(engine, &tile));
    return crc;
}

static void an_engine_draws_what_its_parts_draw(void **state)
{
    (void)state;
    tp_scene scene;
    uint8_t *block;

    tp_scene_init(&scene);
    tp_engine *engine = open_engine(&config, &scene, &block);
    tp_world *world = scene_world(&scene, NULL);
    test_frame f = frame_of(&scene, NULL, &config);
    for (int n = 0; n < TICKS; n++) {
        uint32_t crc = 0;
        tp_tile  tile;
        tp_frame_begin(f.frame, world);
        for (uint32_t i = 0; tp_frame_draw_tile(f.frame, i, f.scratch, &tile); i++)
            crc = tp_crc32(crc, tile.pixels, tile.stride * (tile.y1 - tile.y0));
        assert_int_equal(picture_of(engine), crc);
        assert_int_equal(picture_of(engine), crc);      /* same after a new begin */
        tp_world_step(NULL, world, &scene, NULL);
        tp_engine_step(engine, NULL);
    }
    assert_true(tp_world_tick(tp_engine_world(engine)) == TICKS);
    assert_true(frame_guard_holds(block, tp_engine_bytes(&config, &scene)));
    free(world);
    frame_free(&f);
    free(block);
}

static void the_scenes_clock_slows_an_engine_down(void **state)
{
    (void)state;
    tp_scene scene;
    uint8_t *block;

    tp_scene_init(&scene);
    scene.clock.scale = TP_FX(0.25);
    tp_engine *engine = open_engine(&config, &scene, &block);
    for (int n = 0; n < 40; n++)
        tp_engine_step(engine, NULL);
    assert_in_range(tp_world_tick(tp_engine_world(engine)), 10, 11);
    free(block);
}

/* Changed values take effect at once, even while the water stands still. */
static void changed_values_are_seen_at_once(void **state)
{
    (void)state;
    tp_scene scene, other;
    uint8_t *block, *fresh;
    tp_error err;

    tp_scene_init(&scene);
    tp_engine *engine = open_engine(&config, &scene, &block);
    const uint32_t before = picture_of(engine);
    scene.wave[1].amplitude = TP_FX(0.4);
    scene.water.colour = 0x402010;
    other = scene;
    assert_int_equal(tp_engine_apply(engine, &err), TP_OK);
    tp_engine *same = open_engine(&config, &other, &fresh);
    assert_int_equal(picture_of(engine), picture_of(same));
    assert_int_not_equal(picture_of(engine), before);

    scene.wave[1].amplitude = -1;
    assert_int_equal(tp_engine_apply(engine, &err), TP_E_RANGE);
    assert_string_equal(err.word, "wave1.amplitude");
    scene.wave[1].amplitude = TP_FX(0.4);
    scene.pool.cols = scene.pool.rows = 32;
    assert_int_equal(tp_engine_apply(engine, &err), TP_E_WORLD);
    scene.pool.cols = 0;
    assert_int_equal(tp_engine_apply(engine, &err), TP_OK);
    assert_int_equal(picture_of(engine), picture_of(same));
    free(block);
    free(fresh);
}

static void engines_know_nothing_of_each_other(void **state)
{
    (void)state;
    tp_scene scene, other;
    uint8_t *block[2];

    tp_scene_init(&scene);
    tp_scene_level(&other);
    other.wave[0] = scene.wave[2];
    tp_engine *first = open_engine(&config, &scene, &block[0]);
    const uint32_t alone = picture_of(first);
    tp_engine *second = open_engine(&config, &other, &block[1]);
    tp_engine_step(second, NULL);
    assert_int_not_equal(picture_of(second), alone);
    assert_int_equal(picture_of(first), alone);
    free(block[0]);
    free(block[1]);
}

/* -- refusals ------------------------------------------------------------------------- */

static void refused(const tp_config *c, const tp_scene *scene, size_t bytes, tp_status why,
                    const char *word)
{
    static _Alignas(8) uint8_t memory[1 << 20];
    tp_engine *engine = NULL;
    tp_error   err = { 0 };

    assert_int_equal(tp_engine_init(&engine, c, scene, bytes ? memory : NULL, bytes, &err),
                     why);
    assert_int_equal(err.code, why);
    if (word)
        assert_string_equal(err.word, word);
    assert_null(engine);
}

static void what_cannot_be_used_is_refused(void **state)
{
    (void)state;
    tp_config c = config;
    tp_scene  scene;
    tp_engine *engine;

    tp_scene_init(&scene);
    const size_t bytes = tp_engine_bytes(&config, &scene);
    refused(&config, &scene, bytes - 1, TP_E_NOSPACE, NULL);
    refused(&config, &scene, 8, TP_E_NOSPACE, NULL);
    refused(&config, &scene, 0, TP_E_NULL, "memory");
    refused(NULL, &scene, bytes, TP_E_NULL, "config");
    refused(&config, NULL, bytes, TP_E_NULL, "scene");
    assert_int_equal(tp_engine_init(NULL, &config, &scene, &c, 8, NULL), TP_E_NULL);
    assert_int_equal(tp_engine_init(&engine, &config, &scene, (char *)&c + 1, 8, NULL),
                     TP_E_ALIGN);
    c.width = 15;
    assert_int_equal(tp_engine_bytes(&c, &scene), 0);
    refused(&c, &scene, bytes, TP_E_SIZE, NULL);
    c = config;
    scene.pool.courant = TP_FX(0.9);
    scene.pool.cols = scene.pool.rows = 16;
    assert_int_equal(tp_engine_bytes(&config, &scene), 0);
    refused(&c, &scene, bytes, TP_E_RANGE, "pool.courant");
    assert_int_equal(tp_engine_bytes(NULL, &scene), 0);
    assert_int_equal(tp_engine_bytes(&config, NULL), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_engine_draws_what_its_parts_draw),
        cmocka_unit_test(the_scenes_clock_slows_an_engine_down),
        cmocka_unit_test(changed_values_are_seen_at_once),
        cmocka_unit_test(engines_know_nothing_of_each_other),
        cmocka_unit_test(what_cannot_be_used_is_refused),
    };
    return cmocka_run_group_tests_name("engine", tests, NULL, NULL);
}
