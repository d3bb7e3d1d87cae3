/* SPDX-License-Identifier: MIT */
/* Pose of a boat on waves, [E1] [E2] [E3]. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/deep_water.h"
#include "tests/lib/measure.h"
#include "tests/lib/boats.h"

#define Q30 1073741824.0

static uint64_t chance;

static tp_rotation turn_of(const tp_world *w)
{
    return tp_rotation_from_angles(w->boat.heading, w->boat.pitch, w->boat.roll);
}

/* Upward components of the boat's bow and right side, as sines. */
static double bow_up(const tp_world *w)
{
    const tp_rotation turn = turn_of(w);
    return tp_rotate_back(&turn, (tp_vec3){ 0, 0, -TP_Q30_ONE }).y / Q30;
}

static double starboard_up(const tp_world *w)
{
    const tp_rotation turn = turn_of(w);
    return tp_rotate_back(&turn, (tp_vec3){ TP_Q30_ONE, 0, 0 }).y / Q30;
}

/* -- the pose ------------------------------------------------------------------------ */

/* A standing swell of 200 m length and 2 m amplitude that rises from the origin in its
 * heading; the boat is at the origin. */
static tp_world slope_world(tp_fx swell, tp_fx boat, tp_scene *scene)
{
    *scene = boat_calm_scene();
    scene->wave[0] = (tp_wave){ 2 * TP_FX_ONE, 200 * TP_FX_ONE, 0, swell, 0, 0, 1 };
    scene->boat.x = scene->boat.z = 0;
    scene->boat.heading = boat;
    return boat_world(scene);
}

static void no_boat_is_placed_where_none_is_named(void **state)
{
    (void)state;
    tp_scene scene = scene_plain();

    scene.boat.mesh[0] = 0;
    tp_world w = boat_world(&scene);
    tp_world_step(&tp_program_all, &w, &scene, NULL);
    assert_true(w.boat.place.x == 0 && w.boat.place.y == 0 && w.boat.place.z == 0);
    assert_int_equal(turn_of(&w).x.x, TP_Q30_ONE);
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
    assert_true(abs(w.boat.place.y) < 64);
}

/* A slope of 0.9 at 45 degrees to the boat: the mast is normal to the plane.  Roll measured
 * in the level frame would give an error of 6 degrees. */
static void the_mast_is_square_to_a_steep_slope(void **state)
{
    (void)state;
    tp_scene scene = boat_calm_scene();

    scene.wave[0] = (tp_wave){ 16 * TP_FX_ONE, 112 * TP_FX_ONE, 0, 45 * TP_FX_ONE, 0, 0,
                               1 };
    scene.boat.x = scene.boat.z = 0;
    scene.boat.heading = 0;
    scene.boat.length = scene.boat.beam = TP_FX(0.5);
    tp_world w = boat_world(&scene);
    const double slope = 16 * 2 * PI / 112, level = cos(atan(slope));
    const tp_rotation turn = turn_of(&w);

    assert_true(fabs(turn.y.y / Q30 - level) < 0.001);
    assert_true(fabs(turn.y.x / Q30 + sin(atan(slope)) * sqrt(0.5)) < 0.001);
    assert_true(fabs(turn.y.z / Q30 - sin(atan(slope)) * sqrt(0.5)) < 0.001);
}

static void heave_is_the_water_s_height_and_the_lift(void **state)
{
    (void)state;
    tp_scene scene;
    tp_world w = slope_world(0, 0, &scene);

    scene.wave[0].phase = 90 * TP_FX_ONE;       /* a crest at the origin */
    tp_world_apply(&tp_program_all, &w, &scene, NULL);
    assert_true(fabs(w.boat.place.y * LSB - 2) < 0.02);
    scene.boat.lift = TP_FX(-0.75);
    tp_world_apply(&tp_program_all, &w, &scene, NULL);
    assert_true(fabs(w.boat.place.y * LSB - 1.25) < 0.02);
    scene.wave[0].phase = -90 * TP_FX_ONE;
    tp_world_apply(&tp_program_all, &w, &scene, NULL);
    assert_true(fabs(w.boat.place.y * LSB + 2.75) < 0.02);
}

static void calm_water_carries_the_boat_level(void **state)
{
    (void)state;
    for (int n = 0; n < 6; n++) {
        tp_scene scene = boat_calm_scene();
        scene.boat.heading = 30 * TP_FX_ONE;
        scene.boat.mode = n % 2 ? TP_BOAT_DYNAMIC : TP_BOAT_KINEMATIC;
        scene.boat.smooth = n < 4 ? 0 : TP_FX_ONE;
        tp_world w = boat_world(&scene);
        boat_steps(&w, &scene, NULL, n < 2 ? 0 : 500);
        assert_int_equal(w.boat.place.y, 0);
        assert_int_equal(w.boat.place.x, scene.boat.x);
        assert_int_equal(w.boat.place.z, scene.boat.z);
        assert_int_equal(turn_of(&w).y.x, 0);
        assert_int_equal(turn_of(&w).y.y, TP_Q30_ONE);
        assert_int_equal(turn_of(&w).y.z, 0);
    }
}

