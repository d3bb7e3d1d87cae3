/* SPDX-License-Identifier: MIT */
/* Light reflected by water: the fused stage, the reflected vector, the Fresnel mix with
 * HDR light, and haze at the horizon, in double precision.  Errors are in levels of
 * 255. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/sky/sky.h"
#include "tests/lib/shading.h"

static uint64_t chance;
static test_sky sky;

/* The Fresnel share is in 255ths for 1/256 of N.V and falls by up to 6 (at grazing views):
 * 6 levels of 255 per entry; the sky's entry is 1/256, 2 levels; the share is truncated
 * twice, the mix rounded. */
static void mirrors_show_the_sky_by_fresnel(void **state)
{
    (void)state;
    measure off = { .what = "mirror", .unit = "levels" };

    for (int n = 0; n < 1000; n++) {
        const tp_shade s = shade_any(&chance);
        test_run r;
        run_any(&r, 0, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            r.run.nv[i] = (int16_t)chance_int(&chance, 0, 16384);
            r.run.up[i] = (int16_t)chance_int(&chance, -16384, 16384);
        }
        const tp_run before = r.run;
        tp_stage_mirror_gradient_sky(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const double up = before.up[i] / Q14;
            const double above = ref_clamp(1 + 4 * up, 0.5, 1);
            const double share = ref_fresnel(before.nv[i] / Q14) * s.mirror / 256 * above;
            const double e = ref_colour_difference(
                r.run.colour[i], ref_mix(ref_colour_unpack(before.colour[i]),
                                         ref_sky(s.sky[0], s.sky[TP_SKY], up), share));
            assert_true(e <= 6 + 2 + 2.5);
            measure_add(&off, e, before.nv[i], before.up[i], s.mirror);
        }
    }
    measure_print(&off);
}

static void fresnel_has_the_known_ends(void **state)
{
    (void)state;
    measure off = { .what = "fresnel table", .unit = "of 1/256" };

    for (int i = 0; i <= 256; i++) {
        const double e = tp_fresnel_table[i] - 256 * ref_fresnel(i / 256.0);
        assert_true(fabs(e) <= 1);      /* 255 stands for 1 */
        measure_add(&off, e, i, 0, 0);
    }
    measure_print(&off);
    assert_int_equal(tp_fresnel_table[0], 255);
    assert_int_equal(tp_fresnel_table[256], 5);        /* 0.0204 */
}

/* The same table by Schlick's rule. */
static void schlick_takes_the_place_of_the_exact_law(void **state)
{
    (void)state;
    for (int i = 0; i <= 256; i++) {
        const double c = 1 - i / 256.0;
        assert_true(fabs(tp_schlick_table[i] - 256 * (0.02037 + 0.97963 * pow(c, 5))) <= 1);
    }
}

/* -- the parts of the fused stage ------------------------------------------------------ */

/* N.V and the height are right to 20 units of 1/16384, slopes are up to 1.4: 60. */
static void the_view_is_reflected_by_the_bent_normal(void **state)
{
    (void)state;
    measure off = { .what = "reflected", .unit = "of 1/16384" };

    for (int n = 0; n < 1000; n++) {
        const tp_shade s = shade_any(&chance);
        test_run r;
        run_any(&r, 4000, &chance);
        tp_stage_view(&s, &r.run);
        tp_stage_slopes(&s, &r.run);
        tp_stage_light(&s, &r.run);
        tp_stage_reflect_gradient(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = { r.run.vx[i] / Q14, r.run.vy[i] / Q14, r.run.vz[i] / Q14 };
            const ref_dir normal = ref_normal(run_sx(&r, i), run_sz(&r, i));
            const double nv = ref_dir_dot(normal, v);
            if (nv < 0)
                continue;
            const double x = 2 * nv * normal.x - v.x, z = 2 * nv * normal.z - v.z;
            const double e = fmax(fabs(r.run.rx[i] / Q14 - ref_clamp(x, -1, 1)),
                                  fabs(r.run.rz[i] / Q14 - ref_clamp(z, -1, 1)));
            assert_true(e <= 60 / Q14);
            measure_add(&off, e * Q14, (int32_t)r.n[i], i, 0);
            const int32_t up = r.run.up[i] > 0 ? r.run.up[i] : 0;
            assert_int_equal(r.run.mirror[i],
                             tp_env_sample(&s, r.run.rx[i], up, r.run.rz[i]));
        }
    }
    measure_print(&off);
}

/* The parts in sequence equal the fused stage, bit for bit. */
static void reflection_in_parts_is_the_fused_one(void **state)
{
    (void)state;
    for (int n = 0; n < 1000; n++) {
        const tp_shade s = shade_any(&chance);
        test_run r;
        run_any(&r, 4000, &chance);
        tp_stage_view(&s, &r.run);
        tp_stage_slopes(&s, &r.run);
        tp_stage_light(&s, &r.run);
        tp_run fused = r.run;
        tp_stage_mirror_gradient_sky(&s, &fused);
        tp_stage_reflect_gradient(&s, &r.run);
        tp_stage_fresnel(&s, &r.run);
        assert_memory_equal(r.run.colour, fused.colour, sizeof fused.colour);
    }
}

/* Far water takes coarser mipmap levels of a cube; near water and smooth pictures give the
 * same result. */
