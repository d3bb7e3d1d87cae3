/* SPDX-License-Identifier: MIT */
/* The pool's surface between cells and ticks compared with double precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/measure.h"
#include "tests/lib/pools.h"

static uint64_t chance;

typedef struct { double height, slope_x, slope_z; } relief;

static double metres_per_lsb(const tp_pool *pool)
{
    return pool->cells == TP_CELLS_8 ? pool->range / 65536.0 / 127
         : pool->cells == TP_CELLS_16 ? pool->range / 65536.0 / 32767 : pow(2, -24);
}

/* Height of a cell that may lie outside: mirrored at a wall, or wrapped. */
static double height_at(const tp_pool *pool, int x, int y, double back)
{
    const int cols = (int)pool->cols, rows = (int)pool->rows;

    if (pool->edges == TP_EDGES_TILE) {
        x = (x + 4 * cols) % cols;
        y = (y + 4 * rows) % rows;
    }
    x = x < 0 ? -1 - x : x < cols ? x : 2 * cols - 1 - x;
    y = y < 0 ? -1 - y : y < rows ? y : 2 * rows - 1 - y;
    return metres_per_lsb(pool)
         * (tp_pool_height_lsb(pool, (uint32_t)x, (uint32_t)y)
            - back * tp_pool_velocity(pool, (uint32_t)x, (uint32_t)y));
}

/* Value n of a cell: height, slope along x, slope along z. */
static double value_at(const tp_pool *pool, int x, int y, double back, int n)
{
    const double two = 2 * pool->cell / 65536.0;

    if (n == 0)
        return height_at(pool, x, y, back);
    return n == 1
        ? (height_at(pool, x + 1, y, back) - height_at(pool, x - 1, y, back)) / two
        : (height_at(pool, x, y + 1, back) - height_at(pool, x, y - 1, back)) / two;
}

/* Bilinear at (u, w) in cells from the field's corner. */
static double sample(const tp_pool *pool, double u, double w, double back, int n)
{
    const int x = (int)floor(u - 0.5), y = (int)floor(w - 0.5);
    const double s = u - 0.5 - x, t = w - 0.5 - y;

    return (1 - t) * ((1 - s) * value_at(pool, x, y, back, n)
                      + s * value_at(pool, x + 1, y, back, n))
         + t * ((1 - s) * value_at(pool, x, y + 1, back, n)
                + s * value_at(pool, x + 1, y + 1, back, n));
}

static tp_pool *any_pool(tp_cells cells, tp_edges edges)
{
    tp_pool_config c = pool_config(cells, edges, (uint32_t)chance_int(&chance, 16, 40),
                                   (uint32_t)chance_int(&chance, 16, 40));
    c.cell = chance_scale(&chance, 0.01, 50);
    c.range = chance_scale(&chance, 0.01, 64);
    c.x = chance_fx(&chance, -1000, 1000);
    c.z = chance_fx(&chance, -1000, 1000);
    tp_pool *const pool = pool_make(&c);
    pool_fill(pool, &chance, cells == TP_CELLS_8 ? 127 : cells == TP_CELLS_16 ? 32767
                                                                       : (1 << 30) - 1);
    pool_steps(pool, chance_int(&chance, 0, 5));
    return pool;
}

/* Tolerances: a height is rounded to 2^-16 m; a weight has 16 bits for a difference of up
 * to two ranges, in both directions; a position has 2^-33 of the field; slopes likewise
 * over two cells. */
