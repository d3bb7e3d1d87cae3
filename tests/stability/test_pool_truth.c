/* SPDX-License-Identifier: MIT */
/* The reference water for pools, tests/charts/pool_truth.c, is that of the damped wave
 * equation: its modes obey the equation, it is the limit of ever finer cells and ticks, and
 * without damping it is d'Alembert's pair of waves. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/charts/pool_rules.h"
#include "tests/charts/pool_truth.h"
#include "tests/lib/random.h"

#define PI 3.14159265358979323846

static uint64_t chance;

/* -- single mode --------------------------------------------------------------------- */

/* h'' + 2 g h' + omega^2 h = 0 by differences, from waves to creeping. */
static void a_mode_obeys_its_equation(void **state)
{
    (void)state;
    const double e = 1e-3;
    double worst = 0;

    for (int n = 0; n < 2000; n++) {
        const double omega = chance_double(&chance, 0, 2);
        const double gamma = n % 4 ? chance_double(&chance, 0, 0.4) : omega;
        const double a = chance_double(&chance, -1, 1), v = chance_double(&chance, -1, 1);
        const double t = chance_double(&chance, 0, 20);
        const double h = pool_truth_mode(omega, gamma, a, v, t);
        const double on = pool_truth_mode(omega, gamma, a, v, t + e);
        const double back = pool_truth_mode(omega, gamma, a, v, t - e);
        const double left = (on - 2 * h + back) / (e * e) + gamma * (on - back) / e
                          + omega * omega * h;
        worst = fmax(worst, fabs(left));
        assert_true(fabs(pool_truth_mode(omega, gamma, a, v, 0) - a) < 1e-14);
    }
    printf("# what a mode leaves of its equation: %.1e at the most\n", worst);
    assert_true(worst < 1e-5);
}

static void a_mode_begins_as_it_is_told(void **state)
{
    (void)state;
    const double e = 1e-5;

    for (int n = 0; n < 2000; n++) {
        const double omega = chance_double(&chance, 0, 2.2);
        const double gamma = n % 4 ? chance_double(&chance, 0, 0.4) : omega;
        const double a = chance_double(&chance, -1, 1), b = chance_double(&chance, -1, 1);
        const double v = pool_truth_speed(omega, gamma, a, b);
        const double slope = (pool_truth_mode(omega, gamma, a, v, e)
                              - pool_truth_mode(omega, gamma, a, v, -e)) / (2 * e);
        assert_true(fabs(pool_truth_mode(omega, gamma, a, v, -1) - b) < 1e-11);
        assert_true(fabs(slope - v) < 1e-7);
    }
}

/* The cells' rules lose the same amount: an oscillating mode's root is e^-g of the same
 * damping. */
static void the_rules_of_cells_are_damped_alike(void **state)
{
    (void)state;
    for (int n = 0; n < 30; n++) {
        const tp_cells cells = n % 2 ? TP_CELLS_16 : TP_CELLS_32;
        const uint32_t m = 4 + (uint32_t)n / 2 % 7;
        const double h = 1, rho = 1 - ldexp(1, -(int)m);
        pool_truth truth;
        pool_truth_init(&truth, 1, 1, 0.4, rho, &h, NULL);
        assert_true(fabs(pool_rule_root(pool_rule_of(cells, 0.16, m), 1)
                         - exp(-truth.gamma)) < 1e-12);
        pool_truth_free(&truth);
    }
}

/* -- fields -------------------------------------------------------------------------- */

enum { COLS = 32, ROWS = 24, FINEST = 8, CELLS = COLS * ROWS * FINEST * FINEST };

static double hat(double x, double z)
{
    const double s = (x * x + z * z) / 9;
    return (1 - s / 2) * exp(-s / 2);
}

/* A splash of sigma 3 cells at (13.2, 10.6), with its images in the walls, so that no wall
 * cuts the shape. */
static double hat_at(double x, double z)
{
    double h = 0;

    for (int n = 0; n < 16; n++) {
        const double way_x = n & 1 ? -13.2 : 13.2, way_z = n & 2 ? -10.6 : 10.6;
        h += hat(x - way_x - (n & 4 ? 2.0 * COLS : 0),
                 z - way_z - (n & 8 ? 2.0 * ROWS : 0));
    }
    return h;
}

static void lay(double *h, uint32_t finer)
{
    for (uint32_t j = 0; j < ROWS * finer; j++)
        for (uint32_t i = 0; i < COLS * finer; i++)
            h[j * COLS * finer + i] = hat_at((i + 0.5) / finer, (j + 0.5) / finer);
}

static double rms_of(const double *a, const double *b, uint32_t count)
{
    double sum = 0;

    for (uint32_t i = 0; i < count; i++)
        sum += pow(a[i] - (b ? b[i] : 0), 2);
    return sqrt(sum / count);
}

static double lap(const double *h, uint32_t i, uint32_t j, uint32_t cols, uint32_t rows)
{
    const uint32_t at = j * cols + i;

    return (i ? h[at - 1] - h[at] : 0) + (i + 1 < cols ? h[at + 1] - h[at] : 0)
         + (j ? h[at - cols] - h[at] : 0) + (j + 1 < rows ? h[at + cols] - h[at] : 0);
}