/* [E2] in double precision: four heights, their mean and two angles, roll about the boat's
 * own axis. */
static void compare_boat(const tp_scene *scene, const tp_world *w, measure *heave,
                         measure *tilt)
{
    const ref_deep_water sea =
        ref_deep_water_make(scene->wave, TP_WAVES, scene->water.gravity);
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
        y[i] = ref_sample_deep_water(&sea, phase, x, z).y;
    }
    const double pitch = atan2(y[0] - y[1], scene->boat.length * LSB);
    const double roll = atan2((y[3] - y[2]) * cos(pitch), scene->boat.beam * LSB);
    const double off = w->boat.place.y * LSB - (y[0] + y[1] + y[2] + y[3]) / 4
                     - scene->boat.lift * LSB;
    const double bow = asin(bow_up(w)) - pitch;
    const double side = asin(starboard_up(w)) + asin(cos(pitch) * sin(roll));
    measure_add(heave, off * 1000, (int64_t)w->tick, 0, 0);
    measure_add(tilt, fmax(fabs(bow), fabs(side)) * 180 / PI, (int64_t)w->tick, 0, 0);
}

/* An error of 1 mm in the search [E1], over a beam of 2 m and a slope below 1.2, gives less
 * than 0.07 degrees; the height has the same error of 1 mm. */
static void the_boat_follows_the_models(void **state)
{
    (void)state;
    measure heave = { .what = "heave", .unit = "mm" }, tilt = { .what = "pitch, roll",
                                                                .unit = "degrees" };

    for (int n = 0; n < 300; n++) {
        const tp_scene scene = boat_swells(&chance, 0.9);
        tp_world w = boat_world(&scene);
        w.tick = random_next(&chance) >> 30;
        tp_world_apply(&tp_program_all, &w, &scene, NULL);
        for (int t = 0; t < 3; t++) {
            compare_boat(&scene, &w, &heave, &tilt);
            tp_world_step(&tp_program_all, &w, &scene, NULL);
        }
    }
    measure_print(&heave);
    measure_print(&tilt);
    assert_true(heave.worst < 1);
    assert_true(tilt.worst < 0.07);
}

/* A sine of 120 m under a boat with a natural frequency of 4 rad/s: the lag equals the
 * model's 1 - 1 / (1 - r^2 + 2 i zeta r), where r is the swell's frequency over the natural
 * frequency.  The mean of the hull's four points is the swell's height times (1 + cos(k
 * length / 2)) / 2.  A step uses the water of the tick at its end, so the test compares
 * with the next tick. */
static void a_floating_boat_lags_behind_long_swells(void **state)
{
    (void)state;
    tp_scene scene = boat_calm_scene(), lying;
    double worst = 0;

    scene.wave[0] = (tp_wave){ 2 * TP_FX_ONE, 120 * TP_FX_ONE, 0, 0, 0, TP_FX_ONE, 1 };
    scene.boat.heading = 0;
    scene.boat.mode = TP_BOAT_DYNAMIC;
    lying = scene;
    lying.boat.mode = TP_BOAT_KINEMATIC;
    tp_world w = boat_world(&scene), v = boat_world(&lying);
    tp_world_step(&tp_program_all, &v, &lying, NULL);
    for (int t = 0; t < 2000; t++) {
        tp_world_step(&tp_program_all, &w, &scene, NULL);
        tp_world_step(&tp_program_all, &v, &lying, NULL);
        if (t >= 600)
            worst = fmax(worst, abs(w.boat.place.y - v.boat.place.y) * LSB);
    }
    const double g = scene.water.gravity * LSB, k = 2 * PI / 120;
    const double r = sqrt(k * scene.boat.draft * LSB), zeta = scene.boat.drag * LSB;
    const double high = 1 + cos(k * scene.boat.length * LSB / 2);
    const double lag = high * hypot(r * r, 2 * zeta * r) / hypot(1 - r * r, 2 * zeta * r);
    print_message("# g %.2f: apart by %.4f m, model %.4f\n", g, worst, lag);
    assert_true(fabs(worst / lag - 1) < 0.01);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_boat_is_placed_where_none_is_named),
        cmocka_unit_test(the_boat_lies_as_the_water_slopes),
        cmocka_unit_test(the_mast_is_square_to_a_steep_slope),
        cmocka_unit_test(heave_is_the_water_s_height_and_the_lift),
        cmocka_unit_test(calm_water_carries_the_boat_level),
        cmocka_unit_test(the_boat_follows_the_models),
        cmocka_unit_test(a_floating_boat_lags_behind_long_swells),
    };
    return cmocka_run_group_tests_name("features/boat", tests, NULL, NULL);
}
