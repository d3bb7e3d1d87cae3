/* SPDX-License-Identifier: MIT */
/* Cells of 32 bits: the model's own equation in 64 bits, the closed form of a wave, and the
 * promises of the fluxes: an exact sum, exact rest, and no height beyond the range. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/pool.h"
#include "pixel/pixel.h"
#include "tests/lib/pools.h"

#define FULL ((1 << 30) - 1)
#define PI   3.14159265358979323846

static uint64_t chance;

static void assert_same(const tp_pool *pool, const ref_pool *ref)
{
    for (int32_t i = 0; i < ref->cols * ref->rows; i++)
        assert_int_equal(tp_pool_height_lsb(pool, (uint32_t)(i % ref->cols),
                                        (uint32_t)(i / ref->cols)), ref->h[i]);
}

static void soak_reference(ref_pool *ref, const tp_pool *pool)
{
    const uint8_t *const own = (const uint8_t *)pool + pool->sponge;

    for (int32_t i = 0; i < ref->cols * ref->rows; i++) {
        const uint8_t column = own[i % ref->cols], row = own[ref->cols + i / ref->cols];
        ref->own[i] = column < row ? column : row;
    }
}

static void step_equals_the_model(tp_edges edges, uint32_t walls)
{
    static ref_pool ref;

    for (int n = 0; n < 16; n++) {
        tp_pool_config c = pool_config(TP_CELLS_32, edges,
                                       (uint32_t)chance_int(&chance, 16, 40),
                                       (uint32_t)chance_int(&chance, 16, 40));
        c.damping = (uint32_t)chance_int(&chance, 4, 10);
        c.mask = walls ? pool_mask(&chance, c.cols, c.rows, walls) : NULL;
        tp_pool *const pool = pool_make(&c);
        pool->courant_sq_q10 = (uint32_t)chance_int(&chance, 0, 767);
        pool_fill(pool, &chance, n % 3 ? 100000 : FULL);
        ref_pool_read(&ref, pool);
        if (edges == TP_EDGES_SPONGE)
            soak_reference(&ref, pool);
        const int64_t sum = tp_pool_stats(pool).sum;
        for (int tick = 0; tick < 60; tick++) {
            tp_pool_step(pool);
            ref_fluxes(&ref);
            assert_same(pool, &ref);
            const tp_pool_state look = tp_pool_stats(pool);
            assert_true(look.sum == sum && look.highest <= FULL);
        }
        free(pool);
    }
}

static void walled_steps_are_the_model_and_keep_the_sum(void **state)
{
    (void)state;
    step_equals_the_model(TP_EDGES_WALL, 0);
}

static void tiled_steps_are_the_model_and_keep_the_sum(void **state)
{
    (void)state;
    step_equals_the_model(TP_EDGES_TILE, 0);
}

static void steps_between_walls_are_the_model_and_keep_the_sum(void **state)
{
    (void)state;
    step_equals_the_model(TP_EDGES_WALL, 60);
    step_equals_the_model(TP_EDGES_TILE, 60);
}

static void sponge_steps_are_the_model_and_keep_the_sum(void **state)
{
    (void)state;
    step_equals_the_model(TP_EDGES_SPONGE, 0);
    step_equals_the_model(TP_EDGES_SPONGE, 40);
}

/* [C6] with the damping after the kick: h' = (1 + d - d a mu) h - d h_prev, h_prev = h at
 * first, for a mode cos(pi p (i + 1/2) / N) cos(pi q (j + 1/2) / M). */
static void a_mode_swings_as_its_closed_form(void **state)
{
    (void)state;
    const uint32_t cols = 64, rows = 48;
    const double amplitude = 1 << 24, a = 240 / 1024.0, d = 1 - 1 / 64.0;
    double worst = 0;

    for (int n = 0; n < 6; n++) {
        const tp_pool_config c = pool_config(TP_CELLS_32, TP_EDGES_WALL, cols, rows);
        tp_pool *const pool = pool_make(&c);
        const int p = chance_int(&chance, 1, 10), q = chance_int(&chance, 1, 10);
        const double mu = 4 * pow(sin(PI * p / 2 / cols), 2)
                        + 4 * pow(sin(PI * q / 2 / rows), 2);
        for (uint32_t y = 0; y < rows; y++)
            for (uint32_t x = 0; x < cols; x++)
                tp_pool_add_cell_height(pool, x, y, (int32_t)lround(amplitude
                    * cos(PI * p * (x + 0.5) / cols) * cos(PI * q * (y + 0.5) / rows)));
        const double shape = cos(PI * p * 0.5 / cols) * cos(PI * q * 0.5 / rows);
        double h = amplitude, last = amplitude;
        for (int tick = 0; tick < 200; tick++) {
            const double next = (1 + d - d * a * mu) * h - d * last;
            last = h;
            h = next;
            tp_pool_step(pool);
            worst =
                fmax(worst, fabs(tp_pool_height_lsb(pool, 0, 0) - h * shape) / amplitude);
        }
        free(pool);
    }
    print_message("    worst error %.2g of the amplitude in 200 ticks\n", worst);
    assert_true(worst < 2e-5);
}

