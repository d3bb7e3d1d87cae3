/* SPDX-License-Identifier: MIT */
/* Deep water compared with the models in double precision: any legal waves, at any
 * position, at any tick of ten years, and the tables of tests/vectors.  The test prints the
 * errors. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/deep_water.h"
#include "tests/lib/vectors.h"

static uint64_t chance;

static void any_legal_sea_follows_the_models(void **state)
{
    (void)state;
    errors e = errors_of("any height", "any place", "any normal");

    for (int n = 0; n < 2000; n++) {
        const deep_water o = deep_water_any(&chance, TP_WAVES);
        for (int k = 0; k < 20; k++)
            deep_water_compare(&o, chance_fx(&chance, -24000, 24000),
                               chance_fx(&chance, -24000, 24000), &e);
    }
    errors_print(&e);
}

/* [G4] allows .13 mm and .01 degrees for eight waves; the heights here add up to 8 x 2 m at
 * most.  Beyond the steepness 0.7 of [A10] the surface is nearly vertical at its crests,
 * and errors grow as 1 / (1 - steepness). */
static void usual_seas_keep_the_error_budget(void **state)
{
    (void)state;
    errors e = errors_of("usual height", "usual place", "usual normal");

    for (int n = 0; n < 2000; n++) {
        const deep_water o = deep_water_usual(&chance, 8, chance_double(&chance, 0, 0.7));
        for (int k = 0; k < 20; k++)
            deep_water_compare(&o, chance_fx(&chance, -500, 500),
                               chance_fx(&chance, -500, 500), &e);
    }
    errors_print(&e);
    assert_true(e.height.worst < 0.13);
    assert_true(e.normal.worst < 0.01);
}

/* [A10]: the error from omitting the cross terms, where the deep water omits the terms: two
 * waves and many waves, with Q = 1, any Q, and a high wave of low steepness beside waves of
 * the opposite kind. */
static void normals_without_cross_terms_are_within_a_degree_and_a_half(void **state)
{
    (void)state;
    measure normal[3] = { { .what = "uncrossed, Q = 1", .unit = "degrees" },
                          { .what = "uncrossed, any Q", .unit = "degrees" },
                          { .what = "uncrossed, apart", .unit = "degrees" } };

    for (int n = 0; n < 9000; n++) {
        const double steepness = chance_scale(&chance, 0.02, 0.3) * LSB;
        deep_water o = deep_water_usual(&chance, n % 2 ? 2 : TP_WAVES, steepness);
        for (int i = 0; i < o.count && n % 3 == 0; i++)
            o.wave[i].amplitude = (tp_fx)(o.wave[i].steepness * (o.wave[i].length * LSB)
                                          / (2 * PI));
        if (n % 3 == 2)
            o.wave[0].steepness = 0;
        for (int i = 1; i < o.count && n % 3 == 2; i++)
            o.wave[i].amplitude = 1;
        if (n % 6 == 4)
            deep_water_sharpen(&chance, &o);
        deep_water_settle(&o);
        for (int k = 0; k < 20 && !o.deep.crossed; k++) {
            const tp_fx x = chance_fx(&chance, -500, 500);
            const tp_fx z = chance_fx(&chance, -500, 500);
            const ref_point want = ref_at_rest(&o.ref, o.ref_phases, x * LSB, z * LSB);
            const tp_surface_point got =
                tp_deep_water_displace_point(&o.deep, o.phases, x, z);
            measure_add(&normal[n % 3], normal_angle(&want, &got) * 180 / PI, o.count, x,
                        z);
        }
    }
    for (int i = 0; i < 3; i++) {
        measure_print(&normal[i]);
        assert_true(normal[i].worst < 1.5);
        assert_true(normal[i].worst > 0.1);
    }
}

static bool crossed(tp_fx a, tp_fx b, uint32_t count)
{
    const tp_wave waves[2] = { { TP_FX_ONE, 20 * TP_FX_ONE, a, 0, 0, 0, 0 },
                               { TP_FX(0.1), 20 * TP_FX_ONE, b, 0, 0, 0, 0 } };
    tp_deep_water deep;
    tp_deep_water_init(&deep, waves, count, TP_FX(9.81));
    return deep.crossed;
}

/* k A is 0.314 and 0.0314: together the waves turn normals by the greater of 0.0314 a and
 * 0.314 b, over 1 - a - b; the limit is 0.026. */
static void cross_terms_are_taken_where_they_count(void **state)
{
    (void)state;
    assert_false(crossed(TP_FX(0.9), 0, 1));
    assert_false(crossed(0, 0, 2));
    assert_false(crossed(TP_FX(0.29), TP_FX(0.009), 2));
    assert_true(crossed(TP_FX(0.29), TP_FX(0.011), 2));
    assert_false(crossed(TP_FX(0.1), TP_FX(0.067), 2));
    assert_true(crossed(TP_FX(0.1), TP_FX(0.071), 2));
}

/* -- tables -------------------------------------------------------------------------- */

