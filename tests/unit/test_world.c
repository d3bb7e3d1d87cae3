/* SPDX-License-Identifier: MIT */
/* The world from tick to tick: the camera's steps and the clock of the deep water; a run
 * repeats bit for bit.  The boat has its own tests. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "world/world.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

#define LSB (1 / 65536.0)

static uint64_t chance;

static void assert_same_world(const tp_world *a, const tp_world *b)
{
    assert_int_equal(a->tick, b->tick);
    assert_int_equal(a->heading, b->heading);
    assert_int_equal(a->pitch, b->pitch);
    assert_memory_equal(&a->eye, &b->eye, sizeof a->eye);
    assert_memory_equal(&a->boat, &b->boat, sizeof a->boat);
    assert_int_equal(a->deep.count, b->deep.count);
    for (uint32_t i = 0; i < a->deep.count; i++)
        assert_int_equal(a->phases[i], b->phases[i]);
}

/* -- the camera ---------------------------------------------------------------------- */

static tp_world world_at(tp_fx heading, tp_scene *scene)
{
    tp_world world;

    *scene = scene_plain();
    scene->camera.x = 5 * TP_FX_ONE;
    scene->camera.z = -7 * TP_FX_ONE;
    scene->camera.heading = heading;
    tp_world_init(&tp_program_all, &world, sizeof world, scene, NULL, NULL);
    return world;
}

/* Asserts the eye's displacement by one step of `in`, to the nearest metre. */
static void assert_goes(tp_fx heading, tp_input in, int x, int y, int z)
{
    tp_scene scene;
    const tp_world before = world_at(heading, &scene);
    tp_world after = before;

    tp_world_step(&tp_program_all, &after, &scene, &in);
    assert_true(fabs((after.eye.x - before.eye.x) * LSB - x) < 1e-3);
    assert_true(fabs((after.eye.y - before.eye.y) * LSB - y) < 1e-3);
    assert_true(fabs((after.eye.z - before.eye.z) * LSB - z) < 1e-3);
}

static void the_world_begins_as_the_scene_says(void **state)
{
    (void)state;
    tp_scene scene;
    const tp_world world = world_at(90 * TP_FX_ONE, &scene);

    assert_int_equal(world.tick, 0);
    assert_int_equal(world.eye.x, scene.camera.x);
    assert_int_equal(world.eye.y, scene.camera.y);
    assert_int_equal(world.eye.z, scene.camera.z);
    assert_true(abs((int32_t)(world.heading - 0x40000000u)) < 64);
    assert_true((int32_t)world.pitch < 0);      /* -6 degrees by default */
}

static void steps_go_where_the_camera_looks(void **state)
{
    (void)state;
    const tp_fx m = 3 * TP_FX_ONE, turn = 90 * TP_FX_ONE;
    const tp_input ahead = { .forward = m }, aside = { .strafe = m };
    const tp_input up = { .up = m }, back = { .forward = -m };

    assert_goes(0, ahead, 0, 0, -3);
    assert_goes(turn, ahead, 3, 0, 0);
    assert_goes(2 * turn, ahead, 0, 0, 3);
    assert_goes(-turn, ahead, -3, 0, 0);
    assert_goes(turn, back, -3, 0, 0);
    assert_goes(0, aside, 3, 0, 0);
    assert_goes(turn, aside, 0, 0, 3);
    assert_goes(2 * turn, aside, -3, 0, 0);
    assert_goes(turn, up, 0, 3, 0);
}

/* Each step turns first, then moves. */
static void turns_are_clockwise_and_tilts_are_up(void **state)
{
    (void)state;
    tp_scene scene;
    tp_world world = world_at(0, &scene);
    const tp_input in = { .forward = TP_FX_ONE, .turn = 0x40000000, .tilt = 0x08000000 };
    const tp_turn before = world.pitch;

    tp_world_step(&tp_program_all, &world, &scene, &in);
    assert_int_equal(world.heading, 0x40000000);
    assert_int_equal(world.pitch - before, 0x08000000);
    assert_true(fabs((world.eye.x - scene.camera.x) * LSB - 1) < 1e-3);
}

