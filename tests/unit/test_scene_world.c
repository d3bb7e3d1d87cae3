/* SPDX-License-Identifier: MIT */
/* The world from tick to tick: the camera's steps, the sea's clock, the boat on the
 * surface; and that a run can be repeated bit for bit. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/sea.h"
#include "scenes.h"

#define LSB (1 / 65536.0)
#define Q30 1073741824.0

static uint64_t chance;

static void assert_same_world(const tp_world *a, const tp_world *b)
{
    assert_int_equal(a->tick, b->tick);
    assert_int_equal(a->heading, b->heading);
    assert_int_equal(a->pitch, b->pitch);
    assert_memory_equal(&a->eye, &b->eye, sizeof a->eye);
    assert_memory_equal(&a->boat, &b->boat, sizeof a->boat);
    assert_memory_equal(&a->boat_turn, &b->boat_turn, sizeof a->boat_turn);
    assert_int_equal(a->sea.count, b->sea.count);
    for (uint32_t i = 0; i < a->sea.count; i++)
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
    tp_world_init(&world, scene);
    return world;
}

/* Where one step of `in` takes the eye, to the nearest metre. */
static void assert_goes(tp_fx heading, tp_input in, int x, int y, int z)
{
    tp_scene scene;
    const tp_world before = world_at(heading, &scene);
    tp_world after = before;

    tp_world_step(&after, &scene, &in);
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
    const tp_input ahead = { m, 0, 0, 0, 0 }, aside = { 0, m, 0, 0, 0 };
    const tp_input up = { 0, 0, m, 0, 0 }, back = { -m, 0, 0, 0, 0 };

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

/* Each step turns first, then goes. */
static void turns_are_clockwise_and_tilts_are_up(void **state)
{
    (void)state;
    tp_scene scene;
    tp_world world = world_at(0, &scene);
    const tp_input in = { TP_FX_ONE, 0, 0, 0x40000000, 0x08000000 };
    const tp_turn before = world.pitch;

    tp_world_step(&world, &scene, &in);
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
        tp_world_step(&world, &scene, n % 3 ? &in : NULL);
        assert_true(fabs((double)(int32_t)world.pitch) <= most);
    }
    const tp_input up = { .tilt = INT32_MAX };
    tp_world_step(&world, &scene, &up);
    assert_true(fabs((int32_t)world.pitch - most) < 2);
}

static void the_eye_stays_within_eight_kilometres(void **state)
{
    (void)state;
    tp_scene scene;
    tp_world world = world_at(0, &scene);

    for (int n = 0; n < 500; n++) {
        const tp_input in = { (int32_t)random_next(&chance),
                              (int32_t)random_next(&chance),
                              (int32_t)random_next(&chance),
                              (int32_t)random_next(&chance),
                              (int32_t)random_next(&chance) };
        tp_world_step(&world, &scene, &in);
        assert_true(abs(world.eye.x) <= 8000 * TP_FX_ONE);
        assert_true(abs(world.eye.y) <= 8000 * TP_FX_ONE);
        assert_true(abs(world.eye.z) <= 8000 * TP_FX_ONE);
    }
}

/* 1000 steps of up to 1 cm forth and as many back, anywhere: rounding is no drift. */
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
        tp_world_refresh(&after, &scene);
        for (int k = 0; k < 2000; k++) {
            const int way = k < 1000 ? 1 : -1;
            const tp_input in = { way * ahead, way * aside, 0, 0, 0 };
            tp_world_step(&after, &scene, &in);
        }
        assert_int_equal(after.eye.x, before.eye.x);
        assert_int_equal(after.eye.z, before.eye.z);
    }
}

/* -- the clock ----------------------------------------------------------------------- */

static tp_input any_input(void)
{
    return (tp_input){ chance_fx(&chance, -0.2, 0.2), chance_fx(&chance, -0.2, 0.2),
                       chance_fx(&chance, -0.1, 0.1),
                       chance_int(&chance, -4000000, 4000000),
                       chance_int(&chance, -4000000, 4000000) };
}

/* A tape played twice, and once from a copy made on the way. */
static void a_tape_replays_bit_for_bit(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        const tp_scene scene = scene_any(&chance);
        tp_input tape[100];
        tp_world first, second, copy;
        for (int i = 0; i < 100; i++)
            tape[i] = any_input();
        tp_world_init(&first, &scene);
        memset(&second, 0xa5, sizeof second);
        tp_world_init(&second, &scene);
        assert_same_world(&first, &second);
        for (int i = 0; i < 100; i++) {
            if (i == 37)
                memcpy(&copy, &first, sizeof copy);
            tp_world_step(&first, &scene, i % 7 ? &tape[i] : NULL);
        }
        for (int i = 0; i < 100; i++)
            tp_world_step(&second, &scene, i % 7 ? &tape[i] : NULL);
        for (int i = 37; i < 100; i++)
            tp_world_step(&copy, &scene, i % 7 ? &tape[i] : NULL);
        assert_same_world(&first, &second);
        assert_same_world(&first, &copy);
        assert_int_equal(first.tick, 100);
    }
}