static void point_errors(const tp_surface_point *got, const double place[3],
                         const double normal[3], int row, errors *e)
{
    measure_add(&e->height, row_error(got->position.y, place[1]) * 1000, row, 0, 0);
    measure_add(&e->place, row_error(got->position.x, place[0]) * 1000, row, 0, 0);
    measure_add(&e->place, row_error(got->position.z, place[2]) * 1000, row, 0, 0);
    measure_add(&e->normal, row_angle(got, normal), row, 0, 0);
}

static void within_budget(const errors *e)
{
    errors_print(e);
    assert_true(e->height.worst < 0.25);
    assert_true(e->place.worst < 0.25);
    assert_true(e->normal.worst < 0.02);
}

/* [A7][A8]: L, S, Dx, Dz, x0, z0, t; then the point and its normal.  Q = 1. */
static void single_waves_follow_the_table(void **state)
{
    (void)state;
    errors e = errors_of("single height", "single place", "single normal");
    vector_table r = rows_of("gerstner_single");

    while (rows_next(&r)) {
        const double *const at = r.at, k = TURN / at[0];
        r.waves = at[1] > 0;            /* without steepness no amplitude */
        r.wave[0] = (row_wave){ k, sqrt(9.81 * k), at[2], at[3], 0, at[1] / k, 1 };
        tp_deep_water deep;
        tp_turn phases[TP_WAVES];
        rows_sea(&r, 1, &deep);
        rows_phases(&r, at[6], phases);
        const tp_surface_point got =
            tp_deep_water_displace_point(&deep, phases, row_fx(at[4]), row_fx(at[5]));
        point_errors(&got, at + 7, at + 10, r.rows, &e);
    }
    assert_int_equal(r.rows, 200);
    within_budget(&e);
}

/* [A9][A10]: x0, z0, t; then the point and its normal. */
static void sums_of_gerstner_waves_follow_the_table(void **state)
{
    (void)state;
    errors e = errors_of("sum height", "sum place", "sum normal");
    vector_table r = rows_of("gerstner_sum");
    tp_deep_water deep;
    tp_turn phases[TP_WAVES];

    while (rows_next(&r)) {
        rows_sea(&r, 1, &deep);
        rows_phases(&r, r.at[2], phases);
        const tp_surface_point got =
            tp_deep_water_displace_point(&deep, phases, row_fx(r.at[0]), row_fx(r.at[1]));
        point_errors(&got, r.at + 3, r.at + 6, r.rows, &e);
    }
    assert_int_equal(r.rows, 200);
    assert_true(deep.crossed);
    within_budget(&e);
}

/* [A1][A2]: x, z, t; then the height, its slopes and the normal. */
static void sums_of_sines_follow_the_table(void **state)
{
    (void)state;
    errors e = errors_of("sines' height", "sines' place", "sines' normal");
    measure slope = { .what = "sines' slope", .unit = "m/m" };
    vector_table r = rows_of("sum_of_sines");
    tp_deep_water deep;
    tp_turn phases[TP_WAVES];

    while (rows_next(&r)) {
        rows_sea(&r, 0, &deep);
        rows_phases(&r, r.at[2], phases);
        const tp_surface_point got =
            tp_deep_water_displace_point(&deep, phases, row_fx(r.at[0]), row_fx(r.at[1]));
        const double place[3] = { r.at[0], r.at[3], r.at[1] };
        point_errors(&got, place, r.at + 6, r.rows, &e);
        measure_add(&slope, row_error(got.slope_x, r.at[4]), r.rows, 0, 0);
        measure_add(&slope, row_error(got.slope_z, r.at[5]), r.rows, 0, 0);
    }
    assert_int_equal(r.rows, 150);
    measure_print(&slope);
    assert_true(slope.worst < 5e-5);
    within_budget(&e);
}

/* [G1][G5]: the phase; then sine and cosine, and both in 16.16. */
static void sines_follow_the_table(void **state)
{
    (void)state;
    measure sine = { .what = "sine", .unit = "LSB" };
    vector_table r = rows_of("sine");

    while (rows_next(&r)) {
        const tp_turn phase = (tp_turn)r.at[0];
        measure_add(&sine, tp_fx_sin(phase) - r.at[1] * 65536, phase, 0, 0);
        measure_add(&sine, tp_fx_cos(phase) - r.at[2] * 65536, phase, 0, 0);
        assert_true(abs(tp_fx_sin(phase) - (int)r.at[3]) <= 1);
        assert_true(abs(tp_fx_cos(phase) - (int)r.at[4]) <= 1);
    }
    assert_int_equal(r.rows, 250);
    measure_print(&sine);
    assert_true(sine.worst <= 1);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_legal_sea_follows_the_models),
        cmocka_unit_test(usual_seas_keep_the_error_budget),
        cmocka_unit_test(normals_without_cross_terms_are_within_a_degree_and_a_half),
        cmocka_unit_test(cross_terms_are_taken_where_they_count),
        cmocka_unit_test(single_waves_follow_the_table),
        cmocka_unit_test(sums_of_gerstner_waves_follow_the_table),
        cmocka_unit_test(sums_of_sines_follow_the_table),
        cmocka_unit_test(sines_follow_the_table),
    };
    return cmocka_run_group_tests_name("waves/gerstner", tests, NULL, NULL);
}
