/* SPDX-License-Identifier: MIT */
/* Camera modes: the modified inputs lead the camera exactly to the mode's position from any
 * position, and replay without the mode. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/camera_modes.h"

/* Distance of the target from the line through the middle of the picture, m. */
static double off_centre(const camera_mode *l, const tp_world *w)
{
    const tp_camera c = tp_world_camera(w);
    const tp_vec3 local = tp_rotate(&c.turn, tp_vec3_sub(l->about, c.eye));
    return hypot(local.x, local.y) / 65536;
}

/* -- free mode ---------------------------------------------------------------------- */

static void free_input_stays_as_it_is(void **state)
{
    (void)state;
    const tp_scene s = sea();
    const tp_world w = boat_world(&s);
    camera_mode l = { .mode = CAMERA_FREE };
    const tp_input in = any_input();
    tp_input out = in;

    assert_true(camera_mode_begin(&l, CAMERA_FREE, &w, &s));
    camera_mode_steer(&l, &w, &s, &out);
    assert_memory_equal(&in, &out, sizeof in);
    assert_int_equal(camera_mode_follow(&l, &s), TP_FOLLOW_NONE);
    tp_scene aboard = s;
    aboard.camera.follow = TP_FOLLOW_BOAT;
    assert_int_equal(camera_mode_follow(&l, &aboard), TP_FOLLOW_BOAT);
}

static void leaving_a_way_leads_back_to_where_the_camera_was_free(void **state)
{
    (void)state;
    tp_scene s = sea();
    tp_world w = boat_world(&s);
    camera_mode l = { .mode = CAMERA_FREE };

    for (int n = 0; n < 20; n++)
        go(&l, &w, &s, any_input());
    const tp_vec3 eye = w.eye;
    const tp_turn heading = w.heading, pitch = w.pitch;
    for (int mode = CAMERA_ORBIT; mode < CAMERA_MODES; mode++) {
        begin(&l, (camera_mode_kind)mode, &w, &s);
        for (int n = 0; n < 30; n++)
            go(&l, &w, &s, any_input());
    }
    assert_true(distance(w.eye, eye) > 1);
    begin(&l, CAMERA_FREE, &w, &s);
    assert_true(l.jump);
    go(&l, &w, &s, any_input());
    assert_at(w.eye, eye, NEAR);
    assert_int_equal(w.heading, heading);
    assert_int_equal(w.pitch, pitch);
    assert_false(l.jump);
    const tp_input in = any_input();
    tp_input out = in;
    camera_mode_steer(&l, &w, &s, &out);
    assert_memory_equal(&in, &out, sizeof in);
}

/* -- orbit mode --------------------------------------------------------------------- */

static void going_round_begins_where_the_camera_is(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        tp_scene s = sea();
        s.camera.heading = chance_fx(&chance, 0, 200);
        s.camera.pitch = chance_fx(&chance, -80, 40);
        s.camera.y = chance_fx(&chance, 2, 50);
        tp_world w = boat_world(&s);
        const tp_world before = w;
        camera_mode l = { .mode = CAMERA_FREE };
        begin(&l, CAMERA_ORBIT, &w, &s);
        go(&l, &w, &s, (tp_input){ 0 });
        assert_at(w.eye, before.eye, NEAR);
        assert_int_equal(w.heading, before.heading);
        assert_int_equal(w.pitch, before.pitch);
        assert_true(l.away <= TP_FX(25) + 4 * s.camera.y);
    }
}

static void what_is_looked_at_is_the_water_in_the_middle(void **state)
{
    (void)state;
    const tp_scene s = sea();
    tp_world w = boat_world(&s);
    camera_mode l = { .mode = CAMERA_FREE };

    assert_true(camera_mode_begin(&l, CAMERA_ORBIT, &w, &s));
    const tp_fx high = tp_world_sample(&tp_program_all, &w, l.about.x, l.about.z).height;
    assert_true(abs(high - l.about.y) < 66);
    assert_true(fabs(distance(w.eye, l.about) - l.away / 65536.0) < 0.01);
}

/* For a thousand ticks of any input the target stays in the middle, within the mode's
 * precision. */
