/* SPDX-License-Identifier: MIT */
/* An application's own spans in tiles.  An overlay without spans changes no bit, for any
 * scene, format, tiling and number of threads; nearer geometry hides spans.
 * TP_OVERLAY_PICTURES=FOLDER keeps the picture of a sprite behind a crest. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/scene/frame_renderer.h"
#include "app/files/path.h"
#include "tests/lib/random.h"
#include "world/world.h"
#include "tools/reference/image.h"
#include "tools/reference/shipped_scene.h"

/* -- an empty overlay ------------------------------------------------------------------ */

static void draw_nothing(void *user, const tp_overlay_row *row)
{
    (void)row;
    __atomic_add_fetch((uint32_t *)user, row->x1 - row->x0, __ATOMIC_RELAXED);
}

static uint32_t crc_of(const ref_stand *s, tp_config config, uint32_t threads)
{
    frame_renderer c;

    memset(&c, 0, sizeof c);
    frame_renderer_plan(&c, &config, threads);
    assert_int_equal(frame_renderer_open(&c, &s->file.scene, &s->assets.names), 0);
    frame_renderer_draw(&c, s->world);
    const uint32_t crc = picture_crc(&c.picture);
    frame_renderer_close(&c);
    return crc;
}

/* Returns the CRC of the picture without an overlay.  Overlays need the colours of all
 * pixels: quality.blending is exact. */
static uint32_t crc_of_bare(ref_stand *s, const tp_config *config)
{
    int32_t *blending = &s->file.scene.quality.blending;
    const int32_t own = *blending;

    *blending = TP_RUNG_EXACT;
    const uint32_t crc = crc_of(s, *config, 1);
    *blending = own;
    return crc;
}

/* Tries each format once, with alternating tilings, starting at `turn`; under the sanitizers
 * every other format. */
static void try_scene(const char *folder, const char *name, size_t turn)
{
    static const uint32_t tiles[][2] = { { 0, 150 }, { 48, 7 }, { 16, 1 } };
    enum { WIDTH = 208, HEIGHT = 150 };
    char path[256];
    ref_stand s;

    snprintf(path, sizeof path, "%s/%s.ini", folder, name);
    assert_int_equal(ref_stand_open(&s, path, NULL, 0, 60), 0);
    for (int format = (int)turn % random_rounds(1, 2); format < TP_FORMAT_COUNT;
         format += random_rounds(1, 2)) {
        tp_config config = { .width = WIDTH,
                                   .height = HEIGHT,
                                   .tile_height = HEIGHT,
                                   .format = (tp_format)format };
        const uint32_t want = crc_of_bare(&s, &config), i = (turn + (size_t)format) % 4;
        uint32_t pixels = 0;
        config.tile_width = tiles[i % 3][0];
        config.tile_height = tiles[i % 3][1];
        config.overlay = tp_overlay_make(draw_nothing, &pixels);
        assert_int_equal(crc_of(&s, config, i == 3 ? 3 : 1), want);
        assert_int_equal(pixels, WIDTH * HEIGHT);
    }
    ref_stand_close(&s);
}

static void an_overlay_of_nothing_changes_no_bit(void **state)
{
    static const char *const folders[] = { "assets/scenes", "tests/golden/scenes" };
    (void)state;
    for (int f = 0; f < 2; f++) {
        size_t count = 0;
        char **names = path_scene_names(folders[f], &count);
        assert_true(count > 0);
        for (size_t i = 0; i < count; i++)
            try_scene(folders[f], names[i], i);
        path_free_names(names, count);
    }
}

/* -- spans ----------------------------------------------------------------------------- */

enum { WIDTH = 320, HEIGHT = 240, PIXELS = WIDTH * HEIGHT };

static void draw_picture(const ref_stand *s, tp_overlay overlay, uint32_t *pixels,
                         const char *name)
{
    const tp_config config = {
        .width = WIDTH, .height = HEIGHT, .tile_height = 16, .overlay = overlay
    };
    const char *folder = getenv("TP_OVERLAY_PICTURES");
    char path[256];
    frame_renderer c;

    memset(&c, 0, sizeof c);
    frame_renderer_plan(&c, &config, 1);
    assert_int_equal(frame_renderer_open(&c, &s->file.scene, &s->assets.names), 0);
    frame_renderer_draw(&c, s->world);
    for (uint32_t y = 0; y < HEIGHT; y++)
        picture_expand_row(&c.picture, y, pixels + y * WIDTH);
    snprintf(path, sizeof path, "%s/%s.png", folder, name);
    if (folder)
        assert_int_equal(picture_write_png(&c.picture, path), 0);
    frame_renderer_close(&c);
}