static void the_camera_never_looks_straight_up_or_down(void **state)
{
    (void)state;
    tp_scene scene;
    tp_world world = world_at(0, &scene);
    const double most = 89 / 360.0 * 4294967296.0;

    for (int n = 0; n < 2000; n++) {
        const tp_input in = { .tilt = n % 100 < 50 ? INT32_MAX - n : INT32_MIN + n };
        tp_world_step(&tp_program_all, &world, &scene, n % 3 ? &in : NULL);
        assert_true(fabs((double)(int32_t)world.pitch) <= most);
    }
    const tp_input up = { .tilt = INT32_MAX };
    tp_world_step(&tp_program_all, &world, &scene, &up);
    assert_true(fabs((int32_t)world.pitch - most) < 2);
}

static void the_eye_stays_within_eight_kilometres(void **state)
{
    (void)state;
    tp_scene scene;
    tp_world world = world_at(0, &scene);

    for (int n = 0; n < 500; n++) {
        const tp_input in = { .forward = (int32_t)random_next(&chance),
                              .strafe = (int32_t)random_next(&chance),
                              .up = (int32_t)random_next(&chance),
                              .turn = (int32_t)random_next(&chance),
                              .tilt = (int32_t)random_next(&chance) };
        tp_world_step(&tp_program_all, &world, &scene, &in);
        assert_true(abs(world.eye.x) <= 8000 * TP_FX_ONE);
        assert_true(abs(world.eye.y) <= 8000 * TP_FX_ONE);
        assert_true(abs(world.eye.z) <= 8000 * TP_FX_ONE);
    }
}

/* 1000 steps of up to 1 cm forth and as many back, anywhere: rounding causes no drift. */
static void a_walk_forth_and_back_ends_where_it_began(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        tp_scene scene;
        const tp_world before = world_at(chance_fx(&chance, -360, 360), &scene);
        tp_world after = before;
        const tp_fx ahead = chance_int(&chance, 1, 655),
                    aside = chance_int(&chance, 1, 655);
        scene.wave[0].amplitude = scene.wave[1].amplitude = scene.wave[2].amplitude = 0;
        tp_world_apply(&tp_program_all, &after, &scene, NULL);
        for (int k = 0; k < 2000; k++) {
            const int way = k < 1000 ? 1 : -1;
            const tp_input in = { .forward = way * ahead, .strafe = way * aside };
            tp_world_step(&tp_program_all, &after, &scene, &in);
        }
        assert_int_equal(after.eye.x, before.eye.x);
        assert_int_equal(after.eye.z, before.eye.z);
    }
}

/* -- the clock ----------------------------------------------------------------------- */

static tp_push any_push(void)
{
    return (tp_push){ chance_fx(&chance, -1, 1), chance_fx(&chance, -5, 5),
                      chance_fx(&chance, -5, 5) };
}

static tp_input any_input(void)
{
    return (tp_input){ .forward = chance_fx(&chance, -0.2, 0.2),
                       .strafe = chance_fx(&chance, -0.2, 0.2),
                       .up = chance_fx(&chance, -0.1, 0.1),
                       .turn = chance_int(&chance, -4000000, 4000000),
                       .tilt = chance_int(&chance, -4000000, 4000000),
                       .sphere_x = chance_fx(&chance, -0.1, 0.1),
                       .drops = chance_int(&chance, -2, 2),
                       .throttle = chance_fx(&chance, -9, 9),
                       .rudder = chance_fx(&chance, -90, 90),
                       .push[0] = any_push(),
                       .push[3] = any_push(),
                       .slowdown = chance_int(&chance, -1, 1) };
}

static int32_t at_most(int32_t x, int32_t most)
{
    return x < most ? x : most;
}

/* Any valid scene, with pools small enough for a quick test. */
static tp_scene any_moving_scene(void)
{
    tp_scene scene = scene_any(&chance);

    scene.pool.cols = at_most(scene.pool.cols, 32);
    scene.pool.rows = at_most(scene.pool.rows, 32);
    scene.field.cols = at_most(scene.field.cols, 32);
    scene.field.rows = at_most(scene.field.rows, 32);
    scene.pool.courant = at_most(scene.pool.courant, TP_FX(0.48));
    scene.field.courant = at_most(scene.field.courant, TP_FX(0.48));
    scene.drops.count = at_most(scene.drops.count, 40);
    scene.drops.rings = at_most(scene.drops.rings, 40);
    strcpy(scene.boat.mesh, random_below(&chance, 2) ? "boat.obj" : "");
    return scene;
}

