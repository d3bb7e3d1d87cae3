/* SPDX-License-Identifier: MIT */
/* Cells of 8 and 16 bits: the shared vectors, the models' own equations in 64 bits, and the
 * promises of the two gears: bounded, exact rest, no drift. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/pool.h"
#include "pixel/pixel.h"
#include "tests/lib/pools.h"

static uint64_t chance;

/* -- the vectors --------------------------------------------------------------- */

/* CRC-32 of all heights, then all velocities, as int16, low byte first. */
static uint32_t crc_of(const tp_pool *pool)
{
    static uint8_t bytes[4 * 16 * 16];
    size_t n = 0;

    for (uint32_t i = 0; i < 2 * pool->cols * pool->rows; i++) {
        const uint32_t at = i % (pool->cols * pool->rows);
        const uint32_t x = at % pool->cols, y = at / pool->cols;
        const int32_t value = i == at ? tp_pool_height_lsb(pool, x, y)
                                      : tp_pool_velocity(pool, x, y);
        bytes[n++] = (uint8_t)value;
        bytes[n++] = (uint8_t)((uint32_t)value >> 8);
    }
    return tp_crc32(0, bytes, n);
}

/* The vectors' tanks are smaller than a pool may be: a pool of 16 rows is cut to the
 * vector's rows, which no part of the step can notice. */
static tp_pool *vector_pool(uint32_t bits, uint32_t cols, uint32_t rows,
                            uint32_t courant_sq_q10, uint32_t m, const char *init)
{
    tp_pool_config c = pool_config(bits == 8 ? TP_CELLS_8 : TP_CELLS_16, TP_EDGES_WALL,
                                   cols, 16);
    c.damping = m;
    tp_pool *const pool = pool_make(&c);
    pool->rows = rows;
    pool->courant_sq_q10 = courant_sq_q10;
    while (*init != '\0') {
        char *end;
        const uint32_t at = (uint32_t)strtoul(init, &end, 10);
        const int32_t height = (int32_t)strtol(end + 1, &end, 10);
        assert_int_equal(tp_pool_add_cell_height(pool, at % cols, at / cols, height),
                         height);
        init = *end == ';' ? end + 1 : end;
    }
    pool->gear = 24;
    return pool;
}

static void steps_match_the_vectors(void **state)
{
    (void)state;
    FILE *const file = fopen("tests/vectors/automaton_int.csv", "r");
    char line[512], init[128];
    tp_pool *pool = NULL;
    uint32_t rows = 0, now = UINT32_MAX;

    assert_non_null(file);
    while (fgets(line, sizeof line, file) != NULL) {
        uint32_t c, bits, n, m, courant_sq_q10, damping, step, crc;
        int32_t sum_h, sum_v, highest;
        if (sscanf(line,
                   "%" SCNu32 ",%" SCNu32 ",%" SCNu32 ",%" SCNu32 ",%" SCNu32 ",%" SCNu32
                   ",%127[^,],%" SCNu32 ",%*c,%" SCNd32 ",%" SCNd32 ",%" SCNd32
                   ",%" SCNu32,
                   &c, &bits, &n, &m, &courant_sq_q10, &damping, init, &step, &sum_h,
                   &sum_v, &highest, &crc)
            != 12)
            continue;
        if (c != now) {
            free(pool);
            pool = vector_pool(bits, n, m, courant_sq_q10, damping, init);
            now = c;
        }
        pool_steps(pool, (int)(step - (uint32_t)pool->tick));
        assert_int_equal(crc_of(pool), crc);
        assert_int_equal(tp_pool_stats(pool).sum, sum_h);
        assert_int_equal(tp_pool_stats(pool).highest, highest);
        rows++;
    }
    free(pool);
    fclose(file);
    print_message("    %" PRIu32 " CRCs\n", rows);
    assert_int_equal(rows, 78);
}

/* -- the models, as printed -------------------------------------------------------- */

static void assert_same(const tp_pool *pool, const ref_pool *ref)
{
    for (int32_t i = 0; i < ref->cols * ref->rows; i++) {
        const uint32_t x = (uint32_t)(i % ref->cols), y = (uint32_t)(i / ref->cols);
        assert_int_equal(tp_pool_height_lsb(pool, x, y), ref->h[i]);
        assert_int_equal(tp_pool_velocity(pool, x, y), ref->v[i]);
    }
    assert_int_equal(pool->at_rest, ref->at_rest);
}

