/* SPDX-License-Identifier: MIT */
/* The world does not depend on how it is drawn: picture sizes, rungs of all kinds and
 * effects, and the governor's steps leave the same bytes of world behind.  Values of the
 * scene that change the world, foam.slices and pool.interval, do change it; init fixes them,
 * and tapes and snapshots keep their world. */
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
#include "tests/lib/random.h"
#include "tidepool/world.h"
#include "world/text.h"

#define TICKS 120
#define EVERY 12                /* ticks a frame */

/* A way of drawing: size of the picture, 0 for none; rungs. */
typedef struct {
    uint32_t wide, high;
    int32_t  visibility, shading, rate, effect;         /* effect: of all, at most its last */
    bool     governed;
} way;

/* Values of a scene that change its world. */
typedef struct { int32_t slices, interval; } world_rungs;

static const world_rungs exact_world = { 1, 0 }, cheap_world = { 4, 1 };

/* Steep swells that foam, spray off them, rings, and a pool that drops stir. */
static tp_scene rough_water(world_rungs by)
{
    tp_scene s = scene_plain();

    s.boat.mesh[0] = 0;
    for (int i = 0; i < 3; i++)
        s.wave[i].steepness = TP_FX(0.28);
    s.foam.cells = 48;
    s.foam.crest = TP_FX(0.9);
    s.foam.slices = by.slices;
    s.spray.count = 40;
    s.drops.count = 3;
    s.pool.cols = s.pool.rows = 24;
    s.pool.courant = TP_FX(0.12);
    s.pool.damping = 7;
    s.pool.splash_interval = TP_FX(0.25);
    s.pool.interval = by.interval;
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

static void walk_of(tp_set_walk *walk, const tp_scene *scene, const way *w)
{
    tp_view_costs view;
    uint32_t open;
    const tp_rung_set from = tp_rung_set_named(scene, true, &open);

    assert_true(tp_plan_view(&view, scene, NULL, w->wide, w->high));
    tp_set_walk_make(walk, &view, from, open);
}

/* Returns the CRC of the world after TICKS ticks, drawn now and then as `w` says. */
static uint32_t crc_of(world_rungs by, const way *w)
{
    static uint32_t pixels[160 * 120];
    tp_scene scene = rough_water(by);
    const tp_config config = { .width = w->wide, .height = w->high };
    test_frame f = { .frame = NULL };
    static tp_set_walk walk;
    tp_governor governor;
    size_t bytes;

    set_way(&scene, w);
    tp_world *world = cleared_world(&scene, &bytes);
    if (w->wide) {
        walk_of(&walk, &scene, w);
        f = frame_of(&scene, NULL, &config);
        tp_governor_init(&governor, &walk, w->governed ? 1 : 0);
    }
    for (int tick = 1; tick <= TICKS; tick++) {
        tp_world_step(&tp_program_all, world, &scene,
                      tick % 50 ? NULL : &(tp_input){ .drops = 1 });
        if (!w->wide || tick % EVERY)
            continue;
        frame_draw_picture(&f, world, pixels);
        for (int k = 0; w->governed && k < 40; k++)     /* slow frames: down the ladder */
            tp_governor_add_frame_time(&governor, 100);
        if (w->governed) {
            tp_rung_set_apply(&scene, &walk.set[governor.at]);
            frame_free(&f);
            f = frame_of(&scene, NULL, &config);
        }
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
    static const world_rungs worlds[] = { { 1, 0 }, { 4, 0 }, { 1, 1 } };
    uint32_t crc[3];

    for (int n = 0; n < 3; n++) {
        crc[n] = crc_of(worlds[n], &ways[0]);
        for (size_t i = 1; i < sizeof ways / sizeof ways[0]; i++)
            assert_int_equal(crc_of(worlds[n], &ways[i]), crc[n]);
    }
    assert_int_not_equal(crc[0], crc[1]);       /* slices are another world */
    assert_int_not_equal(crc[0], crc[2]);       /* and so are slow steps */
}

/* -- tapes and snapshots ------------------------------------------------------------- */

static uint64_t chance;

/* The input of a tick: drops, splashes, a turn of the camera. */
static tp_input some_input(void)
{
    return (tp_input){
        .drops = chance_int(&chance, 0, 3), .turn = chance_int(&chance, -9, 9) * (1 << 20),
        .push[0] = { chance_fx(&chance, -2, 2), chance_fx(&chance, -2, 2),
                     chance_int(&chance, 0, 3) ? 0 : TP_FX(0.3) },
    };
}

static void step_world(tp_world *world, const tp_scene *scene, const tp_input *input)
{
    tp_world_advance_clock(world);
    tp_world_step(&tp_program_all, world, scene, input);
}

/* Runs a world by random inputs and writes them as a tape of a line each tick. */
static void record(tp_world *world, const tp_scene *scene, char tape[][TP_TAPE_LINE])
{
    for (int tick = 0; tick < TICKS; tick++) {
        const tp_tape_entry entry = { .tick = (uint64_t)tick, .input = some_input() };
        assert_true(tp_tape_write(&entry, tape[tick], TP_TAPE_LINE) > 0);
        step_world(world, scene, &entry.input);
    }
}

static void replay(tp_world *world, const tp_scene *scene, char tape[][TP_TAPE_LINE],
                   int from, int to)
{
    for (int tick = from; tick < to; tick++) {
        tp_tape_entry entry;
        assert_int_equal(tp_tape_read(&entry, tape[tick], strlen(tape[tick]), NULL), TP_OK);
        step_world(world, scene, &entry.input);
    }
}

/* Half of the tape ends between two steps of the pool and within a round of slices. */
static void tapes_and_snapshots_keep_the_world_of_cheap_values(void **state)
{
    (void)state;
    static char tape[TICKS][TP_TAPE_LINE];
    enum { HALF = TICKS / 2 + 1 };
    const tp_scene scene = rough_water(cheap_world);
    size_t bytes;
    tp_world *world = cleared_world(&scene, &bytes), *fresh = cleared_world(&scene, &bytes);

    record(world, &scene, tape);
    const uint32_t crc = tp_crc32(0, world, bytes);

    tp_world *again = cleared_world(&scene, &bytes);
    replay(again, &scene, tape, 0, HALF);
    tp_world *snapshot = malloc(bytes);
    memcpy(snapshot, again, bytes);
    replay(again, &scene, tape, HALF, TICKS);
    assert_int_equal(tp_crc32(0, again, bytes), crc);

    assert_int_equal(tp_world_check(&tp_program_all, snapshot, bytes, fresh, NULL), TP_OK);
    replay(snapshot, &scene, tape, HALF, TICKS);
    assert_int_equal(tp_crc32(0, snapshot, bytes), crc);
    free(snapshot);
    free(again);
    free(fresh);
    free(world);
}

/* Runs a world while the scene has other cheap values: a port makes the world again, but no
 * tick may read them. */
static uint32_t crc_of_edited(world_rungs by, world_rungs edited)
{
    tp_scene scene = rough_water(by);
    size_t bytes;
    tp_world *world = cleared_world(&scene, &bytes);

    for (int tick = 0; tick < TICKS; tick++) {
        if (tick == 40)
            scene = rough_water(edited);
        step_world(world, &scene, NULL);
    }
    assert_int_equal(tp_world_apply(&tp_program_all, world, &scene, NULL),
                     by.slices == edited.slices && by.interval == edited.interval);
    const uint32_t crc = tp_crc32(0, world, bytes);
    free(world);
    return crc;
}

/* A world keeps the values of its init; a snapshot of other values is refused. */
static void init_fixes_the_values(void **state)
{
    (void)state;
    static const world_rungs others[] = { { 1, 1 }, { 4, 0 }, { 16, 2 } };
    const uint32_t crc = crc_of_edited(cheap_world, cheap_world);

    for (int i = 0; i < 3; i++) {
        const tp_scene mine = rough_water(cheap_world), other = rough_water(others[i]);
        size_t bytes, other_bytes;
        tp_world *world = cleared_world(&mine, &bytes);
        tp_world *fresh = cleared_world(&other, &other_bytes);
        assert_int_equal(crc_of_edited(cheap_world, others[i]), crc);
        assert_int_equal(bytes, other_bytes);
        assert_int_equal(tp_world_check(&tp_program_all, world, bytes, fresh, NULL),
                         TP_E_WORLD);
        free(fresh);
        free(world);
    }
    assert_int_not_equal(crc_of_edited(exact_world, exact_world), crc);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_way_of_drawing_leaves_the_same_world),
        cmocka_unit_test(tapes_and_snapshots_keep_the_world_of_cheap_values),
        cmocka_unit_test(init_fixes_the_values),
    };
    return cmocka_run_group_tests_name("world/rungs", tests, NULL, NULL);
}
