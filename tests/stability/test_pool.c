/* SPDX-License-Identifier: MIT */
/* Limits of pools of 8 and 16 bits: r beyond its bound, starts at the full range, dampings
 * at both ends, water too low to move; and the volume of all kinds of cells.  The test
 * prints the results and asserts [C8]-[C18]: nothing leaves its range, a pool in a valid
 * configuration comes to exact rest, nothing drifts.
 *
 *     TP_SOAK=1       more sizes and starts: minutes instead of seconds */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/pools.h"

#define PI 3.14159265358979323846

static uint64_t chance;

/* Sets full-range heights with a sum of 0: each height has its opposite. */
static void stir(tp_pool *pool)
{
    const uint32_t count = pool->cols * pool->rows;
    const int32_t full = tp_pool_max_lsb(pool);

    for (uint32_t i = 0; i < count / 2; i++) {
        const int32_t h = chance_int(&chance, -full, full);
        const uint32_t j = (i + count / 2) % count;
        tp_pool_add_cell_height(pool, i % pool->cols, i / pool->cols, h);
        tp_pool_add_cell_height(pool, j % pool->cols, j / pool->cols, -h);
    }
    tp_pool_start_carry_rounding(pool, full);
}

/* Returns the ticks until rest, or `most`. */
static int run(tp_pool *pool, int most)
{
    int tick = 0;

    while (tick < most && !pool->at_rest) {
        tp_pool_step(pool);
        if (++tick % 64 == 0)
            look_bounded(pool);
    }
    return tick;
}

/* -- 8 and 16 bits: Courant x damping x starts --------------------------------------- */

/* Returns the period in ticks after which all cells repeat; 0: more than 4. */
static int cycle_of(tp_pool *pool)
{
    const size_t bytes = tp_pool_count(pool) * (pool->cells == TP_CELLS_8 ? 2 : 4);
    void *const now = malloc(bytes);
    int ticks = 0;

    assert_non_null(now);
    memcpy(now, pool + 1, bytes);
    do {
        tp_pool_step(pool);
    } while (++ticks <= 4 && memcmp(now, pool + 1, bytes) != 0);
    free(now);
    return ticks <= 4 ? ticks : 0;
}

/* Beyond the bound: prints the ticks until rest, the period of a cycle, or saturation. */
static void print_end(tp_pool *pool)
{
    for (int ticks = 0; ticks < 100000; ticks += 512) {
        const int more = run(pool, 512);
        const tp_pool_state look = look_bounded(pool);
        const int cycle = look.at_rest || look.fastest > 2 ? 0 : cycle_of(pool);
        if (look.at_rest)
            printf(" %5d", ticks + more);
        else if (cycle != 0)
            printf("    c%d", cycle);
        else if (look.fastest > tp_pool_max_lsb(pool) / 2)
            printf("     s");
        else
            continue;
        return;
    }
    printf("     m");
}

/* Returns the displacement of the mean at the end of gear A, relative to the range. */
static double settle(tp_cells cells, uint32_t size, uint32_t m, double r)
{
    tp_pool *const pool = tank(cells, TP_EDGES_WALL, size, m, r);

    stir(pool);
    run(pool, (int)pool->gear);
    const double mean = fabs((double)tp_pool_stats(pool).sum) / (size * size)
                      / tp_pool_max_lsb(pool);
    if (is_bounded(r, m)) {
        printf(" %5d", run(pool, 200000));
        const tp_pool_state look = tp_pool_stats(pool);
        assert_true(look.at_rest && look.sum == 0 && look.highest == 0);
        assert_int_equal(look.fastest, 0);
    } else {
        print_end(pool);
    }
    free(pool);
    return is_bounded(r, m) ? mean : 0;
}

/* The models' clamps [C5] keep the energy, not the sum: where water hits the range's
 * end its cells stop, and the motion of the other cells displaces the mean for 2^m
 * ticks. */
