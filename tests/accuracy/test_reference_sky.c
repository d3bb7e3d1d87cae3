/* SPDX-License-Identifier: MIT */
/* Checks the reference's generated skies against closed forms: seen directly and mirrored,
 * with highlights brighter than white. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/reference_scenes.h"

static uint64_t seed;

/* Brightness of the two halos around the light, relative to the light's colour. The halos
 * fall with the chord 2 sin(angle / 2) and end opposite the light; peaks in 1/256, widths
 * as 1 over the chord squared. */
static double halo_of(const tp_scene *s, double cosine)
{
    static const double peak[3][2] = { { 96, 72 }, { 88, 96 }, { 80, 52 } };
    static const double narrow[3][2] = { { 256, 16 }, { 256, 8 }, { 1024, 32 } };
    const int kind = s->sky.kind - TP_SKY_DAY;
    double sum = 0;

    for (int i = 0; i < 2; i++)
        sum += peak[kind][i] / 256 * (1 / (1 + narrow[kind][i] * 2 * (1 - cosine))
                                      - 1 / (1 + narrow[kind][i] * 4));
    return sum;
}

/* Share of the light's disc: 1 up to 1.095 degrees, 0 from 1.266 degrees on. */
static double disc_of(double cosine)
{
    const double square = 2 * (1 - cosine) * 0x1p28;
    return fmin(1, fmax(0, (131072 - square) / 33072));
}

/* Day sky before the light is clamped, that is, with light brighter than white. */
static double day_of(const tp_scene *s, sight_angles to, double cosine, bool disc, int k)
{
    const double low = pow(1 - fmax(0, sin(to.elevation)), 4) * 5 / 8;
    const double base = gradient_of(s, to.elevation, k);
    const double light = channel(s->light.colour, k);
    const double side = pow((1 + cosine) / 2, 2);      /* cos^4 of half the angle */
    const double more = disc ? fmin(1, s->sky.sun / 65536.0) * disc_of(cosine) : 0;

    return between(base, between(base, light, low), side)
         + light * (halo_of(s, disc ? cosine : fmin(cosine, 1 - 131072 / 0x1p29)) + more);
}

/* Random direction near the light: half of the directions see the disc. */
static sight_angles near_light(const view_of_ref *v)
{
    sight_angles s = sight_light(v);

    s.azimuth += chance_double(&seed, -0.05, 0.05);
    s.elevation += chance_double(&seed, -0.02, 0.02);
    return s;
}

