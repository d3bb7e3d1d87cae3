/* SPDX-License-Identifier: MIT */
/* Limits of pools of 32 bits [C17]: starts at the full range, r beyond its bound, where
 * fluxes grow; and r of any kind of cells that no configuration allows.
 *
 *     TP_SOAK=1       larger fields and all r: minutes instead of seconds */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/pools.h"

static uint64_t chance;

static int64_t sum_of(const tp_pool *pool)
{
    const int32_t *const h = tp_pool_const_pointer(pool, sizeof *pool);
    int64_t sum = 0;

    for (uint32_t i = 0; i < tp_pool_count(pool); i++)
        sum += h[i];
    return sum;
}

static bool flows(const tp_pool *pool)
{
    const int32_t *const h = tp_pool_const_pointer(pool, sizeof *pool);
    const uint32_t count = tp_pool_count(pool);
    int32_t any = 0;

    for (uint32_t i = count; i < 3 * count; i++)
        any |= h[i];
    return any != 0;
}

/* Full-range starts with any sum, which no step changes.  Returns the ticks until all
 * fluxes are 0, and the largest difference between heights and their mean.  The overdamped
 * corner r = 0.05, m = 4 is slow: 64 x 64 cells took 224427 ticks there.  A million counts
 * as never. */
static int rest_of_fluxes(uint32_t size, uint32_t m, double r, int32_t *residue)
{
    tp_pool *const pool = tank(TP_CELLS_32, TP_EDGES_WALL, size, m, r);

    pool_fill(pool, &chance, TP_FULL_32);
    const int64_t sum = sum_of(pool);
    while (!pool->at_rest) {
        tp_pool_step(pool);
        assert_true(sum_of(pool) == sum);
        assert_true(pool->tick < 1000000);
        if (pool->tick % 64 == 0)
            look_bounded(pool);
    }
    assert_false(flows(pool));
    *residue = 0;
    for (uint32_t i = 0; i < size * size; i++) {
        const int32_t h = tp_pool_cell_height(pool, i);
        const int32_t off = abs(h - (int32_t)(sum / size / size));
        *residue = off > *residue ? off : *residue;
    }
    const int ticks = (int)pool->tick;
    free(pool);
    return ticks;
}

static void fluxes_come_to_exact_rest_and_lose_no_water(void **state)
{
    (void)state;
    const uint32_t size = soak() ? 64 : 24;

    printf("# 32 bits, %u x %u: ticks until all fluxes are 0, residue in 2^-24 m\n"
           "#  m  r =", (unsigned)size, (unsigned)size);
    for (int i = 0; i < RATES && is_bounded(rate_at(i), 10); i++)
        printf("        %.2f", rate_at(i));
    for (uint32_t m = 4; m <= 10; m += 2) {
        printf("\n# %2d     ", (int)m);
        for (int i = 0; i < RATES && is_bounded(rate_at(i), m); i++) {
            int32_t residue;
            if (m == 10 && i % 3 != 2 && !soak()) {
                printf("           -");
                continue;
            }
            const int ticks = rest_of_fluxes(size, m, rate_at(i), &residue);
            printf("  %5d %4d", ticks, residue);
        }
    }
    printf("\n");
}

static void what_would_not_rest_is_refused(void **state)
{
    (void)state;
    for (int n = 0; n < 3 * RATES; n++) {
        for (uint32_t m = 4; m <= 10; m++) {
            tp_pool_config c = pool_config((tp_cells)(n % 3), TP_EDGES_WALL, 24, 24);
            const double r = rate_at(n / 3), delta = pow(2, -(double)m);
            c.courant = (tp_fx)lround(r * 65536);
            c.damping = m;
            const bool may = r2q_of(r) / 1024.0 <= (1 - 1 / (2 - delta)) / 2;
            assert_int_equal(tp_pool_check(&c, NULL), may ? TP_OK : TP_E_POOL_COURANT);
            assert_int_equal(tp_pool_bytes(&c) != 0, may);
        }
    }
}

/* The checkerboard is a mode with mu = 8: z^2 - (1 + d - 8 d a) z + d = 0, whose larger
 * root is the growth per step. */
