/* SPDX-License-Identifier: MIT */
/* A frame made of a constant, as a baked file makes it, draws the bits of one made by
 * tp_frame_init, in the same memory; its errors are the same too. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#undef fail                     /* cmocka's, without arguments */
#include "app/scene/loaded_scene.h"
#include "frame/frame.h"
#include "frame/tools.h"
#include "pixel/pixel.h"
#include "tests/lib/frames.h"

enum { WIDTH = 64, HEIGHT = 48, PICTURES = 2, TICKS = 20 };

static options given;
static loaded_scene stood;

static void open_scene(const char *scene, bool cheap)
{
    char path[64];

    snprintf(path, sizeof path, "assets/scenes/%s.ini", scene);
    given = (options){ .scene = path, .width = WIDTH, .height = HEIGHT, .threads = 1,
                       .texels = 16, .format = TP_FORMAT_RGB565 };
    assert_int_equal(loaded_scene_open(&stood, &given), 0);
    tp_scene *s = &stood.file.scene;
    if (!cheap)
        return;
    s->quality.shading = TP_SHADING_QUICK;
    s->quality.lines = s->quality.blending = TP_RUNG_FAST;
    s->quality.visibility = TP_VISIBILITY_ROWS;
    s->quality.rows = TP_RUNG_PAIRS;
}

static tp_config config_of_scene(const tp_program *by)
{
    return (tp_config){ .width = WIDTH, .height = HEIGHT, .format = TP_FORMAT_RGB565,
                        .program = by, .assets = &stood.assets.names };
}

/* The program without samples: things in the water count as dropped. */
static tp_program without_samples(void)
{
    tp_program own = tp_program_all;

    own.water.samples = NULL;
    return own;
}

/* -- pictures ------------------------------------------------------------------------ */

typedef struct {
    uint32_t crc, dropped;
    tp_rungs rungs;
    uint64_t on;
    uint8_t  outlined;
    const char *lacks;
    tp_ram_use ram;
} drawn_picture;

static drawn_picture draw(tp_frame *frame, const tp_world *world)
{
    const tp_ram_use ram = tp_frame_ram(frame);
    uint8_t *scratch = frame_block(ram.scratch);
    drawn_picture p = { .ram = ram };
    tp_tile tile;

    tp_frame_begin(frame, world);
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++) {
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            p.crc = tp_crc32_pixels(p.crc, frame->config.format,
                                    (const uint8_t *)tile.pixels
                                        + (y - tile.y0) * tile.stride,
                                    (int)(tile.x1 - tile.x0));
        p.dropped += tile.dropped;
    }
    assert_true(frame_guard_holds(scratch, ram.scratch));
    free(scratch);
    p.dropped += tp_frame_stats(frame).dropped;
    p.rungs = frame->rungs;
    p.on = frame->modules_on;
    p.outlined = frame->outlined;
    p.lacks = tp_frame_lacks(frame);
    return p;
}

static void expect_same(const drawn_picture *a, const drawn_picture *b)
{
    assert_int_equal(a->crc, b->crc);
    assert_int_equal(a->dropped, b->dropped);
    assert_memory_equal(&a->rungs, &b->rungs, sizeof a->rungs);
    assert_true(a->on == b->on);
    assert_int_equal(a->outlined, b->outlined);
    assert_true(a->lacks == b->lacks);
    assert_memory_equal(&a->ram, &b->ram, sizeof a->ram);
}