static void what_is_looked_at_stays_in_the_middle(void **state)
{
    (void)state;
    for (int mode = CAMERA_ORBIT; mode <= CAMERA_TOP; mode++) {
        tp_scene s = sea();
        tp_world w;
        camera_mode l = started((camera_mode_kind)mode, &w, &s);
        for (int n = 0; n < 1000; n++) {
            go(&l, &w, &s, any_input());
            assert_true(off_centre(&l, &w) < 0.001);
            assert_true(fabs(distance(w.eye, l.about) - l.away / 65536.0) < 0.001);
            assert_int_equal(w.heading, l.heading);
            assert_int_equal(w.pitch, l.pitch);
        }
    }
}

static void each_way_round_does_what_it_stands_for(void **state)
{
    (void)state;
    tp_scene s = sea();
    tp_world w;
    camera_mode l = started(CAMERA_ORBIT, &w, &s);
    go(&l, &w, &s, (tp_input){ 0 });
    const camera_mode from = l;
    go(&l, &w, &s, (tp_input){ .turn = 5000 });
    assert_int_equal(l.heading, from.heading + 5000);
    go(&l, &w, &s, (tp_input){ .turn = -5000, .tilt = 7000 });
    assert_int_equal(l.pitch, from.pitch + 7000);
    go(&l, &w, &s, (tp_input){ .tilt = -7000, .forward = TP_FX(0.2) });
    assert_int_equal(l.away, from.away - TP_FX(0.2));
    go(&l, &w, &s, (tp_input){ .up = TP_FX(0.2) });
    assert_int_equal(l.about.y, from.about.y + TP_FX(0.2));
    const tp_vec3 eye = w.eye;
    go(&l, &w, &s, (tp_input){ .strafe = TP_FX(0.2) });
    const double level = cos((int32_t)l.pitch * 6.283185307179586 / 4294967296.0);
    assert_true(fabs(distance(w.eye, eye) - 0.2 * level) < 0.002);
    assert_true((int32_t)(l.heading - from.heading) < 0);   /* to the right of the target */
}

static void from_far_away_steps_are_longer(void **state)
{
    (void)state;
    tp_scene s = sea();
    s.camera.y = TP_FX(160);
    s.camera.pitch = TP_FX(-89);
    tp_world w;
    camera_mode l = started(CAMERA_ORBIT, &w, &s);
    go(&l, &w, &s, (tp_input){ 0 });
    const tp_fx away = l.away;
    assert_in_range(away, TP_FX(155), TP_FX(165));
    go(&l, &w, &s, (tp_input){ .forward = TP_FX(0.2) });
    assert_in_range(away - l.away, TP_FX(1.9), TP_FX(2.1));
}

/* -- from above --------------------------------------------------------------------- */

static void from_above_it_glides(void **state)
{
    (void)state;
    tp_scene s = sea();
    tp_world w;
    camera_mode l = started(CAMERA_TOP, &w, &s);
    go(&l, &w, &s, any_input());        /* the first input jumps, for any values */
    assert_int_equal((int32_t)w.pitch, -(int32_t)TP_DEG(89));
    assert_int_equal(w.heading, tp_turn_of_degrees(s.camera.heading));
    l.away = TP_FX(10);
    const tp_vec3 about = l.about;
    go(&l, &w, &s,
       (tp_input){ .forward = TP_FX(0.3), .strafe = TP_FX(0.1), .tilt = 9999 });
    const double h = 70 * 3.14159265358979 / 180;
    const double x = 0.3 * sin(h) + 0.1 * cos(h), z = 0.1 * sin(h) - 0.3 * cos(h);
    assert_true(fabs((l.about.x - about.x) / 65536.0 - x) < 0.0001);
    assert_true(fabs((l.about.z - about.z) / 65536.0 - z) < 0.0001);
    assert_int_equal(l.about.y, 0);
    assert_int_equal((int32_t)w.pitch, -(int32_t)TP_DEG(89));
    const tp_fx high = w.eye.y;
    go(&l, &w, &s, (tp_input){ .up = TP_FX(0.25) });
    assert_in_range(w.eye.y - high, TP_FX(0.249), TP_FX(0.251));
}

