/* SPDX-License-Identifier: MIT */
/* Light on water against Phong and Fresnel in double precision.  Errors are in levels of
 * 255; every product and mix of colours is cut, not rounded: a level for each. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "shades.h"

static uint64_t chance;

/* Every other run to a slope of 2 in all, where the root's table ends, and as far as 16
 * bits go, where it is used up to three times over. */
static void compare_diffuse(stage *diffuse, measure *off, double most)
{
    for (int n = 0; n < 2000; n++) {
        const tp_shade s = shade_any(&chance);
        test_run r;
        run_any(&r, n % 2 ? 32000 : 5700, &chance);
        const tp_run before = r.run;
        tp_stage_view(&s, &r.run);
        diffuse(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir normal = ref_normal(run_sx(&r, i), run_sz(&r, i));
            const double ambient = s.ambient / 256.0;
            const double nl = fmax(0, ref_dir_dot(normal, shade_light(&s.world)));
            const double e = ref_off(r.run.colour[i],
                                     ref_scale(ref_colour_of(before.colour[i]),
                                               ambient + (1 - ambient) * fmin(nl, 1)));
            assert_true(e <= most);
            measure_add(off, e, (int32_t)r.n[i], s.ambient, s.world.ly);
        }
    }
    measure_print(off);
}

/* The share in 256ths is cut (a level), the product too (a level); the root's nearest
 * entry of 1/128 is off by 0.2 % (half a level). */
static void diffuse_follows_lambert(void **state)
{
    (void)state;
    measure off = { .what = "diffuse", .unit = "levels" };
    compare_diffuse(tp_stage_diffuse, &off, 2.6);
}

/* Two cuts of a level; the root is interpolated. */
static void light_follows_lambert(void **state)
{
    (void)state;
    measure off = { .what = "light", .unit = "levels" };
    compare_diffuse(tp_stage_light, &off, 2.1);
}

/* Waves and ripples may be as steep as their 16 bits.  No colour comes out brighter than
 * it went in: a share above 1 would carry one channel into the next. */
static void no_slope_makes_water_brighter_than_itself(void **state)
{
    (void)state;
    static stage *const stages[] = { tp_stage_diffuse, tp_stage_light,
                                     tp_stage_diffuse_rippled, tp_stage_light_rippled };

    for (int n = 0; n < 4000; n++) {
        const tp_shade s = shade_any(&chance);
        test_run r;
        run_any(&r, 32000, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            r.run.sx[i] = (int16_t)chance_int(&chance, -32000, 32000);
            r.run.sz[i] = (int16_t)chance_int(&chance, -32000, 32000);
        }
        tp_stage_view(&s, &r.run);
        const tp_run before = r.run;
        stages[n % 4](&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_colour was = ref_colour_of(before.colour[i]);
            const ref_colour is = ref_colour_of(r.run.colour[i]);
            for (int k = 0; k < 3; k++)
                assert_true(is.c[k] <= was.c[k]
                            && is.c[k] >= floor(was.c[k] * s.ambient / 256.0));
            if (n % 2) {
                assert_in_range(r.run.nv[i], 0, 16384);
                assert_true(r.run.up[i] >= -16384 && r.run.up[i] <= 16384);
            }
        }
    }
}

/* N.V and the mirrored view's height, of eyes above the water. */
static void light_hands_on_view_and_mirror(void **state)
{
    (void)state;
    measure nv_off = { .what = "N.V", .unit = "of 1/16384" };
    measure up_off = { .what = "mirrored height", .unit = "of 1/16384" };

    for (int n = 0; n < 2000; n++) {
        const tp_shade s = shade_any(&chance);
        test_run r;
        run_any(&r, 5700, &chance);
        tp_stage_view(&s, &r.run);
        tp_stage_light(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = { r.run.vx[i] / Q14, r.run.vy[i] / Q14, r.run.vz[i] / Q14 };
            const ref_dir normal = ref_normal(run_sx(&r, i), run_sz(&r, i));
            const double nv = ref_clamp(ref_dir_dot(normal, v), 0, 1);
            const double up = ref_clamp(2 * nv * normal.y - v.y, -1, 1);
            /* The root is cut in its table and between its entries, 2 units, times a sum
             * of up to 2.2 that is cut by one too; the product by one more: 7 units.  The
             * height is twice nv ny, with the root's 2 again and two more cuts: 20. */
            assert_true(fabs(r.run.nv[i] / Q14 - nv) <= 7 / Q14);
            assert_true(fabs(r.run.up[i] / Q14 - up) <= 20 / Q14);
            measure_add(&nv_off, (r.run.nv[i] / Q14 - nv) * Q14, (int32_t)r.n[i], 0, 0);
            measure_add(&up_off, (r.run.up[i] / Q14 - up) * Q14, (int32_t)r.n[i], 0, 0);
        }
    }
    measure_print(&nv_off);
    measure_print(&up_off);
}

