/* SPDX-License-Identifier: MIT */
/* Domes, cubes and their stages compared with double precision.  Errors are in levels of
 * 255. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/shading.h"
#include "tidepool/modules.h"

static uint64_t chance;
static test_sky sky;

/* -- the dome -------------------------------------------------------------------------- */

/* The dome's light towards d, with gradients interpolated between their entries.  Sets
 * *edge where a direction's last bits are worth many levels: beside the disc's edge, and
 * where the horizon cuts the disc.  The sky below the horizon has no light beyond white,
 * so the brightness of the disc steps there by up to 16 whites.  View vectors are right to
 * about 3 of 2^14 (test_shade_stages). */
static ref_light dome_at(const tp_shade *s, ref_dir d, bool *edge)
{
    const ref_dir l = shade_light(&s->world);
    const ref_dir off = { d.x - l.x, d.y - l.y, d.z - l.z };
    const double square = ref_dir_dot(off, off) * 268435456.0;
    const double at = ref_clamp(d.y, 0, 1) * TP_SKY, share = ref_towards(square);
    const int i = (int)fmin(at, TP_SKY - 1);
    const ref_colour away = ref_mix(ref_colour_unpack(sky.dome.away[i]),
                                    ref_colour_unpack(sky.dome.away[i + 1]), at - i);
    const ref_colour towards = ref_mix(ref_colour_unpack(sky.dome.towards[i]),
                                       ref_colour_unpack(sky.dome.towards[i + 1]), at - i);
    ref_light light = ref_glow((int)sky.config.kind, sky.config.light,
                               sky.config.sun / 65536.0, square);

    *edge = (square > 90000 && square < 140000)
         || (light.alpha > 0 && fabs(d.y) <= 4 / Q14);
    light.colour = ref_add(ref_mix(away, towards, share), light.colour);
    if (d.y < 0)
        light = (ref_light){ ref_scale(light.colour, ref_clamp(1 + 4 * d.y, 0.25, 1)), 0 };
    return light;
}

static ref_colour shown(ref_light light, const tp_shade *s)
{
    const ref_colour c = ref_unclamped_colour(light, s->env.beyond / 4096.0);
    return (ref_colour){ { fmin(255, c.c[0]), fmin(255, c.c[1]), fmin(255, c.c[2]) } };
}

/* Every second span looks at the light.  Entries of gradients and glow, two mixes and the
 * tables' steps give at most a level each; in HDR an alpha of 255 is 16 whites, so a step
 * of alpha may be 16 levels.  Below the horizon the sky darkens in steps of 1/64: four levels
 * more. */
static void domes_follow_their_formulas(void **state)
{
    (void)state;
    colour_error off = { .what = "dome" }, hdr = { .what = "dome, HDR" },
                 low = { .what = "below the horizon" };

    for (int n = 0; n < 400; n++) {
        tp_shade s = shade_any(&chance);
        test_run r;
        bool edge;
        sky_dome(&sky, &s, &chance);
        run_any(&r, 0, &chance);
        if (n % 2) {
            const ref_dir v = shade_view(&s, &s.world, r.run.x + 30, r.run.y);
            s.world.lx = sky_q14(-v.x);
            s.world.ly = sky_q14(-v.y);
            s.world.lz = sky_q14(-v.z);
        }
        tp_stage_sky_dome(&s, &r.run);
        test_run bright = r;
        tp_stage_sky_dome_hdr(&s, &bright.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = shade_view(&s, &s.world, r.run.x + i, r.run.y);
            const ref_light want = dome_at(&s, (ref_dir){ -v.x, -v.y, -v.z }, &edge);
            if (edge)
                continue;
            colour_error_add(v.y > 0 ? &low : &off, r.run.colour[i], want.colour);
            colour_error_add(&hdr, bright.run.colour[i], shown(want, &s));
        }
    }
    colour_error_print(&off);
    colour_error_print(&low);
    colour_error_print(&hdr);
    assert_true(off.largest <= 8 && colour_error_rms(&off) <= 1.5);
    assert_true(low.largest <= 12 && colour_error_rms(&low) <= 1.5);
    assert_true(hdr.largest <= 20 && colour_error_rms(&hdr) <= 1.5);
}