static void far_water_mirrors_a_coarser_picture(void **state)
{
    (void)state;
    tp_shade s = shade_any(&chance);
    double spread[2] = { 0, 0 };

    sky_cube(&sky, &s, sky_noise, &chance);
    for (int n = 0; n < 400; n++) {
        test_run r;
        run_any(&r, 2000, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            r.key[i] = n % 2 ? 0x8000 : 0x20000000;         /* depths differ by 2^15 */
            r.run.up[i] = (int16_t)chance_int(&chance, 0, 16384);
            r.run.vy[i] = (int16_t)chance_int(&chance, 0, 16384 - r.run.up[i]);
            r.run.vx[i] = (int16_t)chance_int(&chance, -9999, 9999);
            r.run.vz[i] = (int16_t)chance_int(&chance, -9999, 9999);
            r.run.sx[i] = r.run.sz[i] = 0;
        }
        s.zi_log = 15 * 256 + 14 * 256;
        tp_stage_reflect_cube(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++)
            spread[n % 2] += fabs((double)(r.run.mirror[i] & 0xff) - 127.5);
    }
    assert_true(spread[1] < spread[0] / 2);
}

/* The share is truncated twice and the mix rounded; in HDR the mix is truncated, and an
 * alpha of 255 counts as 255 of 256. */
static void fresnel_mixes_light_beyond_white(void **state)
{
    (void)state;
    colour_error off = { .what = "fresnel" }, hdr = { .what = "fresnel, HDR" };

    for (int n = 0; n < 1000; n++) {
        tp_shade s = shade_any(&chance);
        test_run r;
        s.env.beyond = (uint32_t)chance_int(&chance, 0, 4096);
        run_any(&r, 0, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            r.run.nv[i] = (int16_t)chance_int(&chance, 0, 16384);
            r.run.up[i] = (int16_t)chance_int(&chance, -16384, 16384);
            r.run.mirror[i] = (uint32_t)random_next(&chance);
        }
        const tp_run before = r.run;
        tp_run bright = r.run;
        tp_stage_fresnel(&s, &r.run);
        tp_stage_fresnel_hdr(&s, &bright);
        for (int i = 0; i < TP_RUN; i++) {
            const double above = ref_clamp(1 + 4 * before.up[i] / Q14, 0.5, 1);
            const double f = s.fresnel[before.nv[i] >> 6] / 256.0;
            const double share = f * s.mirror / 256 * above;
            const ref_light light = ref_light_unpack(before.mirror[i]);
            const ref_colour was =
                ref_scale(ref_colour_unpack(before.colour[i]), 1 - share);
            colour_error_add(&off, r.run.colour[i],
                             ref_add(was, ref_scale(light.colour, share)));
            colour_error_add(
                &hdr, bright.colour[i],
                ref_add(was, ref_scale(ref_unclamped_colour(light, s.env.beyond / 4096.0),
                                       share)));
        }
    }
    colour_error_print(&off);
    colour_error_print(&hdr);
    assert_true(off.largest <= 5 && colour_error_rms(&off) <= 1.5);
    assert_true(hdr.largest <= 8 && colour_error_rms(&hdr) <= 1.5);
}

/* -- haze ------------------------------------------------------------------------------ */

/* The horizon in the direction of each column; exact at the ends of 16 columns. */
static void air_takes_the_horizon_s_colour_in_its_direction(void **state)
{
    (void)state;
    colour_error off = { .what = "haze, dome" };

    for (int n = 0; n < 600; n++) {
        tp_shade s = shade_any(&chance);
        test_run r;
        sky_dome(&sky, &s, &chance);
        s.env.beyond = 0;
        run_any(&r, 0, &chance);
        const tp_haze haze = { .scale = (uint32_t)random_next(&chance)
                               >> chance_int(&chance, 0, 31) };
        r.run.mine = &haze;
        const tp_run before = r.run;
        tp_stage_haze_dome(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = shade_view(&s, &s.world, r.run.x + i, r.run.y);
            const ref_dir flat = ref_unit((ref_dir){ -v.x, 0, -v.z });
            const uint64_t entry = (uint64_t)(r.key[i] >> 1) * haze.scale >> 32;
            const double share = tp_haze_table[entry < TP_HAZE ? entry : TP_HAZE] / 256.0;
            const uint32_t light = tp_env_sample(&s, sky_q14(flat.x), 0, sky_q14(flat.z));
            if (fabs(v.y) > 0.7 || light >> 24)
                continue;       /* 16 columns cover many degrees there */
            colour_error_add(&off, r.run.colour[i],
                             ref_mix(ref_colour_unpack(before.colour[i]),
                                     ref_colour_unpack(light), share));
        }
    }
    colour_error_print(&off);
    assert_true(colour_error_rms(&off) <= 1.5);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mirrors_show_the_sky_by_fresnel),
        cmocka_unit_test(fresnel_has_the_known_ends),
        cmocka_unit_test(schlick_takes_the_place_of_the_exact_law),
        cmocka_unit_test(the_view_is_reflected_by_the_bent_normal),
        cmocka_unit_test(reflection_in_parts_is_the_fused_one),
        cmocka_unit_test(far_water_mirrors_a_coarser_picture),
        cmocka_unit_test(fresnel_mixes_light_beyond_white),
        cmocka_unit_test(air_takes_the_horizon_s_colour_in_its_direction),
    };
    return cmocka_run_group_tests_name("shade/mirror", tests, NULL, NULL);
}