static void a_drop_comes_to_exact_rest_and_stays(void **state)
{
    (void)state;
    for (int n = 0; n < 3; n++) {
        tp_pool_config c = pool_config(TP_CELLS_32, (tp_edges)n, 40, 40);
        c.damping = 5;
        tp_pool *const pool = pool_make(&c);
        tp_pool_add_splash(pool, 0, 0, TP_FX(1), TP_FX(0.5));
        int tick = 0;
        for (; tick < 6000 && !tp_pool_stats(pool).at_rest; tick++)
            tp_pool_step(pool);
        const tp_pool_state look = tp_pool_stats(pool);
        print_message("    edges %d: rests at %d, residue %d LSB of 2^-24 m\n", n, tick,
                      look.highest);
        assert_true(look.at_rest && look.sum == 0 && look.fastest == 0);
        assert_true(look.highest < 1 << 12);
        /* awake or asleep, the pool would not move */
        const uint32_t crc = tp_crc32(0, pool + 1, tp_pool_bytes(&c) - sizeof *pool);
        pool->at_rest = 0;
        pool_steps(pool, 10);
        assert_int_equal(tp_crc32(0, pool + 1, tp_pool_bytes(&c) - sizeof *pool), crc);
        free(pool);
    }
}

/* Heights at both ends of the range, and an r far beyond the bound. */
static void no_height_leaves_the_range_whatever_r_is(void **state)
{
    (void)state;
    const tp_pool_config c = pool_config(TP_CELLS_32, TP_EDGES_TILE, 17, 33);
    tp_pool *const pool = pool_make(&c);
    for (uint32_t y = 0; y < 33; y++)
        for (uint32_t x = 0; x < 17; x++)
            tp_pool_add_cell_height(pool, x, y,
                                    random_next(&chance) & 1 ? INT32_MAX : -INT32_MAX);
    assert_int_equal(tp_pool_stats(pool).highest, FULL);
    const int64_t sum = tp_pool_stats(pool).sum;
    pool->courant_sq_q10 = UINT32_MAX;
    for (int tick = 0; tick < 500; tick++) {
        tp_pool_step(pool);
        assert_true(tp_pool_stats(pool).highest <= FULL);
        assert_true(tp_pool_stats(pool).sum == sum);
    }
    free(pool);
}

static void velocity_is_the_last_change_of_height(void **state)
{
    (void)state;
    for (int n = 0; n < 2; n++) {
        tp_pool_config c = pool_config(TP_CELLS_32, n ? TP_EDGES_TILE : TP_EDGES_WALL,
                                       19, 21);
        tp_pool *const pool = pool_make(&c);
        pool_fill(pool, &chance, FULL);
        for (int tick = 0; tick < 40; tick++) {
            const uint32_t x = tick % 2 ? 0 : 18, y = tick % 3 ? 20 : 0;
            const int32_t before = tp_pool_height_lsb(pool, x, y);
            tp_pool_step(pool);
            assert_int_equal(tp_pool_velocity(pool, x, y),
                             tp_pool_height_lsb(pool, x, y) - before);
        }
        free(pool);
    }
}

/* For any height: between two ticks the water stands at H - back V, which must be in
 * range. */
static void what_is_added_keeps_both_ends_of_the_last_tick_in_the_range(void **state)
{
    (void)state;
    const tp_pool_config c = pool_config(TP_CELLS_32, TP_EDGES_TILE, 20, 16);
    tp_pool *const pool = pool_make(&c);

    pool_fill(pool, &chance, FULL);
    for (int n = 0; n < 4000; n++) {
        const uint32_t x = random_below(&chance, 20), y = random_below(&chance, 16);
        if (n % 40 == 0)
            tp_pool_step(pool);
        tp_pool_add_cell_height(pool, x, y, chance_word(&chance));
        const int64_t h = tp_pool_height_lsb(pool, x, y), v = tp_pool_velocity(pool, x, y);
        assert_true(llabs(h) <= FULL && llabs(h - v) <= FULL);
        const tp_height_slope at = tp_pool_height_slope(pool, chance_word(&chance),
                                                        chance_word(&chance), TP_FX_ONE);
        assert_true(abs(at.height) <= 64 * TP_FX_ONE);
    }
    free(pool);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walled_steps_are_the_model_and_keep_the_sum),
        cmocka_unit_test(tiled_steps_are_the_model_and_keep_the_sum),
        cmocka_unit_test(steps_between_walls_are_the_model_and_keep_the_sum),
        cmocka_unit_test(sponge_steps_are_the_model_and_keep_the_sum),
        cmocka_unit_test(a_mode_swings_as_its_closed_form),
        cmocka_unit_test(a_drop_comes_to_exact_rest_and_stays),
        cmocka_unit_test(no_height_leaves_the_range_whatever_r_is),
        cmocka_unit_test(velocity_is_the_last_change_of_height),
        cmocka_unit_test(what_is_added_keeps_both_ends_of_the_last_tick_in_the_range),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("pool flux", tests, NULL, NULL);
}
