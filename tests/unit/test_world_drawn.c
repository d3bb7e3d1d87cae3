/* SPDX-License-Identifier: MIT */
/* The world between its last two ticks, and the clock that gives the fraction. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "world/world.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

static uint64_t chance;

/* A moved world; boat and camera turn through the wrap of the heading. */
static tp_world moved(tp_scene *scene, int ticks)
{
    tp_world world;

    *scene = scene_plain();
    scene->camera.heading = chance_fx(&chance, -1, 1);
    scene->boat.heading = chance_fx(&chance, -1, 1);
    scene->boat.speed = 5 * TP_FX_ONE;
    scene->boat.rudder = chance_fx(&chance, -90, 90);
    assert_int_equal(
        tp_world_init(&tp_program_all, &world, sizeof world, scene, NULL, NULL), TP_OK);
    for (int i = 0; i < ticks; i++) {
        const tp_input in = { .forward = chance_fx(&chance, -1, 1),
                              .up = chance_fx(&chance, -1, 1),
                              .turn = chance_int(&chance, -90000000, 90000000),
                              .tilt = chance_int(&chance, -9000000, 9000000) };
        tp_world_step(&tp_program_all, &world, scene, &in);
    }
    return world;
}

static void assert_pose(const tp_pose *a, const tp_pose *b)
{
    assert_memory_equal(a, b, sizeof *a);
}

static void assert_camera(const tp_camera *at, tp_vec3 eye, tp_turn heading, tp_turn pitch)
{
    const tp_rotation turn = tp_rotation_from_angles(heading, pitch, 0);
    assert_memory_equal(&at->eye, &eye, sizeof eye);
    assert_memory_equal(&at->turn, &turn, sizeof turn);
}

static void back_0_is_the_tick(void **state)
{
    (void)state;
    for (int n = 0; n < 50; n++) {
        tp_scene scene;
        tp_world w = moved(&scene, n);
        w.lag = 0;
        const tp_drawn at = tp_world_interpolate(&w);
        assert_camera(&at.camera, w.eye, w.heading, w.pitch);
        assert_pose(&at.boat, &w.boat);
        for (uint32_t i = 0; i < w.deep.count; i++)
            assert_int_equal(at.phases[i], w.phases[i]);
        assert_int_equal(at.time, n * (int64_t)65536);
    }
}

static void back_1_is_the_last_tick(void **state)
{
    (void)state;
    for (int n = 0; n < 50; n++) {
        tp_scene scene;
        const tp_world before = moved(&scene, n);
        tp_world w = before;
        const tp_input in = { .forward = TP_FX_ONE,
                              .turn = chance_int(&chance, -9999999, 9999999),
                              .tilt = 999999 };
        tp_world_step(&tp_program_all, &w, &scene, &in);
        w.lag = TP_FX_ONE;
        const tp_drawn at = tp_world_interpolate(&w);
        assert_camera(&at.camera, before.eye, before.heading, before.pitch);
        assert_pose(&at.boat, &before.boat);
        for (uint32_t i = 0; i < w.deep.count; i++)
            assert_true(abs((int32_t)(at.phases[i] - before.phases[i])) <= 1);
        assert_int_equal(at.time, n * (int64_t)65536);
    }
}

/* Asserts that `now` is between a (back 1) and b (back 0) and moves monotonically. */
static void assert_between(int32_t a, int32_t b, int32_t now, int32_t *last)
{
    assert_true(b >= a ? now >= a && now <= b : now <= a && now >= b);
    assert_true(b >= a ? now >= *last : now <= *last);
    *last = now;
}

