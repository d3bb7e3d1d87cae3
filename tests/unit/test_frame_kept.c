/* SPDX-License-Identifier: MIT */
/* Kept lines draw the same bits as stored lines whatever the order of the tiles: tiles at
 * random, in several scratches, into the scratch or into the picture, by frames that are made
 * again in the same memory. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/renderers.h"
#include "frame/tools.h"
#include "tests/lib/tilings.h"

enum { SCRATCHES = 3, PICTURES = 2, FRAMES = 2 };

static uint64_t chance;
static test_kit kit;
static tp_program streamed;

typedef struct {
    tp_config config;
    uint8_t  *block, *scratch[SCRATCHES];
    size_t    bytes, scratch_bytes;
    uint8_t  *picture;
    size_t    row_bytes;
    bool      direct;
} drawer;

static struct {
    uint32_t kept, walked, rows, halves, outlined, direct, coastal;
} count;                        /* pictures */

static void open_drawer(drawer *d, const tp_scene *scene, tp_config config, bool direct)
{
    d->config = config;
    d->direct = direct;
    d->bytes = tp_frame_bytes(&config, scene);
    d->scratch_bytes = direct ? tp_frame_direct_scratch_bytes(&config, scene)
                              : tp_frame_scratch_bytes(&config, scene);
    d->block = frame_block(d->bytes);
    d->row_bytes = tp_format_row_bytes(config.format, (int)config.width) + 8;
    d->picture = calloc(config.height, d->row_bytes);
    for (int i = 0; i < SCRATCHES; i++)
        d->scratch[i] = frame_block(d->scratch_bytes);
}

static void close_drawer(drawer *d)
{
    assert_true(frame_guard_holds(d->block, d->bytes));
    free(d->block);
    free(d->picture);
    for (int i = 0; i < SCRATCHES; i++) {
        assert_true(frame_guard_holds(d->scratch[i], d->scratch_bytes));
        free(d->scratch[i]);
    }
}

/* Makes the drawer's frame, again in the same memory, with scratches of zeros. */
static tp_frame *make_frame(drawer *d, const tp_scene *scene)
{
    tp_frame *frame;

    assert_int_equal(tp_frame_init(&frame, &d->config, scene, d->block, d->bytes, NULL),
                     TP_OK);
    for (int i = 0; i < SCRATCHES; i++)
        memset(d->scratch[i], 0, d->scratch_bytes);
    return frame;
}

static void draw_tile(const drawer *d, const tp_frame *frame, uint32_t i, void *scratch)
{
    const tp_format format = d->config.format;
    tp_tile tile;

    if (d->direct) {
        assert_true(tp_frame_draw_tile_direct(frame, i, scratch, d->picture, d->row_bytes,
                                              &tile));
        return;
    }
    assert_true(tp_frame_draw_tile(frame, i, scratch, &tile));
    const size_t left = tp_format_row_bytes(format, (int)tile.x0);
    const size_t bytes = tp_format_row_bytes(format, (int)(tile.x1 - tile.x0));
    for (uint32_t y = tile.y0; y < tile.y1; y++)
        memcpy(d->picture + y * d->row_bytes + left,
               (const uint8_t *)tile.pixels + (y - tile.y0) * tile.stride, bytes);
}

/* Draws all tiles, each into any scratch: in any order, or in the order of their count. */
static void draw_tiles(const drawer *d, const tp_frame *frame, bool in_order)
{
    const uint32_t tiles = tp_frame_tiles(frame);
    uint32_t *order = malloc(tiles * sizeof *order);

    for (uint32_t i = 0; i < tiles; i++) {
        const uint32_t k = in_order ? i : random_below(&chance, i + 1);
        order[i] = order[k];
        order[k] = i;
    }
    for (uint32_t n = 0; n < tiles; n++)
        draw_tile(d, frame, order[n], d->scratch[random_below(&chance, SCRATCHES)]);
    free(order);
}

/* Draws the same picture whole, from stored lines, by the same renderer. */
static void draw_stored(drawer *d, const tp_scene *scene, tp_config config,
                        const tp_world *world, const tp_frame *by)
{
    tp_rungs rungs = by->rungs;

    rungs.visibility = by->visibility;
    config.program = &tp_program_all;
    config.tile_width = 0;
    config.tile_height = config.height;
    config.kept_bytes = 0;
    open_drawer(d, scene, config, false);
    tp_frame *frame = make_frame(d, scene);
    tp_frame_set_rungs(frame, &rungs);
    tp_frame_begin(frame, world);
    draw_tiles(d, frame, true);
}

static void assert_same_pixels(const drawer *a, const drawer *b)
{
    const tp_config *c = &a->config;

    for (uint32_t y = 0; y < c->height; y++)
        for (int x = 0; x < (int)c->width; x++)
            assert_int_equal(tp_pixel_read(c->format, a->picture + y * a->row_bytes, x),
                             tp_pixel_read(c->format, b->picture + y * b->row_bytes, x));
}

