/* SPDX-License-Identifier: MIT */
/* The paddle: water volume is constant, and waves have about the requested
 * height.  Waves are measured from one to two or more wave lengths south of the
 * paddle, before the reflection returns: damping 10 takes 5 % until there,
 * 16-bit cells slightly more by their gears.  The height is from trough to
 * crest. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/measure.h"
#include "tests/lib/pools.h"
#include "tests/lib/scenes.h"
#include "features/pool/pool_module.h"

enum { COLS = 16, ROWS = 240 };

static uint64_t chance;

static tp_scene_pool scene_of(tp_cells cells, tp_edges edges, double courant, double height,
                              double period)
{
    return (tp_scene_pool){
        .cols = COLS, .rows = ROWS, .cell_bits = (int32_t)cells, .boundary = (int32_t)edges,
        .damping = 10, .sponge = 8, .courant = (tp_fx)lround(courant * 65536),
        .max_height = TP_FX_ONE, .cell = TP_FX(0.25),
        .paddle = (tp_fx)lround(height * 65536),
        .paddle_period = (tp_fx)lround(period * 65536),
    };
}

static tp_pool *pool_for(const tp_scene_pool *s)
{
    tp_pool_config c = pool_config((tp_cells)s->cell_bits, (tp_edges)s->boundary,
                                   (uint32_t)s->cols, (uint32_t)s->rows);
    c.courant = s->courant;
    c.interval = (uint32_t)s->interval;
    c.damping = (uint32_t)s->damping;
    c.sponge = (uint32_t)s->sponge;
    c.range = s->max_height;
    return pool_make(&c);
}

/* Height difference between the lowest and the highest row of a column, m. */
static double height_of(const tp_pool *pool, uint32_t first, uint32_t end)
{
    int32_t low = INT32_MAX, high = INT32_MIN;

    for (uint32_t row = first; row < end; row++) {
        const int32_t h = tp_pool_height_lsb(pool, pool->cols / 2, row);
        low = h < low ? h : low;
        high = h > high ? h : high;
    }
    return (high - (double)low) / tp_pool_from_metres(pool, TP_FX_ONE);
}

static void the_sum_stays_exactly_0(void **state)
{
    (void)state;
    for (int n = 0; n < 60; n++) {
        tp_scene_pool s = scene_of((tp_cells)(n % 3), (tp_edges)(n / 3 % 3),
                                   chance_double(&chance, 0.05, 0.48),
                                   chance_scale(&chance, 0.001, 16) / 65536.0,
                                   chance_scale(&chance, 0.1, 60) / 65536.0);
        s.cols = chance_int(&chance, 16, 24);
        s.rows = chance_int(&chance, 16, 40);
        s.sponge = chance_int(&chance, 4, 64);
        tp_pool *pool = pool_for(&s);
        for (uint32_t tick = 1; tick < 40; tick++) {
            const int64_t before = tp_pool_stats(pool).sum;
            tp_paddle_push(pool, &s, tick);
            assert_int_equal(tp_pool_stats(pool).sum, before);
            if (s.cell_bits == TP_CELLS_32)
                assert_int_equal(before, 0);
            tp_pool_step(pool);
        }
        free(pool);
    }
}

static void the_sum_stays_0_where_walls_stand_in_a_paddle_s_way(void **state)
{
    (void)state;
    const tp_scene_pool s = scene_of(TP_CELLS_32, TP_EDGES_WALL, 0.48, 2, 0.5);
    tp_pool_config c = pool_config(TP_CELLS_32, TP_EDGES_WALL, 40, 40);
    c.mask = pool_mask(&chance, 40, 40, 60);
    tp_pool *pool = pool_make(&c);

    for (uint32_t tick = 1; tick < 300; tick++) {
        tp_paddle_push(pool, &s, tick);
        tp_pool_step(pool);
        assert_int_equal(tp_pool_stats(pool).sum, 0);
    }
    assert_true(tp_pool_stats(pool).highest > 0);
    free(pool);
}

static void waves_are_as_high_as_asked_for(void **state)
{
    (void)state;
    static const double courants[] = { 0.2, 0.3, 0.48 }, periods[] = { 0.3, 0.5, 1, 2 };
    measure off[2] = { { .what = "16 bits", .unit = "of the height" },
                       { .what = "32 bits", .unit = "of the height" } };

    for (int n = 0; n < 2 * 2 * 3 * 4; n++) {
        const double r = courants[n / 4 % 3], period = periods[n % 4];
        const tp_edges edges = n / 12 % 2 ? TP_EDGES_TILE : TP_EDGES_WALL;
        const tp_cells cells = n / 24 ? TP_CELLS_32 : TP_CELLS_16;
        const tp_scene_pool s = scene_of(cells, edges, r, 0.2, period);
        const uint32_t wave = (uint32_t)(r * period * 60);      /* cells */
        if (wave * 4 > ROWS)
            continue;
        const int ticks = (int)((3.5 * wave + 20) / r);
        if (ticks * r > ROWS - 3 * wave)    /* waves that went north come round */
            continue;
        tp_pool *pool = pool_for(&s);
        for (int tick = 1; tick < ticks; tick++) {
            tp_paddle_push(pool, &s, (uint64_t)tick);
            tp_pool_step(pool);
        }
        measure_add(&off[n / 24], height_of(pool, wave, 2 * wave + 4) / 0.2 - 1,
                    lround(100 * r), lround(10 * period), edges);
        free(pool);
    }
    measure_print(&off[0]);
    measure_print(&off[1]);
    assert_true(off[0].inputs > 15 && off[1].inputs > 15);
    assert_true(off[0].worst < 0.2);
    assert_true(off[1].worst < 0.2);
}