static void between_them_all_is_monotone(void **state)
{
    (void)state;
    for (int n = 0; n < 30; n++) {
        tp_scene scene;
        tp_world w = moved(&scene, 5);
        int32_t x = w.last_eye.x, y = w.last_eye.y, place = w.last_boat.place.z;
        const int32_t last = tp_rotation_from_angles(w.last_heading, w.last_pitch, 0).x.z;
        const int32_t now = tp_rotation_from_angles(w.heading, w.pitch, 0).x.z;
        int32_t right = last, roll = 0;
        for (tp_fx lag = TP_FX_ONE; lag >= 0; lag -= 257) {
            w.lag = lag;
            const tp_drawn at = tp_world_interpolate(&w);
            assert_between(w.last_eye.x, w.eye.x, at.camera.eye.x, &x);
            assert_between(w.last_eye.y, w.eye.y, at.camera.eye.y, &y);
            assert_between(w.last_boat.place.z, w.boat.place.z, at.boat.place.z, &place);
            assert_between(last, now, at.camera.turn.x.z, &right);
            assert_between(0, (int32_t)(w.boat.roll - w.last_boat.roll),
                           (int32_t)(at.boat.roll - w.last_boat.roll), &roll);
        }
    }
}

static void a_heading_goes_the_short_way_across_the_wrap(void **state)
{
    (void)state;
    tp_scene scene;
    tp_world w = moved(&scene, 1);

    w.last_heading = 0xff000000u;
    w.heading = 0x01000000u;
    w.last_pitch = w.pitch;
    w.last_boat.heading = 0x00800000u;
    w.boat.heading = 0xff800000u;
    w.lag = TP_FX_ONE / 2;
    tp_drawn at = tp_world_interpolate(&w);
    assert_camera(&at.camera, at.camera.eye, 0, w.pitch);
    assert_int_equal(at.boat.heading, 0);
    w.lag = TP_FX_ONE / 4;
    at = tp_world_interpolate(&w);
    assert_camera(&at.camera, at.camera.eye, 0x00800000u, w.pitch);
    assert_int_equal(at.boat.heading, 0xffc00000u);
}

static void far_places_are_interpolated_too(void **state)
{
    (void)state;
    const tp_fx far = 8000 * TP_FX_ONE;

    assert_int_equal(tp_interpolate(-far, far, TP_FX_ONE), -far);
    assert_int_equal(tp_interpolate(-far, far, TP_FX_ONE / 2), 0);
    assert_int_equal(tp_interpolate(far, -far, TP_FX_ONE / 4), -far / 2);
}

/* -- the clock --------------------------------------------------------------------- */

/* Shows one picture: steps the ticks that the clock requests.  Returns the shown time in
 * ticks x 65536. */
static int64_t show(tp_world *w, const tp_scene *scene)
{
    for (uint32_t ticks = tp_world_advance_clock(w); ticks > 0; ticks--)
        tp_world_step(&tp_program_all, w, scene, NULL);
    assert_in_range(w->lag, 0, TP_FX_ONE - 1);
    return tp_world_interpolate(w).time;
}

static void at_every_scale_pictures_are_evenly_spaced(void **state)
{
    (void)state;
    static const double scales[] = { 0.125, 0.25, 0.5, 1, 2, 4, 0.3, 0.77, 3.1 };

    for (size_t n = 0; n < sizeof scales / sizeof *scales; n++) {
        tp_scene scene = scene_plain();
        tp_world w;
        scene.boat.mesh[0] = '\0';
        scene.clock.scale = (tp_fx)lround(scales[n] * 65536);
        assert_int_equal(tp_world_init(&tp_program_all, &w, sizeof w, &scene, NULL, NULL),
                         TP_OK);
        int64_t last = tp_world_interpolate(&w).time;
        for (int i = 1; i <= 400; i++) {
            const int64_t now = show(&w, &scene);
            assert_true(llabs(now - last - scene.clock.scale) <= 1);
            assert_int_equal(now, i * (int64_t)scene.clock.scale);
            last = now;
        }
    }
}

