/* SPDX-License-Identifier: MIT */
/* The world does not depend on how it is drawn: picture sizes, rungs of all kinds and
 * effects, and the governor's steps leave the same bytes of world behind.  Values of the
 * scene that change the world, foam.slices, do change it. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/foam/foam.h"
#include "frame/tools.h"
#include "pixel/pixel.h"
#include "quality/plan.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

#define TICKS 120
#define EVERY 12                /* ticks a frame */

/* A way of drawing: size of the picture, 0 for none; rungs. */
typedef struct {
    uint32_t wide, high;
    int32_t  visibility, shading, rate, effect;         /* effect: of all, at most its last */
    bool     governed;
} way;

/* Steep swells that foam, spray off them, rings and a pool's bumps. */
static tp_scene rough_water(int32_t slices)
{
    tp_scene s = scene_plain();

    s.boat.mesh[0] = 0;
    for (int i = 0; i < 3; i++)
        s.wave[i].steepness = TP_FX(0.28);
    s.foam.cells = 48;
    s.foam.crest = TP_FX(0.9);
    s.foam.slices = slices;
    s.spray.count = 40;
    s.drops.count = 3;
    return s;
}

static void set_way(tp_scene *s, const way *w)
{
    s->quality.visibility = w->visibility;
    s->quality.shading = w->shading;
    s->quality.rate = w->rate;
#define X(name, words, last, help) \
    s->quality.name = w->effect < last ? w->effect : last;
    TP_EFFECT_LIST(X)
#undef X
    s->quality.frame_ms = w->governed ? TP_FX_ONE : 0;
}

static tp_world *cleared_world(const tp_scene *scene, size_t *bytes)
{
    *bytes = tp_world_bytes(&tp_program_all, scene, NULL);
    tp_world *world = calloc(1, *bytes);

    assert_int_equal(tp_world_init(&tp_program_all, world, *bytes, scene, NULL, NULL), TP_OK);
    return world;
}

/* Returns the CRC of the world after TICKS ticks, drawn now and then as `w` says. */
static uint32_t crc_of(int32_t slices, const way *w)
{
    static uint32_t pixels[160 * 120];
    tp_scene scene = rough_water(slices);
    const tp_config config = { .width = w->wide, .height = w->high };
    test_frame f = { .frame = NULL };
    tp_governor governor;
    size_t bytes;

    set_way(&scene, w);
    tp_world *world = cleared_world(&scene, &bytes);
    if (w->wide) {
        const tp_ladder ladder = tp_ladder_make(&scene, NULL, w->wide, w->high);
        f = frame_of(&scene, NULL, &config);
        tp_governor_init(&governor, &ladder, w->governed ? 1 : 0);
    }
    for (int tick = 1; tick <= TICKS; tick++) {
        tp_world_step(&tp_program_all, world, &scene,
                      tick % 50 ? NULL : &(tp_input){ .drops = 1 });
        if (!w->wide || tick % EVERY)
            continue;
        frame_draw_picture(&f, world, pixels);
        for (int k = 0; w->governed && k < 40; k++)     /* slow frames: down the ladder */
            tp_governor_add_frame_time(&governor, 100);
        const tp_rungs rungs = tp_governor_rungs(&governor);
        if (w->governed)
            tp_frame_set_rungs(f.frame, &rungs);
    }
    const uint32_t crc = tp_crc32(0, world, bytes);
    if (w->wide)
        frame_free(&f);
    free(world);
    return crc;
}

static const way ways[] = {
    { 0, 0, 0, 0, 0, 0, false },
    { 64, 48, TP_VISIBILITY_TRIANGLES, TP_SHADING_EXACT, TP_RATE_FULL, TP_RUNG_EXACT, false },
    { 160, 120, TP_VISIBILITY_TRIANGLES, TP_SHADING_EXACT, TP_RATE_FULL, TP_RUNG_EXACT, false },
    { 160, 120, TP_VISIBILITY_AUTO, TP_SHADING_QUICK, TP_RATE_AUTO, 9, false },
    { 96, 64, TP_VISIBILITY_PROJECTED, TP_SHADING_QUICK, TP_RATE_COLOUR, TP_RUNG_FAST, false },
    { 160, 120, TP_VISIBILITY_AUTO, TP_SHADING_AUTO, TP_RATE_AUTO, TP_RUNG_AUTO, true },
};

static void any_way_of_drawing_leaves_the_same_world(void **state)
{
    (void)state;
    uint32_t crc[2];

    for (int n = 0; n < 2; n++) {
        crc[n] = crc_of(n ? 4 : 1, &ways[0]);
        for (size_t i = 1; i < sizeof ways / sizeof ways[0]; i++)
            assert_int_equal(crc_of(n ? 4 : 1, &ways[i]), crc[n]);
    }
    assert_int_not_equal(crc[0], crc[1]);       /* slices are another world */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_way_of_drawing_leaves_the_same_world),
    };
    return cmocka_run_group_tests_name("world/rungs", tests, NULL, NULL);
}
