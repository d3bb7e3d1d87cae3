/* SPDX-License-Identifier: MIT */
/* The moving light: by the scene, by input, between ticks. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "world/world.h"
#include "world/light.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

static uint64_t chance;

static tp_world *light_world(const tp_scene *scene)
{
    tp_world *w = scene_world(scene, NULL);
    assert_non_null(w);
    return w;
}

static tp_scene light_scene(void)
{
    tp_scene s = scene_plain();

    s.boat.mesh[0] = '\0';
    s.light.heading = chance_fx(&chance, -360, 360);
    s.light.elevation = chance_fx(&chance, 1, 90);
    return s;
}

static void it_begins_where_the_scene_has_it(void **state)
{
    (void)state;
    for (int n = 0; n < 100; n++) {
        const tp_scene s = light_scene();
        tp_world *w = light_world(&s);
        const tp_dir3 d = tp_light_direction(w->light_heading, w->light_elevation);
        const double h = s.light.heading / 65536.0 * 3.14159265358979 / 180;
        const double e = s.light.elevation / 65536.0 * 3.14159265358979 / 180;
        assert_true(fabs(d.x / 1073741824.0 - cos(e) * sin(h)) < 2e-5);
        assert_true(fabs(d.y / 1073741824.0 - sin(e)) < 2e-5);
        assert_true(fabs(d.z / 1073741824.0 + cos(e) * cos(h)) < 2e-5);
        free(w);
    }
}

static void it_goes_round_by_degrees_a_second(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        tp_scene s = light_scene();
        s.light.turn = chance_fx(&chance, -90, 90);
        tp_world *w = light_world(&s);
        const tp_turn before = w->light_heading;
        for (int t = 0; t < 600; t++)
            tp_world_step(&tp_program_all, w, &s, NULL);
        const tp_turn want = tp_turn_of_degrees(s.light.turn) * 10;
        assert_true(abs((int32_t)(w->light_heading - before - want)) <= 310);
        free(w);
    }
}

/* The light stays above the horizon and does not pass the zenith. */
static void input_turns_it_and_tilts_it_within_1_and_90_degrees(void **state)
{
    (void)state;
    const tp_scene s = light_scene();
    tp_world *w = light_world(&s);

    for (int n = 0; n < 2000; n++) {
        const tp_input in = { .light_turn = random_number(&chance),
                              .light_tilt = random_number(&chance) };
        const tp_turn heading = w->light_heading;
        const int64_t height = (int64_t)w->light_elevation + in.light_tilt;
        tp_world_step(&tp_program_all, w, &s, &in);
        assert_int_equal(w->light_heading, heading + (tp_turn)in.light_turn);
        assert_in_range(w->light_elevation, TP_DEG(1), TP_DEG(90));
        if (height >= TP_DEG(1) && height <= TP_DEG(90))
            assert_int_equal(w->light_elevation, height);
    }
    free(w);
}

static void between_ticks_it_is_between(void **state)
{
    (void)state;
    const tp_scene s = light_scene();
    tp_world *w = light_world(&s);
    const tp_input in = { .light_turn = 1000000, .light_tilt = -2000000 };

    w->light_elevation = TP_DEG(40);
    tp_world_step(&tp_program_all, w, &s, &in);
    w->lag = TP_FX_ONE / 4;
    tp_drawn at = tp_world_interpolate(w);
    assert_int_equal(at.light_heading, w->light_heading - 250000);
    assert_int_equal(at.light_elevation, w->light_elevation + 500000);
    w->lag = TP_FX_ONE;
    at = tp_world_interpolate(w);
    assert_int_equal(at.light_elevation, TP_DEG(40));
    free(w);
}

/* A refresh for another parameter leaves the light in place; a new direction in the scene
 * applies. */
static void a_refresh_takes_what_has_changed(void **state)
{
    (void)state;
    tp_scene s = light_scene();
    tp_world *w = light_world(&s);
    const tp_input in = { .light_turn = 123456789 };

    tp_world_step(&tp_program_all, w, &s, &in);
    const tp_turn moved = w->light_heading;
    s.wave[0].amplitude += 999;
    assert_true(tp_world_apply(&tp_program_all, w, &s, NULL));
    assert_int_equal(w->light_heading, moved);
    s.light.heading = 17 * TP_FX_ONE;
    s.hdr.exposure_factor = 3 * TP_FX_ONE;
    assert_true(tp_world_apply(&tp_program_all, w, &s, NULL));
    assert_int_equal(w->light_heading, tp_turn_of_degrees(17 * TP_FX_ONE));
    assert_int_equal(w->exposure, 3 * TP_FX_ONE);
    free(w);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_begins_where_the_scene_has_it),
        cmocka_unit_test(it_goes_round_by_degrees_a_second),
        cmocka_unit_test(input_turns_it_and_tilts_it_within_1_and_90_degrees),
        cmocka_unit_test(between_ticks_it_is_between),
        cmocka_unit_test(a_refresh_takes_what_has_changed),
    };
    return cmocka_run_group_tests_name("world/light", tests, NULL, NULL);
}
