/* SPDX-License-Identifier: MIT */
/* Auto exposure: the metered mean, and the final value of the exposure. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/sky_light.h"
#include "tools/reference/shading.h"
#include "features/exposure/exposure.h"
#include "world/world.h"
#include "tests/lib/measure.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

static uint64_t chance;

static tp_scene auto_scene(void)
{
    tp_scene s = scene_plain();

    s.boat.mesh[0] = '\0';
    s.hdr.exposure = TP_EXPOSURE_AUTO;
    s.hdr.rate = TP_FX(0.05);
    return s;
}

static tp_fx settled(const tp_scene *scene, int ticks, tp_fx *mean)
{
    tp_world *w = scene_world(scene, NULL);
    for (int t = 0; t < ticks; t++)
        tp_world_step(&tp_program_all, w, scene, NULL);
    const tp_fx exposure = w->exposure;
    *mean = tp_meter_mean(w, scene);
    free(w);
    return exposure;
}

static double grey(ref_colour c)
{
    return (77 * c.c[0] + 150 * c.c[1] + 29 * c.c[2]) / 256 / 255;
}

/* Reference sky towards d, with |d.y|: generated skies include the glow. */
static double ref_sky_at(const tp_scene *s, ref_dir d)
{
    const double rad = 3.14159265358979 / 180 / 65536;
    const double turn = s->light.heading * rad, up = s->light.elevation * rad;
    const ref_scene scene = { .scene = s, .light = { cos(up) * sin(turn), sin(up),
                                                     -cos(up) * cos(turn) } };

    if (s->sky.kind == TP_SKY_GRADIENT)
        return grey(ref_sky((uint32_t)s->sky.horizon, (uint32_t)s->sky.zenith, fabs(d.y)));
    return grey(ref_dome(&scene, (ref_vec){ d.x, fabs(d.y), d.z }, true).colour);
}

/* The meter's rays in double precision.  Adds to *doubt what the mean may change by rays
 * so close to the horizon that the rounding of axes, ray and unit vector, together 8 of
 * 2^14 at most, decides between sky and water: in a level picture a whole row of 32. */
static double ref_mean(const tp_scene *s, double *doubt)
{
    const double rad = 3.14159265358979 / 180 / 65536;
    const double h = s->camera.heading * rad, p = s->camera.pitch * rad;
    const double tangent = tan(s->camera.fov * rad / 2);
    const double lit = s->light.ambient / 65536.0
                     + (1 - s->light.ambient / 65536.0) * sin(s->light.elevation * rad);
    double sum = 0;

    for (int k = 0; k < 32 * 24; k++) {
        const double u = (2 * (k % 32) - 31) / 24.0 * tangent;
        const double v = (23 - 2 * (k / 32)) / 24.0 * tangent;
        const double along = cos(p) - v * sin(p), y = sin(p) + v * cos(p);
        const ref_dir d = ref_unit((ref_dir){ u * cos(h) + along * sin(h), y,
                                              u * sin(h) - along * cos(h) });
        const double sky = ref_sky_at(s, d);
        const double share = ref_fresnel(fabs(d.y)) * s->water.reflection / 65536.0;
        const double water = grey(ref_colour_unpack((uint32_t)s->water.colour)) * lit;
        const double sea = water + (sky - water) * share;
        sum += d.y >= 0 ? sky : sea;
        *doubt += fabs(d.y) < 8 / 16384.0 ? fabs(sky - sea) / (32 * 24) : 0;
    }
    return sum / (32 * 24);
}

static void the_meter_sees_what_the_formulas_say(void **state)
{
    (void)state;
    measure off = { .what = "mean", .unit = "of white" };

    for (int n = 0; n < 200; n++) {
        tp_scene s = auto_scene();
        s.camera.heading = chance_fx(&chance, -180, 180);
        s.camera.pitch = chance_fx(&chance, -89, 89);
        s.camera.fov = chance_fx(&chance, 20, 100);
        s.light.elevation = chance_fx(&chance, 1, 90);
        s.light.ambient = chance_fx(&chance, 0, 1);
        s.water.reflection = chance_fx(&chance, 0, 1);
        s.sky.horizon = (int32_t)(random_next(&chance) & 0xffffff);
        s.sky.zenith = (int32_t)(random_next(&chance) & 0xffffff);
        tp_world *w = scene_world(&s, NULL);
        double doubt = 0;
        const double e = tp_meter_mean(w, &s) / 65536.0 - ref_mean(&s, &doubt);
        const double sure = fmax(0, fabs(e) - doubt);
        measure_add(&off, sure, n, 0, 0);
        assert_true(sure <= 0.015);
        free(w);
    }
    measure_print(&off);
}

/* The light in the middle of the picture, where the glow is as bright as the rest of the
 * sky; its disc is smaller than the angle between rays and is left out.  The light is high
 * and the sky is not dusk: at dusk the glow saturates red, while the meter adds greys,
 * which saturate later. */
static void domes_are_metered_with_their_glow(void **state)
{
    (void)state;
    measure off = { .what = "mean", .unit = "of white" };

    for (int n = 0; n < 200; n++) {
        tp_scene s = auto_scene();
        s.sky.kind = n % 2 ? TP_SKY_DAY : TP_SKY_NIGHT;
        s.sky.sun = 0;
        s.camera.fov = chance_fx(&chance, 20, 60);
        s.camera.heading = s.light.heading = chance_fx(&chance, -180, 180);
        s.camera.pitch = s.light.elevation = chance_fx(&chance, 25, 80);
        s.sky.horizon = s.sky.zenith = 0;
        tp_world *w = scene_world(&s, NULL);
        double doubt = 0;
        const double e = tp_meter_mean(w, &s) / 65536.0 - ref_mean(&s, &doubt);
        const double sure = fmax(0, fabs(e) - doubt);
        measure_add(&off, sure, n, 0, 0);
        assert_true(sure <= 0.01);
        free(w);
    }
    measure_print(&off);
}

