/* SPDX-License-Identifier: MIT */
/* Fresnel, reflection and refraction compared with their formulas in double precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/shading.h"
#include "tests/lib/measure.h"
#include "tests/lib/random.h"
#include "shade/optics.h"

#define Q30 1073741824.0
#define ETA (1 / 1.333)

static uint64_t chance;

/* -- Fresnel shares ---------------------------------------------------------------- */

static void fresnel_is_the_exact_formula(void **state)
{
    (void)state;
    measure m = { .what = "tp_fresnel", .unit = "" };

    for (int32_t c = 0; c <= TP_Q30_ONE - 1021; c += 1021)
        measure_add(&m, tp_fresnel(c) / Q30 - ref_fresnel(c / Q30), c, 0, 0);
    measure_print(&m);
    assert_true(m.worst < 0x1p-28);
    assert_int_equal(tp_fresnel(0), TP_Q30_ONE);
    assert_true(fabs(tp_fresnel(TP_Q30_ONE) / Q30 - 0.0203731883) < 1e-8);
}

static void a_cosine_outside_its_range_is_held(void **state)
{
    (void)state;
    const tp_q30 beyond[] = { TP_Q30_ONE + 1, INT32_MAX, -1, INT32_MIN };

    for (int i = 0; i < 4; i++) {
        const tp_q30 held = i < 2 ? TP_Q30_ONE : 0;
        assert_int_equal(tp_fresnel(beyond[i]), tp_fresnel(held));
        assert_int_equal(tp_fresnel_schlick(beyond[i]), tp_fresnel_schlick(held));
    }
}

/* [F2] states the largest error of Schlick's rule: 0.059, at 83.8 degrees. */
static void schlick_is_his_rule_and_as_far_off_as_the_models_say(void **state)
{
    (void)state;
    measure rule = { .what = "schlick", .unit = "" };
    measure off = { .what = "schlick - exact", .unit = "" };

    for (int32_t c = 0; c <= TP_Q30_ONE - 10007; c += 10007) {
        const double r0 = pow(0.333 / 2.333, 2), got = tp_fresnel_schlick(c) / Q30;
        measure_add(&rule, got - r0 - (1 - r0) * pow(1 - c / Q30, 5), c, 0, 0);
        measure_add(&off, got - ref_fresnel(c / Q30), c, 0, 0);
    }
    measure_print(&rule);
    measure_print(&off);
    assert_true(rule.worst < 0x1p-28);
    assert_true(fabs(off.worst - 0.059) < 0.0005);
    assert_true(fabs((double)off.at[0] / Q30 - cos(83.8 * 3.14159265 / 180)) < 0.002);
    assert_int_equal(tp_fresnel_schlick(0), TP_Q30_ONE);
}

/* -- directions -------------------------------------------------------------------- */

static tp_dir3 any_direction(void)
{
    return tp_normalise(random_number(&chance), random_number(&chance),
                        random_number(&chance));
}

/* A direction nearly perpendicular to `normal`: within 2^-12 of grazing, on either side. */
static tp_dir3 grazing(tp_dir3 normal)
{
    const tp_dir3 across = tp_dir3_cross(normal, any_direction());
    const int32_t lift = chance_int(&chance, -4096, 4096) * 64;

    return tp_normalise(across.x + tp_q30_mul(normal.x, lift),
                        across.y + tp_q30_mul(normal.y, lift),
                        across.z + tp_q30_mul(normal.z, lift));
}

static ref_dir ref_of(tp_dir3 d)
{
    return (ref_dir){ d.x / Q30, d.y / Q30, d.z / Q30 };
}

/* in a + n b */
static ref_dir ref_sum(ref_dir in, double a, ref_dir n, double b)
{
    return (ref_dir){ in.x * a + n.x * b, in.y * a + n.y * b, in.z * a + n.z * b };
}

static double apart(tp_dir3 got, ref_dir want)
{
    const ref_dir g = ref_of(got);
    return fmax(fabs(g.x - want.x), fmax(fabs(g.y - want.y), fabs(g.z - want.z)));
}

static double length_error(tp_dir3 d)
{
    const ref_dir v = ref_of(d);
    return sqrt(ref_dir_dot(v, v)) - 1;
}

enum { RAYS = 300000 };

