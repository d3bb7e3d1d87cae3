/* SPDX-License-Identifier: MIT */
/* Water put into a pool: the shape and the sum of a splash, single cells, the duration of
 * the gear, and the drive. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/measure.h"
#include "tests/lib/pools.h"

static uint64_t chance;

/* In open water the splash is (1 - s) exp(-s), within 1/2 LSB of rounding, one LSB of
 * carry, and 1e-4 of the height for the bell table. */
static void the_hat_is_a_hat(void **state)
{
    (void)state;
    measure worst = { "hat", "tolerances", 0, 0, { 0 } };

    for (int n = 0; n < 12; n++) {
        const tp_cells cells = (tp_cells)(n % 3);
        const tp_pool_config c = pool_config(cells, TP_EDGES_TILE, 64, 64);
        tp_pool *const pool = pool_make(&c);
        const double sigma = chance_double(&chance, 1.5, 5.5);         /* cells */
        const tp_fx x = chance_fx(&chance, -8, 8), z = chance_fx(&chance, -8, 8);
        const double peak = tp_pool_from_metres(pool, TP_FX(0.75));
        assert_true(tp_pool_add_splash(pool, x, z, (tp_fx)lround(sigma * 0.25 * 65536),
                                       TP_FX(0.75)));
        for (uint32_t row = 0; row < 64; row++) {
            for (uint32_t col = 0; col < 64; col++) {
                double dx = fabs(col + 0.5 - 32 - x / 16384.0);
                double dz = fabs(row + 0.5 - 32 - z / 16384.0);
                dx = fmin(dx, 64 - dx);
                dz = fmin(dz, 64 - dz);
                const double s = (dx * dx + dz * dz) / (2 * sigma * sigma);
                const double want = peak * (1 - s) * exp(-s);
                measure_add(&worst, (tp_pool_height_lsb(pool, col, row) - want)
                            / (2.5 + peak * 3e-3), n, col, row);
            }
        }
        assert_true(tp_pool_stats(pool).sum == 0);
        free(pool);
    }
    measure_print(&worst);
    assert_true(worst.worst <= 1);
}

/* Splashes anywhere, also half in a corner or between walls; many splashes, until cells are
 * full. */
static void hats_add_up_to_nothing(void **state)
{
    (void)state;
    uint32_t refused = 0;

    for (int n = 0; n < 27; n++) {
        tp_pool_config c = pool_config((tp_cells)(n % 3), (tp_edges)(n / 3 % 3),
                                       (uint32_t)chance_int(&chance, 16, 50), 33);
        c.mask = n >= 9 ? pool_mask(&chance, c.cols, c.rows, 70) : NULL;
        tp_pool *const pool = pool_make(&c);
        for (int k = 0; k < 25; k++) {
            const tp_fx x = chance_fx(&chance, -7, 7), z = chance_fx(&chance, -5, 5);
            uint32_t col, row;
            const bool open = tp_pool_open_cell_at_point(pool, x, z, &col, &row);
            assert_int_equal(tp_pool_add_splash(pool, x, z, chance_scale(&chance, 0.01, 40),
                                         chance_fx(&chance, -1.5, 1.5)), open);
            refused += !open;
            assert_true(tp_pool_stats(pool).sum == 0);
        }
        free(pool);
    }
    assert_true(refused > 0);
}

static void a_cell_takes_what_fits(void **state)
{
    (void)state;
    for (int n = 0; n < 3; n++) {
        const int32_t full = n == 0 ? 127 : n == 1 ? 32767 : (1 << 30) - 1;
        const tp_pool_config c = pool_config((tp_cells)n, TP_EDGES_WALL, 16, 16);
        tp_pool *const pool = pool_make(&c);
        assert_int_equal(tp_pool_add_cell_height(pool, 3, 4, 100), 100);
        assert_int_equal(tp_pool_add_cell_height(pool, 3, 4, INT32_MAX), full - 100);
        assert_int_equal(tp_pool_add_cell_height(pool, 3, 4, INT32_MIN), -2 * full);
        assert_int_equal(tp_pool_height_lsb(pool, 3, 4), -full);
        assert_int_equal(tp_pool_add_cell_height(pool, 16, 4, 5), 0);
        assert_int_equal(tp_pool_add_cell_height(pool, 3, UINT32_MAX, 5), 0);
        assert_int_equal(tp_pool_height_lsb(pool, 16, 0), 0);
        assert_true(tp_pool_is_wall_or_outside(pool, 0, 16)
                    && !tp_pool_is_wall_or_outside(pool, 0, 15));
        free(pool);
    }
}

/* [C5]: the height of the preceding tick must stay in range too. */
static void what_is_added_keeps_the_past_in_range(void **state)
{
    (void)state;
    const tp_pool_config c = pool_config(TP_CELLS_8, TP_EDGES_TILE, 16, 16);
    tp_pool *const pool = pool_make(&c);

    pool_fill(pool, &chance, 127);
    for (int tick = 0; tick < 50; tick++) {
        tp_pool_step(pool);
        for (uint32_t i = 0; i < 256; i++) {
            tp_pool_add_cell_height(pool, i % 16, i / 16, chance_int(&chance, -300, 300));
            const int32_t h = tp_pool_height_lsb(pool, i % 16, i / 16);
            const int32_t v = tp_pool_velocity(pool, i % 16, i / 16);
            assert_true(abs(h) <= 127 && abs(h - v) <= 127);
        }
    }
    free(pool);
}

