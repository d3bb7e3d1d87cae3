/* SPDX-License-Identifier: MIT */
/* View, sky, glint and haze compared with their formulas in double precision, and rules for
 * all stages.  Errors are in levels of 255; products and mixes of colours are rounded, so a
 * stage may err by half a level for each. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/boat/boat.h"
#include "features/exposure/exposure.h"
#include "features/sky/sky.h"
#include "tests/lib/shading.h"

static uint64_t chance;
static test_sky sky;

/* -- view and sky -------------------------------------------------------------------- */

/* A chord over n pixels of a circle of radius f lies (n/f)^2 / 8 below the circle at its
 * middle. */
static double chord(const tp_shade *s, double pixels)
{
    const double angle = pixels / (s->focal / 16.0);
    return angle * angle / 8;
}

static void the_view_points_to_the_eye(void **state)
{
    (void)state;
    measure off = { .what = "view", .unit = "of 1/16384" };

    for (int n = 0; n < 2000; n++) {
        const tp_shade s = shade_any(&chance);
        test_run r;
        run_any(&r, 0, &chance);
        tp_stage_view(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = shade_view(&s, &s.world, r.run.x + i, r.run.y);
            const ref_dir l = shade_light(&s.world);
            /* Two ends truncated to Q1.14 and the interpolation truncated too: three units.
             * The bow leaves a twentieth of the chord's error.  The light's product adds
             * three truncations of 1. */
            const double most = chord(&s, 16) / 20 + 3 / Q14, most_l = most * 1.8 + 2 / Q14;
            const double e = fmax(fmax(fabs(r.run.vx[i] / Q14 - v.x),
                                       fabs(r.run.vy[i] / Q14 - v.y)),
                                  fabs(r.run.vz[i] / Q14 - v.z));
            assert_true(e <= most);
            assert_true(fabs(r.run.lv[i] / Q14 - ref_dir_dot(v, l)) <= most_l);
            measure_add(&off, e * Q14, r.run.x + i, r.run.y, s.focal);
        }
    }
    measure_print(&off);
}

static void the_sky_turns_from_horizon_to_zenith(void **state)
{
    (void)state;
    measure off = { .what = "sky", .unit = "levels" };

    for (int n = 0; n < 2000; n++) {
        const tp_shade s = shade_any(&chance);
        test_run r;
        run_any(&r, 0, &chance);
        tp_stage_sky(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = shade_view(&s, &s.world, r.run.x + i, r.run.y);
            const double e = ref_colour_difference(r.run.colour[i],
                                     ref_sky(s.sky[0], s.sky[TP_SKY], -v.y));
            /* The gradient rises by 2 at the horizon, times 255 levels: an entry of 1/256
             * is up to 2 levels, and the chord's error over 64 pixels likewise. */
            assert_true(e <= 2 * 255 * (1 / 256.0 + chord(&s, 64) + 3 / Q14) + 2);
            measure_add(&off, e, r.run.x + i, r.run.y, s.focal);
        }
    }
    measure_print(&off);
}

static void glints_add_the_light_and_hold_at_white(void **state)
{
    (void)state;
    measure off = { .what = "glint", .unit = "levels" };

    for (int n = 0; n < 1000; n++) {
        const tp_shade s = shade_any(&chance);
        test_run r;
        run_any(&r, 0, &chance);
        for (int i = 0; i < TP_RUN; i++)
            r.run.glint[i] =
                (uint16_t)(random_below(&chance, 2) ? random_below(&chance, 1025) : 0);
        const tp_run before = r.run;
        tp_stage_glint(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const double share = fmin(1, before.glint[i] / 256.0);
            const double e =
                ref_colour_difference(r.run.colour[i],
                        ref_add(ref_colour_unpack(before.colour[i]),
                                ref_scale(ref_colour_unpack(s.light_colour), share)));
            assert_true(e < 0.51);      /* one product, rounded */
            measure_add(&off, e, before.glint[i], 0, 0);
        }
    }
    measure_print(&off);
}

/* Share z^2 / (z^2 + h^2) by 32 h / z in whole entries: near entry 18, the steepest point,
 * an entry is 0.02 or 5 levels; at most 255 of 256; a mix. */
static void haze_goes_into_the_horizon(void **state)
{
    (void)state;
    measure off = { .what = "haze", .unit = "levels" };

    for (int n = 0; n < 2000; n++) {
        const tp_shade s = shade_any(&chance);
        test_run r;
        run_any(&r, 0, &chance);
        const double zi_near = 0.25 * 255 / 256 * 65536;
        const int32_t half = chance_int(&chance, 1, 32000);     /* metres */
        const tp_haze haze = { .scale = (uint32_t)(half * 65536.0 * 64 / zi_near) };
        r.run.mine = &haze;
        const tp_run before = r.run;
        tp_stage_haze(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const double z = zi_near / 65536 / (r.key[i] / 4294967296.0);
            const double share = z * z / (z * z + (double)half * half);
            const double e = ref_colour_difference(r.run.colour[i],
                                     ref_mix(ref_colour_unpack(before.colour[i]),
                                             ref_colour_unpack(s.sky[0]), share));
            assert_true(e <= 5 + 1 + 0.5);
            measure_add(&off, e, r.key[i], half, 0);
        }
    }
    measure_print(&off);
}

/* -- cuts ---------------------------------------------------------------------------- */