/* The lobe lies between those of a slightly lesser and a slightly larger R.V: the table
 * has 1024 entries; R.V is 2 N.L N.V - L.V, of which N.L and N.V are right to 7 units of
 * 1/16384: 30 in all. */
static void glints_follow_the_phong_lobe(void **state)
{
    (void)state;
    int lit = 0;

    for (int n = 0; n < 2000; n++) {
        tp_shade s = shade_any(&chance);
        const double strength = chance_double(&chance, 0, 4);
        const int shininess = chance_int(&chance, 1, n % 2 ? 1000 : 30);
        tp_shade_shine(&s, shininess * TP_FX_ONE, (tp_fx)(strength * 65536));
        test_run r;
        run_any(&r, 2000, &chance);
        tp_stage_view(&s, &r.run);
        tp_stage_light(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = { r.run.vx[i] / Q14, r.run.vy[i] / Q14, r.run.vz[i] / Q14 };
            const ref_dir normal = ref_normal(run_sx(&r, i), run_sz(&r, i));
            const double nv = ref_clamp(ref_dir_dot(normal, v), 0, 1);
            const double nl = ref_clamp(ref_dir_dot(normal, shade_light(&s.world)), 0, 1);
            const double rv = 2 * nl * nv - r.run.lv[i] / Q14;
            if (fabs(rv) < 30 / Q14 || nl < 10 / Q14)
                continue;
            const double low =
                pow(ref_clamp(rv - 1 / 1024.0 - 30 / Q14, 0, 1), shininess);
            const double high = pow(ref_clamp(rv + 30 / Q14, 0, 1), shininess);
            assert_true(r.run.glint[i] >= low * strength * 256 - 2);
            assert_true(r.run.glint[i] <= high * strength * 256 + 2);
            lit += r.run.glint[i] > 0;
        }
    }
    assert_true(lit > 1000);
}

/* Fresnel's share is in 255ths by 1/256 of N.V, whose curve falls by up to 6 (at grazing
 * views): 6 levels of 255 an entry; the sky's entry is 1/256, 2 levels of it; four
 * products are cut. */
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
        tp_stage_mirror(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const double up = before.up[i] / Q14;
            const double above = ref_clamp(1 + 4 * up, 0.5, 1);
            const double share = ref_fresnel(before.nv[i] / Q14) * s.mirror / 256 * above;
            const double e = ref_off(
                r.run.colour[i], ref_mix(ref_colour_of(before.colour[i]),
                                         ref_sky(s.sky[0], s.sky[TP_SKY], up), share));
            assert_true(e <= 6 + 2 + 4);
            measure_add(&off, e, before.nv[i], before.up[i], s.mirror);
        }
    }
    measure_print(&off);
}

static void fresnel_has_the_known_ends(void **state)
{
    (void)state;
    const tp_shade s = shade_any(&chance);
    measure off = { .what = "fresnel table", .unit = "of 1/256" };

    for (int i = 0; i <= 256; i++) {
        const double e = s.fresnel[i] - 256 * ref_fresnel(i / 256.0);
        assert_true(fabs(e) <= 1);      /* 255 stands for 1 */
        measure_add(&off, e, i, 0, 0);
    }
    measure_print(&off);
    assert_int_equal(s.fresnel[0], 255);
    assert_int_equal(s.fresnel[256], 5);        /* 0.0204 */
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(diffuse_follows_lambert),
        cmocka_unit_test(light_follows_lambert),
        cmocka_unit_test(no_slope_makes_water_brighter_than_itself),
        cmocka_unit_test(light_hands_on_view_and_mirror),
        cmocka_unit_test(glints_follow_the_phong_lobe),
        cmocka_unit_test(mirrors_show_the_sky_by_fresnel),
        cmocka_unit_test(fresnel_has_the_known_ends),
    };
    return cmocka_run_group_tests_name("light", tests, NULL, NULL);
}