/* Pushes and steps come together, every second or fourth tick. */
static void slow_steps_make_the_same_waves(void **state)
{
    (void)state;
    for (int interval = 0; interval <= 2; interval++)
        for (int n = 0; n < 4; n++) {
            tp_scene_pool s = scene_of(n % 2 ? TP_CELLS_32 : TP_CELLS_16,
                                       n / 2 ? TP_EDGES_TILE : TP_EDGES_WALL, 0.12, 0.2, 2);
            s.interval = interval;
            const uint32_t wave = 14;       /* cells: 0.12 x 120 ticks */
            tp_pool *pool = pool_for(&s);
            for (uint32_t tick = 0; tick < 70 / 0.12; tick++) {
                if (tp_pool_is_due(pool))
                    tp_paddle_push(pool, &s, tick);
                tp_pool_step(pool);
            }
            const double height = height_of(pool, wave, 3 * wave);
            print_message("    %d ticks a step, %d: %.3f m of 0.2\n", 1 << interval, n,
                          height);
            assert_true(height > 0.17 && height < 0.23);
            free(pool);
        }
}

/* In a world of slow steps the paddle waits for the cells: between two steps no cell
 * changes. */
static void paddles_of_a_world_push_with_the_steps(void **state)
{
    (void)state;
    tp_scene s;
    int moved = 0;

    tp_scene_level(&s);
    s.pool.cols = s.pool.rows = 40;
    s.pool.courant = TP_FX(0.12);
    s.pool.damping = 8;
    s.pool.interval = 2;
    s.pool.paddle = TP_FX(0.2);
    s.field = s.pool;
    tp_world *world = scene_world(&s, NULL);
    for (int tick = 0; tick < 64; tick++) {
        const tp_pool *pool[2] = { tp_world_pool(world), tp_world_field(world) };
        const bool due = tp_pool_is_due(pool[0]);
        const int32_t before[2] = { tp_pool_height_lsb(pool[0], 5, 0),
                                    tp_pool_height_lsb(pool[1], 5, 0) };
        assert_int_equal(due, tp_pool_is_due(pool[1]));
        tp_world_step(&tp_program_all, world, &s, NULL);
        for (int i = 0; i < 2; i++) {
            const bool moves = tp_pool_height_lsb(pool[i], 5, 0) != before[i];
            assert_true(due || !moves);
            moved += moves;
        }
    }
    assert_true(moved > 24);
    free(world);
}

static void twice_the_height_is_twice_the_wave(void **state)
{
    (void)state;
    double height[2];

    for (int n = 0; n < 2; n++) {
        const tp_scene_pool s = scene_of(TP_CELLS_32, TP_EDGES_WALL, 0.4, 0.1 + 0.1 * n, 1);
        tp_pool *pool = pool_for(&s);
        for (uint32_t tick = 1; tick < 300; tick++) {
            tp_paddle_push(pool, &s, tick);
            tp_pool_step(pool);
        }
        height[n] = height_of(pool, 30, 80);
        free(pool);
    }
    assert_true(fabs(height[1] / height[0] - 2) < 0.01);
}

/* Only the side of open water counts; the sponge absorbs the other waves. */
static void before_a_sponge_waves_go_south(void **state)
{
    (void)state;
    tp_scene_pool s = scene_of(TP_CELLS_32, TP_EDGES_SPONGE, 0.4, 0.2, 0.75);
    s.cols = 90;
    s.rows = 140;
    s.sponge = 20;
    tp_pool *pool = pool_for(&s);

    for (uint32_t tick = 1; tick < 230; tick++) {
        tp_paddle_push(pool, &s, tick);
        tp_pool_step(pool);
    }
    const double south = height_of(pool, 45, 65), north = height_of(pool, 0, 3);
    print_message("    south %.3f m, north's edge %.3f m of 0.2 asked\n", south, north);
    assert_true(south > 0.13 && south < 0.27);
    assert_true(north < south / 4);
    free(pool);
}

static void any_paddle_and_any_tick_are_taken(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        tp_scene_pool s = scene_of((tp_cells)(n % 3), (tp_edges)(n / 3 % 3),
                                   n % 4 ? 0.48 : 0.05, n % 5 ? 16 : 0.00002,
                                   n % 2 ? 60 : 0.1);
        s.rows = n % 7 ? 16 : 512;
        s.interval = n % 4 ? 0 : n % 3;
        s.sponge = n % 2 ? 64 : 4;
        tp_pool *pool = pool_for(&s);
        for (int k = 0; k < 5; k++)
            tp_paddle_push(pool, &s, random_next(&chance));
        assert_int_equal(tp_pool_stats(pool).sum, 0);
        free(pool);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_sum_stays_exactly_0),
        cmocka_unit_test(the_sum_stays_0_where_walls_stand_in_a_paddle_s_way),
        cmocka_unit_test(waves_are_as_high_as_asked_for),
        cmocka_unit_test(slow_steps_make_the_same_waves),
        cmocka_unit_test(paddles_of_a_world_push_with_the_steps),
        cmocka_unit_test(twice_the_height_is_twice_the_wave),
        cmocka_unit_test(before_a_sponge_waves_go_south),
        cmocka_unit_test(any_paddle_and_any_tick_are_taken),
    };
    return cmocka_run_group_tests_name("features/pool_paddle", tests, NULL, NULL);
}
