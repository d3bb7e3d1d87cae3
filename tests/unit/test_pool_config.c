/* SPDX-License-Identifier: MIT */
/* Valid pools, the errors for invalid configurations, and copies of a pool by its bytes. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/pools.h"

static uint64_t chance;

static void assert_says(const tp_pool_config *config, const char *sentence)
{
    tp_error err;
    tp_pool pool;
    char text[160];

    assert_int_not_equal(tp_pool_check(config, &err), TP_OK);
    tp_error_text(&err, text, sizeof text);
    assert_string_equal(text, sentence);
    assert_int_equal(tp_pool_bytes(config), 0);
    assert_int_not_equal(tp_pool_init(&pool, config, NULL), TP_OK);
}

static void sizes_are_16_to_512(void **state)
{
    (void)state;
    tp_pool_config c = pool_config(TP_CELLS_16, TP_EDGES_WALL, 16, 512);
    assert_true(tp_pool_bytes(&c) > 16 * 512 * 4);
    c.cols = 15;
    assert_says(&c, "cols: pool of 15 x 512 cells; 16 x 16 to 512 x 512 can be computed");
    c.cols = 16;
    c.rows = 513;
    assert_says(&c, "rows: pool of 16 x 513 cells; 16 x 16 to 512 x 512 can be computed");
}

static void numbers_have_ranges(void **state)
{
    (void)state;
    const tp_pool_config good = pool_config(TP_CELLS_16, TP_EDGES_SPONGE, 32, 32);
    tp_pool_config c = good;
    assert_int_equal(tp_pool_check(&c, NULL), TP_OK);
    c.courant = TP_FX(0.81);
    assert_says(&c, "courant is outside the range of pools");
    c = good, c.damping = 3;
    assert_says(&c, "damping is outside the range of pools");
    c = good, c.damping = 11;
    assert_says(&c, "damping is outside the range of pools");
    c = good, c.sponge = 65;
    assert_says(&c, "sponge is outside the range of pools");
    c = good, c.range = 0;
    assert_says(&c, "max_height is outside the range of pools");
    c = good, c.cell = TP_FX(51);
    assert_says(&c, "cell is outside the range of pools");
    c = good, c.drive_min = 2, c.drive_max = 1;
    assert_says(&c, "drive_min is above drive_max");
    c = good, c.cells = (tp_cells)3;
    assert_says(&c, "cell_bits is outside the range of pools");
    const tp_grey none = { 4, 0, NULL };
    c = good, c.mask = &none;
    assert_says(&c, "mask has no samples: 4 x 0");
}

/* (1 - 1 / (2 - delta)) / 2 for every damping, from both sides. */
static void r_beyond_the_bound_is_refused(void **state)
{
    (void)state;
    for (uint32_t m = 4; m <= 10; m++) {
        const double bound = 1024 * (1 - 1 / (2 - pow(2, -(double)m))) / 2;
        tp_pool_config c = pool_config(TP_CELLS_32, TP_EDGES_TILE, 32, 32);
        c.damping = m;
        for (uint32_t courant_sq_q10 = 230; courant_sq_q10 < 280; courant_sq_q10++) {
            c.courant = (tp_fx)lround(sqrt(courant_sq_q10 / 1024.0) * 65536);
            const tp_status status = tp_pool_check(&c, NULL);
            assert_int_equal(status, courant_sq_q10 <= bound ? TP_OK : TP_E_POOL_COURANT);
        }
    }
}

/* The bound in the message is usable, and 0.49 is usable for any damping. */
static void the_bound_that_is_said_is_none_too_high(void **state)
{
    (void)state;
    for (uint32_t m = 4; m <= 10; m++) {
        tp_pool_config c = pool_config(TP_CELLS_32, TP_EDGES_TILE, 32, 32);
        c.damping = m;
        c.courant = TP_FX(0.49);
        assert_int_equal(tp_pool_check(&c, NULL), TP_OK);
        for (c.courant = TP_FX(0.49); c.courant <= TP_FX(0.8); c.courant += 7) {
            tp_error err = { .code = TP_OK };
            if (tp_pool_check(&c, &err) == TP_OK)
                continue;
            assert_true(err.a > err.b && err.a <= 800 && err.b >= 490);
            tp_pool_config at_bound = c;
            at_bound.courant = (tp_fx)(err.b * 65536 / 1000);
            assert_int_equal(tp_pool_check(&at_bound, NULL), TP_OK);
        }
    }
    tp_pool_config c = pool_config(TP_CELLS_16, TP_EDGES_WALL, 32, 32);
    c.courant = TP_FX(0.75);
    assert_says(&c, "courant of 0.750 is above 0.497, the bound of this damping; water "
                    "would not come to rest");
}

