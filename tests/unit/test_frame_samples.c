/* SPDX-License-Identifier: MIT */
/* Depth and kind of each pixel of a drawn tile: the shader lists tell every kind apart, and
 * the nearer key has the nearer depth. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/frame.h"
#include "tests/lib/frames.h"
#include "tests/lib/scenes.h"

enum { SCENES = 240, WIDTH = 96, HEIGHT = 64, TICKS = 40 };

static uint64_t chance;

static const tp_sample_kind kind_of[] = {
    [MARKS_SKY] = TP_SAMPLE_SKY,     [MARKS_WATER] = TP_SAMPLE_WATER,
    [MARKS_BOAT] = TP_SAMPLE_OBJECT, [MARKS_LAND] = TP_SAMPLE_LAND,
    [MARKS_DROP] = TP_SAMPLE_DROP,   [MARKS_TANK] = TP_SAMPLE_WALL,
    [MARKS_SIDE] = TP_SAMPLE_GLASS,
};

/* Counts the pixels of each kind in a drawn tile. */
static void compare_tile(const test_frame *f, const tp_tile *tile, uint32_t *count)
{
    const uint32_t *key = (const uint32_t *)(const void *)f->scratch;
    tp_fx depth[WIDTH], alone[WIDTH];
    uint8_t kind[WIDTH];

    for (uint32_t y = tile->y0; y < tile->y1; y++, key += tile->x1 - tile->x0) {
        tp_frame_sample_row(f->frame, f->scratch, tile, y, depth, kind);
        tp_frame_sample_row(f->frame, f->scratch, tile, y, alone, NULL);
        assert_memory_equal(alone, depth, (tile->x1 - tile->x0) * sizeof *depth);
        for (uint32_t x = 0; x < tile->x1 - tile->x0; x++) {
            assert_int_equal(kind[x], kind_of[marks_kind_of(f->frame, TP_MARK(key[x]))]);
            /* water beyond 32 km saturates too */
            assert_true(kind[x] != TP_SAMPLE_SKY || depth[x] == TP_FX_MAX);
            if (x > 0 && kind[x] != TP_SAMPLE_SKY && kind[x - 1] != TP_SAMPLE_SKY
                && TP_ZI(key[x]) > TP_ZI(key[x - 1]))
                assert_true(depth[x] <= depth[x - 1]);
            count[kind[x]]++;
        }
    }
}

static void each_kind_of_thing_is_told(void **state)
{
    (void)state;
    static test_kit kit;
    uint32_t count[TP_SAMPLE_OTHER + 1] = { 0 };

    kit_make(&kit, &chance);
    for (int n = 0; n < SCENES; n++) {
        tp_scene scene = kit_scene(&chance, 400, 40);
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_height = 32 };
        tp_world *world = scene_world(&scene, &assets);
        if (!world)
            continue;
        test_frame f = frame_of(&scene, &assets, &config);
        tp_tile tile;

        for (int i = 0; i < TICKS; i++)
            tp_world_step(&tp_program_all, world, &scene, NULL);
        tp_frame_begin(f.frame, world);
        for (uint32_t i = 0; tp_frame_draw_tile(f.frame, i, f.scratch, &tile); i++)
            compare_tile(&f, &tile, count);
        frame_free(&f);
        free(world);
    }
    for (uint32_t k = TP_SAMPLE_SKY; k < TP_SAMPLE_OTHER; k++) {
        printf("    kind %u: %u pixels\n", k, count[k]);
        assert_true(count[k] > 0);
    }
    assert_int_equal(count[TP_SAMPLE_OTHER], 0);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = { cmocka_unit_test(each_kind_of_thing_is_told) };
    return cmocka_run_group_tests_name("frame/samples", tests, NULL, NULL);
}