/* A tick's sea does not depend on how it was reached. */
static void a_leap_in_time_is_as_good_as_its_steps(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        const tp_scene scene = scene_any(&chance);
        tp_world steps, leap;
        tp_world_init(&steps, &scene);
        tp_world_init(&leap, &scene);
        steps.tick = leap.tick = random_next(&chance) >> 20;
        tp_world_refresh(&steps, &scene);
        for (int i = 0; i < 50; i++)
            tp_world_step(&steps, &scene, NULL);
        leap.tick += 50;
        tp_world_refresh(&leap, &scene);
        assert_same_world(&steps, &leap);
    }
}

static void changed_waves_take_effect_at_a_refresh(void **state)
{
    (void)state;
    tp_scene scene = scene_plain();
    tp_world world;

    tp_world_init(&world, &scene);
    scene.wave[1].amplitude = 0;
    scene.wave[0].amplitude = TP_FX(0.9);
    tp_world_step(&world, &scene, NULL);
    assert_int_equal(world.sea.count, 3);
    assert_int_equal(world.sea.swell[0].amplitude, TP_FX(0.4));
    tp_world_refresh(&world, &scene);
    assert_int_equal(world.tick, 1);
    assert_int_equal(world.sea.count, 2);
    assert_int_equal(world.sea.swell[0].amplitude, TP_FX(0.9));
}

/* -- the boat ------------------------------------------------------------------------ */

/* A swell of 200 m and 2 m that stands still, rising from the origin to where it heads;
 * the boat at the origin. */
static tp_world slope_world(tp_fx swell, tp_fx boat, tp_scene *scene)
{
    tp_world world;

    tp_scene_default(scene);
    strcpy(scene->boat.mesh, "boat.obj");
    scene->wave[0] = (tp_wave){ 2 * TP_FX_ONE, 200 * TP_FX_ONE, 0, swell, 0, 0 };
    scene->boat.x = scene->boat.z = 0;
    scene->boat.heading = boat;
    tp_world_init(&world, scene);
    return world;
}

static void no_boat_is_placed_where_none_is_named(void **state)
{
    (void)state;
    tp_scene scene = scene_plain();
    tp_world w;

    scene.boat.mesh[0] = 0;
    tp_world_init(&w, &scene);
    tp_world_step(&w, &scene, NULL);
    assert_true(w.boat.x == 0 && w.boat.y == 0 && w.boat.z == 0);
    assert_int_equal(w.boat_turn.x.x, TP_Q30_ONE);
}

/* How much the boat's bow and right side point up, as sines. */
static double bow_up(const tp_world *w)
{
    return tp_rotate_back(&w->boat_turn, (tp_vec3){ 0, 0, -TP_Q30_ONE }).y / Q30;
}

static double starboard_up(const tp_world *w)
{
    return tp_rotate_back(&w->boat_turn, (tp_vec3){ TP_Q30_ONE, 0, 0 }).y / Q30;
}

static void the_boat_lies_as_the_water_slopes(void **state)
{
    (void)state;
    const double slope = 2 * 2 * PI / 200, sine = sin(atan(slope)), near = 0.001;
    tp_scene scene;
    const tp_fx turn = 90 * TP_FX_ONE;
    tp_world w = slope_world(0, 0, &scene);     /* rises ahead */

    assert_true(fabs(bow_up(&w) - sine) < near && fabs(starboard_up(&w)) < near);
    w = slope_world(2 * turn, 0, &scene);       /* falls ahead */
    assert_true(fabs(bow_up(&w) + sine) < near);
    w = slope_world(turn, 0, &scene);           /* rises to starboard */
    assert_true(fabs(starboard_up(&w) - sine) < near && fabs(bow_up(&w)) < near);
    w = slope_world(-turn, 0, &scene);          /* falls to starboard */
    assert_true(fabs(starboard_up(&w) + sine) < near);
    w = slope_world(turn, turn, &scene);        /* the boat turned with the swell */
    assert_true(fabs(bow_up(&w) - sine) < near);
    w = slope_world(0, turn, &scene);           /* rises to port */
    assert_true(fabs(starboard_up(&w) + sine) < near);
    assert_true(abs(w.boat.y) < 64);
}

static void heave_is_the_water_s_height_and_the_lift(void **state)
{
    (void)state;
    tp_scene scene;
    tp_world w = slope_world(0, 0, &scene);

    scene.wave[0].phase = 90 * TP_FX_ONE;       /* a crest at the origin */
    tp_world_refresh(&w, &scene);
    assert_true(fabs(w.boat.y * LSB - 2) < 0.02);
    scene.boat.lift = TP_FX(-0.75);
    tp_world_refresh(&w, &scene);
    assert_true(fabs(w.boat.y * LSB - 1.25) < 0.02);
    scene.wave[0].phase = -90 * TP_FX_ONE;
    tp_world_refresh(&w, &scene);
    assert_true(fabs(w.boat.y * LSB + 2.75) < 0.02);
}