/* A rectangle: rows y0 to y1 from column x, with width, depth and one colour. */
typedef struct {
    int32_t x, y0, y1;
    uint32_t width, colour;
    tp_fx depth;
} sprite;

static void draw_sprite(void *user, const tp_overlay_row *row)
{
    const sprite *s = user;
    uint32_t colours[1024];

    if ((int32_t)row->y < s->y0 || (int32_t)row->y >= s->y1)
        return;
    for (uint32_t i = 0; i < s->width; i++)
        colours[i] = s->colour;
    tp_overlay_span(row, s->x, s->width, s->depth, colours);
}

static uint32_t without[PIXELS], with[PIXELS];

/* Depth 0 is in front of everything; spans are cut at the row's ends; alpha blends with
 * rounding. */
static void a_hud_is_over_everything(void **state)
{
    (void)state;
    ref_stand s;
    assert_int_equal(ref_stand_open(&s, "assets/scenes/storm.ini", NULL, 0, 100), 0);
    sprite hud = { -20, 100, 140, 1000, 0x80ff4020, 0 };
    draw_picture(&s, (tp_overlay){ 0 }, without, "storm");
    draw_picture(&s, tp_overlay_make(draw_sprite, &hud), with, "storm-hud");
    for (int i = 0; i < PIXELS; i++) {
        const bool in = i / WIDTH >= hud.y0 && i / WIDTH < hud.y1;
        for (int k = 0; k < 24; k += 8) {
            const double a = 128 / 255.0, over = hud.colour >> k & 255;
            const double under = without[i] >> k & 255;
            const double want = in ? a * over + (1 - a) * under : under;
            assert_true(fabs((with[i] >> k & 255) - want) < 0.51);
        }
    }
    hud.colour = 0x00ffffff;
    draw_picture(&s, tp_overlay_make(draw_sprite, &hud), with, "storm-nothing");
    assert_memory_equal(with, without, sizeof with);
    hud.colour = 0xff123456;
    hud.depth = TP_FX_MAX;
    draw_picture(&s, tp_overlay_make(draw_sprite, &hud), with, "storm-farthest");
    for (int i = hud.y0 * WIDTH; i < hud.y1 * WIDTH; i++)
        assert_true(with[i] == without[i] || with[i] == 0x123456);
    ref_stand_close(&s);
}

/* A billboard 30 m ahead of a low eye over the swells, compared with depths in double
 * precision. */
static void a_crest_hides_what_stands_behind_it(void **state)
{
    (void)state;
    static const tp_fx depth = 30 * TP_FX_ONE;
    sprite board = { 90, 60, 200, 140, 0xffff00ff, depth };
    int hidden = 0, shown = 0, wrong = 0;
    ref_scene ref;
    ref_image image;
    ref_stand s;

    assert_int_equal(ref_stand_open(&s, "assets/scenes/three-swells.ini", NULL, 0, 100),
                     0);
    tp_scene *scene = &s.file.scene;
    const tp_fx side = 30 * TP_FX_ONE; /* away from the boat */
    const tp_water water = tp_world_sample(&tp_program_all, s.world, side, side);
    tp_world_set_camera(s.world, (tp_vec3){ side, water.height + TP_FX_ONE, side },
                        TP_DEG(200), TP_DEG(-3), TP_DEG(8));
    draw_picture(&s, tp_overlay_make(draw_sprite, &board), with, "swells-board");
    ref_scene_open(&ref, scene, &s.assets.names, s.world, WIDTH, HEIGHT, true);
    ref_image_draw(&image, &ref, WIDTH, HEIGHT, 1, 2);
    for (int y = board.y0; y < board.y1; y++)
        for (int x = board.x; x < board.x + (int)board.width; x++) {
            const double near = image.near[y * WIDTH + x] * 30;
            const bool there = with[y * WIDTH + x] == (board.colour & 0xffffff);
            if (fabs(near - 1) < 0.03)
                continue;
            hidden += near > 1;
            shown += near < 1;
            wrong += (near < 1) != there;
        }
    printf("    %d pixels hidden, %d shown, %d otherwise\n", hidden, shown, wrong);
    assert_true(hidden > 1000 && shown > 1000);
    assert_true(wrong < (hidden + shown) / 200);
    ref_image_free(&image);
    ref_scene_close(&ref);
    ref_stand_close(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hud_is_over_everything),
        cmocka_unit_test(a_crest_hides_what_stands_behind_it),
        cmocka_unit_test(an_overlay_of_nothing_changes_no_bit),
    };
    return cmocka_run_group_tests_name("overlay of an application", tests, NULL, NULL);
}