static void count_picture(const drawer *d, const tp_frame *frame)
{
    const tp_grid *grid = frame->buffers.grid;

    count.kept += frame->kept_bytes > 0;
    count.walked += frame->visibility == TP_VISIBILITY_WALK;
    count.rows += frame->visibility == TP_VISIBILITY_ROWS;
    count.halves += tp_frame_has_half_lines(frame) ? 1 : 0;
    count.outlined += frame->outlined > 0;
    count.coastal += grid && grid->dry;
    count.direct += d->direct;
}

/* Returns bytes for no line, for some lines or for all. */
static uint32_t random_kept_bytes(void)
{
    const uint32_t bytes[] = { 1, random_below(&chance, 300), random_below(&chance, 2000),
                               random_below(&chance, 12000), UINT32_MAX - 2 };
    return bytes[random_below(&chance, sizeof bytes / sizeof *bytes)];
}

static void compare(const tp_scene *scene, const tp_assets *assets, tp_world *world)
{
    const tp_config config = {
        .width = 20 + random_below(&chance, 80),
        .height = 16 + random_below(&chance, 54),
        .tile_width = 16 * random_below(&chance, 5),
        .tile_height = random_below(&chance, 24),
        .format = (tp_format)random_below(&chance, TP_FORMAT_COUNT),
        .program = &streamed,
        .assets = assets,
        .kept_bytes = random_kept_bytes(),
        .depth = random_below(&chance, 4) == 0,
    };
    drawer tiled, whole;

    open_drawer(&tiled, scene, config, random_below(&chance, 2));
    for (int n = 0; n < FRAMES; n++) {
        tp_frame *frame = make_frame(&tiled, scene);
        for (int k = 0; k < PICTURES; k++) {
            tp_frame_begin(frame, world);
            draw_tiles(&tiled, frame, random_below(&chance, 3) == 0);
            draw_stored(&whole, scene, config, world, frame);
            assert_same_pixels(&tiled, &whole);
            close_drawer(&whole);
            count_picture(&tiled, frame);
            tp_world_step(&tp_program_all, world, scene, NULL);
        }
    }
    close_drawer(&tiled);
}

/* Deep water of triangles, of scanlines, or walked. */
static tp_scene deep_scene(tp_visibility visibility)
{
    tp_scene s = scene_plain();

    s.quality.visibility = (int32_t)visibility;
    s.camera.y = chance_fx(&chance, 1, 9);
    s.camera.heading = chance_fx(&chance, -60, 60)
                     + 180 * chance_int(&chance, 0, 1) * TP_FX_ONE;
    s.camera.pitch = chance_fx(&chance, -25, 5);
    s.grid.vertices = chance_int(&chance, 64, 3000);
    return s;
}

static void any_order_of_tiles_draws_the_same(void **state)
{
    static const tp_visibility deep[] = { TP_VISIBILITY_TRIANGLES, TP_VISIBILITY_ROWS,
                                          TP_VISIBILITY_WALK };
    const uint32_t scenes = (uint32_t)random_rounds(600, 120);

    (void)state;
    for (uint32_t n = 0; n < scenes; n++) {
        tp_scene scene = kit_scene(&chance, 3600, 24);
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        if (n % 4)
            scene = deep_scene(deep[n % 4 - 1]);
        scene.quality.rows = chance_int(&chance, TP_RUNG_AUTO, TP_RUNG_PAIRS);
        scene.quality.lines = chance_int(&chance, TP_RUNG_AUTO, TP_RUNG_FAST);
        scene.quality.blending = chance_int(&chance, TP_RUNG_AUTO, TP_RUNG_FAST);
        tp_world *world = scene_world(&scene, &assets);
        if (world)
            compare(&scene, &assets, world);
        free(world);
    }
    printf("# kept %" PRIu32 ", walked %" PRIu32 ", by rows %" PRIu32 ", half lines %" PRIu32
           ", outlined %" PRIu32 ", coastal %" PRIu32 ", direct %" PRIu32 "\n",
           count.kept, count.walked, count.rows, count.halves, count.outlined,
           count.coastal, count.direct);
    assert_true(count.kept > 2 * scenes && count.direct > scenes);
    assert_true(count.walked > scenes / 4 && count.rows > scenes / 4);
    assert_true(count.halves > scenes / 2 && count.outlined > scenes / 2);
    assert_true(count.coastal > scenes / 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_order_of_tiles_draws_the_same),
    };
    chance = 77;
    kit_make(&kit, &chance);
    streamed = tp_program_all;
    streamed.method.triangles = &tp_method_streamed;
    streamed.method.walk = &tp_method_streamed_walk;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