/* From the lowest and the highest exposure to 0.5 / mean, and constant from there on. */
static void it_settles_at_a_mean_of_a_half(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        tp_scene s = auto_scene();
        tp_fx mean;
        s.sky.kind = n % 4;
        s.hdr.exposure_factor = n % 2 ? TP_FX_ONE / 8 : 8 * TP_FX_ONE;
        const tp_fx at = settled(&s, 1500, &mean);
        const double target = ref_clamp(0.5 / fmax(mean / 65536.0, 1 / 16.0), 0.125, 8);
        assert_true(fabs(at / 65536.0 - target) < 0.001);
    }
}

static void nights_brighten_and_snow_darkens(void **state)
{
    (void)state;
    tp_scene s = auto_scene();
    tp_fx mean;

    s.sky.kind = TP_SKY_NIGHT;
    s.water.colour = 0x0e2230;
    s.light.heading = 180 * TP_FX_ONE;
    assert_true(settled(&s, 600, &mean) > 3 * TP_FX_ONE);
    s.sky.kind = TP_SKY_GRADIENT;
    s.sky.horizon = s.sky.zenith = s.water.colour = 0xffffff;
    s.light.ambient = TP_FX_ONE;
    assert_true(settled(&s, 600, &mean) < TP_FX(0.55));
}

/* The mean does not depend on the exposure, so the exposure moves towards its target
 * monotonically. */
static void it_never_swings(void **state)
{
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        tp_scene s = auto_scene();
        s.sky.kind = kind;
        s.hdr.share = TP_FX_ONE;
        s.hdr.rate = chance_fx(&chance, 0.01, 1);
        tp_world *w = scene_world(&s, NULL);
        tp_world_step(&tp_program_all, w, &s, NULL);
        const bool rises = w->exposure > w->last_exposure;
        for (int t = 0; t < 800; t++) {
            tp_world_step(&tp_program_all, w, &s, NULL);
            assert_true(rises ? w->exposure >= w->last_exposure
                              : w->exposure <= w->last_exposure);
        }
        free(w);
    }
}

/* A turning sun changes the metered mean, and a copy of the world meters the same. */
static void a_copy_of_the_world_meters_the_same(void **state)
{
    (void)state;
    tp_scene s = auto_scene();
    s.sky.kind = TP_SKY_DUSK;
    s.light.turn = 40 * TP_FX_ONE;
    tp_world *w = scene_world(&s, NULL), *copy = scene_world(&s, NULL);
    const size_t bytes = w->layout.bytes;

    for (int t = 0; t < 30; t++)
        tp_world_step(&tp_program_all, w, &s, NULL);
    const tp_fx then = tp_meter_mean(w, &s);
    memcpy(copy, w, bytes);
    for (int t = 0; t < 200; t++) {
        tp_world_step(&tp_program_all, w, &s, NULL);
        tp_world_step(&tp_program_all, copy, &s, NULL);
    }
    assert_memory_equal(copy, w, bytes);
    assert_int_not_equal(tp_meter_mean(w, &s), then);
    free(w);
    free(copy);
}

/* Six faces of one grey: the meter's probe keeps the textures' mean light without the
 * textures. */
static void cubes_are_metered_by_their_pictures(void **state)
{
    (void)state;
    tp_scene s = auto_scene();
    tp_assets assets = { .boat = NULL };
    tp_texture face;
    uint32_t texel = 0x80404040u, memory[1];
    assert_int_equal(
        tp_texture_init(&face, &texel, 1, 1, memory, tp_texture_bytes(1, 1), NULL),
        TP_OK);

    for (int i = 0; i < TP_FACES; i++)
        assets.sky[i] = &face;
    s.sky.kind = TP_SKY_CUBE;
    s.camera.pitch = 60 * TP_FX_ONE;
    for (int share = 0; share <= 1; share++) {
        s.hdr.share = share * TP_FX(0.25);
        tp_world *w = scene_world(&s, &assets);
        const double want = 64 / 255.0 * (1 + share * 128 / 255.0 * 16 * 0.25);
        assert_true(fabs(tp_meter_mean(w, &s) / 65536.0 - want) < 0.01);
        free(w);
    }
}

static void a_fixed_exposure_takes_no_room_and_stays(void **state)
{
    (void)state;
    tp_scene s = auto_scene(), fixed = s;
    fixed.hdr.exposure = TP_EXPOSURE_FIXED;
    fixed.hdr.exposure_factor = TP_FX(2.5);

    assert_true(tp_world_bytes(&tp_program_all, &s, NULL)
                > tp_world_bytes(&tp_program_all, &fixed, NULL));
    assert_int_equal(tp_world_bytes(&tp_program_all, &fixed, NULL), sizeof(tp_world));
    tp_fx mean;
    assert_int_equal(settled(&fixed, 50, &mean), TP_FX(2.5));
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_meter_sees_what_the_formulas_say),
        cmocka_unit_test(domes_are_metered_with_their_glow),
        cmocka_unit_test(it_settles_at_a_mean_of_a_half),
        cmocka_unit_test(nights_brighten_and_snow_darkens),
        cmocka_unit_test(it_never_swings),
        cmocka_unit_test(a_copy_of_the_world_meters_the_same),
        cmocka_unit_test(cubes_are_metered_by_their_pictures),
        cmocka_unit_test(a_fixed_exposure_takes_no_room_and_stays),
    };
    return cmocka_run_group_tests_name("features/exposure_meter", tests, NULL, NULL);
}