static void the_disc_is_the_brightest_and_beyond_white(void **state)
{
    (void)state;
    for (int n = 0; n < 300; n++) {
        tp_shade s = shade_any(&chance);
        sky_dome(&sky, &s, &chance);
        if (s.world.ly < 1000)
            continue;
        const uint32_t sun = tp_env_sample(&s, s.world.lx, s.world.ly, s.world.lz);
        const double white = fmin(1, sky.config.sun / 65536.0);
        const ref_colour c = ref_colour_unpack(sun),
                         l = ref_colour_unpack(sky.config.light);
        for (int k = 0; k < 3; k++)
            assert_true(c.c[k] >= floor(l.c[k] * white) - 2);
        assert_true(fabs((sun >> 24) - 255 * (sky.config.sun / 65536.0) / 16) <= 2);
        const uint32_t zenith = tp_env_sample(&s, -s.world.lx, s.world.ly, -s.world.lz);
        if (s.world.ly < 14000)
            assert_int_equal(zenith >> 24, 0);
    }
}

/* Glittering water leaves the sun's disc to its lobe: the reflected sky has no edge. */
static void mirrors_may_leave_the_disc_out(void **state)
{
    (void)state;
    for (int n = 0; n < 300; n++) {
        tp_shade s = shade_any(&chance);
        sky_dome(&sky, &s, &chance);
        const tp_view_axes *w = &s.world;
        const uint32_t inside = tp_env_dome(&s, TP_DISC_END, w->lx, w->ly, w->lz);
        assert_int_equal(inside >> 24, 0);
        const uint32_t around = tp_env_dome(&s, TP_DISC_END, w->lx + 200, w->ly, w->lz);
        assert_true(ref_colour_difference(inside, ref_colour_unpack(around)) <= 3);
    }
}

/* -- the cube -------------------------------------------------------------------------- */

/* Weights have 8 bits and each of three mixes is truncated; a position is right to 1/200
 * texel, a level in noise; alpha likewise. */
static void cubes_are_looked_up_between_their_texels(void **state)
{
    (void)state;
    colour_error off = { .what = "cube" };
    double alpha = 0;

    for (int n = 0; n < 20; n++) {
        tp_shade s = shade_any(&chance);
        sky_cube(&sky, &s, sky_noise, &chance);
        for (int i = 0; i < 3000; i++) {
            const ref_dir d = sky_direction(&chance);
            const ref_place p = ref_cube_place(d);
            const double near = fmin(fmin(p.s, 1 - p.s), fmin(p.t, 1 - p.t));
            const uint32_t got =
                tp_env_sample(&s, sky_q14(d.x), sky_q14(d.y), sky_q14(d.z));
            const ref_light want = ref_face_texel(sky.texel[p.face], SKY_SIDE, SKY_SIDE,
                                                  p.s, p.t);
            if (near < 0.001)   /* may be on the next face */
                continue;
            colour_error_add(&off, got, want.colour);
            alpha = fmax(alpha, fabs((got >> 24) - want.alpha));
        }
    }
    colour_error_print(&off);
    assert_true(off.largest <= 7 && colour_error_rms(&off) <= 1.5);
    assert_true(alpha <= 7);
}

/* A smooth picture of the whole sphere: 100 levels per radian. */
static uint32_t smooth(ref_dir d, void *with)
{
    (void)with;
    const double c[3] = { 128 + 100 * d.x, 128 + 70 * d.y + 30 * d.z, 128 + 100 * d.z };
    return 0x40000000u | (uint32_t)lround(c[0]) << 16 | (uint32_t)lround(c[1]) << 8
         | (uint32_t)lround(c[2]);
}

/* All twelve edges and the eight corners at their ends, a thousandth to either side.  A
 * texel is 3 levels; the picture ends half a texel before the edge. */
static void seams_do_not_show(void **state)
{
    (void)state;
    tp_shade s = shade_any(&chance);
    colour_error off = { .what = "seams" }, whole = { .what = "sphere" };
    double step = 0;

    sky_cube(&sky, &s, smooth, NULL);
    for (int edge = 0; edge < 12; edge++) {
        const int axis = edge / 4, a = edge & 1 ? 1 : -1, b = edge & 2 ? 1 : -1;
        for (int k = -100; k <= 100; k++) {
            uint32_t side[2];
            for (int which = 0; which < 2; which++) {
                const double out = 1 + (which ? 0.001 : -0.001);
                double v[3];
                v[axis] = k / 100.0;
                v[(axis + 1) % 3] = a * out;
                v[(axis + 2) % 3] = b;
                const ref_dir d = ref_unit((ref_dir){ v[0], v[1], v[2] });
                side[which] = tp_env_sample(&s, sky_q14(d.x), sky_q14(d.y), sky_q14(d.z));
                colour_error_add(&off, side[which], ref_colour_unpack(smooth(d, NULL)));
            }
            step = fmax(step, ref_colour_difference(side[0], ref_colour_unpack(side[1])));
        }
    }
    for (int i = 0; i < 20000; i++) {
        const ref_dir d = sky_direction(&chance);
        colour_error_add(&whole,
                         tp_env_sample(&s, sky_q14(d.x), sky_q14(d.y), sky_q14(d.z)),
                         ref_colour_unpack(smooth(d, NULL)));
    }
    colour_error_print(&off);
    colour_error_print(&whole);
    printf("    across a seam      largest step %.0f levels\n", step);
    assert_true(off.largest <= 4 && step <= 3);
    assert_true(whole.largest <= 4 && colour_error_rms(&whole) <= 1.5);
}