/* The sponge's damping by its own formula in double precision. */
static void soak_reference(ref_pool *ref, double width)
{
    const double dmax = width > 16 ? 8 / width : 0.5;

    for (int32_t i = 0; i < ref->cols * ref->rows; i++) {
        const int32_t x = i % ref->cols, y = i / ref->cols;
        double d = fmin(fmin(x, y), fmin(ref->cols - 1 - x, ref->rows - 1 - y));
        d = fmin(d, width - 1e-9);
        const double j = -log2(dmax * pow((width - d) / width, 2));
        ref->own[i] = (int32_t)fmin(fmax(floor(j + 0.5), 1), ref->m);
    }
}

static void step_equals_the_models(tp_edges edges, uint32_t walls)
{
    static ref_pool ref;

    for (int n = 0; n < 24; n++) {
        tp_pool_config c = pool_config(n % 2 ? TP_CELLS_8 : TP_CELLS_16, edges,
                                       (uint32_t)chance_int(&chance, 16, 40),
                                       (uint32_t)chance_int(&chance, 16, 40));
        c.damping = (uint32_t)chance_int(&chance, 4, 10);
        c.sponge = (uint32_t)chance_int(&chance, 4, 64);
        c.mask = walls ? pool_mask(&chance, c.cols, c.rows, walls) : NULL;
        tp_pool *const pool = pool_make(&c);
        /* includes values that cannot be configured: odd, and beyond every bound */
        pool->courant_sq_q10 = (uint32_t)chance_int(&chance, 0, 767);
        pool_fill(pool, &chance, n % 3 ? 40 : 32767);
        pool->gear = 30;
        ref_pool_read(&ref, pool);
        if (edges == TP_EDGES_SPONGE)
            soak_reference(&ref, c.sponge);
        for (int tick = 0; tick < 60; tick++) {
            tp_pool_step(pool);
            if (!ref.at_rest)
                ref_gears(&ref);
            assert_same(pool, &ref);
        }
        free(pool);
    }
}

static void walled_steps_are_the_models(void **state)
{
    (void)state;
    step_equals_the_models(TP_EDGES_WALL, 0);
}

static void tiled_steps_are_the_models(void **state)
{
    (void)state;
    step_equals_the_models(TP_EDGES_TILE, 0);
}

static void steps_between_walls_are_the_models(void **state)
{
    (void)state;
    step_equals_the_models(TP_EDGES_WALL, 60);
    step_equals_the_models(TP_EDGES_TILE, 60);
}

static void sponge_steps_are_the_models(void **state)
{
    (void)state;
    step_equals_the_models(TP_EDGES_SPONGE, 0);
    step_equals_the_models(TP_EDGES_SPONGE, 40);
}

/* -- promises ---------------------------------------------------------------------- */

/* Ticks until all cells are 0; -1 if more than `most`. */
static int ticks_to_rest(tp_pool *pool, int most)
{
    for (int tick = 1; tick <= most; tick++) {
        tp_pool_step(pool);
        if (tp_pool_stats(pool).at_rest)
            return tick;
    }
    return -1;
}

static void the_droplet_of_the_table_rests_when_it_says(void **state)
{
    (void)state;
    /* automaton_settle_table.csv: 64 x 64, r = 0.4841; bits, m, TA, settle */
    static const int table[4][4] = {
        { 8, 4, 81, 96 }, { 8, 6, 324, 348 }, { 16, 4, 259, 276 }, { 16, 6, 1034, 1061 },
    };

    for (int n = 0; n < 4; n++) {
        const int *const row = table[n];
        tp_pool_config c = pool_config(row[0] == 8 ? TP_CELLS_8 : TP_CELLS_16,
                                       TP_EDGES_WALL, 64, 64);
        c.damping = (uint32_t)row[1];
        tp_pool *const pool = pool_make(&c);
        const tp_fx height = row[0] == 8 ? TP_FX(100.0 / 127) : TP_FX(25600.0 / 32767);
        assert_true(tp_pool_add_splash(pool, 0, 0, TP_FX(1), height));
        assert_int_equal(pool->gear, row[2]);
        const int rest = ticks_to_rest(pool, 2000);
        const tp_pool_state look = tp_pool_stats(pool);
        print_message("    %2d bits, m %d: rests at %d (table %d)\n", row[0], row[1],
                      rest, row[3]);
        assert_in_range(rest, (unsigned)row[2], (unsigned)row[3] + 30);
        assert_true(look.sum == 0 && look.highest == 0 && look.fastest == 0);
        free(pool);
    }
}

/* A pocket between walls may begin with all cells at the same full height: only peeling
 * empties the pocket, one LSB per tick. */