static void a_day_has_its_gradient_halos_and_disc(void **state)
{
    measure off = { .what = "day", .unit = "of 255" };
    int in_disc = 0;

    (void)state;
    for (int n = 0; n < 2000; n++) {
        view_of_ref v = { .scene = scene_sky(&seed, TP_SKY_DAY) };
        v.scene.sky.sun = chance_fx(&seed, 0, 4);
        v.scene.hdr.share = n % 2 ? chance_fx(&seed, 0, 1) : 0;
        v.scene.camera.heading = v.scene.light.heading;
        v.scene.camera.pitch = v.scene.light.elevation = chance_fx(&seed, 5, 80);
        view_open(&v, 64, 48);
        const sight_angles to =
            n % 4 < 2 ? near_light(&v) : sight_any(&v, &seed, 0, PI / 2);
        const double cosine = sight_cos(to, sight_light(&v));
        const double more = v.scene.sky.sun / 65536.0 * disc_of(cosine)
                          * v.scene.hdr.share / 65536.0;
        const ref_seen seen = sight_look(&v, to);
        in_disc += disc_of(cosine) > 0;
        for (int k = 0; k < 3; k++)
            measure_add(&off, seen.colour.c[k]
                        - fmin(255, fmin(255, day_of(&v.scene, to, cosine, true, k))
                               * (1 + more)), n, k, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(in_disc > 100);
    assert_true(off.worst < 1e-8);      /* the disc's edge is 1/8000 rad wide */
}

/* Below the horizon the sky darkens to a quarter within 11 degrees, and no part is brighter
 * than white. */
static void a_day_grows_dark_below_the_horizon(void **state)
{
    measure off = { .what = "below", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 500; n++) {
        view_of_ref v = { .scene = scene_sky(&seed, TP_SKY_DAY) };
        go_ashore(&v.scene);
        v.scene.camera.pitch = -20 * TP_FX_ONE;
        v.scene.hdr.share = TP_FX_ONE;
        if (n % 2) {            /* half of the light's disc has set */
            v.scene.camera.heading = v.scene.light.heading;
            v.scene.light.elevation = TP_FX_ONE;
        }
        view_open(&v, 64, 48);
        sight_angles to = sight_any(&v, &seed, -0.5, 0);
        if (n % 2)
            to = (sight_angles){ sight_light(&v).azimuth
                                     + chance_double(&seed, -0.01, 0.01),
                                 chance_double(&seed, -0.004, 0) };
        const double cosine = sight_cos(to, sight_light(&v));
        const ref_seen seen = sight_look(&v, to);
        for (int k = 0; k < 3 && seen.kind == REF_SKY; k++)
            measure_add(&off, seen.colour.c[k]
                        - fmax(0.25, 1 + 4 * sin(to.elevation))
                          * fmin(255, day_of(&v.scene, to, cosine, true, k)), n, k, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.inputs > 1200);
    assert_true(off.worst < 1e-8);
}

/* With glitter the mirrored sky has no disc. Light brighter than white counts although the
 * water reflects only a share of it. */
static void level_water_mirrors_a_day(void **state)
{
    measure off = { .what = "mirrored day", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 2000; n++) {
        view_of_ref v = { .scene = scene_sky(&seed, TP_SKY_DAY) };
        const bool disc = n % 2;
        v.scene.sky.sun = chance_fx(&seed, 0, 8);
        v.scene.hdr.share = chance_fx(&seed, 0, 1);
        v.scene.camera.heading = v.scene.light.heading;
        v.scene.camera.pitch = -30 * TP_FX_ONE;
        v.scene.light.elevation = chance_fx(&seed, 5, 60);
        v.scene.water.specular = disc ? 0 : 1;      /* 2^-16, the least glitter */
        view_open(&v, 64, 48);
        const sight_angles up = near_light(&v);
        const double cosine = sight_cos(up, sight_light(&v));
        const double share = fresnel_of(PI / 2 - up.elevation, WATER);
        const double more = disc ? v.scene.sky.sun / 65536.0 * disc_of(cosine)
                                 * v.scene.hdr.share / 65536.0 : 0;
        const ref_seen seen = sight_look(&v, (sight_angles){ up.azimuth, -up.elevation });
        const double power = v.scene.water.shininess / TP_FX_ONE;
        const double glint = disc ? 0 : 0x1p-16 * pow(fmax(0, cosine), power);
        for (int k = 0; k < 3; k++)
            measure_add(&off, seen.colour.c[k]
                        - fmin(255, glint * channel(v.scene.light.colour, k)
                               + fmin(255, channel(v.scene.water.colour, k) * (1 - share)
                               + share * (1 + more)
                                 * fmin(255, day_of(&v.scene, up, cosine, disc, k)))),
                        n, k, disc);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-8);
}

/* Sky colour in a direction with the light's colour replaced. */
static ref_colour lit_sky(tp_scene scene, int32_t colour, sight_angles to)
{
    view_of_ref v = { .scene = scene };

    v.scene.light.colour = colour;
    view_open(&v, 64, 48);
    const ref_seen seen = sight_look(&v, to);
    view_close(&v);
    return seen.colour;
}

/* Dusk and night with a black light: at one elevation the colour goes from the dark side to
 * the bright side by cos^4 of half the angle from the light, so two directions predict a
 * third. A coloured light adds only halos. */
static void dusk_and_night_have_two_sides_and_halos(void **state)
{
    measure sides = { .what = "two sides", .unit = "of 255" };
    measure halos = { .what = "halos", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 600; n++) {
        tp_scene scene = scene_sky(&seed, n % 2 ? TP_SKY_DUSK : TP_SKY_NIGHT);
        view_of_ref v = { .scene = scene };
        const int32_t grey = 0x141414 * chance_int(&seed, 0, 5);
        double side[3], cosine = 1;
        ref_colour dark[3];
        scene.camera.pitch = 20 * TP_FX_ONE;
        scene.sky.sun = 0;
        v.scene = scene;
        view_open(&v, 64, 48);
        const double up = chance_double(&seed, 0.05, 0.8);
        for (int i = 0; i < 3; i++) {
            const sight_angles to = { sight_ahead(&v).azimuth + 0.6 * i - 0.6, up };
            cosine = sight_cos(to, sight_light(&v));
            side[i] = pow(cos(acos(cosine) / 2), 4);
            dark[i] = lit_sky(scene, 0, to);
            const ref_colour lit = lit_sky(scene, grey, to);
            for (int k = 0; k < 3; k++)
                measure_add(&halos, lit.c[k] - fmin(255, dark[i].c[k] + channel(grey, k)
                                                          * halo_of(&scene, cosine)),
                            n, i, k);
        }
        for (int k = 0; k < 3; k++)
            measure_add(&sides, (dark[2].c[k] - dark[0].c[k]) * (side[1] - side[0])
                                - (dark[1].c[k] - dark[0].c[k]) * (side[2] - side[0]),
                        n, k, 0);
        view_close(&v);
    }
    measure_print(&sides);
    measure_print(&halos);
    assert_true(sides.worst < 1e-9);
    assert_true(halos.worst < 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_day_has_its_gradient_halos_and_disc),
        cmocka_unit_test(a_day_grows_dark_below_the_horizon),
        cmocka_unit_test(level_water_mirrors_a_day),
        cmocka_unit_test(dusk_and_night_have_two_sides_and_halos),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