static void calm_water_carries_the_boat_level(void **state)
{
    (void)state;
    tp_scene scene = scene_plain();
    tp_world w;

    for (int i = 0; i < 3; i++)
        scene.wave[i].amplitude = 0;
    scene.boat.heading = 30 * TP_FX_ONE;
    tp_world_init(&w, &scene);
    assert_int_equal(w.boat.y, 0);
    assert_int_equal(w.boat.x, scene.boat.x);
    assert_int_equal(w.boat.z, scene.boat.z);
    assert_int_equal(w.boat_turn.y.x, 0);
    assert_int_equal(w.boat_turn.y.y, TP_Q30_ONE);
    assert_int_equal(w.boat_turn.y.z, 0);
}

/* [E2] in double precision: four heights, their mean and two angles. */
static void compare_boat(const tp_scene *scene, const tp_world *w, measure *heave,
                         measure *tilt)
{
    const ref_sea sea = ref_sea_of(scene->wave, TP_WAVES, scene->water.gravity);
    const double h = scene->boat.heading * LSB * PI / 180;
    const double half[4][2] = { { scene->boat.length * LSB / 2, 0 },
                                { -scene->boat.length * LSB / 2, 0 },
                                { 0, scene->boat.beam * LSB / 2 },
                                { 0, -scene->boat.beam * LSB / 2 } };
    double phase[TP_WAVES], y[4];

    ref_phases(&sea, w->tick, phase);
    for (int i = 0; i < 4; i++) {
        const double x = scene->boat.x * LSB + half[i][0] * sin(h) + half[i][1] * cos(h);
        const double z = scene->boat.z * LSB - half[i][0] * cos(h) + half[i][1] * sin(h);
        y[i] = ref_above(&sea, phase, x, z).y;
    }
    const double pitch = atan2(y[0] - y[1], scene->boat.length * LSB);
    const double roll = atan2(y[3] - y[2], scene->boat.beam * LSB);
    const double off = w->boat.y * LSB - (y[0] + y[1] + y[2] + y[3]) / 4
                     - scene->boat.lift * LSB;
    const double bow = asin(bow_up(w)) - pitch;
    const double side = asin(starboard_up(w)) + asin(cos(pitch) * sin(roll));
    measure_add(heave, off * 1000, (int64_t)w->tick, 0, 0);
    measure_add(tilt, fmax(fabs(bow), fabs(side)) * 180 / PI, (int64_t)w->tick, 0, 0);
}

/* Steepness up to a half: the eight steps of the inversion leave less than 2^-8 / (1 -
 * 1/2) of at most 1.1 m, 9 mm, times the slope, over a beam of 2 m and more: a quarter
 * of a degree at the worst. */
static void the_boat_follows_the_models(void **state)
{
    (void)state;
    measure heave = { .what = "heave", .unit = "mm" }, tilt = { .what = "pitch, roll",
                                                                .unit = "degrees" };

    for (int n = 0; n < 600; n++) {
        tp_scene scene = scene_plain();
        tp_world w;
        for (int i = 0; i < 3; i++) {
            scene.wave[i].amplitude = chance_fx(&chance, 0.05, 0.5);
            scene.wave[i].length = chance_fx(&chance, 8, 40);
            scene.wave[i].steepness = chance_fx(&chance, 0, 0.5 / 3);
            scene.wave[i].heading = chance_fx(&chance, -360, 360);
        }
        scene.boat.heading = chance_fx(&chance, -720, 720);
        scene.boat.length = chance_fx(&chance, 2, 20);
        scene.boat.beam = chance_fx(&chance, 2, 6);
        scene.boat.lift = chance_fx(&chance, -3, 3);
        tp_world_init(&w, &scene);
        w.tick = random_next(&chance) >> 30;
        tp_world_refresh(&w, &scene);
        compare_boat(&scene, &w, &heave, &tilt);
    }
    measure_print(&heave);
    measure_print(&tilt);
    assert_true(heave.worst < 9);
    assert_true(tilt.worst < 0.25);
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
        cmocka_unit_test(no_boat_is_placed_where_none_is_named),
        cmocka_unit_test(the_boat_lies_as_the_water_slopes),
        cmocka_unit_test(heave_is_the_water_s_height_and_the_lift),
        cmocka_unit_test(calm_water_carries_the_boat_level),
        cmocka_unit_test(the_boat_follows_the_models),
    };
    return cmocka_run_group_tests_name("world", tests, NULL, NULL);
}