static void sweep(uint32_t size)
{
    printf("# %u x %u: ticks of gear B until exact rest; c2: cycle of two ticks, s: "
           "saturated, m: moves\n# bits  m r =", (unsigned)size, (unsigned)size);
    for (int i = 0; i < RATES; i++)
        printf("  %.2f", rate_at(i));
    printf("   mean after gear A\n");
    for (uint32_t n = 0; n < 8; n++) {
        const uint32_t m = 4 + 2 * (n % 4);
        double mean = 0;
        printf("# %4d %2d    ", n < 4 ? 8 : 16, (int)m);
        for (int i = 0; i < RATES; i++) {
            if (n % 4 > 1 && i % 4 != 1 && !soak())
                printf("     -");           /* the longest runs */
            else
                mean = fmax(mean, settle(n < 4 ? TP_CELLS_8 : TP_CELLS_16, size, m,
                                         rate_at(i)));
        }
        printf("   %.3f of the range\n", mean);
    }
}

static void full_range_water_comes_to_exact_rest_within_the_bound(void **state)
{
    (void)state;
    sweep(24);
    for (int n = 0; soak() && n < 8; n++)
        sweep(n % 2 ? 40 : 64);
}

/* [C9] on its own: from the full range until nothing moves, 24 x 24. */
static void gear_b_alone_comes_to_a_stand(void **state)
{
    (void)state;
    int worst[2] = { 0, 0 };

    for (int n = 0; n < (soak() ? 400 : 32); n++) {
        const tp_cells cells = n % 2 ? TP_CELLS_16 : TP_CELLS_8;
        const double r = chance_double(&chance, 0.1, 0.49);
        tp_pool *const pool = tank(cells, TP_EDGES_WALL, 24,
                                   4 + 2 * (uint32_t)(n / 2 % 4), r);
        pool_fill(pool, &chance, tp_pool_max_lsb(pool));
        pool->gear = 0;
        int ticks = 0;
        do {
            tp_pool_step(pool);
            assert_true(++ticks < 20000);
        } while (look_bounded(pool).fastest != 0);
        worst[n % 2] = ticks > worst[n % 2] ? ticks : worst[n % 2];
        free(pool);
    }
    printf("# gear B stands after %d ticks (8 bits) and %d (16 bits) at the most; the "
           "models' starts: 199 and 5904\n", worst[0], worst[1]);
}

/* -- drift --------------------------------------------------------------------------- */

/* Largest |mean| in LSB after the zero-sum splash of the models' table, or after another
 * splash.  In gear A the mean is exactly 0.  `rest`: ticks of gear B. */
static double mean_of_hat(tp_cells cells, uint32_t m, double r, bool any, int *rest)
{
    tp_pool *const pool = tank(cells, TP_EDGES_WALL, 64, m, r);
    const tp_fx height = cells == TP_CELLS_8 ? TP_FX(100.0 / 127)
                                             : TP_FX(25600.0 / 32767);
    double worst = 0;

    assert_true(any ? tp_pool_add_splash(pool, chance_fx(&chance, -7.9, 7.9),
                                         chance_fx(&chance, -7.9, 7.9),
                                         chance_fx(&chance, 0.4, 2), height)
                    : tp_pool_add_splash(pool, 0, 0, TP_FX(1), height));
    while (pool->gear != 0) {
        run(pool, pool->gear < 64 ? (int)pool->gear : 64);
        assert_true(tp_pool_stats(pool).sum == 0);
    }
    for (*rest = 0; !pool->at_rest; ++*rest) {
        tp_pool_step(pool);
        worst = fmax(worst, fabs((double)tp_pool_stats(pool).sum) / 4096);
        assert_true(*rest < 5000);
    }
    free(pool);
    return worst;
}

/* The models' figures for r >= 0.35: 0.72 LSB at most, and 82 ticks of gear B. */
static void two_gears_drift_by_less_than_one_lsb(void **state)
{
    (void)state;
    static const double rate[] = { 0.35, 0.433, 0.484 };
    double any = 0;

    printf("# largest |mean|, LSB, of one hat; ticks of gear B\n"
           "# bits  m  r = 0.35       0.433       0.484\n");
    for (uint32_t n = 0; n < 8; n++) {
        const uint32_t m = 4 + 2 * (n % 4);
        printf("# %4d %2d", n < 4 ? 8 : 16, (int)m);
        for (int i = 0; i < 3; i++) {
            const tp_cells cells = n < 4 ? TP_CELLS_8 : TP_CELLS_16;
            int rest;
            if (m == 10 && i < 2 && !soak())
                continue;
            const double mean = mean_of_hat(cells, m, rate[i], false, &rest);
            printf("  %6.4f %3d", mean, rest);
            assert_true(mean <= 0.72);
            assert_in_range(rest, 1, 82);
            if (m <= 6 || soak())
                any = fmax(any, mean_of_hat(cells, m, rate[i], true, &rest));
        }
        printf("\n");
    }
    printf("# any hat, anywhere: up to %.4f LSB\n", any);
}