/* TA = ceil(2^(m+1) ln(A / 8)), for every A and m. */
static void gear_a_lasts_as_long_as_the_model_says(void **state)
{
    (void)state;
    tp_pool_config c = pool_config(TP_CELLS_16, TP_EDGES_WALL, 16, 16);
    tp_pool *const pool = pool_make(&c);

    for (pool->damping = 4; pool->damping <= 10; pool->damping++) {
        for (int32_t peak = 0; peak <= 32767; peak++) {
            const double time = peak > 8 ? (2 << pool->damping) * log(peak / 8.0) : 0;
            pool->gear = 0;
            tp_pool_start_carry_rounding(pool, peak & 1 ? peak : -peak);
            if (fabs(time - round(time)) > 1e-4)
                assert_int_equal(pool->gear, (int32_t)ceil(time));
            else
                assert_in_range(pool->gear, (uint32_t)time, (uint32_t)ceil(time) + 1);
        }
    }
    pool->damping = 6;
    pool->gear = 0;
    tp_pool_start_carry_rounding(pool, 25600);
    assert_int_equal(pool->gear, 1034);
    tp_pool_start_carry_rounding(pool,
                                 100); /* a smaller splash does not shorten the gear */
    assert_int_equal(pool->gear, 1034);
    tp_pool_start_carry_rounding(pool, INT32_MIN);
    assert_int_equal(pool->gear, 1065);     /* the same as at full range */
    free(pool);
}

static void metres_become_lsb_to_nearest(void **state)
{
    (void)state;
    for (int n = 0; n < 3000; n++) {
        tp_pool_config c = pool_config((tp_cells)(n % 3), TP_EDGES_WALL, 16, 16);
        static tp_pool *pool;
        if (n < 3)
            pool = pool_make(&c);
        pool->cells = (uint32_t)(n % 3);
        pool->range = chance_scale(&chance, 0.01, 64);
        const double full = n % 3 == 0 ? 127 : n % 3 == 1 ? 32767 : (1 << 30) - 1;
        const tp_fx metres = (tp_fx)random_number(&chance);
        const double lsb = n % 3 == 2 ? metres * 256.0 : metres * full / pool->range;
        assert_int_equal(tp_pool_from_metres(pool, metres),
                         (int32_t)fmax(fmin(floor(lsb + 0.5), full), -full));
        if (n < 2 || n == 2999)
            free(pool);
    }
}

static double rms(const tp_pool *pool)
{
    double sum = 0;
    for (uint32_t i = 0; i < pool->cols * pool->rows; i++)
        sum += pow(tp_pool_height_lsb(pool, i % pool->cols, i / pool->cols), 2);
    return sqrt(sum / (pool->cols * pool->rows));
}

/* [C16] measured 492 to 597 for these numbers in 38000 ticks of another sequence; the
 * present sequence, without random numbers, gives 478 to 593 in 8000. */
static void feeding_holds_the_band(void **state)
{
    (void)state;
    tp_pool_config c = pool_config(TP_CELLS_16, TP_EDGES_TILE, 64, 64);
    c.drive_min = TP_FX(512.0 / 32767);
    c.drive_max = TP_FX(700.0 / 32767);
    c.drive_amplitude = TP_FX(4096.0 / 32767);
    tp_pool *const pool = pool_make(&c);
    double low = 1e9, high = 0;

    pool_steps(pool, 200);
    for (int tick = 0; tick < 1500; tick++) {
        tp_pool_step(pool);
        low = fmin(low, rms(pool));
        high = fmax(high, rms(pool));
    }
    print_message("    rms %.0f to %.0f for 512, %" PRIu32 " injections\n", low, high,
                  pool->injections);
    assert_true(low > 475 && high < 600);
    assert_true(tp_pool_stats(pool).sum == 0);
    free(pool);
}

/* A splash of 1/4 of the height alone holds 344 of 512. */
static void too_low_a_feed_gains_authority(void **state)
{
    (void)state;
    for (int n = 0; n < 3; n++) {
        tp_pool_config c = pool_config((tp_cells)n,
                                       n == 2 ? TP_EDGES_WALL : TP_EDGES_TILE, 48, 48);
        c.range = n == 0 ? TP_FX(127) / 2 : TP_FX(1);
        c.drive_min = n == 0 ? TP_FX(3) : TP_FX(0.02);
        c.drive_max = 2 * c.drive_min;
        c.drive_amplitude = c.drive_min / 4;
        c.mask = n == 1 ? pool_mask(&chance, 48, 48, 40) : NULL;
        tp_pool *const pool = pool_make(&c);
        const int32_t asked = pool->drive_peak;
        pool_steps(pool, 2500);
        double low = 1e12, high = 0;
        for (int tick = 0; tick < 200; tick++) {
            tp_pool_step(pool);
            low = fmin(low, rms(pool));
            high = fmax(high, rms(pool));
        }
        const double want = tp_pool_from_metres(pool, c.drive_min);
        print_message("    cells %d: rms %.3g to %.3g for %.3g, hats of %d, not %d\n", n,
                      low, high, want, pool->drive_peak, asked);
        assert_true(pool->drive_peak > asked);
        assert_true(low > 0.8 * want && high < 2 * want);
        free(pool);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_hat_is_a_hat),
        cmocka_unit_test(hats_add_up_to_nothing),
        cmocka_unit_test(a_cell_takes_what_fits),
        cmocka_unit_test(what_is_added_keeps_the_past_in_range),
        cmocka_unit_test(gear_a_lasts_as_long_as_the_model_says),
        cmocka_unit_test(metres_become_lsb_to_nearest),
        cmocka_unit_test(feeding_holds_the_band),
        cmocka_unit_test(too_low_a_feed_gains_authority),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("pool/splash", tests, NULL, NULL);
}