/* -- all modes ---------------------------------------------------------------------- */

/* The modified inputs give the same bits in a world without a camera mode. */
static void bent_inputs_replay_to_the_same_bits(void **state)
{
    (void)state;
    tp_scene s = sea();
    tp_world w = boat_world(&s), twin = w;
    camera_mode l = { .mode = CAMERA_FREE };

    for (int n = 0; n < 400; n++) {
        if (n % 40 == 20)
            begin(&l, (camera_mode_kind)(n / 40 % CAMERA_MODES), &w, &s);
        tp_input in = any_input();
        camera_mode_steer(&l, &w, &s, &in);
        assert_true(tp_world_apply(&tp_program_all, &twin, &s, NULL));
        assert_true(tp_world_apply(&tp_program_all, &w, &s, NULL));
        tp_world_step(&tp_program_all, &w, &s, &in);
        tp_world_step(&tp_program_all, &twin, &s, &in);
        assert_memory_equal(&w, &twin, sizeof w);
    }
}

/* From any position to any other: exactly, and within the world. */
static void any_jump_ends_where_it_should(void **state)
{
    (void)state;
    const tp_scene s = sea();
    for (int n = 0; n < 2000; n++) {
        tp_world w = boat_world(&s);
        w.eye = (tp_vec3){ chance_fx(&chance, -8000, 8000), chance_fx(&chance, -99, 2000),
                           chance_fx(&chance, -8000, 8000) };
        w.heading = (tp_turn)random_next(&chance);
        camera_mode l = { .mode = CAMERA_BOAT, .jump = true,
                   .heading = (tp_turn)random_next(&chance),
                   .pitch = tp_turn_of_degrees(chance_fx(&chance, -89, 89)) };
        l.about = (tp_vec3){ chance_fx(&chance, -8000, 8000),
                             chance_fx(&chance, -99, 2000),
                             chance_fx(&chance, -8000, 8000) };
        tp_input in = any_input();
        camera_mode_steer(&l, &w, &s, &in);
        tp_world_move_camera(&w, &in);
        assert_at(w.eye, l.about, NEAR);
        assert_int_equal(w.heading, l.heading);
        assert_int_equal(w.pitch, l.pitch);
    }
}

static tp_input huge_input(int32_t most)
{
    return (tp_input){
        .forward = chance_int(&chance, -most, most),
        .strafe = chance_int(&chance, -most, most),
        .up = chance_int(&chance, -most, most),
        .turn = chance_int(&chance, -most, most),
        .tilt = chance_int(&chance, -most, most),
    };
}

/* Inputs of any size: nothing overflows, and the camera does not pass through the
 * target. */
static void no_input_is_too_large(void **state)
{
    (void)state;
    for (int mode = CAMERA_ORBIT; mode <= CAMERA_TOP; mode++) {
        tp_scene s = sea();
        s.camera.near = 3 * TP_FX_ONE;
        tp_world w;
        camera_mode l = started((camera_mode_kind)mode, &w, &s);
        for (int n = 0; n < 3000; n++) {
            go(&l, &w, &s, huge_input(n % 3 ? INT32_MAX : 1 << 22));
            assert_in_range(l.away, n ? TP_FX(6) : 1, TP_FX(4000));
        }
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_input_stays_as_it_is),
        cmocka_unit_test(leaving_a_way_leads_back_to_where_the_camera_was_free),
        cmocka_unit_test(going_round_begins_where_the_camera_is),
        cmocka_unit_test(what_is_looked_at_is_the_water_in_the_middle),
        cmocka_unit_test(what_is_looked_at_stays_in_the_middle),
        cmocka_unit_test(each_way_round_does_what_it_stands_for),
        cmocka_unit_test(from_far_away_steps_are_longer),
        cmocka_unit_test(from_above_it_glides),
        cmocka_unit_test(bent_inputs_replay_to_the_same_bits),
        cmocka_unit_test(any_jump_ends_where_it_should),
        cmocka_unit_test(no_input_is_too_large),
    };
    return cmocka_run_group_tests_name("interact/camera_mode", tests, NULL, NULL);
}