/* Injections into water that gear B has begun to settle: the remainder of the velocities'
 * sum after gear B's truncation must not become gear A's drift, which lasts 2^m ticks and
 * once reached 452 LSB at m = 10.  The remaining drift is that of gear B itself between two
 * splashes: 1.19 LSB at most in 62 runs, all at m = 10. */
static double mean_of_hats(tp_cells cells, uint32_t m)
{
    tp_pool *const pool = tank(cells, TP_EDGES_WALL, 24, m, 0.484);
    const tp_fx height = cells == TP_CELLS_8 ? TP_FX(20.0 / 127) : TP_FX(20.0 / 32767);
    double worst = 0;

    for (int tick = 0, still = 0; tick < 12000; tick++) {
        if (pool->gear == 0 && still++ == (int)m + 3) {
            assert_true(tp_pool_add_splash(pool, chance_fx(&chance, -2.9, 2.9),
                                    chance_fx(&chance, -2.9, 2.9), TP_FX(0.6), height));
            still = 0;
        }
        tp_pool_step(pool);
        if (tick % 16 == 0)
            worst = fmax(worst, fabs((double)look_bounded(pool).sum) / (24 * 24));
    }
    free(pool);
    return worst;
}

static void water_stirred_again_while_it_settles_does_not_drift(void **state)
{
    (void)state;
    double worst = 0;

    printf("# hats of 20 LSB, each when gear B has just begun: largest |mean|, LSB\n"
           "# bits  m = 4       6       8      10\n");
    for (int n = 0; n < 2; n++) {
        printf("# %4d", n ? 16 : 8);
        for (uint32_t m = 4; m <= 10; m += 2) {
            const double mean = mean_of_hats(n ? TP_CELLS_16 : TP_CELLS_8, m);
            printf("  %6.2f", mean);
            worst = fmax(worst, mean);
        }
        printf("\n");
    }
    assert_true(worst < 2);
}

/* Volume of a splash's water until rest, by kind of cells and of edges. */
static void volume(tp_cells cells, tp_edges edges)
{
    tp_pool *const pool = tank(cells, edges, 48, 6, 0.484);
    double worst = 0, moved = 0;
    int ticks = 0;

    assert_true(tp_pool_add_splash(pool, chance_fx(&chance, -5, 5),
                                   chance_fx(&chance, -5, 5), TP_FX(1), TP_FX(0.7)));
    for (uint32_t i = 0; i < tp_pool_count(pool); i++)
        moved += abs(tp_pool_cell_height(pool, i)) / 2.0;
    for (; !pool->at_rest; ticks++) {
        assert_true(ticks < 20000);
        tp_pool_step(pool);
        const int64_t sum = tp_pool_stats(pool).sum;
        worst = fmax(worst, fabs((double)sum));
        assert_true(cells != TP_CELLS_32 || sum == 0);
    }
    const tp_pool_state look = tp_pool_stats(pool);
    printf("# %4d  %-6s  %17.0f  %10.3g %%  %8d  %7d\n", 8 << cells,
           edges == TP_EDGES_WALL ? "walls" : edges == TP_EDGES_TILE ? "tiled" : "sponge",
           worst, 100 * worst / moved, ticks, look.highest);
    assert_true(look.sum == 0 && look.fastest == 0);
    assert_true(edges == TP_EDGES_SPONGE || worst <= 0.72 * tp_pool_count(pool));
    free(pool);
}

static void no_volume_is_lost(void **state)
{
    (void)state;
    printf("# bits  edges   volume error, LSB  of the crest  rests at  residue\n");
    for (int n = 0; n < 9; n++)
        volume((tp_cells)(n / 3), (tp_edges)(n % 3));
}

/* -- dead zones [C14] ---------------------------------------------------------------- */

