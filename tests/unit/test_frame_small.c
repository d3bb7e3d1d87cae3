/* SPDX-License-Identifier: MIT */
/* Frames for little memory: streamed grid vertices and pixels written straight into the
 * picture.  These frames draw the same as others, bit for bit. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/frame.h"
#include "frame/tools.h"
#include "tests/lib/frames.h"
#include "tests/lib/scenes.h"
#include "pixel/pixel.h"

enum { WIDTH = 160, HEIGHT = 90, STRIDE = 4 * WIDTH + 8 };

static uint64_t chance;
static test_kit kit;
static tp_program streamed;
static uint32_t by_rows, by_streams;

/* Draws with exactly the requested scratch memory, filled with any data. */
static void draw_into(const test_frame *f, const tp_config *config, uint8_t *picture)
{
    const tp_config into = config_with(config, &streamed, NULL);
    const size_t bytes = tp_frame_direct_scratch_bytes(&into, f->frame->scene);
    uint8_t *scratch = malloc(bytes + 64);
    tp_tile  tile;

    memset(scratch, 0x5a, bytes + 64);
    for (uint32_t i = 0;
         tp_frame_draw_tile_direct(f->frame, i, scratch, picture, STRIDE, &tile); i++)
        assert_ptr_equal(tile.pixels, picture + tile.y0 * STRIDE
                         + tp_format_row_bytes(config->format, (int)tile.x0));
    for (int i = 0; i < 64; i++)
        assert_int_equal(scratch[bytes + (size_t)i], 0x5a);
    assert_true(frame_guard_holds(f->block, f->bytes));
    free(scratch);
}

static void draw_tiles(const test_frame *f, const tp_config *config, uint8_t *picture)
{
    const size_t row_bytes = tp_format_row_bytes(config->format, WIDTH);
    tp_tile tile;

    for (uint32_t i = 0; tp_frame_draw_tile(f->frame, i, f->scratch, &tile); i++)
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            memcpy(picture + y * STRIDE,
                   (const uint8_t *)tile.pixels + (y - tile.y0) * tile.stride, row_bytes);
}

/* Compares by the small frame's renderer: a small frame has no scanline tables along
 * columns and draws triangles there. */
static void compare(const tp_scene *scene, const tp_assets *assets, const tp_world *world)
{
    static uint8_t picture[2][HEIGHT * STRIDE];
    const tp_format format = (tp_format)random_below(&chance, TP_FORMAT_COUNT);
    const tp_config whole = {
        .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = format
    };
    const tp_config tiled = { .width = WIDTH,
                              .height = HEIGHT,
                              .tile_width = 16 * random_below(&chance, 10),
                              .tile_height = random_below(&chance, HEIGHT),
                              .format = format };
    test_frame kept = frame_by(&tp_program_all, scene, assets, &whole);
    test_frame small = frame_by(&streamed, scene, assets, &tiled);

    memset(picture, 0, sizeof picture);
    assert_true(small.bytes <= kept.bytes);
    by_streams += small.frame->buffers.grid->streams;
    for (int k = 0; k < 2; k++) {               /* second draw: memory full of the first */
        tp_frame_begin(small.frame, world);
        tp_rungs rungs = small.frame->rungs;
        rungs.visibility = small.frame->visibility;
        tp_frame_set_rungs(kept.frame, &rungs);
        tp_frame_begin(kept.frame, world);
        draw_tiles(&kept, &whole, picture[0]);
        draw_into(&small, &tiled, picture[1]);
        assert_memory_equal(picture[0], picture[1], sizeof picture[0]);
    }
    by_rows += small.frame->visibility == TP_VISIBILITY_ROWS;
    frame_free(&kept);
    frame_free(&small);
}

/* Every kind of scene except coastal water, whose grid vertices are stored. */
static void streamed_crossings_draw_the_same(void **state)
{
    (void)state;

    for (int n = 0; n < 60; n++) {
        tp_scene scene = scene_plain();
        kit_gather(&scene, &chance);
        kit_switch_on(&scene, &chance);
        scene.floor.depth = scene.wind.strength = 0;
        scene.floor.map[0] = '\0';
        scene.quality.visibility = chance_int(&chance, TP_VISIBILITY_TRIANGLES,
                                              TP_VISIBILITY_FLAT);
        scene.camera.pitch = chance_fx(&chance, -30, 5);
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        tp_world *world = scene_world(&scene, &assets);
        assert_non_null(world);
        compare(&scene, &assets, world);
        free(world);
    }
    printf("# streamed: %" PRIu32 "\n", by_streams);
    assert_true(by_streams > 30);
}

/* The plain scene from a view where the scanline renderer is valid: along z rows are
 * streamed, along x triangles. */
