/* SPDX-License-Identifier: MIT */
/* The camera aboard the boat: the camera stays on the deck in any motion of the water. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "view/projection.h"
#include "tests/lib/boats.h"

#define Q30 1073741824.0

static uint64_t chance;

/* A boat that sails, turns and rocks, seen from a random point on its deck. */
static tp_scene aboard_scene(void)
{
    tp_scene s = scene_plain();

    s.camera.follow = TP_FOLLOW_BOAT;
    s.camera.x = chance_fx(&chance, -2, 2);
    s.camera.y = chance_fx(&chance, 0.5, 4);
    s.camera.z = chance_fx(&chance, 2, 8);
    s.camera.heading = chance_fx(&chance, -60, 60);
    s.camera.pitch = chance_fx(&chance, -40, 40);
    s.boat.x = chance_fx(&chance, -500, 500);
    s.boat.heading = chance_fx(&chance, 0, 360);
    s.boat.speed = chance_fx(&chance, -5, 5);
    s.boat.rudder = chance_fx(&chance, -20, 20);
    s.boat.mode = chance_int(&chance, TP_BOAT_KINEMATIC, TP_BOAT_DYNAMIC);
    return s;
}

static tp_projection lens_of(const tp_world *w)
{
    const tp_camera camera = tp_world_camera(w);
    tp_projection projection;

    tp_projection_init_turned(&projection, camera.eye, camera.turn, 60 * TP_FX_ONE,
                              TP_FX(0.25), 640, 480);
    return projection;
}

/* Screen position of a point on the deck, px. */
static void seen_at(const tp_world *w, tp_vec3 deck, double *u, double *v)
{
    const tp_rotation turn =
        tp_rotation_from_angles(w->boat.heading, w->boat.pitch, w->boat.roll);
    const tp_vec3 way = tp_rotate_back(&turn, deck);
    const tp_projection projection = lens_of(w);
    tp_view_vertex c;
    int32_t at[2];
    uint32_t zi;

    tp_projection_view_vertex(&projection, tp_vec3_add(w->boat.place, way), &c);
    assert_true(tp_projection_can_project(&projection, &c));
    tp_projection_project(&projection, &c, &at[0], &at[1], &zi);
    *u = at[0] / 16.0;
    *v = at[1] / 16.0;
}

/* A point drawn 7 m from the eye stays within 1/8 px, twice the rounding of 28.4, as long
 * as the boat sails; the world around the boat moves. */
static void the_deck_stands_still_in_the_picture(void **state)
{
    (void)state;
    double least = 1e9, most = 0;
    for (int n = 0; n < 20; n++) {
        const tp_scene scene = aboard_scene();
        tp_world w = boat_world(&scene);
        const tp_camera start = tp_world_camera(&w);
        const tp_rotation turn =
            tp_rotation_from_angles(tp_turn_of_degrees(scene.camera.heading),
                                    tp_turn_of_degrees(scene.camera.pitch), 0);
        const tp_vec3 ahead = tp_rotate_back(&turn, (tp_vec3){ TP_FX(1.5), TP_FX(-1),
                                                               TP_FX(-7) });
        const tp_vec3 point = tp_vec3_add(ahead, w.eye);
        double u0, v0, u, v;
        seen_at(&w, point, &u0, &v0);
        for (int i = 0; i < 300; i++) {
            tp_world_step(&tp_program_all, &w, &scene, NULL);
            seen_at(&w, point, &u, &v);
            most = fmax(most, fmax(fabs(u - u0), fabs(v - v0)));
        }
        const tp_camera end = tp_world_camera(&w);
        least = fmin(least, abs(end.turn.x.y - start.turn.x.y) / Q30
                            + abs(end.eye.y - start.eye.y) / 65536.0);
    }
    printf("the deck moves by %.3f pixels at the most\n", most);
    assert_true(most <= 0.125);
    assert_true(least > 0);
}

/* Compared with double precision: the deck's position and axes, rotated by roll, pitch,
 * heading. */
static void the_eye_is_where_the_deck_carries_it(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        tp_scene scene = aboard_scene();
        tp_world w = boat_world(&scene);
        w.boat.pitch = (tp_turn)chance_int(&chance, -400000000, 400000000);
        w.boat.roll = (tp_turn)chance_int(&chance, -400000000, 400000000);
        const double turn = 6.283185307179586 / 4294967296.0;
        const double h = w.boat.heading * turn, p = w.boat.pitch * turn;
        const double r = w.boat.roll * turn;
        const double e[3] = { w.eye.x, w.eye.y, w.eye.z };
        /* Rolled about the bow's axis, pitched about the right axis, turned about the
         * mast. */
        const double x = e[0] * cos(r) + e[1] * sin(r);
        const double y1 = e[1] * cos(r) - e[0] * sin(r);
        const double y = y1 * cos(p) - e[2] * sin(p), z = e[2] * cos(p) + y1 * sin(p);
        const tp_camera at = tp_world_camera(&w);
        assert_true(fabs(at.eye.x - w.boat.place.x - (x * cos(h) - z * sin(h))) < 3);
        assert_true(fabs(at.eye.y - w.boat.place.y - y) < 3);
        assert_true(fabs(at.eye.z - w.boat.place.z - (x * sin(h) + z * cos(h))) < 3);
    }
}

static void a_boat_at_rest_carries_the_camera_as_the_world_does(void **state)
{
    (void)state;
    tp_scene scene = aboard_scene();
    tp_world w = boat_world(&scene);

    w.boat = w.last_boat = (tp_pose){ { 0, 0, 0 }, 0, 0, 0 };
    const tp_camera carried = tp_world_camera(&w);
    w.aboard = 0;
    const tp_camera standing = tp_world_camera(&w);
    assert_memory_equal(&carried.eye, &standing.eye, sizeof carried.eye);
    const int32_t *a = &carried.turn.x.x, *b = &standing.turn.x.x;
    for (int i = 0; i < 9; i++)
        assert_true(abs(a[i] - b[i]) <= 1);
}