static double growth_of_model(double a, double d)
{
    const double half = (1 + d - 8 * d * a) / 2, root = half * half - d;
    return root < 0 ? sqrt(d) : fabs(half) + sqrt(root);
}

/* Growth per step between 2^14 and 2^26 LSB; 0: no growth. */
static double growth_measured(tp_pool *pool, int *full_at)
{
    double from = 0, log_rise = 0;
    int begun = 0;

    *full_at = 0;
    for (int tick = 1; tick <= 4000 && *full_at == 0; tick++) {
        tp_pool_step(pool);
        const tp_pool_state look = look_bounded(pool);
        assert_true(look.sum == 0);
        if (from == 0 && look.highest > 1 << 14) {
            from = look.highest;
            begun = tick;
        }
        if (from > 0 && look.highest < 1 << 26 && tick > begun)
            log_rise = log(look.highest / from) / (tick - begun);
        if (look.highest > TP_FULL_32 / 2)
            *full_at = tick;
    }
    return *full_at == 0 ? 0 : exp(log_rise);
}

static void grow(uint32_t m, double r)
{
    tp_pool *const pool = tank(TP_CELLS_32, TP_EDGES_TILE, 24, m, r);
    const double model =
        growth_of_model(pool->courant_sq_q10 / 1024.0, 1 - pow(2, -(double)m));
    int full_at;

    for (uint32_t k = 0; k < 24 * 24; k++)
        tp_pool_add_cell_height(pool, k % 24, k / 24, (k % 24 + k / 24) % 2 ? 4096 : -4096);
    const double growth = growth_measured(pool, &full_at);
    assert_int_equal(full_at != 0, model > 1);
    if (model > 1) {
        printf("# %2d  %.2f  %6.4f  %6.4f  %d\n", (int)m, r, growth, model, full_at);
        assert_true(fabs(growth - model) < 0.01 * model);
    } else {
        printf("# %2d  %.2f  none    %6.4f\n", (int)m, r, model);
    }
    for (int tick = 0; tick < 500; tick++) {
        tp_pool_step(pool);
        assert_true(look_bounded(pool).sum == 0);
    }
    free(pool);
}

static void beyond_the_bound_fluxes_grow_to_the_range_and_no_further(void **state)
{
    (void)state;
    static const double rate[] = { 0.55, 0.7, 0.72, 0.75, 0.8 };

    printf("# 32 bits beyond the bound: growth a tick of the shortest waves, the "
           "model's, and the tick at which they are 32 m high\n"
           "#  m  r     growth  model\n");
    for (uint32_t m = 4; m <= 10; m += 3)
        for (int i = 0; i < 5; i++)
            grow(m, rate[i]);
}

/* Every r2q is defined: above 767 it counts as 767. */
static void any_r_set_by_hand_is_held(void **state)
{
    (void)state;
    for (int n = 0; n < 9; n++) {
        const tp_pool_config c = pool_config((tp_cells)(n % 3), (tp_edges)(n / 3), 33,
                                             17);
        tp_pool *const pool = pool_make(&c), *const copy = pool_make(&c);
        pool_fill(pool, &chance, tp_pool_max_lsb(pool));
        memcpy(copy, pool, tp_pool_bytes(&c));
        pool->courant_sq_q10 = 767;
        copy->courant_sq_q10 = n % 2 ? UINT32_MAX : 768;
        for (int tick = 0; tick < 200; tick++) {
            tp_pool_step(pool);
            tp_pool_step(copy);
            look_bounded(pool);
        }
        assert_memory_equal(pool + 1, copy + 1, tp_pool_bytes(&c) - sizeof *pool);
        free(pool);
        free(copy);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fluxes_come_to_exact_rest_and_lose_no_water),
        cmocka_unit_test(beyond_the_bound_fluxes_grow_to_the_range_and_no_further),
        cmocka_unit_test(what_would_not_rest_is_refused),
        cmocka_unit_test(any_r_set_by_hand_is_held),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("stability of pools, fluxes", tests, NULL, NULL);
}
