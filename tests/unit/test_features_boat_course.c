/* SPDX-License-Identifier: MIT */
/* Course of a boat: the boat sails by speed and rudder, stays at rest where nothing moves
 * the boat, and a run repeats bit for bit. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/deep_water.h"
#include "tests/lib/boats.h"

static uint64_t chance;

/* -- course -------------------------------------------------------------------------- */

static void a_boat_without_way_keeps_its_place(void **state)
{
    (void)state;
    for (int n = 0; n < 8; n++) {
        tp_scene scene = boat_swells(&chance, 0.5);
        scene.boat.x = chance_fx(&chance, -8000, 8000);
        scene.boat.z = chance_fx(&chance, -8000, 8000);
        scene.boat.mode = n % 2 ? TP_BOAT_DYNAMIC : TP_BOAT_KINEMATIC;
        tp_world w = boat_world(&scene);
        const tp_turn heading = w.boat.heading;
        boat_steps(&w, &scene, NULL, 200);
        assert_int_equal(w.boat.place.x, scene.boat.x);
        assert_int_equal(w.boat.place.z, scene.boat.z);
        assert_int_equal(w.boat.heading, heading);
    }
}

static void it_sails_where_its_bow_points(void **state)
{
    (void)state;
    for (int n = 0; n < 24; n++) {
        tp_scene scene = boat_calm_scene();
        scene.boat.heading = 15 * n * TP_FX_ONE;
        scene.boat.speed = 3 * TP_FX_ONE;
        const tp_input in = { .throttle = -TP_FX_ONE };
        tp_world w = boat_world(&scene);
        boat_steps(&w, &scene, &in, 600);
        const double h = 15 * n * PI / 180;
        assert_true(fabs((w.boat.place.x - scene.boat.x) * LSB - 20 * sin(h)) < 0.001);
        assert_true(fabs((w.boat.place.z - scene.boat.z) * LSB + 20 * cos(h)) < 0.001);
    }
}

/* A speed of 0.1 mm/s is about 0.1 LSB per tick. */
static void slow_boats_arrive_too(void **state)
{
    (void)state;
    tp_scene scene = boat_calm_scene();

    scene.boat.speed = 7;
    tp_world w = boat_world(&scene);
    boat_steps(&w, &scene, NULL, 60 * 200);
    assert_int_equal(w.boat.place.z - scene.boat.z, -7 * 200);
    assert_int_equal(w.boat.place.x, scene.boat.x);
}

/* 6 degrees per second are one turn per minute; at 5 m/s the radius is 47.7 m. */
static void the_rudder_makes_a_circle(void **state)
{
    (void)state;
    tp_scene scene = boat_calm_scene();

    scene.boat.speed = 5 * TP_FX_ONE;
    scene.boat.rudder = 10 * TP_FX_ONE;
    const tp_input in = { .rudder = -4 * TP_FX_ONE };
    tp_world w = boat_world(&scene);
    boat_steps(&w, &scene, &in, 1800);
    assert_true(abs((int32_t)(w.boat.heading - 0x80000000u)) < 64);
    assert_true(fabs((w.boat.place.x - scene.boat.x) * LSB - 300 / PI) < 0.5);
    boat_steps(&w, &scene, &in, 1800);
    assert_true(abs((int32_t)w.boat.heading) < 64);
    assert_true(abs(w.boat.place.x - scene.boat.x) < 32);
    assert_true(abs(w.boat.place.z - scene.boat.z) < 32);
}

static void sailed_forth_and_back_is_not_sailed(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        tp_scene scene = boat_calm_scene();
        scene.boat.heading = chance_fx(&chance, -360, 360);
        tp_world w = boat_world(&scene);
        tp_input in = { .throttle = chance_fx(&chance, -30, 30) };
        boat_steps(&w, &scene, &in, 500);
        assert_true(w.boat.place.z != scene.boat.z);
        in.throttle = -in.throttle;
        boat_steps(&w, &scene, &in, 500);
        assert_int_equal(w.boat.place.x, scene.boat.x);
        assert_int_equal(w.boat.place.z, scene.boat.z);
    }
}

static void it_stays_within_eight_kilometres(void **state)
{
    (void)state;
    tp_scene scene = boat_calm_scene();
    tp_world w = boat_world(&scene);
    const tp_input full = { .throttle = TP_FX_MAX, .rudder = TP_FX_MIN };

    boat_steps(&w, &scene, &full, 10);
    for (int n = 0; n < 4; n++) {
        scene.boat.heading = (45 + 90 * n) * TP_FX_ONE;
        tp_world_apply(&tp_program_all, &w, &scene, NULL);
        const tp_input in = { .throttle = TP_FX_MAX };
        for (int t = 0; t < 20000; t++) {
            tp_world_step(&tp_program_all, &w, &scene, &in);
            assert_true(abs(w.boat.place.x) <= 8000 * TP_FX_ONE);
            assert_true(abs(w.boat.place.z) <= 8000 * TP_FX_ONE);
        }
        assert_true(abs(w.boat.place.x) == 8000 * TP_FX_ONE
                    || abs(w.boat.place.z) == 8000 * TP_FX_ONE);
    }
}

/* The scene changes as by the preview's sliders. */
/* On any course the tank leaves half the boat's length free before each wall; between
 * closer walls the boat lies in the middle. */