static void rays_are_those_of_the_formulas(void **state)
{
    (void)state;
    measure m[4] = { { .what = "tp_reflect", .unit = "" },
                     { .what = "tp_refract", .unit = "" },
                     { .what = "|reflected| - 1", .unit = "" },
                     { .what = "|refracted| - 1", .unit = "" } };

    for (int i = 0; i < RAYS; i++) {
        const tp_dir3 n = any_direction(), in = i % 3 ? any_direction() : grazing(n);
        const tp_dir3 r = tp_reflect(in, n), t = tp_refract(in, n);
        const ref_dir rin = ref_of(in), rn = ref_of(n);
        const double ci = -ref_dir_dot(rin, rn), ct = sqrt(1 - ETA * ETA * (1 - ci * ci));
        const ref_dir bent = ref_sum(rin, ETA, rn, ETA * ci - ct);
        measure_add(&m[0], apart(r, ref_sum(rin, 1, rn, 2 * ci)), in.x, in.y, in.z);
        measure_add(&m[1], apart(t, bent), in.x, in.y, in.z);
        measure_add(&m[2], length_error(r), in.x, in.y, in.z);
        measure_add(&m[3], length_error(t), in.x, in.y, in.z);
        assert_true(-ref_dir_dot(ref_of(t), rn) > 0.661);   /* into the water */
    }
    for (int i = 0; i < 4; i++) {
        measure_print(&m[i]);
        assert_true(m[i].worst < 0x1p-26);
    }
}

static void light_from_above_is_not_bent(void **state)
{
    (void)state;
    const tp_dir3 up = { 0, TP_Q30_ONE, 0 }, down = { 0, -TP_Q30_ONE, 0 };
    const tp_dir3 r = tp_reflect(down, up), t = tp_refract(down, up);

    assert_memory_equal(&r, &up, sizeof up);
    assert_true(t.x == 0 && t.z == 0 && tp_abs(t.y + TP_Q30_ONE) <= 1);
}

/* The sine of the refracted angle is that of the incident angle over 1.333, so an object at
 * a depth appears at three quarters of the depth. */
static void a_floor_seen_from_above_appears_at_three_quarters(void **state)
{
    (void)state;
    const tp_dir3 up = { 0, TP_Q30_ONE, 0 };
    const tp_dir3 in = tp_normalise(TP_Q30(0.01), -TP_Q30_ONE, TP_Q30(-0.02));
    const tp_floor_offset at = tp_refract_offset(tp_refract(in, up), 8 * TP_FX_ONE);

    assert_true(fabs(at.x / 65536.0 - 0.08 / 1.333) < 3e-5);
    assert_true(fabs(at.z / 65536.0 + 0.16 / 1.333) < 3e-5);
}

static void offsets_are_quotients_and_saturate(void **state)
{
    (void)state;
    measure m = { .what = "offset", .unit = "LSB" };

    for (int i = 0; i < RAYS; i++) {
        const tp_dir3 t = any_direction();
        const tp_fx depth = random_number(&chance);
        const tp_floor_offset at = tp_refract_offset(t, depth);
        const double want = t.y < 0 ? -(double)depth * t.x / t.y : t.x * 1e12;
        const double held = ref_clamp(want, TP_FX_MIN, TP_FX_MAX);
        measure_add(&m, at.x - held, t.x, t.y, depth);
    }
    measure_print(&m);
    assert_true(m.worst < 0.500001);        /* the reference has 53 bits */
    const tp_floor_offset flat = tp_refract_offset((tp_dir3){ -TP_Q30_ONE, 0, 0 }, 1);
    assert_true(flat.x == TP_FX_MIN && flat.z == 0);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fresnel_is_the_exact_formula),
        cmocka_unit_test(a_cosine_outside_its_range_is_held),
        cmocka_unit_test(schlick_is_his_rule_and_as_far_off_as_the_models_say),
        cmocka_unit_test(rays_are_those_of_the_formulas),
        cmocka_unit_test(light_from_above_is_not_bent),
        cmocka_unit_test(a_floor_seen_from_above_appears_at_three_quarters),
        cmocka_unit_test(offsets_are_quotients_and_saturate),
    };
    return cmocka_run_group_tests_name("shade/optics", tests, NULL, NULL);
}
