/* SPDX-License-Identifier: MIT */
/* The pool statements of the stability charts as tests.  Within the bound of configurations
 * no noise grows and nothing drifts; beyond von Neumann's line noise grows to the range's
 * end; rest comes at the time of the theory; and where 8 bits are too few, gear A's
 * roundings add energy to the water. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/charts/pool_runs.h"
#include "tests/lib/random.h"

#define PI 3.14159265358979323846

static pool_tank tank_of(tp_cells cells, uint32_t side, uint32_t m, double r)
{
    return (pool_tank){ cells, side, side, (uint32_t)lround(r * r * POOL_WHOLE), m };
}

/* Rounded downwards, so that the requested value is within the bound. */
static pool_tank tank_within(tp_cells cells, uint32_t side, uint32_t m, double r2)
{
    return (pool_tank){ cells, side, side, (uint32_t)floor(r2 * POOL_WHOLE), m };
}

/* -- theory -------------------------------------------------------------------------- */

/* The shortest mode of a tank of 16 x 16 by the rule without rounding: the root multiplies
 * the mode per tick, and the root passes 1 at von Neumann's line. */
static void a_mode_grows_by_its_root(void **state)
{
    (void)state;
    const double mu = 8 * pow(sin(PI * 15 / 32), 2);

    for (int n = 0; n < 60; n++) {
        const tp_cells cells = (tp_cells)(n % 3);
        const uint32_t m = 1 + (uint32_t)n % 10;
        const double line = pool_neumann_r2(cells, m), r2 = line * (1.05 + 0.01 * n);
        const pool_rule rule = pool_rule_of(cells, r2, m);
        const pool_tank still = tank_of(TP_CELLS_8, 16, 6, 0.4);
        tp_pool *const pool = pool_tank_new(&still);
        pool_field w = pool_field_of(pool);
        double before = 0;
        for (uint32_t i = 0; i < 256; i++)
            w.h[i] = cos(PI * 15 * (i % 16 + 0.5) / 16)
                   * cos(PI * 15 * (i / 16 + 0.5) / 16);
        for (int tick = 0; tick < 300 && fabs(w.h[0]) < 1e100; tick++) {
            before = w.h[0];
            pool_field_step(&w, rule);
        }
        assert_true(fabs(w.h[0] / before / -pool_rule_root(rule, mu) - 1) < 1e-6);
        assert_true(pool_rule_root(pool_rule_of(cells, 1.0001 * line, m), 8) > 1);
        assert_true(pool_rule_root(pool_rule_of(cells, 0.9999 * line, m), 8) <= 1);
        pool_field_free(&w);
        free(pool);
    }
}

/* -- growth -------------------------------------------------------------------------- */

/* 16 and 32 bits: the same as the rule without rounding, for every valid pool. */
static void within_the_bound_noise_dies_away_as_theory_says(void **state)
{
    (void)state;
    double worst = -1, apart = 0;

    for (int n = 0; n < 42; n++) {
        const tp_cells cells = n % 2 ? TP_CELLS_16 : TP_CELLS_32;
        const uint32_t m = 4 + (uint32_t)n / 2 % 7;
        const double bound = pool_bound_r2(m);
        if (m % 2 && !getenv("TP_SOAK"))
            continue;
        const pool_tank tank = n < 14 ? tank_of(cells, GROWTH_SIDE, m, 0.05)
                             : tank_within(cells, GROWTH_SIDE, m,
                                           n < 28 ? bound / 4 : bound);
        const pool_growth g = pool_tank_growth(&tank);
        worst = fmax(worst, g.growth - 1);
        apart = fmax(apart, fabs(g.growth - g.unrounded));
        assert_true(g.growth < 1);
        assert_int_equal(g.full_at, 0);
    }
    printf("# a tick multiplies noise by 1 %+.5f at the most; %.1e off without "
           "rounding\n", worst, apart);
    assert_true(apart < 1e-4);
}

/* Von Neumann's line within 1 % of r on either side. */
static void beyond_von_neumann_noise_grows_to_the_ranges_end(void **state)
{
    (void)state;
    double apart = 0;

    for (int n = 0; n < 21; n++) {
        const tp_cells cells = (tp_cells)(n % 3);
        const uint32_t m = 4 + (uint32_t)n / 3;
        const double line = sqrt(pool_neumann_r2(cells, m));
        if (m % 2 && !getenv("TP_SOAK"))
            continue;
        const pool_tank within = tank_of(cells, GROWTH_SIDE, m, 0.99 * line);
        const pool_tank beyond = tank_of(cells, GROWTH_SIDE, m, 1.01 * line);
        const pool_tank far = tank_of(cells, GROWTH_SIDE, m, 1.15 * line);
        const pool_growth a = pool_tank_growth(&within), b = pool_tank_growth(&beyond);
        const pool_growth c = pool_tank_growth(&far);
        assert_true(a.growth < 1);
        assert_true(b.growth > 1.05 && b.full_at > 0);
        assert_true(c.growth > 1.5 && c.full_at > 0);
        if (cells != TP_CELLS_8)
            apart = fmax(apart, fmax(fabs(b.growth / b.unrounded - 1),
                                     fabs(c.growth / c.unrounded - 1)));
    }
    printf("# beyond the line growth is within %.1e of the unrounded rule's\n", apart);
    assert_true(apart < 1e-3);
}

