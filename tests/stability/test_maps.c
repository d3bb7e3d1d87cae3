/* SPDX-License-Identifier: MIT */
/* The stability maps of assets/charts: measured borders agree with the theory. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/charts/stability.h"

/* -- crests that fold [A11] ---------------------------------------------------------- */

#define ROUNDING 1e-6           /* by the engine's sines and sums, Q8.24 */

/* Bound of the difference between the sweep's minimum and the minimum where all crests
 * meet, as a share of the sum. */
static const struct {
    int    waves;
    double fan, share;
} swept[] = {
    { 1, 0, 1e-5 }, { 2, 0, 1e-4 }, { 4, 0, 0.01 }, { 8, 0, 0.25 }, { 2, 120, 1e-4 },
    { 4, 120, 0.005 },
};
enum { SWEPT = sizeof swept / sizeof *swept };

static void the_jacobian_falls_to_where_all_crests_meet(void **state)
{
    (void)state;
    for (int n = 0; n < SWEPT; n++)
        for (double sum = 0.3; sum < 1.9; sum += 0.4) {
            const tp_deep_water deep =
                stability_sea_unheld(swept[n].waves, swept[n].fan, sum);
            const double theory = stability_crests(&deep), least = stability_least(&deep);
            if (swept[n].fan == 0)              /* a wave's share is halved and truncated */
                assert_true(fabs(theory - (1 - sum))
                            < 1.5 * swept[n].waves * STABILITY_LSB + ROUNDING);
            assert_true(least > theory - ROUNDING);
            assert_true(least < theory + swept[n].share * sum + ROUNDING);
        }
}

/* A single wave and two waves of one direction reach 1 - sum, to the rounding of the
 * requested sum. */
static void loops_begin_at_a_sum_of_1(void **state)
{
    (void)state;
    for (int waves = 1; waves <= 2; waves++) {
        const tp_deep_water before = stability_sea_unheld(waves, 0, 0.999);
        const tp_deep_water after = stability_sea_unheld(waves, 0, 1.001);
        assert_true(stability_least(&before) > 0);
        assert_true(stability_least(&after) < 0);
    }
}

/* Deep water without the clamp equals the engine's own where the engine does not clamp. */
static void the_clamp_leaves_a_twentieth_of_the_jacobian(void **state)
{
    (void)state;
    for (int n = 0; n < SWEPT; n++)
        for (double sum = 0.5; sum < 1.9; sum += 0.3) {
            const tp_deep_water deep = stability_sea(swept[n].waves, swept[n].fan, sum);
            const tp_deep_water unheld = stability_sea_unheld(swept[n].waves, swept[n].fan,
                                                       fmin(sum, 0.95));
            const double least = stability_least(&deep);
            assert_true(least > 0.05 - ROUNDING);
            assert_true(fabs(least - stability_least(&unheld)) < 1e-4);
        }
}

/* Position along the first wave's direction of a point that rests `from` m beyond a
 * crest. */
static double moved_along(const tp_deep_water *deep, double from)
{
    const tp_swell *w = &deep->swell[0];
    const tp_turn phases[TP_WAVES] = { 0x40000000 };
    const double x = (double)w->turns_x, z = (double)w->turns_z, turns = hypot(x, z);
    const tp_vec3 p =
        tp_deep_water_sample_iterated(deep, phases, TP_FX(from * x / turns),
                                         TP_FX(from * z / turns), 0)
            .position;

    return (p.x * x + p.z * z) / turns * STABILITY_LSB;
}

/* Two neighbour points at a crest approach each other as the Jacobian gives, and pass each
 * other. */
static void points_fold_where_the_jacobian_is_below_0(void **state)
{
    (void)state;
    const double near = 1 / 64.0;

    for (double sum = 0.1; sum < 1.9; sum += 0.1) {
        const tp_deep_water deep = stability_sea_unheld(1, 0, sum);
        const double apart = moved_along(&deep, near) - moved_along(&deep, -near);
        assert_true(fabs(apart / (2 * near) - (1 - sum)) < 0.003);
    }
}

/* -- breaking [B14] [B15] ------------------------------------------------------------ */

static uint32_t flags_at(int i, int j)
{
    return stability_flags(stability_rise(i), stability_depth(j));
}

/* Heights between the limits in 16.16 m, at least 8000 units; bisection finds the
 * border. */
static void criteria_begin_where_the_theory_says(void **state)
{
    (void)state;
    for (int c = 0; c < STABILITY_CRITERIA; c++)
        for (int j = 0; j < STABILITY_DEPTHS; j++) {
            double low = 0.001, high = 1;
            for (int n = 0; n < 40; n++) {
                const double rise = (low + high) / 2;
                if (stability_flags(rise, stability_depth(j)) >> c & 1)
                    high = rise;
                else
                    low = rise;
            }
            assert_true(fabs(low / stability_border(c, stability_depth(j)) - 1) < 3e-4);
        }
}

/* In each column of the map the first row with the flag set is the first row beyond the
 * theory, or its neighbour. */