/* Explicit steps of second order in cells and ticks, from rest; r = 0.484. */
static void step_fine(double *h, double *before, uint32_t finer, double gamma, int first)
{
    static double next[CELLS];
    const uint32_t cols = COLS * finer, rows = ROWS * finer;
    const double g = gamma / finer, r2 = 0.484 * 0.484;

    for (uint32_t at = 0; at < cols * rows; at++) {
        const double force = r2 * lap(h, at % cols, at / cols, cols, rows);
        next[at] = first ? h[at] + force / 2
                         : (2 * h[at] - (1 - g) * before[at] + force) / (1 + g);
    }
    memcpy(before, h, cols * rows * sizeof *h);
    memcpy(h, next, cols * rows * sizeof *h);
}

/* Rms difference from the reference after `ticks`, for cells `finer` times as small. */
static double miss(const pool_truth *truth, double gamma, uint32_t finer, uint32_t ticks)
{
    static double h[CELLS], before[CELLS], right[CELLS];
    const uint32_t count = COLS * ROWS * finer * finer;

    lay(h, finer);
    for (uint32_t n = 0; n < ticks * finer; n++)
        step_fine(h, before, finer, gamma, n == 0);
    pool_truth_at(truth, ticks, finer, right);
    return rms_of(h, right, count) / rms_of(right, NULL, count);
}

/* Halving cells and ticks together removes three fourths of the error, so the remaining
 * error at the finest step is a third of the last gain: the limit is the reference. */
static void finer_cells_and_ticks_converge_on_it(void **state)
{
    (void)state;
    static const uint32_t ticks[] = { 20, 100, 400 };
    static double start[COLS * ROWS];

    lay(start, 1);
    printf("# rms off the truth, %%: cells and ticks 1, 1/2, 1/4, 1/8; their limit\n");
    for (int n = 0; n < (getenv("TP_SOAK") ? 6 : 4); n++) {
        const uint32_t m = n % 2 ? 6 : 10;
        const double delta = ldexp(1, -(int)m), gamma = -log1p(-delta) / 2;
        pool_truth truth;
        double off[4];
        pool_truth_init(&truth, COLS, ROWS, 0.484, 1 - delta, start, NULL);
        for (uint32_t k = 0; k < 4; k++)
            off[k] = 100 * miss(&truth, gamma, 1u << k, ticks[n / 2]);
        printf("# damping 2^-%-2d tick %3d  %8.4f %8.4f %8.4f %8.4f\n", (int)m,
               (int)ticks[n / 2], off[0], off[1], off[2], off[3]);
        assert_true(off[3] < off[2] / 3.8 && off[3] > off[2] / 4.2);
        pool_truth_free(&truth);
    }
}

/* A ridge along z without damping: two halves that run apart and are reflected at the
 * walls. */
static double ridge(double x)
{
    double h = 0;

    for (int n = -4; n <= 4; n++)
        h += exp(-pow((x - 2.0 * n * COLS - 12) / 3, 2) / 2)
           + exp(-pow((x - 2.0 * n * COLS + 12) / 3, 2) / 2);
    return h;
}

static void without_damping_it_is_two_waves_running_apart(void **state)
{
    (void)state;
    static double start[COLS * ROWS], h[COLS * ROWS * 9];
    pool_truth truth;
    double worst = 0;

    for (uint32_t i = 0; i < COLS * ROWS; i++)
        start[i] = ridge(i % COLS + 0.5);
    pool_truth_init(&truth, COLS, ROWS, 0.484, 1, start, NULL);
    for (int t = 0; t <= 400; t += 25) {
        pool_truth_at(&truth, t, 3, h);
        for (uint32_t i = 0; i < COLS * ROWS * 9; i++) {
            const double x = (i % (COLS * 3) + 0.5) / 3, way = 0.484 * t;
            worst = fmax(worst, fabs(h[i] - (ridge(x - way) + ridge(x + way)) / 2));
        }
    }
    pool_truth_free(&truth);
    printf("# against two waves, undamped: %.1e of the crest at the most\n", worst);
    assert_true(worst < 1e-9);
}

/* The reference passes through both given ticks. */
static void a_field_passes_through_its_start(void **state)
{
    (void)state;
    static double now[COLS * ROWS], before[COLS * ROWS], h[COLS * ROWS];

    for (int n = 0; n < 8; n++) {
        pool_truth truth;
        for (uint32_t i = 0; i < COLS * ROWS; i++) {
            now[i] = chance_double(&chance, -1, 1);
            before[i] = chance_double(&chance, -1, 1);
        }
        pool_truth_init(&truth, COLS, ROWS, chance_double(&chance, 0.05, 0.5),
                        1 - pow(2, -chance_int(&chance, 1, 10)), now, before);
        pool_truth_at(&truth, 0, 1, h);
        assert_true(rms_of(h, now, COLS * ROWS) < 1e-12);
        pool_truth_at(&truth, -1, 1, h);
        assert_true(rms_of(h, before, COLS * ROWS) < 1e-10);
        pool_truth_free(&truth);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mode_obeys_its_equation),
        cmocka_unit_test(a_mode_begins_as_it_is_told),
        cmocka_unit_test(the_rules_of_cells_are_damped_alike),
        cmocka_unit_test(finer_cells_and_ticks_converge_on_it),
        cmocka_unit_test(without_damping_it_is_two_waves_running_apart),
        cmocka_unit_test(a_field_passes_through_its_start),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("the pools' truth", tests, NULL, NULL);
}