static void samples_are_bilinear(void **state)
{
    (void)state;
    measure worst[3] = { { "height", "tolerances", 0, 0, { 0 } },
                         { "slope x", "tolerances", 0, 0, { 0 } },
                         { "slope z", "tolerances", 0, 0, { 0 } } };

    for (int n = 0; n < 90; n++) {
        tp_pool *const pool = any_pool((tp_cells)(n % 3), (tp_edges)(n / 3 % 3));
        const double cell = pool->cell / 65536.0;
        const double full = pool->cells == TP_CELLS_32 ? 64 : pool->range / 65536.0;
        const double weight = 2 * full * 3 / 65536;
        const double near[3] = { 1.0 / 65536 + weight, 1.0 / 65536 + 2 * weight / cell,
                                 1.0 / 65536 + 2 * weight / cell };
        for (int k = 0; k < 60; k++) {
            const double u = chance_double(&chance, 0, pool->cols - 0.001);
            const double w = chance_double(&chance, 0, pool->rows - 0.001);
            const tp_fx x = pool->x + (tp_fx)lround((u - pool->cols / 2.0) * pool->cell);
            const tp_fx z = pool->z + (tp_fx)lround((w - pool->rows / 2.0) * pool->cell);
            const tp_fx back = k % 2 ? 0 : chance_int(&chance, 0, 65536);
            const tp_height_slope got = tp_pool_height_slope(pool, x, z, back);
            const double got_of[3] = { got.height / 65536.0, got.slope_x / 65536.0,
                                       got.slope_z / 65536.0 };
            const double at_u = (x - pool->x) / (double)pool->cell + pool->cols / 2.0;
            const double at_w = (z - pool->z) / (double)pool->cell + pool->rows / 2.0;
            for (int i = 0; i < 3; i++)
                measure_add(&worst[i],
                            (got_of[i] - sample(pool, at_u, at_w, back / 65536.0, i))
                            / near[i], n, k, back);
        }
        free(pool);
    }
    for (int i = 0; i < 3; i++) {
        measure_print(&worst[i]);
        assert_true(worst[i].worst <= 1);
    }
}

/* A sample one whole tick back equals the sample of the preceding
 * tick. */
static void a_whole_tick_back_is_the_tick_before(void **state)
{
    (void)state;
    for (int n = 0; n < 18; n++) {
        tp_pool *const pool = any_pool((tp_cells)(n % 3), n % 2 ? TP_EDGES_TILE
                                                               : TP_EDGES_WALL);
        const tp_fx x = pool->x + pool->cell / 3, z = pool->z - pool->cell * 2;
        pool->gear = 10;                    /* no peeling */
        for (int tick = 0; tick < 4; tick++) {
            const tp_height_slope before = tp_pool_height_slope(pool, x, z, 0);
            tp_pool_step(pool);
            const tp_height_slope back = tp_pool_height_slope(pool, x, z, TP_FX_ONE);
            assert_int_equal(before.height, back.height);
            assert_int_equal(before.slope_x, back.slope_x);
            assert_int_equal(before.slope_z, back.slope_z);
        }
        free(pool);
    }
}

static void the_surface_glides_between_two_ticks(void **state)
{
    (void)state;
    for (int n = 0; n < 6; n++) {
        tp_pool *const pool = any_pool((tp_cells)(n % 3), TP_EDGES_TILE);
        const tp_fx now = tp_pool_height_slope(pool, pool->x, pool->z, 0).height;
        const tp_fx then = tp_pool_height_slope(pool, pool->x, pool->z, TP_FX_ONE).height;
        for (tp_fx back = 0; back <= TP_FX_ONE; back += 997) {
            const double want = now + (then - (double)now) * back / 65536;
            const tp_fx got = tp_pool_height_slope(pool, pool->x, pool->z, back).height;
            assert_true(fabs(got - want) <= 2);
        }
        free(pool);
    }
}

/* A tiled field is the same from every repeat except for a last bit, and has no visible
 * seam. */
static void a_tiled_field_has_no_seam(void **state)
{
    (void)state;
    tp_pool_config c = pool_config(TP_CELLS_16, TP_EDGES_TILE, 32, 48);
    tp_pool *const pool = pool_make(&c);

    pool_fill(pool, &chance, 3000);
    pool_steps(pool, 10);
    for (int k = 0; k < 2000; k++) {
        const tp_fx x = chance_fx(&chance, -4, 4), z = chance_fx(&chance, -6, 6);
        const tp_height_slope here = tp_pool_height_slope(pool, x, z, 0);
        const tp_height_slope far =
            tp_pool_height_slope(pool, x + chance_int(&chance, -3000, 3000) * TP_FX(8),
                                 z + chance_int(&chance, -2000, 2000) * TP_FX(12), 0);
        assert_in_range(here.height - far.height + 1, 0, 2);
        assert_in_range(here.slope_x - far.slope_x + 1, 0, 2);
        assert_in_range(here.slope_z - far.slope_z + 1, 0, 2);
    }
    for (tp_fx z = TP_FX(-6); z < TP_FX(6); z += 5003) {
        const tp_height_slope left = tp_pool_height_slope(pool, TP_FX(4) - 1, z, 0);
        const tp_height_slope right = tp_pool_height_slope(pool, TP_FX(4), z, 0);
        assert_in_range(left.height - right.height + 8, 0, 16);
        assert_in_range(left.slope_x - right.slope_x + 32, 0, 64);
    }
    free(pool);
}