static void criteria_begin_within_one_step_of_the_theory(void **state)
{
    (void)state;
    for (int c = 0; c < STABILITY_CRITERIA; c++)
        for (int j = 0; j < STABILITY_DEPTHS; j++) {
            const double border = stability_border(c, stability_depth(j));
            int flagged = 0, beyond = 0;
            while (flagged < STABILITY_RISES && !(flags_at(flagged, j) >> c & 1))
                flagged++;
            while (beyond < STABILITY_RISES && stability_rise(beyond) <= border)
                beyond++;
            assert_in_range(flagged + 1, beyond, beyond + 2);
        }
}

static void what_breaks_goes_on_breaking_when_it_is_higher(void **state)
{
    (void)state;
    for (int j = 0; j < STABILITY_DEPTHS; j++)
        for (int i = 1; i < STABILITY_RISES; i++)
            assert_int_equal(flags_at(i - 1, j) & ~flags_at(i, j), 0);
}

/* -- inversion [E1] ------------------------------------------------------------------ */

static void plain_steps_stay_below_their_bound(void **state)
{
    (void)state;
    for (double q = 0.1; q < 1.3; q += 0.1)
        for (uint32_t n = 1; n <= 16; n *= 2) {
            const tp_deep_water deep = stability_sea_unheld(2, 0, q);
            const stability_off off = stability_inversion(&deep, STABILITY_PLAIN, n);
            const double bound = stability_bound(&deep, STABILITY_PLAIN, n);
            assert_true(off.along < bound + 4 * STABILITY_LSB);
        }
}

/* Plain steps fail where theory permits: at q = 1 and beyond more steps give no
 * improvement. */
static void plain_steps_fail_beyond_a_sum_of_1(void **state)
{
    (void)state;
    const tp_deep_water below = stability_sea_unheld(2, 0, 0.8);
    const tp_deep_water above = stability_sea_unheld(2, 0, 1.2);

    assert_true(stability_inversion(&below, STABILITY_PLAIN, 16).along
                < stability_inversion(&below, STABILITY_PLAIN, 4).along / 8);
    assert_true(stability_inversion(&above, STABILITY_PLAIN, 16).along
                > stability_inversion(&above, STABILITY_PLAIN, 4).along);
}

/* The height error is the horizontal error times the slope, which is below 8. */
static void the_engine_finds_the_surface_up_to_the_clamp(void **state)
{
    (void)state;
    for (int waves = 1; waves <= 8; waves *= 2)
        for (double q = 0.1; q < 1.3; q += 0.2) {
            const tp_deep_water deep = stability_sea(waves, 0, q);
            const stability_off cold = stability_inversion(&deep, STABILITY_COLD, 0);
            const stability_off warm = stability_inversion(&deep, STABILITY_WARM, 0);
            const double bound = stability_bound(&deep, STABILITY_COLD, 0) + 1e-9;
            assert_true(cold.along < bound && cold.up < 8 * bound);
            assert_true(warm.along < bound && warm.up < 8 * bound);
        }
}

/* -- wave numbers [B2]-[B6] ---------------------------------------------------------- */

static void the_truth_solves_its_equation(void **state)
{
    (void)state;
    for (double kh = 0.01; kh < 10; kh *= 1.1)
        assert_true(fabs(stability_kh(kh * tanh(kh)) / kh - 1) < 1e-14);
}

/* Exact to 2^-19, the resolution of the 20-bit root of Fenton and McKee. */
static void fixed_point_has_its_formulas_errors(void **state)
{
    (void)state;
    for (int n = 0; n < STABILITY_NUMBERS; n++) {
        const stability_number *number = &stability_numbers[n];
        for (double kh = 0.05; number->engine && kh < 10; kh *= 1.07) {
            const double off = number->formula ? stability_formula_off(number, kh) : 0;
            assert_true(fabs(stability_number_off(number, kh, 300) - off) < 2e-6);
        }
    }
}

/* The stated errors of the models, and the points where the errors occur. */
static void formulas_are_off_as_the_models_say(void **state)
{
    (void)state;
    static const double most[] = { 0.0498, 0.0163, 0.00051, 6e-8 };

    for (int n = 0; n < 4; n++) {
        const stability_number *number = &stability_numbers[n];
        double worst = 0;
        for (double kh = 0.01; kh < 10; kh *= 1.01)
            worst = fmax(worst, fabs(stability_number_off(number, kh, 40)));
        assert_true(worst < 1.005 * most[n]);
        assert_true(n == 3 || worst > 0.99 * most[n]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_jacobian_falls_to_where_all_crests_meet),
        cmocka_unit_test(loops_begin_at_a_sum_of_1),
        cmocka_unit_test(the_clamp_leaves_a_twentieth_of_the_jacobian),
        cmocka_unit_test(points_fold_where_the_jacobian_is_below_0),
        cmocka_unit_test(criteria_begin_where_the_theory_says),
        cmocka_unit_test(criteria_begin_within_one_step_of_the_theory),
        cmocka_unit_test(what_breaks_goes_on_breaking_when_it_is_higher),
        cmocka_unit_test(plain_steps_stay_below_their_bound),
        cmocka_unit_test(plain_steps_fail_beyond_a_sum_of_1),
        cmocka_unit_test(the_engine_finds_the_surface_up_to_the_clamp),
        cmocka_unit_test(the_truth_solves_its_equation),
        cmocka_unit_test(fixed_point_has_its_formulas_errors),
        cmocka_unit_test(formulas_are_off_as_the_models_say),
    };
    return cmocka_run_group_tests_name("maps", tests, NULL, NULL);
}
