/* SPDX-License-Identifier: MIT */
/* A frame keeps tables, lists and plans from picture to picture. After a number of the
 * scene has changed, and the world with it, the frame draws as a new frame does. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>
#include "tests/lib/frames.h"
#include "tests/lib/worlds.h"

enum { WIDTH = 96, HEIGHT = 64, PIXELS = WIDTH * HEIGHT };

static test_kit kit;
static uint64_t chance;
static uint32_t old[PIXELS], fresh[PIXELS];

static const tp_config config = {
    .width = WIDTH, .height = HEIGHT, .tile_width = 48, .tile_height = 16,
    .format = TP_FORMAT_XRGB8888,
};

/* A sea with most features on, seen by exact or by fast stages. */
static tp_scene sea(tp_sky_kind sky, tp_shading shading)
{
    tp_scene s = scene_plain();

    s.quality.visibility = TP_VISIBILITY_TRIANGLES;
    s.quality.shading = (int32_t)shading;
    s.quality.rate = TP_RATE_FULL;
    s.sky.kind = (int32_t)sky;
    s.sky.haze = TP_FX(0.004);
    s.light.ambient = TP_FX(0.3);
    s.water.specular = TP_FX(0.8);
    s.water.reflection = TP_FX(0.9);
    s.ripple.bump = TP_FX(0.2);
    s.hdr.exposure_factor = TP_FX(1.5);
    if (shading == TP_SHADING_EXACT) {
        s.hdr.share = TP_FX(0.4);
        s.mirror.method = TP_MIRROR_STENCIL;
    }
    return s;
}

static tp_assets all_assets(void)
{
    tp_assets a = { .boat = &kit.boat.mesh, .ripple = &kit.picture[0],
                    .distortion = &kit.picture[2] };

    for (int i = 0; i < TP_LAYERS; i++)
        a.layer[i] = &kit.picture[i];
    for (int i = 0; i < TP_FACES; i++)
        a.sky[i] = &kit.picture[i];
    return a;
}

/* Rows that keep the same modules on, and that need no plan. */
static bool is_tried(const tp_param *row)
{
    return (row->kind == TP_PARAM_FX || row->kind == TP_PARAM_COLOUR
            || row->offset == offsetof(tp_scene, light.model)
            || row->offset == offsetof(tp_scene, water.fresnel))
           && strncmp(row->name, "quality", 7) != 0;
}

/* Returns another value between the present one and an end of the range, not 0, not 1:
 * the values that switch modules. */
static int32_t other_value(const tp_param *row, int32_t now)
{
    if (row->kind == TP_PARAM_CHOICE)
        return !now;
    const int64_t end = random_below(&chance, 2) ? row->low : row->high;
    const int64_t by = row->kind == TP_PARAM_COLOUR ? 3 : 2 + (int64_t)random_below(&chance, 60);
    const int32_t value = (int32_t)(now + (end - now) / by);
    return value == 0 || value == TP_FX_ONE ? now : value;
}

/* Changes one row. Returns its name if the old frame must know the change, else NULL. */
static const char *change(tp_scene *s)
{
    uint32_t count = 0;
    const tp_param *row = &tp_params(&count)[0];

    do
        row = &tp_params(&count)[random_below(&chance, count)];
    while (!is_tried(row) || *scene_number(s, row) == 0);
    const int32_t now = *scene_number(s, row);
    *scene_number(s, row) = other_value(row, now);
    return *scene_number(s, row) != now ? row->name : NULL;
}

/* Draws some pictures by one frame, with one row more changed before each, and compares
 * each with that of a new frame. Returns the number of compared pictures. */
static uint32_t compare_walk(tp_sky_kind sky, tp_shading shading)
{
    tp_scene s = sea(sky, shading);
    const tp_assets assets = all_assets();
    tp_world *world = scene_world(&s, &assets);
    test_frame kept = frame_of(&s, &assets, &config);
    uint32_t compared = 0;

    frame_draw_picture(&kept, world, old);
    for (int step = 0; step < 40; step++) {
        const tp_scene before = s;
        const char *name = change(&s);
        if (!name || !tp_world_apply(&tp_program_all, world, &s, &assets)
            || tp_frame_bytes(&kept.frame->config, &s) != kept.bytes) {
            s = before;
            tp_world_apply(&tp_program_all, world, &s, &assets);
            continue;
        }
        run(&chance, world, &s, (int)random_below(&chance, 3));
        test_frame again = frame_of(&s, &assets, &config);
        frame_draw_picture(&kept, world, old);
        frame_draw_picture(&again, world, fresh);
        if (memcmp(old, fresh, sizeof old) != 0)
            fail_msg("%s draws otherwise than in a new frame", name);
        frame_free(&again);
        compared++;
    }
    frame_free(&kept);
    free(world);
    return compared;
}

static void a_changed_number_draws_as_in_a_new_frame(void **state)
{
    static const tp_sky_kind sky[] = { TP_SKY_GRADIENT, TP_SKY_DAY, TP_SKY_NIGHT,
                                       TP_SKY_CUBE };
    uint32_t compared = 0;

    (void)state;
    for (int walk = 0; walk < 8; walk++)
        compared += compare_walk(sky[walk % 4],
                                 walk < 4 ? TP_SHADING_EXACT : TP_SHADING_QUICK);
    assert_true(compared > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_changed_number_draws_as_in_a_new_frame),
    };
    chance = random_seed();
    kit_make(&kit, &chance);
    return cmocka_run_group_tests_name("frame_refresh", tests, NULL, NULL);
}