static uint32_t opaque(ref_dir d, void *with)
{
    return smooth(d, with) | 0xff000000u;
}

static void pictures_without_alpha_have_no_light_beyond_white(void **state)
{
    (void)state;
    tp_shade s = shade_any(&chance);

    sky_cube(&sky, &s, opaque, NULL);
    assert_int_equal(tp_env_sample(&s, 16384, 0, 0) >> 24, 0);
    sky_cube(&sky, &s, smooth, NULL);
    assert_int_equal(tp_env_sample(&s, 16384, 0, 0) >> 24, 0x40);
}

/* Each face as its viewer sees the face: its right side and its top. */
static void faces_stand_as_the_header_says(void **state)
{
    (void)state;
    for (int f = 0; f < 6; f++) {
        const ref_dir *a = ref_cube_axes[f];
        for (int k = 0; k < 4; k++) {
            const double u = k & 1 ? 0.5 : -0.5, v = k & 2 ? 0.5 : -0.5;
            const ref_dir d = { a[0].x + u * a[1].x + v * a[2].x,
                                a[0].y + u * a[1].y + v * a[2].y,
                                a[0].z + u * a[1].z + v * a[2].z };
            const ref_dir n = ref_unit(d);
            uint32_t recip[TP_RECIP + 2];
            tp_recip_init(recip);
            const tp_cube_place p = tp_cube_project(recip, sky_q14(n.x), sky_q14(n.y),
                                               sky_q14(n.z));
            assert_int_equal(p.face, f);
            assert_true(abs(p.s - (int32_t)((u + 1) * 32768)) < 8);
            assert_true(abs(p.t - (int32_t)((1 - v) * 32768)) < 8);
        }
    }
}

/* -- stars ----------------------------------------------------------------------------- */

static void stars_are_few_and_only_overhead(void **state)
{
    (void)state;
    tp_shade s = shade_any(&chance);
    int lit[3] = { 0, 0, 0 };

    sky_dome(&sky, &s, &chance);
    for (int share = 0; share < 3; share++) {
        s.env.stars = (uint32_t)share * 32;
        s.env.star = (1u << 24) / (80 * 80);
        for (int n = 0; n < 2000; n++) {
            test_run r;
            run_any(&r, 0, &chance);
            memset(r.run.colour, 0, sizeof r.run.colour);
            for (int i = 0; i < TP_RUN; i++) {
                const ref_dir d = sky_direction(&chance);
                r.run.vx[i] = (int16_t)sky_q14(d.x);
                r.run.vy[i] = (int16_t)sky_q14(d.y);
                r.run.vz[i] = (int16_t)sky_q14(d.z);
            }
            tp_stage_stars(&s, &r.run);
            for (int i = 0; i < TP_RUN; i++) {
                lit[share] += r.run.colour[i] != 0;
                assert_true(r.run.colour[i] == 0 || r.run.vy[i] < 0);
            }
        }
    }
    /* An eighth of the cells has a star with 2 % of the cell's area, over half of the
     * sphere. */
    assert_int_equal(lit[0], 0);
    assert_in_range(lit[1], 128000 / 2 * 0.002 / 2, 128000 / 2 * 0.002 * 3);
    assert_true(lit[2] > lit[1] * 3 / 2 && lit[2] < lit[1] * 3);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(domes_follow_their_formulas),
        cmocka_unit_test(the_disc_is_the_brightest_and_beyond_white),
        cmocka_unit_test(mirrors_may_leave_the_disc_out),
        cmocka_unit_test(cubes_are_looked_up_between_their_texels),
        cmocka_unit_test(seams_do_not_show),
        cmocka_unit_test(pictures_without_alpha_have_no_light_beyond_white),
        cmocka_unit_test(faces_stand_as_the_header_says),
        cmocka_unit_test(stars_are_few_and_only_overhead),
    };
    return cmocka_run_group_tests_name("shade/env", tests, NULL, NULL);
}