static void outside_there_is_no_water(void **state)
{
    (void)state;
    tp_pool_config c = pool_config(TP_CELLS_16, TP_EDGES_WALL, 17, 20);
    c.x = TP_FX(100);
    tp_pool *const pool = pool_make(&c);
    uint32_t col, row;

    for (uint32_t y = 0; y < 20; y++)
        for (uint32_t x = 0; x < 17; x++)
            tp_pool_add_cell_height(pool, x, y, 32767);
    /* 17 cells of 1/4 m around x = 100: 97.875 to 102.125; 20 cells around z = 0 */
    assert_int_equal(tp_pool_height_slope(pool, TP_FX(97.875), 0, 0).height, TP_FX_ONE);
    assert_int_equal(tp_pool_height_slope(pool, TP_FX(97.875) - 1, 0, 0).height, 0);
    assert_int_equal(tp_pool_height_slope(pool, TP_FX(102.125) - 1, 0, 0).height,
                     TP_FX_ONE);
    assert_int_equal(tp_pool_height_slope(pool, TP_FX(102.125), 0, 0).height, TP_FX_ONE);
    assert_int_equal(tp_pool_height_slope(pool, TP_FX(102.125) + 1, 0, 0).height, 0);
    assert_int_equal(tp_pool_height_slope(pool, TP_FX(100), TP_FX(2.5), 0).height,
                     TP_FX_ONE);
    assert_int_equal(tp_pool_height_slope(pool, TP_FX(100), TP_FX(2.5) + 1, 0).height, 0);
    assert_int_equal(tp_pool_height_slope(pool, TP_FX(100), TP_FX(-2.5), 0).height,
                     TP_FX_ONE);
    assert_true(tp_pool_open_cell_at_point(pool, TP_FX(97.875), TP_FX(-2.5), &col, &row));
    assert_true(col == 0 && row == 0);
    assert_true(tp_pool_open_cell_at_point(pool, TP_FX(102.1), TP_FX(2.49), &col, &row));
    assert_true(col == 16 && row == 19);
    assert_false(tp_pool_open_cell_at_point(pool, TP_FX_MIN, 0, &col, &row));
    assert_false(tp_pool_open_cell_at_point(pool, TP_FX(100), TP_FX_MAX, &col, &row));
    free(pool);
}

/* Level water of any height is level up to a wall, and the wall has no water. */
static void level_water_is_level_beside_walls(void **state)
{
    (void)state;
    for (int n = 0; n < 9; n++) {
        tp_pool_config c = pool_config((tp_cells)(n % 3), n < 3 ? TP_EDGES_TILE
                                                               : TP_EDGES_WALL, 24, 24);
        c.mask = pool_mask(&chance, 24, 24, 60);
        tp_pool *const pool = pool_make(&c);
        for (uint32_t y = 0; y < 24; y++)
            for (uint32_t x = 0; x < 24; x++)
                tp_pool_add_cell_height(pool, x, y, 100);
        const int32_t level = (int32_t)lround(100 * metres_per_lsb(pool) * 65536);
        for (int k = 0; k < 500; k++) {
            const tp_fx x = chance_fx(&chance, -2.99, 2.99);
            const tp_fx z = chance_fx(&chance, -2.99, 2.99);
            const tp_height_slope got = tp_pool_height_slope(pool, x, z, 0);
            uint32_t col, row;
            const bool open = tp_pool_open_cell_at_point(pool, x, z, &col, &row);
            assert_int_equal(got.height, open ? level : 0);
            assert_true(got.slope_x == 0 && got.slope_z == 0);
        }
        free(pool);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(samples_are_bilinear),
        cmocka_unit_test(a_whole_tick_back_is_the_tick_before),
        cmocka_unit_test(the_surface_glides_between_two_ticks),
        cmocka_unit_test(a_tiled_field_has_no_seam),
        cmocka_unit_test(outside_there_is_no_water),
        cmocka_unit_test(level_water_is_level_beside_walls),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("pool sample", tests, NULL, NULL);
}