static void a_wave_s_phase_advances_evenly_in_slow_motion(void **state)
{
    (void)state;
    tp_scene scene = scene_plain();
    tp_world w;

    scene.clock.scale = TP_FX_ONE / 8;
    assert_int_equal(tp_world_init(&tp_program_all, &w, sizeof w, &scene, NULL, NULL),
                     TP_OK);
    tp_turn last = tp_world_interpolate(&w).phases[0];
    const double step = (double)w.deep.swell[0].turns_tick / 4294967296.0 / 8;
    for (int i = 0; i < 200; i++) {
        show(&w, &scene);
        const tp_turn now = tp_world_interpolate(&w).phases[0];
        assert_true(fabs((double)(uint32_t)(last - now) - step) <= 2);
        last = now;
    }
}

/* Neither input nor a change of the scene makes the time jump or run backwards. */
static void no_time_is_skipped_when_the_scale_changes(void **state)
{
    (void)state;
    tp_scene scene = scene_plain();
    tp_world w;
    double scale = 1;

    scene.boat.mesh[0] = '\0';
    assert_int_equal(tp_world_init(&tp_program_all, &w, sizeof w, &scene, NULL, NULL),
                     TP_OK);
    int64_t last = tp_world_interpolate(&w).time;
    for (int i = 0; i < 3000; i++) {
        if (i % 100 == 50) {
            const tp_input in = { .slowdown = chance_int(&chance, -5, 5) };
            tp_clock_shift_target(&w.clock, in.slowdown);
        }
        if (i % 100 == 0) {
            scene.clock.scale = chance_fx(&chance, 0.125, 4);
            assert_true(tp_world_apply(&tp_program_all, &w, &scene, NULL));
        }
        const int64_t now = show(&w, &scene);
        const double step = (double)(now - last) / 65536;
        assert_true(step > 0.12 && step < 4.01);
        assert_true(fabs(step - scale) < 4 / 24.0 + 0.01);      /* 1/24 of the distance */
        scale = step;
        last = now;
    }
}

static void the_ticks_stepped_are_the_clock_s(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        tp_scene scene = scene_plain();
        tp_world w;
        scene.boat.mesh[0] = '\0';
        scene.clock.scale = chance_fx(&chance, 0.125, 4);
        assert_int_equal(tp_world_init(&tp_program_all, &w, sizeof w, &scene, NULL, NULL),
                         TP_OK);
        for (int i = 0; i < 200; i++) {
            if (random_below(&chance, 20) == 0)
                tp_clock_set_target(&w.clock, chance_fx(&chance, 0, 5));
            const int64_t time = show(&w, &scene);
            const tp_fx part = tp_clock_fraction(&w.clock);
            assert_int_equal(w.tick, tp_clock_ticks(&w.clock) + (part > 0));
            assert_int_equal(time, (int64_t)tp_clock_ticks(&w.clock) * 65536 + part);
        }
    }
}

/* A camera move while the water stands still has no tick to interpolate. */
static void a_look_is_seen_at_once(void **state)
{
    (void)state;
    tp_scene scene;
    tp_world w = moved(&scene, 3);
    const tp_input in = { .forward = TP_FX_ONE, .turn = 12345678, .tilt = -999 };

    w.lag = TP_FX_ONE / 3;
    tp_world_move_camera(&w, &in);
    const tp_drawn at = tp_world_interpolate(&w);
    assert_camera(&at.camera, w.eye, w.heading, w.pitch);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(back_0_is_the_tick),
        cmocka_unit_test(back_1_is_the_last_tick),
        cmocka_unit_test(between_them_all_is_monotone),
        cmocka_unit_test(a_heading_goes_the_short_way_across_the_wrap),
        cmocka_unit_test(far_places_are_interpolated_too),
        cmocka_unit_test(at_every_scale_pictures_are_evenly_spaced),
        cmocka_unit_test(a_wave_s_phase_advances_evenly_in_slow_motion),
        cmocka_unit_test(no_time_is_skipped_when_the_scale_changes),
        cmocka_unit_test(the_ticks_stepped_are_the_clock_s),
        cmocka_unit_test(a_look_is_seen_at_once),
    };
    return cmocka_run_group_tests_name("world/drawn", tests, NULL, NULL);
}