static void it_stays_within_a_tank(void **state)
{
    (void)state;
    for (int n = 0; n < 16; n++) {
        tp_scene scene = boat_calm_scene();
        scene.pool.cols = 64;
        scene.pool.rows = n % 4 ? 40 : 16;
        scene.pool.cell = TP_FX_ONE / 4;
        scene.pool.x = TP_FX(100);
        scene.tank.kind = 1 + n % 2;
        scene.boat.wake = 0;
        scene.boat.x = TP_FX(101);
        scene.boat.z = TP_FX(1);
        scene.boat.length = TP_FX(6);
        scene.boat.heading = 23 * n * TP_FX_ONE;
        scene.boat.speed = (n % 3 - 1) * 5 * TP_FX_ONE + TP_FX_ONE;
        scene.boat.rudder = n % 5 * TP_FX_ONE;
        tp_world *w = scene_world(&scene, NULL);
        const tp_fx room = n % 4 ? TP_FX(2) : 0;
        for (int t = 0; t < 900; t++) {
            tp_world_step(&tp_program_all, w, &scene, NULL);
            assert_in_range(w->boat.place.x, TP_FX(95), TP_FX(105));
            assert_in_range(w->boat.place.z + room, 0, 2 * room);
        }
        assert_true(w->boat.place.x != TP_FX(101) || w->boat.place.z != TP_FX(1));
        free(w);
    }
}

static void a_changed_place_moves_the_boat(void **state)
{
    (void)state;
    tp_scene scene = boat_calm_scene();

    scene.boat.speed = 2 * TP_FX_ONE;
    tp_world w = boat_world(&scene);
    boat_steps(&w, &scene, NULL, 300);
    const tp_fx sailed = w.boat.place.z - scene.boat.z;
    assert_true(abs(sailed + 10 * TP_FX_ONE) < 8);
    scene.boat.x += 5 * TP_FX_ONE;
    scene.boat.z -= 7 * TP_FX_ONE;
    scene.boat.heading = 90 * TP_FX_ONE;
    tp_world_apply(&tp_program_all, &w, &scene, NULL);
    assert_int_equal(w.boat.place.x, scene.boat.x);
    assert_int_equal(w.boat.place.z, scene.boat.z + sailed);
    assert_true(abs((int32_t)(w.boat.heading - 0x40000000u)) < 64);
    assert_memory_equal(&w.last_boat, &w.boat, sizeof w.boat);
    boat_steps(&w, &scene, NULL, 300);
    assert_true(abs(w.boat.place.x - scene.boat.x - 10 * TP_FX_ONE) < 8);
}

/* A boat with floating or smoothed motion continues from its pose; any other boat takes the
 * pose of the new water. */
static void a_refresh_does_not_lift_a_floating_boat(void **state)
{
    (void)state;
    for (int n = 0; n < 3; n++) {
        tp_scene scene = boat_swells(&chance, 0.5);
        scene.boat.mode = n == 0 ? TP_BOAT_DYNAMIC : TP_BOAT_KINEMATIC;
        scene.boat.smooth = n == 1 ? 2 * TP_FX_ONE : 0;
        tp_world w = boat_world(&scene);
        boat_steps(&w, &scene, NULL, 100);
        const tp_pose before = w.boat;
        for (int i = 0; i < 3; i++)
            scene.wave[i].phase += 100 * TP_FX_ONE;
        tp_world_apply(&tp_program_all, &w, &scene, NULL);
        assert_int_equal(before.place.y == w.boat.place.y, n < 2);
        assert_int_equal(before.pitch == w.boat.pitch, n < 2);
        assert_int_equal(before.roll == w.boat.roll, n < 2);
    }
}

/* -- repeatability ------------------------------------------------------------------- */

/* A scene from the whole ranges of the table, without buffers behind the world's head. */
static tp_scene any_scene(void)
{
    tp_scene scene = scene_any(&chance);

    strcpy(scene.boat.mesh, "boat.obj");
    scene.pool.cols = scene.field.cols = 0;
    scene.drops.count = scene.foam.cells = scene.spray.count = 0;
    scene.floor.depth = scene.wind.strength = 0;
    scene.hdr.exposure = TP_EXPOSURE_FIXED;
    return scene;
}

static void a_sailing_boat_replays_bit_for_bit(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        const tp_scene scene = any_scene();
        tp_input tape[100];
        for (int t = 0; t < 100; t++)
            tape[t] = (tp_input){ .throttle = random_number(&chance),
                                  .rudder = random_number(&chance) };
        tp_world first = boat_world(&scene), second = boat_world(&scene), copy = first;
        for (int t = 0; t < 100; t++) {
            if (t == 41)
                memcpy(&copy, &first, sizeof copy);
            tp_world_step(&tp_program_all, &first, &scene, &tape[t]);
            tp_world_step(&tp_program_all, &second, &scene, &tape[t]);
            if (t >= 41)
                tp_world_step(&tp_program_all, &copy, &scene, &tape[t]);
        }
        assert_memory_equal(&first.boat, &second.boat, sizeof first.boat);
        assert_memory_equal(&first.boat_state, &second.boat_state, sizeof first.boat_state);
        assert_memory_equal(&first.boat_state, &copy.boat_state, sizeof first.boat_state);
        assert_true(abs(first.boat.place.y) <= 4150 * TP_FX_ONE);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_boat_without_way_keeps_its_place),
        cmocka_unit_test(it_sails_where_its_bow_points),
        cmocka_unit_test(slow_boats_arrive_too),
        cmocka_unit_test(the_rudder_makes_a_circle),
        cmocka_unit_test(sailed_forth_and_back_is_not_sailed),
        cmocka_unit_test(it_stays_within_eight_kilometres),
        cmocka_unit_test(it_stays_within_a_tank),
        cmocka_unit_test(a_changed_place_moves_the_boat),
        cmocka_unit_test(a_refresh_does_not_lift_a_floating_boat),
        cmocka_unit_test(a_sailing_boat_replays_bit_for_bit),
    };
    return cmocka_run_group_tests_name("features/boat course", tests, NULL, NULL);
}