static void full_range_water_stays_in_range_and_rests(void **state)
{
    (void)state;
    for (int n = 0; n < 12; n++) {
        tp_pool_config c = pool_config(n % 2 ? TP_CELLS_8 : TP_CELLS_16,
                                       (tp_edges)(n % 3), 24, 24);
        const int32_t full = n % 2 ? 127 : 32767;
        c.damping = 4 + (uint32_t)n % 3;
        c.mask = n >= 6 ? pool_mask(&chance, 24, 24, 30) : NULL;
        tp_pool *const pool = pool_make(&c);
        pool_fill(pool, &chance, full);
        int tick = 0;
        for (; tick < 40000 && !tp_pool_stats(pool).at_rest; tick++) {
            tp_pool_step(pool);
            const tp_pool_state look = tp_pool_stats(pool);
            assert_true(look.highest <= full && look.fastest <= full);
        }
        assert_true(tp_pool_stats(pool).at_rest);
        free(pool);
    }
}

/* Roundings of a step add up to less than half, so away from the clamps the sum is
 * exact. */
static void the_sum_is_exact_in_gear_a(void **state)
{
    (void)state;
    for (int n = 0; n < 8; n++) {
        tp_pool_config c = pool_config(n % 2 && n < 4 ? TP_CELLS_8 : TP_CELLS_16,
                                       n & 2 ? TP_EDGES_TILE : TP_EDGES_WALL, 32, 27);
        c.mask = n >= 4 ? pool_mask(&chance, 32, 27, 40) : NULL;
        c.damping = 8;
        tp_pool *const pool = pool_make(&c);
        pool_fill(pool, &chance, 12);
        pool->gear = 2000;
        const int64_t sum = tp_pool_stats(pool).sum;
        for (int tick = 0; tick < 1000; tick++) {
            tp_pool_step(pool);
            assert_int_equal(tp_pool_stats(pool).sum, sum);
        }
        free(pool);
    }
}

/* Waves started inside the sponge take their sum along; the mean returns. */
static void a_sponge_does_not_drift(void **state)
{
    (void)state;
    for (int n = 0; n < 2; n++) {
        tp_pool_config c = pool_config(n ? TP_CELLS_8 : TP_CELLS_16, TP_EDGES_SPONGE, 48,
                                       48);
        c.sponge = 16;
        tp_pool *const pool = pool_make(&c);
        const double full = n ? 127 : 32767;
        double worst = 0;
        for (int tick = 0; tick < 1500; tick++) {
            if (tick % 20 == 0)
                tp_pool_add_splash(pool, chance_fx(&chance, -5.5, 5.5),
                                   chance_fx(&chance, -5.5, 5.5), TP_FX(1), TP_FX(0.25));
            tp_pool_step(pool);
            worst = fmax(worst, fabs((double)tp_pool_stats(pool).sum) / (48 * 48) / full);
        }
        print_message("    mean up to %.2g of the range\n", worst);
        assert_true(worst < 0.01);
        free(pool);
    }
}

/* Sampled velocities equal the change of the heights, without peeling. */
static void velocity_is_the_last_change_of_height(void **state)
{
    (void)state;
    const tp_pool_config c = pool_config(TP_CELLS_16, TP_EDGES_TILE, 20, 30);
    tp_pool *const pool = pool_make(&c);
    pool_fill(pool, &chance, 20000);
    for (int tick = 0; tick < 20; tick++) {
        const int32_t before = tp_pool_height_lsb(pool, 7, 11);
        tp_pool_step(pool);
        assert_int_equal(tp_pool_velocity(pool, 7, 11),
                         tp_pool_height_lsb(pool, 7, 11) - before);
    }
    free(pool);
}

static void beyond_the_bound_water_does_not_rest_but_stays_in_range(void **state)
{
    (void)state;
    const tp_pool_config c = pool_config(TP_CELLS_16, TP_EDGES_WALL, 32, 32);
    tp_pool *const pool = pool_make(&c);
    pool->courant_sq_q10 = 576;                        /* r = 0.75 */
    tp_pool_add_splash(pool, 0, 0, TP_FX(1), TP_FX(0.05));
    pool_steps(pool, 2000);
    assert_int_equal(tp_pool_stats(pool).fastest, 32767);
    assert_false(tp_pool_stats(pool).at_rest);
    free(pool);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_match_the_vectors),
        cmocka_unit_test(walled_steps_are_the_models),
        cmocka_unit_test(tiled_steps_are_the_models),
        cmocka_unit_test(steps_between_walls_are_the_models),
        cmocka_unit_test(sponge_steps_are_the_models),
        cmocka_unit_test(the_droplet_of_the_table_rests_when_it_says),
        cmocka_unit_test(full_range_water_stays_in_range_and_rests),
        cmocka_unit_test(the_sum_is_exact_in_gear_a),
        cmocka_unit_test(a_sponge_does_not_drift),
        cmocka_unit_test(velocity_is_the_last_change_of_height),
        cmocka_unit_test(beyond_the_bound_water_does_not_rest_but_stays_in_range),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("pool/flux_gears", tests, NULL, NULL);
}
