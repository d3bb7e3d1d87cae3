/* SPDX-License-Identifier: MIT */
/* quality.exposure=fast: coarse exposures, no light beyond white, the same bits in every
 * tiling and after any other frames, and the same world. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/exposure/exposure.h"
#include "tests/lib/measure.h"
#include "tests/lib/tilings.h"

enum { WIDTH = 96, HEIGHT = 72, PIXELS = WIDTH * HEIGHT };

static uint64_t chance;
static const tp_assets none;
static const tp_config config = {
    .width = WIDTH, .height = HEIGHT, .tile_height = 16, .format = TP_FORMAT_XRGB8888
};

/* A bright sun over a sea that mirrors. */
static tp_scene bright(int32_t rung)
{
    tp_scene s = scene_plain();

    s.boat.mesh[0] = '\0';
    s.sky.kind = TP_SKY_DAY;
    s.sky.sun = 4 * TP_FX_ONE;
    s.light.heading = 0;
    s.light.elevation = 4 * TP_FX_ONE;
    s.light.colour = 0xff8020;
    s.camera.heading = s.camera.pitch = 0;
    s.hdr.share = TP_FX(0.6);
    s.hdr.exposure = TP_EXPOSURE_AUTO;
    s.quality.exposure = rung;
    return s;
}

static void coarse_exposures_change_a_tone_by_two_levels(void **state)
{
    tp_entry8 near[256], exact[256];
    int most = 0;

    (void)state;
    assert_int_equal(tp_exposure_coarse(TP_FX_ONE), TP_FX_ONE);
    assert_int_equal(tp_exposure_coarse(TP_FX_ONE / 8), TP_FX_ONE / 8);
    assert_int_equal(tp_exposure_coarse(8 * TP_FX_ONE), 8 * TP_FX_ONE);
    for (int n = 0; n < 3000; n++) {
        const tp_fx e = chance_scale(&chance, 0.125, 8), c = tp_exposure_coarse(e);
        assert_true(128 * (int64_t)tp_abs(c - e) <= e);
        assert_int_equal(tp_exposure_coarse(c), c);
        tp_exposure_make_tone_curve(exact, e);
        tp_exposure_make_tone_curve(near, c);
        for (int i = 0; i < 256; i++) {
            const int off = abs((int)near[i] - (int)exact[i]);
            most = off > most ? off : most;
        }
    }
    printf("    largest difference of a tone: %d levels\n", most);
    assert_in_range(most, 1, 2);
}

/* Draws a new frame, or one that has drawn other exposures before. */
static void draw(const tp_scene *s, tp_world *world, const tp_fx *before, uint32_t *pixel)
{
    test_frame f = frame_of(s, &none, &config);
    const tp_fx exposure = world->exposure;

    for (; before && *before; before++) {
        world->exposure = world->last_exposure = *before;
        frame_draw_picture(&f, world, pixel);
    }
    world->exposure = world->last_exposure = exposure;
    frame_draw_picture(&f, world, pixel);
    frame_free(&f);
}

static void a_picture_depends_on_no_other(void **state)
{
    static uint32_t fresh[PIXELS], later[PIXELS];
    tp_scene s = bright(TP_RUNG_FAST);
    tp_world *world = scene_world(&s, &none);

    (void)state;
    for (int n = 0; n < 10; n++) {
        const tp_fx e = chance_scale(&chance, 0.2, 6);
        const tp_fx before[] = { e + e / 100, 3 * e / 2, e - e / 200, 0 };
        world->exposure = e;
        draw(&s, world, NULL, fresh);
        draw(&s, world, before, later);
        assert_memory_equal(fresh, later, sizeof fresh);
    }
    free(world);
}

/* The picture is that of the exact rung without hdr.share, at the coarse exposure. */
static void light_beyond_white_is_left_out(void **state)
{
    static uint32_t fast[PIXELS], exact[PIXELS], without[PIXELS];
    tp_scene s = bright(TP_RUNG_FAST);
    tp_world *world = scene_world(&s, &none);

    (void)state;
    world->exposure = world->last_exposure = TP_FX(0.7);
    draw(&s, world, NULL, fast);
    world->exposure = world->last_exposure = tp_exposure_coarse(TP_FX(0.7));
    s.quality.exposure = TP_RUNG_EXACT;
    draw(&s, world, NULL, exact);
    assert_memory_not_equal(fast, exact, sizeof fast);
    s.hdr.share = 0;
    draw(&s, world, NULL, without);
    assert_memory_equal(fast, without, sizeof fast);
    free(world);
}

static void every_tiling_has_the_same_bits(void **state)
{
    uint32_t exposed = 0;

    (void)state;
    for (int n = 0; n < 20; n++) {
        tp_scene s = bright(TP_RUNG_FAST);
        s.quality.shading = n % 2 ? TP_SHADING_QUICK : TP_SHADING_EXACT;
        s.quality.sky = n % 4 < 2 ? TP_RUNG_FAST : TP_RUNG_EXACT;
        tp_world *world = scene_world(&s, &none);
        test_twice t = { 0 };
        world->exposure = world->last_exposure = chance_scale(&chance, 0.2, 6);
        twice_begin(&t, &s, &none, &chance);
        twice_draw(&t, world);
        exposed += t.reached.exposed;
        twice_end(&t);
        free(world);
    }
    assert_int_equal(exposed, 20);
}

/* The tables of the meter hold the light beyond white with either rung. */
static void worlds_do_not_differ(void **state)
{
    tp_scene s = bright(TP_RUNG_EXACT);
    tp_world *world[3];

    (void)state;
    for (int k = 0; k < 3; k++) {
        s.quality.exposure = k == 1 ? TP_RUNG_FAST : TP_RUNG_EXACT;
        s.hdr.share = k == 2 ? 0 : TP_FX(0.6);
        world[k] = scene_world(&s, &none);
        for (int i = 0; i < 60; i++)
            tp_world_step(&tp_program_all, world[k], &s, NULL);
    }
    const size_t bytes = tp_world_bytes(&tp_program_all, &s, &none);
    assert_memory_equal(world[0], world[1], bytes);
    assert_memory_not_equal(world[0], world[2], bytes);
    for (int k = 0; k < 3; k++)
        free(world[k]);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coarse_exposures_change_a_tone_by_two_levels),
        cmocka_unit_test(a_picture_depends_on_no_other),
        cmocka_unit_test(light_beyond_white_is_left_out),
        cmocka_unit_test(every_tiling_has_the_same_bits),
        cmocka_unit_test(worlds_do_not_differ),
    };
    return cmocka_run_group_tests_name("features/exposure fast", tests, NULL, NULL);
}
