/* SPDX-License-Identifier: MIT */
/* The phase under wind compared with the models' vectors and with its equation. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/random.h"
#include "tests/lib/vectors.h"
#include "waves/coastal_water.h"

#define LSB    (1 / 65536.0)
#define TWO_PI 6.28318530717958647693

static uint64_t chance;

static tp_turn turn_of(double radians)
{
    return (tp_turn)(int64_t)llround(remainder(radians, TWO_PI) / TWO_PI * 4294967296.0);
}

/* Phi - theta, radians. */
static double ahead(tp_turn phi, tp_turn theta)
{
    return (int32_t)(phi - theta) / 4294967296.0 * TWO_PI;
}

/* Each iterate with its own column: r, lambda, theta, phi, phi_it1, phi_it2, phi_it3. */
static void iterates_follow_their_vectors(void **state)
{
    (void)state;
    FILE *const file = fopen("tests/vectors/wind_phase.csv", "r");
    measure m = { .what = "iterates", .unit = "rad" };
    double v[7];
    int64_t rows = 0;

    assert_non_null(file);
    while (csv_row(file, v, 7) == 7) {
        const tp_q30 push = tp_wind_phase_shift((tp_fx)lround(v[1] * 65536),
                                         (tp_fx)lround(v[0] * 65536));
        const tp_turn theta = turn_of(v[2]);
        for (int n = 1; n <= 3; n++) {
            const double got = ahead(tp_wind_phase(theta, push, n), theta);
            measure_add(&m, remainder(got - (v[3 + n] - v[2]), TWO_PI), rows, n, 0);
        }
        rows++;
    }
    fclose(file);
    measure_print(&m);
    assert_int_equal(rows, 150);
    assert_true(m.worst < 0.001);
}

/* The root by 60 iterations in double precision; after n iterations the error is
 * |push|^(n+1), plus 5e-6 of the sines. */
static void iterates_close_in_on_the_root(void **state)
{
    (void)state;
    measure m = { .what = "of what may be left", .unit = "" };
    measure rule = { .what = "by the rule", .unit = "rad" };

    for (int i = 0; i < 20000; i++) {
        const double push = chance_double(&chance, -0.5, 0.5);
        const tp_q30 push_q30 = (tp_q30)lround(push * 1073741824);
        const tp_turn theta = (tp_turn)random_next(&chance);
        const double th = theta / 4294967296.0 * TWO_PI;
        double root = th;

        for (int n = 0; n < 60; n++)
            root = th + push * cos(root);
        for (int n = 0; n < 6; n++) {
            const double left = ahead(tp_wind_phase(theta, push_q30, n), theta)
                              - (root - th);
            measure_add(&m, left / (pow(fabs(push), n + 1) + 5e-6), theta, push_q30, n);
        }
        const int n = tp_wind_iterations(push_q30);
        const tp_turn phi = tp_wind_phase(theta, push_q30, n);
        measure_add(&rule, ahead(phi, theta) - (root - th), theta, push_q30, n);
    }
    measure_print(&m);
    measure_print(&rule);
    assert_true(m.worst <= 1);
    assert_true(rule.worst < 0.091);                /* 0.3^2; 0.5^4 is less */
}

static void strong_winds_are_iterated_three_times(void **state)
{
    (void)state;
    assert_int_equal(tp_wind_iterations(0), 1);
    assert_int_equal(tp_wind_iterations(TP_Q30(0.3)), 1);
    assert_int_equal(tp_wind_iterations(TP_Q30(0.3) + 1), 3);
    assert_int_equal(tp_wind_iterations(-TP_Q30(0.3)), 1);
    assert_int_equal(tp_wind_iterations(INT32_MIN), 3);
    assert_int_equal(tp_wind_iterations(INT32_MAX), 3);
}