/* True if any cell moves in one step; otherwise none ever will. */
static bool moves(tp_pool *pool, bool gear_a)
{
    pool->gear = gear_a ? 2 : 0;
    pool->at_rest = 0;
    tp_pool_step(pool);
    return tp_pool_stats(pool).fastest != 0;
}

static bool cell_moves(double r, bool gear_a, int32_t height)
{
    tp_pool *const pool = tank(TP_CELLS_16, TP_EDGES_WALL, 16, 6, r);
    tp_pool_add_cell_height(pool, 7, 8, height);
    const bool moved = moves(pool, gear_a);
    free(pool);
    return moved;
}

/* True if the lowest mode of an N x 16 tank moves: along z the mode is constant. */
static bool mode_moves(double r, bool gear_a, uint32_t n, int32_t height)
{
    tp_pool_config c = pool_config(TP_CELLS_16, TP_EDGES_WALL, n, 16);
    tp_pool *const pool = pool_make(&c);
    pool->courant_sq_q10 = r2q_of(r);
    for (uint32_t i = 0; i < 16 * n; i++)
        tp_pool_add_cell_height(pool, i % n, i / n,
                                (int32_t)lround(height * cos(PI * (i % n + 0.5) / n)));
    const bool moved = moves(pool, gear_a);
    free(pool);
    return moved;
}

/* With q = r^2 (1 - delta / 2) a single cell does not move while 4 q height < 1, in either
 * gear: motion of F below the cell's own -4 comes from its neighbours, by the carry. */
static int least_cell(double r, bool gear_a)
{
    int32_t height = 1;
    while (!cell_moves(r, gear_a, height))
        height++;
    return height;
}

/* Finds the first height that moves, and the height from which on all heights move.  Gear
 * A's carry sums F up to the slope: no motion while q pi height / N < 1/2.  Gear B needs q
 * F >= 1 somewhere, F = pi^2 height / N^2, to which the rounding of the heights adds. */
static void live_modes(double r, bool gear_a, uint32_t n, double formula,
                       int first_last[2])
{
    const int32_t most = (int32_t)(1.2 * formula) + 4;
    const int32_t step = most / 400 + 1;

    first_last[0] = first_last[1] = 0;
    for (int32_t h = step; h <= most; h += step) {
        const bool moved = mode_moves(r, gear_a, n, h);
        if (moved && first_last[0] == 0)
            first_last[0] = h;
        if (!moved)
            first_last[1] = h + step;
    }
}

static void dead_zones_are_those_of_the_models(void **state)
{
    (void)state;
    static const double rate[] = { 0.1, 0.25, 0.35, 0.484 };

    printf("# r      gear  lone cell moves from  formula;  lowest mode of 16, 32, 64: "
           "first, all from, formula\n");
    for (int i = 0; i < 8; i++) {
        const double r = rate[i / 2], q = r2q_of(r) / 1024.0 * (1 - 1 / 128.0);
        const int cell = least_cell(r, i % 2 == 0);
        printf("# %.3f  %c  %20d %8.2f", r, i % 2 == 0 ? 'A' : 'B', cell, 1 / (4 * q));
        assert_true(cell == (int)ceil(1 / (4 * q)));
        for (uint32_t n = 16; n <= 64; n *= 2) {
            const double formula = i % 2 == 0 ? n / (2 * PI * q) : n * n / (PI * PI * q);
            int live[2];
            if (formula > 30000)
                continue;
            live_modes(r, i % 2 == 0, n, formula, live);
            printf("   %5d %5d %5.0f", live[0], live[1], formula);
            assert_in_range(live[0], 0.7 * formula, 1.06 * formula + 2);
            assert_in_range(live[1], 0.9 * formula, 1.06 * formula + 2);
        }
        printf("\n");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(full_range_water_comes_to_exact_rest_within_the_bound),
        cmocka_unit_test(gear_b_alone_comes_to_a_stand),
        cmocka_unit_test(two_gears_drift_by_less_than_one_lsb),
        cmocka_unit_test(water_stirred_again_while_it_settles_does_not_drift),
        cmocka_unit_test(no_volume_is_lost),
        cmocka_unit_test(dead_zones_are_those_of_the_models),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("stability of pools, gears", tests, NULL, NULL);
}