/* 8 bits: gear A's roundings prevail left of the line of noise. */
static void eight_bits_are_fed_by_rounding_left_of_the_line(void **state)
{
    (void)state;
    printf("# 8 bits: noise grows left of r and dies right of it\n"
           "#  m   line  left, right\n");
    for (uint32_t m = 6; m <= 10; m++) {
        const pool_tank any = tank_of(TP_CELLS_8, GROWTH_SIDE, m, 0.4);
        const double line = pool_noise_r(pool_tank_growth(&any).rms, m);
        const pool_tank left = tank_of(TP_CELLS_8, GROWTH_SIDE, m, 0.8 * line);
        const pool_tank right = tank_of(TP_CELLS_8, GROWTH_SIDE, m, 1.25 * line);
        const pool_growth a = pool_tank_growth(&left), b = pool_tank_growth(&right);
        printf("# %2d  %.3f  %+.4f %+.4f\n", (int)m, line, a.growth - 1, b.growth - 1);
        assert_true(a.growth > 1);
        assert_true(b.growth < 1);
    }
}

/* -- drift and rest ------------------------------------------------------------------ */

static void nothing_drifts_until_gear_b(void **state)
{
    (void)state;
    static const double rate[] = { 0.25, 0.35, 0.484 };
    double worst = 0;

    for (int n = 0; n < 27; n++) {
        const tp_cells cells = (tp_cells)(n % 3);
        if (n >= 18 && n < 24 && !getenv("TP_SOAK"))
            continue;                   /* the longest runs */
        const pool_tank tank = tank_of(cells, 64, 4 + 2 * ((uint32_t)n / 9),
                                       rate[n / 3 % 3]);
        const pool_rest rest = pool_tank_rest(&tank, 100000);
        worst = fmax(worst, rest.drift);
        assert_int_equal(rest.ending, POOL_RESTS);
        assert_false(rest.full);
        assert_true(rest.drift_a == 0);
        assert_true(cells != TP_CELLS_32 || rest.drift == 0);
        assert_true(cells == TP_CELLS_32 || rest.residue == 0);
    }
    printf("# the mean drifts by %.3f LSB in gear B at the most\n", worst);
    assert_true(worst < 1);
}

/* Oscillating waves: r is beyond the line of creeping by a third.  Gear B takes up to 100
 * ticks more than gear A's time. */
static void rest_comes_when_theory_says(void **state)
{
    (void)state;
    printf("# bits  m      r   ticks  theory\n");
    for (int n = 0; n < (getenv("TP_SOAK") ? 12 : 8); n++) {
        const tp_cells cells = n % 2 ? TP_CELLS_32 : TP_CELLS_16;
        const uint32_t m = 6 + (uint32_t)n / 4;
        const double r = n / 2 % 2 ? 0.484 : 0.25;
        const pool_tank tank = tank_of(cells, 64, m, r);
        const pool_rest rest = pool_tank_rest(&tank, 100000);
        const double theory = pool_rest_ticks(&tank);
        printf("# %4d %2d  %.3f  %6d  %6.0f\n", 8 << cells, (int)m, r, (int)rest.ticks,
               theory);
        assert_int_equal(rest.ending, POOL_RESTS);
        assert_true(r > 1.3 * pool_creep_r(64, m));
        if (cells == TP_CELLS_16)
            assert_true(rest.ticks >= theory && rest.ticks <= theory + 100);
        else
            assert_true(fabs(rest.ticks / theory - 1) < 0.1);
    }
}

/* Left of the line the tank's longest wave takes far longer than gear A's time. */
static void long_waves_creep_left_of_the_line(void **state)
{
    (void)state;
    for (int n = 0; n < 2; n++) {
        const pool_tank tank = tank_of(n ? TP_CELLS_32 : TP_CELLS_16, 64, 4, 0.1);
        const pool_rest rest = pool_tank_rest(&tank, 100000);
        assert_true(0.1 < 0.2 * pool_creep_r(64, 4));
        assert_int_equal(rest.ending, POOL_RESTS);
        assert_true(rest.ticks > 3 * pool_rest_ticks(&tank));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mode_grows_by_its_root),
        cmocka_unit_test(within_the_bound_noise_dies_away_as_theory_says),
        cmocka_unit_test(beyond_von_neumann_noise_grows_to_the_ranges_end),
        cmocka_unit_test(eight_bits_are_fed_by_rounding_left_of_the_line),
        cmocka_unit_test(nothing_drifts_until_gear_b),
        cmocka_unit_test(rest_comes_when_theory_says),
        cmocka_unit_test(long_waves_creep_left_of_the_line),
    };
    return cmocka_run_group_tests_name("stability of pools, maps", tests, NULL, NULL);
}