static void a_push_is_held_at_half_a_radian(void **state)
{
    (void)state;
    const tp_q30 half = TP_Q30(0.5);

    assert_int_equal(tp_wind_phase_shift(TP_FX(0.25), TP_FX(2)), half);
    assert_int_equal(tp_wind_phase_shift(TP_FX(0.25), TP_FX(1.5)), TP_Q30(0.375));
    assert_int_equal(tp_wind_phase_shift(TP_FX(0.25), TP_FX(2.5)), half);
    assert_int_equal(tp_wind_phase_shift(TP_FX(-0.25), TP_FX(2.5)), -half);
    assert_int_equal(tp_wind_phase_shift(TP_FX_MIN, TP_FX_MIN), half);
    assert_int_equal(tp_wind_phase_shift(TP_FX_MIN, TP_FX_MAX), -half);
    for (int i = 0; i < 1000; i++) {
        const tp_turn theta = (tp_turn)random_next(&chance);
        assert_int_equal(tp_wind_phase(theta, INT32_MAX, 3),
                         tp_wind_phase(theta, half, 3));
        assert_int_equal(tp_wind_phase(theta, INT32_MIN, 3),
                         tp_wind_phase(theta, -half, 3));
        assert_int_equal(tp_wind_phase(theta, 0, 3), theta);
        assert_int_equal(tp_wind_phase(theta, half, -1), theta);
        assert_int_equal(tp_wind_phase(theta, half, INT32_MAX),
                         tp_wind_phase(theta, half, 1000));
    }
}

/* dy = -r cos Phi: the trough is at Phi = 0, the crest at pi.  The point with theta = pi is
 * behind the crest, which has moved on to theta = pi + push: phases grow ahead. */
static void crests_run_ahead_and_troughs_lag(void **state)
{
    (void)state;
    const tp_q30 push = TP_Q30(0.25);
    const double trough = ahead(tp_wind_phase(0, push, 32), 0);
    const double crest = ahead(tp_wind_phase(0x80000000u, push, 32), 0x80000000u);

    assert_true(trough > 0.2 && crest < -0.2);
    assert_true(fabs(trough + crest) < 1e-5);
}

/* After convergence Phi grows with theta for every permitted push, so crests keep their
 * order.  A step of 2^20 is 1.5e-3 rad; sines err by 5e-6. */
static void phases_stay_in_order(void **state)
{
    (void)state;
    for (int push = -8; push <= 8; push++) {
        const tp_q30 q30 = push * (TP_Q30_ONE / 16);
        for (uint32_t theta = 0; theta < 0xfff00000u; theta += 1u << 20) {
            const tp_turn a = tp_wind_phase(theta, q30, 32);
            const tp_turn b = tp_wind_phase(theta + (1u << 20), q30, 32);
            assert_true((int32_t)(b - a) > 0);
        }
    }
}

static void wind_pushes_what_travels_with_it(void **state)
{
    (void)state;
    const tp_fx lambda = TP_FX(0.176);

    assert_int_equal(tp_wind_lambda(lambda, TP_Q30_ONE), lambda);
    assert_int_equal(tp_wind_lambda(lambda, TP_Q30_ONE / 2), lambda / 2);
    assert_int_equal(tp_wind_lambda(lambda, 0), 0);
    assert_int_equal(tp_wind_lambda(lambda, -TP_Q30_ONE), 0);
    assert_int_equal(tp_wind_lambda(TP_FX_MIN, INT32_MAX), TP_FX_MIN);
    assert_int_equal(tp_wind_lambda(TP_FX_MAX, INT32_MIN), 0);
}

static void radii_leave_no_loop(void **state)
{
    (void)state;
    measure m = { .what = "radius", .unit = "LSB, 2^-24" };

    for (int i = 0; i < 20000; i++) {
        const int64_t k = tp_depth_wave_number_deep(chance_scale(&chance, 0.25, 2000));
        const tp_fx lambda = chance_fx(&chance, -4, 4);
        const double want = 0.95 / hypot((double)k / 4294967296.0, lambda * LSB);
        measure_add(&m, fabs(tp_wind_max_radius(k, lambda) * LSB - want)
                        / (LSB / 2 + want / 16777216), k, lambda, 0);
    }
    measure_print(&m);
    assert_true(m.worst < 1.1);
    assert_int_equal(tp_wind_max_radius(0, 0), TP_FX_MAX);
    assert_int_equal(tp_wind_max_radius(INT64_MIN, 0), TP_FX_MAX);
    assert_int_equal(tp_wind_max_radius(INT64_MIN, TP_FX_ONE), TP_FX(0.95));
    assert_int_equal(tp_wind_max_radius(INT64_MAX, TP_FX_MIN), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(iterates_follow_their_vectors),
        cmocka_unit_test(iterates_close_in_on_the_root),
        cmocka_unit_test(strong_winds_are_iterated_three_times),
        cmocka_unit_test(a_push_is_held_at_half_a_radian),
        cmocka_unit_test(crests_run_ahead_and_troughs_lag),
        cmocka_unit_test(phases_stay_in_order),
        cmocka_unit_test(wind_pushes_what_travels_with_it),
        cmocka_unit_test(radii_leave_no_loop),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("waves/wind", tests, NULL, NULL);
}
