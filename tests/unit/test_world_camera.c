/* SPDX-License-Identifier: MIT */
/* A camera placed by the application: its position, the duration, and the inputs that move
 * the camera. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/boats.h"

static uint64_t chance;

typedef struct {
    tp_vec3 eye;
    tp_turn heading, pitch, roll;
} placed;

static placed place_any(tp_world *w)
{
    const placed p = {
        { chance_fx(&chance, -7999, 7999), chance_fx(&chance, -7999, 7999),
          chance_fx(&chance, -7999, 7999) },
        (tp_turn)random_next(&chance),
        (tp_turn)random_next(&chance),
        (tp_turn)random_next(&chance),
    };
    tp_world_set_camera(w, p.eye, p.heading, p.pitch, p.roll);
    return p;
}

static void assert_seen_from(const tp_world *w, const placed *p)
{
    const tp_camera camera = tp_world_camera(w);
    const tp_rotation turn = tp_rotation_from_angles(p->heading, p->pitch, p->roll);

    assert_memory_equal(&camera.eye, &p->eye, sizeof p->eye);
    assert_memory_equal(&camera.turn, &turn, sizeof turn);
}

static tp_scene following(void)
{
    tp_scene s = scene_plain();

    s.camera.follow = TP_FOLLOW_BOAT;
    s.camera.z = TP_FX(5);
    s.boat.speed = TP_FX(4);
    return s;
}

/* At any fraction of a tick, and also after ticks with empty input. */
static void the_picture_is_seen_from_the_place(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        tp_scene scene = n & 1 ? following() : scene_plain();
        tp_world w = boat_world(&scene);
        w.lag = chance_int(&chance, 0, TP_FX_ONE);
        const placed p = place_any(&w);
        assert_seen_from(&w, &p);
        tp_world_step(&tp_program_all, &w, &scene, n & 2 ? &(tp_input){ 0 } : NULL);
        assert_seen_from(&w, &p);
    }
}

/* Local right is (1, 0, 0): rolled by a quarter turn right points down, upside down to
 * -x. */
static void roll_lowers_the_right_side(void **state)
{
    (void)state;
    const tp_scene scene = scene_plain();
    tp_world w = boat_world(&scene);

    tp_world_set_camera(&w, (tp_vec3){ 0, 0, 0 }, 0, 0, TP_DEG(90));
    assert_true(tp_world_camera(&w).turn.x.y < -TP_Q30(0.9999));
    tp_world_set_camera(&w, (tp_vec3){ 0, 0, 0 }, 0, 0, TP_DEG(180));
    assert_true(tp_world_camera(&w).turn.x.x < -TP_Q30(0.9999));
    assert_true(tp_world_camera(&w).turn.y.y < -TP_Q30(0.9999));
}

static void between_ticks_roll_goes_the_shorter_way(void **state)
{
    (void)state;
    const tp_scene scene = scene_plain();
    tp_world w = boat_world(&scene);

    tp_world_set_camera(&w, (tp_vec3){ 0, 0, 0 }, 0, 0, TP_DEG(350));
    w.roll = TP_DEG(30);
    w.lag = TP_FX_ONE / 2;
    const tp_rotation turn = tp_world_camera(&w).turn,
                      want = tp_rotation_from_angles(0, 0, TP_DEG(10));
    assert_in_range(turn.x.y - want.x.y + 64, 0, 128);
    assert_in_range(turn.x.x - want.x.x + 64, 0, 128);
}

static void a_place_out_of_the_world_is_held_at_its_border(void **state)
{
    (void)state;
    const tp_scene scene = scene_plain();
    tp_world w = boat_world(&scene);

    tp_world_set_camera(&w, (tp_vec3){ TP_FX_MAX, TP_FX_MIN, TP_FX(-8001) }, 0, 0, 0);
    assert_int_equal(w.eye.x, 8000 * TP_FX_ONE);
    assert_int_equal(w.eye.y, -8000 * TP_FX_ONE);
    assert_int_equal(w.eye.z, -8000 * TP_FX_ONE);
}

