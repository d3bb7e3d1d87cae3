/* SPDX-License-Identifier: MIT */
/* Camera modes and the boat: the view from the deck, and the orbit around a sailing
 * boat. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/camera_modes.h"

static void without_a_boat_there_is_no_way_aboard(void **state)
{
    (void)state;
    tp_scene s = sea();
    s.boat.mesh[0] = '\0';
    const tp_world w = boat_world(&s);
    camera_mode l = { .mode = CAMERA_ORBIT, .away = 7 * TP_FX_ONE, .heading = 5 };
    const camera_mode before = l;

    assert_false(camera_mode_begin(&l, CAMERA_BOAT, &w, &s));
    assert_false(camera_mode_begin(&l, CAMERA_MODES, &w, &s));
    assert_memory_equal(&before, &l, sizeof l);
}

/* The deck position scales with the length: on a boat of 12 m it is 6 m abaft the
 * middle. */
static void the_deck_is_one_jump_away_and_then_free(void **state)
{
    (void)state;
    tp_scene s = sea();
    tp_world w;
    camera_mode l = started(CAMERA_BOAT, &w, &s);
    assert_int_equal(s.camera.follow, TP_FOLLOW_BOAT);
    tp_input in = any_input(), out = in;
    camera_mode_steer(&l, &w, &s, &out);
    tp_world_move_camera(&w, &out);
    assert_int_equal(w.aboard, 1);
    assert_at(w.eye, (tp_vec3){ 0, TP_FX(2.72), TP_FX(6) }, 12);
    assert_int_equal(w.heading, 0);
    assert_true((int32_t)w.pitch < 0);
    assert_int_equal(out.drops, in.drops);          /* these inputs are not the camera's */
    assert_true(distance(tp_world_camera(&w).eye, w.boat.place) < 8);
    out = in;
    camera_mode_steer(&l, &w, &s, &out);
    assert_memory_equal(&in, &out, sizeof in);
}

static void from_the_deck_it_goes_round_the_boat(void **state)
{
    (void)state;
    tp_scene s = sea();
    s.boat.heading = 130 * TP_FX_ONE;
    tp_world w;
    camera_mode l = started(CAMERA_BOAT, &w, &s);
    go(&l, &w, &s, (tp_input){ 0 });
    begin(&l, CAMERA_ORBIT, &w, &s);
    assert_int_equal(w.aboard, 0);
    go(&l, &w, &s, (tp_input){ 0 });
    assert_true(fabs(distance(w.eye, w.boat.place) - 24) < 0.5);
    assert_true(fabs((w.heading - tp_turn_of_degrees(s.boat.heading)) / 11930464.7) < 10);
}

/* The distance after a minute's sail equals the distance at the start. */
static void a_boat_in_the_middle_is_gone_with(void **state)
{
    (void)state;
    for (int mode = CAMERA_ORBIT; mode <= CAMERA_TOP; mode++) {
        tp_scene s = sea();
        s.boat.x = 30 * TP_FX_ONE;
        s.boat.z = -TP_FX_ONE;
        s.camera.heading = 90 * TP_FX_ONE;
        s.camera.pitch = -8 * TP_FX_ONE;
        tp_world w;
        camera_mode l = started((camera_mode_kind)mode, &w, &s);
        go(&l, &w, &s, (tp_input){ 0 });
        const double off = hypot(l.about.x - w.boat.place.x, l.about.z - w.boat.place.z);
        const tp_fx from = w.boat.place.x;
        assert_true(off < 6 * 65536);
        for (int n = 0; n < 3600; n++)
            go(&l, &w, &s, (tp_input){ .throttle = TP_FX(3), .rudder = TP_FX(1) });
        const double now = hypot(l.about.x - w.boat.place.x, l.about.z - w.boat.place.z);
        assert_true(abs(w.boat.place.x - from) > TP_FX(20));
        assert_true(fabs(now - off) < 0.1 * 65536);         /* a tick behind */
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_a_boat_there_is_no_way_aboard),
        cmocka_unit_test(the_deck_is_one_jump_away_and_then_free),
        cmocka_unit_test(from_the_deck_it_goes_round_the_boat),
        cmocka_unit_test(a_boat_in_the_middle_is_gone_with),
    };
    return cmocka_run_group_tests_name("interact/camera_boat", tests, NULL, NULL);
}