/* Between two ticks the deck also stands still in the picture. */
static void a_picture_between_ticks_is_of_both_boat_and_camera(void **state)
{
    (void)state;
    tp_scene scene = aboard_scene();
    tp_world w = boat_world(&scene);

    scene.boat.speed = 5 * TP_FX_ONE;
    for (int i = 0; i < 20; i++)
        tp_world_step(&tp_program_all, &w, &scene, NULL);
    const tp_camera now = tp_world_camera(&w);
    w.lag = TP_FX_ONE;
    const tp_camera before = tp_world_camera(&w);
    w.lag = TP_FX_ONE / 2;
    const tp_camera middle = tp_world_camera(&w);
    assert_true(abs(middle.eye.x - (now.eye.x + before.eye.x) / 2) < 66);   /* 1 mm */
    assert_true(abs(middle.eye.z - (now.eye.z + before.eye.z) / 2) < 66);
    assert_true(now.eye.x != before.eye.x || now.eye.z != before.eye.z);
}

static void input_moves_the_camera_about_the_deck(void **state)
{
    (void)state;
    tp_scene scene = aboard_scene();
    scene.camera.heading = 0;
    tp_world w = boat_world(&scene);
    const tp_input in = { .forward = TP_FX_ONE,
                          .strafe = TP_FX(0.5),
                          .up = TP_FX(0.25),
                          .turn = 12345,
                          .tilt = -678 };
    const tp_vec3 from = w.eye;
    const tp_turn pitch = w.pitch;

    tp_world_step(&tp_program_all, &w, &scene, &in);
    assert_true(abs(w.eye.x - from.x - TP_FX(0.5)) <= 2);
    assert_int_equal(w.eye.y - from.y, TP_FX(0.25));
    assert_true(abs(w.eye.z - from.z + TP_FX_ONE) <= 2);
    assert_int_equal(w.heading, 12345);
    assert_int_equal((int32_t)(w.pitch - pitch), -678);
}

static void without_a_boat_there_is_no_deck(void **state)
{
    (void)state;
    tp_scene scene = aboard_scene();
    scene.boat.mesh[0] = '\0';
    const tp_world w = boat_world(&scene);
    const tp_camera camera = tp_world_camera(&w);

    assert_int_equal(w.aboard, 0);
    assert_memory_equal(&camera.eye, &w.eye, sizeof w.eye);
}

static void a_change_of_the_scene_goes_aboard_and_ashore(void **state)
{
    (void)state;
    tp_scene scene = aboard_scene();
    tp_world w = boat_world(&scene);

    scene.camera.follow = TP_FOLLOW_NONE;
    assert_true(tp_world_apply(&tp_program_all, &w, &scene, NULL));
    assert_int_equal(w.aboard, 0);
    scene.camera.follow = TP_FOLLOW_BOAT;
    assert_true(tp_world_apply(&tp_program_all, &w, &scene, NULL));
    assert_int_equal(w.aboard, 1);
}

/* A copy of the world with the same inputs sees the same, to the bit. */
static void a_snapshot_goes_on_with_the_same_bits(void **state)
{
    (void)state;
    const tp_scene scene = aboard_scene();
    tp_world w = boat_world(&scene), copy = w;

    for (int i = 0; i < 120; i++) {
        const tp_input in = { .forward = chance_fx(&chance, -0.1, 0.1),
                              .turn = chance_int(&chance, -9999999, 9999999),
                              .throttle = chance_fx(&chance, -4, 4),
                              .rudder = chance_fx(&chance, -20, 20) };
        if (i == 60)
            copy = w;
        tp_world_step(&tp_program_all, &w, &scene, &in);
        if (i >= 60)
            tp_world_step(&tp_program_all, &copy, &scene, &in);
    }
    const tp_camera a = tp_world_camera(&w), b = tp_world_camera(&copy);
    assert_memory_equal(&a, &b, sizeof a);
}

/* A boat at the world's corner, and a camera at the greatest distance from the boat. */
static void the_eye_stays_within_the_world(void **state)
{
    (void)state;
    for (int n = 0; n < 100; n++) {
        tp_scene scene = aboard_scene();
        scene.boat.x = scene.boat.z = 8000 * (n & 1 ? 1 : -1) * TP_FX_ONE;
        scene.camera.x = scene.camera.z = 8000 * TP_FX_ONE;
        scene.camera.y = 2000 * TP_FX_ONE;
        const tp_world w = boat_world(&scene);
        const tp_camera camera = tp_world_camera(&w);
        assert_in_range(camera.eye.x + 8000 * TP_FX_ONE, 0, 16000 * TP_FX_ONE);
        assert_in_range(camera.eye.z + 8000 * TP_FX_ONE, 0, 16000 * TP_FX_ONE);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_deck_stands_still_in_the_picture),
        cmocka_unit_test(the_eye_is_where_the_deck_carries_it),
        cmocka_unit_test(a_boat_at_rest_carries_the_camera_as_the_world_does),
        cmocka_unit_test(a_picture_between_ticks_is_of_both_boat_and_camera),
        cmocka_unit_test(input_moves_the_camera_about_the_deck),
        cmocka_unit_test(without_a_boat_there_is_no_deck),
        cmocka_unit_test(a_change_of_the_scene_goes_aboard_and_ashore),
        cmocka_unit_test(a_snapshot_goes_on_with_the_same_bits),
        cmocka_unit_test(the_eye_stays_within_the_world),
    };
    return cmocka_run_group_tests_name("world/aboard", tests, NULL, NULL);
}