/* A row in pieces equals the whole row, for any cuts: boats and tiles cut rows anywhere. */
static void runs_may_be_cut_anywhere(void **state)
{
    (void)state;
    static stage *const stages[] = {
        tp_stage_view, tp_stage_sky, tp_stage_plain, tp_stage_diffuse, tp_stage_light,
        tp_stage_diffuse_rippled, tp_stage_light_rippled, tp_stage_mirror_gradient_sky,
        tp_stage_glint, tp_stage_haze, tp_stage_solid, tp_stage_solid_blinn, tp_stage_land,
        tp_stage_drop, tp_stage_light_blinn, tp_stage_light_blinn_rippled, tp_stage_slopes,
        tp_stage_sky_dome, tp_stage_sky_dome_hdr, tp_stage_stars,
        tp_stage_reflect_gradient, tp_stage_reflect_dome, tp_stage_fresnel,
        tp_stage_fresnel_hdr, tp_stage_haze_dome, tp_stage_expose
    };
    enum { STAGES = sizeof stages / sizeof stages[0] };
    static const tp_mesh mesh;

    for (int n = 0; n < 300 * STAGES; n++) {
        tp_shade s = shade_any(&chance);
        uint8_t gloss[TP_GLOSS];
        tp_tones tones;
        const tp_exposure exposure = { .tones = &tones };
        const tp_solid solid = solid_any(gloss, &chance);
        test_run r;
        run_any(&r, 5000, &chance);
        tp_shade_gloss(gloss, 20 * TP_FX_ONE);
        tp_shade_shine(shade_shine, 20 * TP_FX_ONE, TP_FX_ONE);
        const tp_boat_shading boat = { &mesh, &solid, s.world };
        sky_dome(&sky, &s, &chance);
        s.env.stars = 200;
        s.env.star = 1000;
        tp_exposure_make_tone_curve(tones.tone, chance_fx(&chance, 0.125, 8));
        tp_stage_view(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            r.run.mirror[i] = (uint32_t)random_next(&chance);
            r.run.sx[i] = (int16_t)chance_int(&chance, -5000, 5000);
            r.run.sz[i] = (int16_t)chance_int(&chance, -5000, 5000);
        }
        tp_stage_light(&s, &r.run);
        const tp_haze haze = { .scale = (uint32_t)random_next(&chance)
                               >> chance_int(&chance, 0, 31) };
        stage *const chosen = stages[n % STAGES];
        r.run.mine = chosen == tp_stage_expose ? (const void *)&exposure
                   : chosen == tp_stage_solid || chosen == tp_stage_solid_blinn
                         ? (const void *)&boat
                   : chosen == tp_stage_land || chosen == tp_stage_drop
                         ? (const void *)&solid : &haze;
        const tp_run before = r.run;
        stages[n % STAGES](&s, &r.run);
        for (int32_t from = 0; from < TP_RUN; ) {
            const int32_t end = chance_int(&chance, from + 1, TP_RUN);
            tp_run part = run_part(&before, from, end);
            const tp_run want = run_part(&r.run, from, end);
            const size_t count = (size_t)(end - from);
            stages[n % STAGES](&s, &part);
            assert_memory_equal(part.colour, want.colour, count * sizeof *part.colour);
            assert_memory_equal(part.vx, want.vx, count * sizeof *part.vx);
            assert_memory_equal(part.vy, want.vy, count * sizeof *part.vy);
            assert_memory_equal(part.vz, want.vz, count * sizeof *part.vz);
            assert_memory_equal(part.lv, want.lv, count * sizeof *part.lv);
            assert_memory_equal(part.nv, want.nv, count * sizeof *part.nv);
            assert_memory_equal(part.up, want.up, count * sizeof *part.up);
            assert_memory_equal(part.glint, want.glint, count * sizeof *part.glint);
            assert_memory_equal(part.mirror, want.mirror, count * sizeof *part.mirror);
            from = end;
        }
    }
}

/* -- colours ------------------------------------------------------------------------- */

static void colours_keep_their_ends(void **state)
{
    (void)state;
    for (uint32_t c = 0; c < 256; c++) {
        const uint32_t grey = c * 0x010101;
        assert_int_equal(tp_colour_scale(grey, 256), grey);
        assert_int_equal(tp_colour_scale(grey, 0), 0);
        assert_int_equal(tp_colour_mix(grey, 0x123456, 0), grey);
        assert_int_equal(tp_colour_mix(0x123456, grey, 256), grey);
        assert_int_equal(tp_colour_times(grey, 0xffffff), grey);
        assert_int_equal(tp_colour_times(grey, 0) & 0xffffff, 0);
        assert_int_equal(tp_colour_add(grey, 0), grey);
        assert_int_equal(tp_colour_add(grey, 0xffffff), 0xffffff);
        for (uint32_t share = 0; share <= 256; share++)
            assert_int_equal(tp_colour_mix(grey, grey, share), grey);
    }
}

static void logarithms_are_within_a_twelfth(void **state)
{
    (void)state;
    measure off = { .what = "log2", .unit = "of 1" };

    for (uint64_t n = 1; n < 1ull << 32; n += 1 + n / 3000) {
        const double e = tp_log2_q8((uint32_t)n) / 256.0 - log2((double)n);
        assert_true(e <= 0 && e >= -1 / 11.0);
        measure_add(&off, e, (int64_t)n, 0, 0);
    }
    measure_print(&off);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_view_points_to_the_eye),
        cmocka_unit_test(the_sky_turns_from_horizon_to_zenith),
        cmocka_unit_test(glints_add_the_light_and_hold_at_white),
        cmocka_unit_test(haze_goes_into_the_horizon),
        cmocka_unit_test(runs_may_be_cut_anywhere),
        cmocka_unit_test(colours_keep_their_ends),
        cmocka_unit_test(logarithms_are_within_a_twelfth),
    };
    return cmocka_run_group_tests_name("shade/stages", tests, NULL, NULL);
}