/* A refresh alone does not go aboard again; a new request by the scene and a reset do. */
static void following_ends_until_it_is_asked_for(void **state)
{
    (void)state;
    for (int way = 0; way < 2; way++) {
        tp_scene scene = following();
        tp_world w = boat_world(&scene);
        const placed p = place_any(&w);

        for (int i = 0; i < 30; i++) {
            tp_world_step(&tp_program_all, &w, &scene, NULL);
            scene.boat.speed += TP_FX_ONE / 8;
            assert_true(tp_world_apply(&tp_program_all, &w, &scene, NULL));
        }
        assert_seen_from(&w, &p);
        assert_int_equal(w.aboard, TP_ABOARD_LEFT);
        if (way == 0) {
            scene.camera.follow = TP_FOLLOW_NONE;
            assert_true(tp_world_apply(&tp_program_all, &w, &scene, NULL));
            assert_seen_from(&w, &p);
            scene.camera.follow = TP_FOLLOW_BOAT;
            assert_true(tp_world_apply(&tp_program_all, &w, &scene, NULL));
        } else {
            tp_world_reset_camera(&w, &scene);
            assert_int_equal(w.eye.z, scene.camera.z);
            assert_int_equal(w.roll, 0);
        }
        assert_int_equal(w.aboard, TP_ABOARD_DECK);
    }
}

/* The position equals the scene's first placement, to the bit. */
static void a_reset_is_the_first_place(void **state)
{
    (void)state;
    const tp_scene scene = following();
    tp_world w = boat_world(&scene);
    const tp_camera first = tp_world_camera(&w);

    place_any(&w);
    tp_world_reset_camera(&w, &scene);
    const tp_camera again = tp_world_camera(&w);
    assert_memory_equal(&again, &first, sizeof first);
}

/* Input continues from the placed camera; only a tilt is limited short of the vertical. */
static void input_moves_a_placed_camera(void **state)
{
    (void)state;
    const tp_scene scene = scene_plain();
    tp_world w = boat_world(&scene);

    tp_world_set_camera(&w, (tp_vec3){ 0, TP_FX(3), 0 }, 0, TP_DEG(-120), TP_DEG(20));
    tp_world_step(&tp_program_all, &w, &scene, &(tp_input){ .forward = TP_FX_ONE });
    assert_int_equal(w.eye.z, -TP_FX_ONE);
    assert_int_equal(w.pitch, TP_DEG(-120));
    assert_int_equal(w.roll, TP_DEG(20));
    tp_world_step(&tp_program_all, &w, &scene, &(tp_input){ .tilt = 1 });
    assert_int_equal(w.pitch, TP_DEG(-89));
}

/* A world from outside may have left the deck, but not boarded a boat that does not
 * exist. */
static void a_stored_world_may_have_left_the_deck(void **state)
{
    (void)state;
    const tp_scene scene = following(), still = scene_plain();
    const tp_world fresh = boat_world(&scene), none = boat_world(&still);
    tp_world w = fresh;

    place_any(&w);
    assert_int_equal(tp_world_check(&tp_program_all, &w, sizeof w, &fresh, NULL), TP_OK);
    w = none;
    w.aboard = TP_ABOARD_LEFT;
    assert_int_equal(tp_world_check(&tp_program_all, &w, sizeof w, &none, NULL),
                     TP_E_WORLD);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_picture_is_seen_from_the_place),
        cmocka_unit_test(roll_lowers_the_right_side),
        cmocka_unit_test(between_ticks_roll_goes_the_shorter_way),
        cmocka_unit_test(a_place_out_of_the_world_is_held_at_its_border),
        cmocka_unit_test(following_ends_until_it_is_asked_for),
        cmocka_unit_test(a_reset_is_the_first_place),
        cmocka_unit_test(input_moves_a_placed_camera),
        cmocka_unit_test(a_stored_world_may_have_left_the_deck),
    };
    return cmocka_run_group_tests_name("world/camera", tests, NULL, NULL);
}