static void play(tp_world *world, const tp_scene *scene, const tp_input tape[100])
{
    for (uint64_t i = tp_world_tick(world); i < 100; i++)
        tp_world_step(&tp_program_all, world, scene, i % 7 ? &tape[i] : NULL);
}

/* A tape is played twice, and once from a copy made on the way: the whole blocks are equal
 * to the last byte, for any previous contents. */
static void a_tape_replays_bit_for_bit(void **state)
{
    (void)state;
    const int tapes = getenv("TP_SOAK") ? 40 : 16;
    for (int n = 0; n < tapes; n++) {
        const tp_scene scene = any_moving_scene();
        const size_t bytes = tp_world_bytes(&tp_program_all, &scene, NULL);
        tp_input tape[100];
        if (bytes == 0)
            continue;
        tp_world *first = malloc(bytes), *second = malloc(bytes), *copy = malloc(bytes);
        memset(second, 0xa5, bytes);
        for (int i = 0; i < 100; i++)
            tape[i] = any_input();
        assert_int_equal(tp_world_init(&tp_program_all, first, bytes, &scene, NULL, NULL),
                         TP_OK);
        assert_int_equal(
            tp_world_init(&tp_program_all, second, bytes, &scene, NULL, NULL), TP_OK);
        assert_memory_equal(first, second, bytes);
        for (int i = 0; i < 37; i++)
            tp_world_step(&tp_program_all, first, &scene, i % 7 ? &tape[i] : NULL);
        memcpy(copy, first, bytes);
        play(first, &scene, tape);
        play(second, &scene, tape);
        play(copy, &scene, tape);
        assert_memory_equal(first, second, bytes);
        assert_memory_equal(first, copy, bytes);
        free(first);
        free(second);
        free(copy);
    }
}

/* The deep water of a tick does not depend on the path to the tick. */
static void a_leap_in_time_is_as_good_as_its_steps(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        tp_scene scene = scene_any(&chance);
        tp_world steps, leap;
        scene.pool.cols = scene.field.cols = scene.drops.count = 0;
        scene.floor.depth = scene.wind.strength = 0;
        scene.hdr.exposure = TP_EXPOSURE_FIXED;
        scene.foam.cells = scene.spray.count = 0;
        scene.boat.mesh[0] = '\0';      /* searches begin at the last results */
        tp_world_init(&tp_program_all, &steps, sizeof steps, &scene, NULL, NULL);
        tp_world_init(&tp_program_all, &leap, sizeof leap, &scene, NULL, NULL);
        steps.tick = leap.tick = random_next(&chance) >> 20;
        tp_world_apply(&tp_program_all, &steps, &scene, NULL);
        for (int i = 0; i < 50; i++)
            tp_world_step(&tp_program_all, &steps, &scene, NULL);
        leap.tick += 50;
        tp_world_apply(&tp_program_all, &leap, &scene, NULL);
        assert_same_world(&steps, &leap);
    }
}

static void changed_waves_take_effect_at_a_refresh(void **state)
{
    (void)state;
    tp_scene scene = scene_plain();
    tp_world world;

    tp_world_init(&tp_program_all, &world, sizeof world, &scene, NULL, NULL);
    scene.wave[1].amplitude = 0;
    scene.wave[0].amplitude = TP_FX(0.9);
    tp_world_step(&tp_program_all, &world, &scene, NULL);
    assert_int_equal(world.deep.count, 3);
    assert_int_equal(world.deep.swell[0].amplitude, TP_FX(0.4));
    tp_world_apply(&tp_program_all, &world, &scene, NULL);
    assert_int_equal(world.tick, 1);
    assert_int_equal(world.deep.count, 2);
    assert_int_equal(world.deep.swell[0].amplitude, TP_FX(0.9));
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_world_begins_as_the_scene_says),
        cmocka_unit_test(steps_go_where_the_camera_looks),
        cmocka_unit_test(turns_are_clockwise_and_tilts_are_up),
        cmocka_unit_test(the_camera_never_looks_straight_up_or_down),
        cmocka_unit_test(the_eye_stays_within_eight_kilometres),
        cmocka_unit_test(a_walk_forth_and_back_ends_where_it_began),
        cmocka_unit_test(a_tape_replays_bit_for_bit),
        cmocka_unit_test(a_leap_in_time_is_as_good_as_its_steps),
        cmocka_unit_test(changed_waves_take_effect_at_a_refresh),
    };
    return cmocka_run_group_tests_name("world", tests, NULL, NULL);
}
