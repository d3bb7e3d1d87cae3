/* SPDX-License-Identifier: MIT */
/* Light on water compared with Phong and Fresnel in double precision.  Errors are in levels
 * of 255; shares are truncated (up to a level), products and mixes of colours are
 * rounded. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/shading.h"
#include "tidepool/modules.h"

static uint64_t chance;

static ref_dir view_of(const test_run *r, int i)
{
    return (ref_dir){ r->run.vx[i] / Q14, r->run.vy[i] / Q14, r->run.vz[i] / Q14 };
}

static ref_dir normal_of(const test_run *r, int i)
{
    return ref_normal(run_sx(r, i), run_sz(r, i));
}

/* Every second span has slopes up to 2 in total, the end of the root's table; the other
 * spans have slopes as steep as 16 bits allow, where the table is used up to three
 * times. */
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
            const ref_dir normal = normal_of(&r, i);
            const double ambient = s.ambient / 256.0;
            const double nl = fmax(0, ref_dir_dot(normal, shade_light(&s.world)));
            const double e = ref_colour_difference(r.run.colour[i],
                                     ref_scale(ref_colour_unpack(before.colour[i]),
                                               ambient + (1 - ambient) * fmin(nl, 1)));
            assert_true(e <= most);
            measure_add(off, e, (int32_t)r.n[i], s.ambient, s.world.ly);
        }
    }
    measure_print(off);
}

/* The share in 256ths is truncated (a level), the product rounded (half a level); the
 * root's nearest entry of 1/128 errs by 0.2 % (half a level). */
static void diffuse_follows_lambert(void **state)
{
    (void)state;
    measure off = { .what = "diffuse", .unit = "levels" };
    compare_diffuse(tp_stage_diffuse, &off, 2);
}

/* The same with an interpolated root. */
static void light_follows_lambert(void **state)
{
    (void)state;
    measure off = { .what = "light", .unit = "levels" };
    compare_diffuse(tp_stage_light, &off, 1.6);
}

/* Waves and ripples may be as steep as 16 bits allow.  No colour gets brighter than the
 * input: a share above 1 would carry from one channel into the next. */
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
            const ref_colour was = ref_colour_unpack(before.colour[i]);
            const ref_colour is = ref_colour_unpack(r.run.colour[i]);
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

/* N.V and the height of the reflected view, for eyes above the water. */
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
            const ref_dir v = view_of(&r, i), normal = normal_of(&r, i);
            const double nv = ref_clamp(ref_dir_dot(normal, v), 0, 1);
            const double up = ref_clamp(2 * nv * normal.y - v.y, -1, 1);
            /* The root is truncated in its table and between its entries, 2 units, times a
             * sum of up to 2.2 with a truncation of 1; the product adds one more: 7 units.
             * The height is twice nv ny, with the root's 2 again and two more truncations:
             * 20. */
            assert_true(fabs(r.run.nv[i] / Q14 - nv) <= 7 / Q14);
            assert_true(fabs(r.run.up[i] / Q14 - up) <= 20 / Q14);
            measure_add(&nv_off, (r.run.nv[i] / Q14 - nv) * Q14, (int32_t)r.n[i], 0, 0);
            measure_add(&up_off, (r.run.up[i] / Q14 - up) * Q14, (int32_t)r.n[i], 0, 0);
        }
    }
    measure_print(&nv_off);
    measure_print(&up_off);
}

/* A span lit with a lobe of random strength and shininess. */
typedef struct {
    tp_shade s;
    test_run r;
    double   strength;
    int      shininess;
} shiny;

static void light_any(shiny *x, bool blinn, int most)
{
    x->s = shade_any(&chance);
    x->strength = chance_double(&chance, 0, 4);
    x->shininess = chance_int(&chance, 1, most);
    (blinn ? tp_shade_shine_blinn : tp_shade_shine)(
        shade_shine, x->shininess * TP_FX_ONE, (tp_fx)(x->strength * 65536));
    run_any(&x->r, 2000, &chance);
    tp_stage_view(&x->s, &x->r.run);
    (blinn ? tp_stage_light_blinn : tp_stage_light)(&x->s, &x->r.run);
}

/* Asserts that the glint is between two powers of the lobe, with a tolerance of two levels;
 * returns 1 if the glint is visible. */