/* Draws the open scene by both frames.  Returns what the last pictures dropped. */
static uint32_t compare(const tp_program *by)
{
    const tp_config config = config_of_scene(by);
    const tp_scene *scene = &stood.file.scene;
    const size_t bytes = tp_frame_bytes(&config, scene);
    uint8_t *const block[2] = { frame_block(bytes), frame_block(bytes) };
    tp_found_frame found;
    tp_frame *frame[2];
    drawn_picture p[2];

    assert_int_equal(tp_frame_find(&found, &config, scene, NULL), TP_OK);
    assert_int_equal(tp_frame_maker.bytes(&found.frame), bytes);
    assert_int_equal(found.frame.scratch_bytes, tp_frame_scratch_bytes(&config, scene));
    assert_int_equal(tp_frame_init(&frame[0], &config, scene, block[0], bytes, NULL), TP_OK);
    assert_int_equal(tp_frame_maker.init(&frame[1], &found.frame, block[1], bytes, NULL),
                     TP_OK);
    for (int n = 0; n < PICTURES; n++) {
        for (int i = 0; i < 2; i++)
            p[i] = draw(frame[i], stood.world);
        expect_same(&p[0], &p[1]);
        for (int k = 0; k < TICKS; k++)
            tp_world_step(&tp_program_all, stood.world, scene, NULL);
    }
    for (int i = 0; i < 2; i++) {
        assert_true(frame_guard_holds(block[i], bytes));
        free(block[i]);
    }
    return p[1].dropped;
}

static void shipped_scenes_draw_the_same_bits(void **state)
{
    static const char *const scenes[] = {
        "calm-bay", "count-64", "deep-sea", "flat-calm", "harbour", "minimal", "night-sea",
        "pond", "raindrops", "shallows", "shore-break", "storm", "tank", "three-swells",
    };
    size_t drawn = 0;

    (void)state;
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++)
        for (int cheap = 0; cheap < 2; cheap++) {
            open_scene(scenes[i], cheap);
            compare(&tp_program_all);
            loaded_scene_close(&stood);
            drawn++;
        }
    assert_int_equal(drawn, 2 * sizeof scenes / sizeof *scenes);
}

static void what_a_program_lacks_is_counted_the_same(void **state)
{
    const tp_program own = without_samples();

    (void)state;
    open_scene("three-swells", false);
    assert_true(compare(&own) > 0);
    loaded_scene_close(&stood);
}

/* -- errors -------------------------------------------------------------------------- */

static void expect_error(tp_status got, const tp_error *err, tp_status code,
                         const char *word)
{
    assert_int_equal(got, code);
    assert_int_equal(err->code, code);
    assert_string_equal(err->word, word);
}

static void bad_memory_is_refused(void **state)
{
    const struct tp_frame_maker *maker = &tp_frame_maker;
    tp_found_frame found;
    tp_error err;
    tp_frame *frame = NULL;

    (void)state;
    open_scene("minimal", false);
    const tp_config config = config_of_scene(&tp_program_all);
    assert_int_equal(tp_frame_find(&found, &config, &stood.file.scene, &err), TP_OK);
    const tp_baked_frame *baked = &found.frame;
    const size_t bytes = maker->bytes(baked);
    uint8_t *const block = frame_block(bytes);
    expect_error(maker->init(NULL, baked, block, bytes, &err), &err, TP_E_NULL, "frame");
    expect_error(maker->init(&frame, baked, NULL, bytes, &err), &err, TP_E_NULL, "memory");
    expect_error(maker->init(&frame, baked, block + 4, bytes, &err), &err, TP_E_ALIGN,
                 "memory");
    assert_int_equal(maker->init(&frame, baked, block, bytes - 1, &err), TP_E_NOSPACE);
    assert_int_equal(err.a, bytes);
    assert_int_equal(err.b, bytes - 1);
    assert_int_equal(maker->init(&frame, baked, block, bytes - 1, NULL), TP_E_NOSPACE);
    assert_null(frame);
    assert_int_equal(block[0], 0xa5);
    assert_int_equal(maker->init(&frame, baked, block, bytes, &err), TP_OK);
    free(block);
    loaded_scene_close(&stood);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shipped_scenes_draw_the_same_bits),
        cmocka_unit_test(what_a_program_lacks_is_counted_the_same),
        cmocka_unit_test(bad_memory_is_refused),
    };
    return cmocka_run_group_tests_name("frame_baked", tests, NULL, NULL);
}