/* A copy in a block of exactly its bytes (under the sanitizers), also after a move of the
 * block. */
static void a_copy_of_its_bytes_is_a_snapshot(void **state)
{
    (void)state;
    for (int n = 0; n < 18; n++) {
        tp_pool_config c = pool_config((tp_cells)(n % 3), (tp_edges)(n / 3 % 3), 17, 23);
        c.mask = n >= 9 ? pool_mask(&chance, 17, 23, 50) : NULL;
        c.drive_min = n % 2 ? TP_FX(0.05) : 0;
        c.drive_max = 2 * c.drive_min;
        c.drive_amplitude = TP_FX(0.5);
        tp_pool *const pool = pool_make(&c);
        const size_t bytes = tp_pool_bytes(&c);
        pool_fill(pool, &chance, 100);
        pool_steps(pool, 20);
        tp_pool *const copy = malloc(bytes);
        memcpy(copy, pool, bytes);
        assert_int_equal(pool->tick, 20);
        pool_steps(pool, 50);
        pool_steps(copy, 50);
        assert_memory_equal(pool, copy, bytes);
        free(pool);
        free(copy);
    }
}

static void a_pool_begins_still_and_stays_so(void **state)
{
    (void)state;
    for (int n = 0; n < 9; n++) {
        const tp_pool_config c = pool_config((tp_cells)(n % 3), (tp_edges)(n / 3), 20,
                                             16);
        tp_pool *const pool = pool_make(&c);
        pool_steps(pool, 3);
        const tp_pool_state look = tp_pool_stats(pool);
        assert_true(look.at_rest && look.sum == 0 && look.highest == 0);
        assert_int_equal(pool->tick, 3);
        free(pool);
    }
}

/* 4 x 2 samples over 16 x 16 cells: each sample covers 4 x 8 cells. */
static void the_mask_is_laid_over_all_cells(void **state)
{
    (void)state;
    static const uint16_t sample[8] = { 0, 65535, 32768, 32767,
                                        65535, 65535, 0, 65535 };
    const tp_grey mask = { 4, 2, sample };
    tp_pool_config c = pool_config(TP_CELLS_8, TP_EDGES_WALL, 16, 16);
    c.mask = &mask;
    tp_pool *const pool = pool_make(&c);

    for (uint32_t y = 0; y < 16; y++)
        for (uint32_t x = 0; x < 16; x++)
            assert_int_equal(tp_pool_is_wall_or_outside(pool, x, y),
                             sample[y / 8 * 4 + x / 4] < 32768);
    free(pool);
}

static void nothing_passes_a_wall_but_through_its_gap(void **state)
{
    (void)state;
    for (int n = 0; n < 6; n++) {
        uint16_t sample[32 * 32];
        const tp_grey mask = { 32, 32, sample };
        tp_pool_config c = pool_config((tp_cells)(n % 3), TP_EDGES_WALL, 32, 32);
        const bool gap = n >= 3;
        c.mask = &mask;
        for (int i = 0; i < 32 * 32; i++)
            sample[i] = i % 32 == 16 && !(gap && i / 32 == 16) ? 0 : 65535;
        tp_pool *const pool = pool_make(&c);
        assert_true(tp_pool_add_splash(pool, TP_FX(-2), 0, TP_FX(0.1), TP_FX(0.9)));
        pool_steps(pool, 60);
        int32_t beyond = 0;
        for (uint32_t i = 0; i < 32 * 15; i++)
            beyond |= tp_pool_height_lsb(pool, 17 + i % 15, i / 15);
        assert_int_equal(beyond != 0, gap);
        free(pool);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sizes_are_16_to_512),
        cmocka_unit_test(numbers_have_ranges),
        cmocka_unit_test(r_beyond_the_bound_is_refused),
        cmocka_unit_test(the_bound_that_is_said_is_none_too_high),
        cmocka_unit_test(a_copy_of_its_bytes_is_a_snapshot),
        cmocka_unit_test(a_pool_begins_still_and_stays_so),
        cmocka_unit_test(the_mask_is_laid_over_all_cells),
        cmocka_unit_test(nothing_passes_a_wall_but_through_its_gap),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("pool config", tests, NULL, NULL);
}