static int assert_glint(const shiny *x, int i, double low, double high)
{
    assert_true(x->r.run.glint[i] >= low * x->strength * 256 - 2);
    assert_true(x->r.run.glint[i] <= high * x->strength * 256 + 2);
    return x->r.run.glint[i] > 0;
}

/* The glint lies between the lobes of a slightly smaller and a slightly larger R.V: the
 * table has 1024 entries; R.V is 2 N.L N.V - L.V, where N.L and N.V are right to 7 units of
 * 1/16384: 30 in all. */
static void glints_follow_the_phong_lobe(void **state)
{
    (void)state;
    int lit = 0;

    for (int n = 0; n < 2000; n++) {
        shiny x;
        light_any(&x, false, n % 2 ? 1000 : 30);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir normal = normal_of(&x.r, i), l = shade_light(&x.s.world);
            const double nv = ref_clamp(ref_dir_dot(normal, view_of(&x.r, i)), 0, 1);
            const double nl = ref_clamp(ref_dir_dot(normal, l), 0, 1);
            const double rv = 2 * nl * nv - x.r.run.lv[i] / Q14;
            if (fabs(rv) < 30 / Q14 || nl < 10 / Q14)
                continue;
            const double low = ref_clamp(rv - 1 / 1024.0 - 30 / Q14, 0, 1);
            const double high = ref_clamp(rv + 30 / Q14, 0, 1);
            lit += assert_glint(&x, i, pow(low, x.shininess), pow(high, x.shininess));
        }
    }
    assert_true(lit > 1000);
}

/* Blinn's lobe, (N.H)^(4 n): N.L, N.V and L.V are right to 7, 7 and 2 units of 1/16384, and
 * V is up to 13 units short between its columns.  All is divided by half of |L + V|^2,
 * which is 0 for light from behind.  The table has 1024 entries. */
static void blinn_glints_follow_the_half_vector(void **state)
{
    (void)state;
    int lit = 0;

    for (int n = 0; n < 2000; n++) {
        shiny x;
        light_any(&x, true, n % 2 ? 300 : 20);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = view_of(&x.r, i), l = shade_light(&x.s.world);
            const ref_dir normal = normal_of(&x.r, i);
            const double nl = ref_dir_dot(normal, l), nv = ref_dir_dot(normal, v);
            const ref_dir h = ref_unit((ref_dir){ l.x + v.x, l.y + v.y, l.z + v.z });
            const double nh = ref_dir_dot(normal, h), lv = ref_dir_dot(l, v);
            const double c = 2 * nh * nh - 1, half = 1 + lv;
            const double e = (40 * sqrt(2 / half) + 80 / half) / Q14;
            if (nl < 10 / Q14 || nv < 0 || c < 0.1 || half < 1 / 32.0)
                continue;
            const double low = (1 + ref_clamp(c - 1 / 1024.0 - e, 0, 1)) / 2;
            const double high = (1 + ref_clamp(c + e, 0, 1)) / 2;
            lit += assert_glint(&x, i, pow(low, 2 * x.shininess),
                                pow(high, 2 * x.shininess));
        }
    }
    assert_true(lit > 1000);
}

/* The lobe of rippled water equals the lobe of smooth water with the same slopes, for any
 * N.V in the Fresnel share. */
static void ripples_glint_as_their_slopes_say(void **state)
{
    (void)state;
    for (int n = 0; n < 1000; n++) {
        tp_shade s = shade_any(&chance);
        test_run r;
        tp_shade_shine(shade_shine, 20 * TP_FX_ONE, TP_FX_ONE);
        run_any(&r, 4000, &chance);
        tp_stage_view(&s, &r.run);
        tp_stage_slopes(&s, &r.run);
        tp_run bent = r.run;
        tp_stage_light(&s, &r.run);
        tp_stage_light_rippled(&s, &bent);
        assert_memory_equal(bent.glint, r.run.glint, sizeof bent.glint);
        assert_memory_equal(bent.colour, r.run.colour, sizeof bent.colour);
    }
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
        cmocka_unit_test(blinn_glints_follow_the_half_vector),
        cmocka_unit_test(ripples_glint_as_their_slopes_say),
    };
    return cmocka_run_group_tests_name("features/water light", tests, NULL, NULL);
}
