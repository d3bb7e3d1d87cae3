/* SPDX-License-Identifier: MIT */
/* Pokes: six places in the pool as one sees it, and that the water answers there. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../../ports/live/poke.h"
#include "scenes.h"

/* A pool of 12 x 8 m around (5, -7), still. */
static tp_scene pool(void)
{
    tp_scene s;

    tp_scene_default(&s);
    s.pool.cols = 48;
    s.pool.rows = 32;
    s.pool.cell = TP_FX(0.25);
    s.pool.x = TP_FX(5);
    s.pool.z = TP_FX(-7);
    s.pool.poke = TP_FX(0.3);
    s.pool.edges = TP_EDGES_WALL;
    return s;
}

static void points_lie_as_they_are_seen_from_the_south(void **state)
{
    static const double want[POKE_POINTS][2] = { { 2, -9 }, { 5, -9 }, { 8, -9 },
                                                 { 2, -5 }, { 5, -5 }, { 8, -5 } };
    (void)state;
    const tp_scene scene = pool();

    for (uint32_t i = 0; i < POKE_POINTS; i++) {
        tp_input in = { .ahead = 7 };
        poke_point(&scene, i, &in);
        assert_int_equal(in.poke, scene.pool.poke);
        assert_int_equal(in.poke_x, TP_FX(want[i][0]));
        assert_int_equal(in.poke_z, TP_FX(want[i][1]));
        assert_int_equal(in.ahead, 7);
    }
}

static void the_water_rises_where_it_was_poked(void **state)
{
    (void)state;
    const tp_scene scene = pool();

    for (uint32_t i = 0; i < POKE_POINTS; i++) {
        tp_world *world = scene_world(&scene, NULL);
        tp_input in = { 0 };
        poke_point(&scene, i, &in);
        tp_world_step(world, &scene, &in);
        const tp_pool *water = tp_world_pool(world);
        uint32_t best[2] = { 0, 0 }, col, row;
        for (uint32_t k = 0; k < 48 * 32; k++)
            if (tp_pool_height(water, k % 48, k / 48)
                > tp_pool_height(water, best[0], best[1])) {
                best[0] = k % 48;
                best[1] = k / 48;
            }
        assert_true(tp_pool_cell(water, in.poke_x, in.poke_z, &col, &row));
        assert_true(abs((int)(col - best[0])) <= 1 && abs((int)(row - best[1])) <= 1);
        free(world);
    }
}

static void a_stir_is_a_third_of_a_poke(void **state)
{
    (void)state;
    const tp_scene scene = pool();
    tp_input in = { 0 };

    poke_at(&scene, TP_FX(1), TP_FX(2), true, &in);
    assert_int_equal(in.poke, scene.pool.poke / 3);
    assert_int_equal(in.poke_x, TP_FX(1));
    assert_int_equal(in.poke_z, TP_FX(2));
    poke_at(&scene, TP_FX(1), TP_FX(2), false, &in);
    assert_int_equal(in.poke, scene.pool.poke);
}

static void without_a_pool_it_is_the_field(void **state)
{
    (void)state;
    tp_scene scene = pool();
    tp_input in = { 0 };

    scene.field = scene.pool;
    scene.field.x = TP_FX(-20);
    scene.field.poke = TP_FX(0.1);
    scene.pool.cols = 0;
    poke_point(&scene, 4, &in);
    assert_int_equal(in.poke, TP_FX(0.1));
    assert_int_equal(in.poke_x, TP_FX(-20));
}

static void there_must_be_water_and_a_point(void **state)
{
    (void)state;
    tp_scene scene = pool();
    tp_input in = { .poke = 1, .poke_x = 2 };
    const tp_input before = in;

    poke_point(&scene, POKE_POINTS, &in);
    assert_memory_equal(&before, &in, sizeof in);
    scene.pool.cols = 0;
    poke_point(&scene, 0, &in);
    poke_at(&scene, 9, 9, false, &in);
    assert_memory_equal(&before, &in, sizeof in);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_lie_as_they_are_seen_from_the_south),
        cmocka_unit_test(the_water_rises_where_it_was_poked),
        cmocka_unit_test(a_stir_is_a_third_of_a_poke),
        cmocka_unit_test(without_a_pool_it_is_the_field),
        cmocka_unit_test(there_must_be_water_and_a_point),
    };
    return cmocka_run_group_tests_name("poke", tests, NULL, NULL);
}