static void streamed_rows_draw_the_same(void **state)
{
    (void)state;
    const tp_assets none = { .boat = NULL };

    by_rows = 0;
    for (int n = 0; n < 40; n++) {
        tp_scene scene = scene_plain();
        scene.camera.y = chance_fx(&chance, 3, 12);
        scene.camera.heading = chance_int(&chance, 0, 3) * 90 * TP_FX_ONE;
        scene.camera.pitch = chance_fx(&chance, -15, 0);
        scene.quality.visibility = n % 4 ? TP_VISIBILITY_ROWS : TP_VISIBILITY_TRIANGLES;
        tp_world *world = scene_world(&scene, &none);
        compare(&scene, &none, world);
        free(world);
    }
    printf("# by rows: %" PRIu32 "\n", by_rows);
    assert_true(by_rows > 5);
}

static void waves_beyond_those_at_init_are_left_out(void **state)
{
    (void)state;
    static uint8_t picture[2][HEIGHT * STRIDE];
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_height = HEIGHT,
                               .format = TP_FORMAT_XRGB8888 };
    const tp_assets none = { .boat = NULL };
    tp_scene scene = scene_plain();
    test_frame f = frame_by(&streamed, &scene, &none, &config);

    for (int k = 0; k < 2; k++) {
        tp_world *world = scene_world(&scene, &none);
        tp_frame_begin(f.frame, world);
        draw_into(&f, &config, picture[k]);
        free(world);
        for (int i = 0; i < TP_WAVES; i++)
            if (scene.wave[i].amplitude == 0)
                scene.wave[i] = (tp_wave){ .amplitude = TP_FX(0.5),
                                           .length = 9 * TP_FX_ONE, .exponent = 1 };
    }
    assert_true(frame_guard_holds(f.block, f.bytes));
    frame_free(&f);
}

/* Calm water that reflects a boat and no sky of its own. */
static tp_scene mirror_scene(void)
{
    tp_scene s = scene_plain();

    s.camera.y = 3 * TP_FX_ONE;
    s.camera.pitch = -12 * TP_FX_ONE;
    s.water.reflection = TP_FX_ONE;
    s.wave[0].amplitude = TP_FX(0.02);
    s.boat.z = -14 * TP_FX_ONE;
    s.boat.scale = 4 * TP_FX_ONE;
    s.boat.length = 4 * TP_FX_ONE;
    s.boat.beam = 2 * TP_FX_ONE;
    s.boat.heading = chance_fx(&chance, 0, 360);
    return s;
}

static void draw_mirror(tp_scene *s, int32_t objects, int32_t size, uint8_t *picture)
{
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_height = HEIGHT,
                               .format = TP_FORMAT_XRGB8888 };
    const tp_assets boat = { .boat = &kit.boat.mesh };

    s->mirror.method = objects;
    s->mirror.size = size;
    test_frame f = frame_of(s, &boat, &config);
    tp_world *world = scene_world(s, &boat);
    tp_frame_begin(f.frame, world);
    draw_tiles(&f, &config, picture);
    assert_true(frame_guard_holds(f.block, f.bytes));
    free(world);
    frame_free(&f);
}

static int64_t difference(const uint8_t *a, const uint8_t *b)
{
    int64_t sum = 0;

    for (int i = 0; i < HEIGHT * STRIDE; i++)
        sum += a[i] > b[i] ? a[i] - b[i] : b[i] - a[i];
    return sum;
}

/* Reflections at a quarter of the picture's size and at its size show the same, in the same
 * place. */
static void mirrors_of_every_size_show_the_same(void **state)
{
    (void)state;
    static uint8_t none[HEIGHT * STRIDE], half[HEIGHT * STRIDE];
    static uint8_t quarter[HEIGHT * STRIDE], full[HEIGHT * STRIDE];
    int64_t mirrored = 0, off = 0, full_off = 0;

    for (int n = 0; n < 40; n++) {
        tp_scene s = mirror_scene();
        draw_mirror(&s, TP_MIRROR_NONE, TP_MIRROR_HALF, none);
        draw_mirror(&s, TP_MIRROR_STENCIL, TP_MIRROR_HALF, half);
        draw_mirror(&s, TP_MIRROR_STENCIL, TP_MIRROR_QUARTER, quarter);
        draw_mirror(&s, TP_MIRROR_STENCIL, TP_MIRROR_FULL, full);
        mirrored += difference(none, half);
        off += difference(half, quarter);
        full_off += difference(half, full);
    }
    printf("# mirrored %" PRId64 ", quarter off %" PRId64 ", full off %" PRId64 "\n", mirrored,
           off, full_off);
    assert_true(mirrored > 100000 && off > 0 && 5 * off < 2 * mirrored);
    assert_true(full_off > 0 && full_off < off);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(streamed_crossings_draw_the_same),
        cmocka_unit_test(streamed_rows_draw_the_same),
        cmocka_unit_test(waves_beyond_those_at_init_are_left_out),
        cmocka_unit_test(mirrors_of_every_size_show_the_same),
    };
    chance = random_seed();
    kit_make(&kit, &chance);
    streamed = tp_program_all;
    streamed.method.triangles = &tp_method_streamed;
    return cmocka_run_group_tests_name("frame small", tests, NULL, NULL);
}
