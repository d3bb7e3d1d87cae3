/* SPDX-License-Identifier: MIT */
/* Pokes and stirs of the pool: their position, the effect of all pokes of a tick, and the
 * queue. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../../ports/interact/poke.h"
#include "world/pools.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

/* A still pool of 12 x 8 m around (5, -7). */
static tp_scene pool(void)
{
    tp_scene s;

    tp_scene_level(&s);
    s.pool.cols = 48;
    s.pool.rows = 32;
    s.pool.cell = TP_FX(0.25);
    s.pool.x = TP_FX(5);
    s.pool.z = TP_FX(-7);
    s.pool.splash_height = TP_FX(0.3);
    s.pool.boundary = TP_EDGES_WALL;
    return s;
}

static void points_lie_as_they_are_seen_from_the_south(void **state)
{
    static const double want[POKE_POINTS][2] = { { 2, -9 }, { 5, -9 }, { 8, -9 },
                                                 { 2, -5 }, { 5, -5 }, { 8, -5 } };
    (void)state;
    const tp_scene scene = pool();

    for (uint32_t i = 0; i < POKE_POINTS; i++) {
        const tp_push push = poke_point(&scene, i);
        assert_int_equal(push.height, scene.pool.splash_height);
        assert_int_equal(push.x, TP_FX(want[i][0]));
        assert_int_equal(push.z, TP_FX(want[i][1]));
    }
}

/* After one tick the highest cell of still water is the cell that was poked. */
static void the_water_rises_where_it_was_poked(void **state)
{
    (void)state;
    const tp_scene scene = pool();

    for (uint32_t i = 0; i < POKE_POINTS; i++) {
        tp_world *world = scene_world(&scene, NULL);
        const tp_input in = { .push[0] = poke_point(&scene, i) };
        tp_world_step(&tp_program_all, world, &scene, &in);
        const tp_pool *water = tp_world_pool(world);
        uint32_t best[2] = { 0, 0 }, col, row;
        for (uint32_t k = 0; k < 48 * 32; k++)
            if (tp_pool_height_lsb(water, k % 48, k / 48)
                > tp_pool_height_lsb(water, best[0], best[1])) {
                best[0] = k % 48;
                best[1] = k / 48;
            }
        assert_true(tp_pool_open_cell_at_point(water, in.push[0].x, in.push[0].z, &col,
                                               &row));
        assert_true(abs((int)(col - best[0])) <= 1 && abs((int)(row - best[1])) <= 1);
        free(world);
    }
}

static void without_a_pool_it_is_the_field(void **state)
{
    (void)state;
    tp_scene scene = pool();

    scene.field = scene.pool;
    scene.field.x = TP_FX(-20);
    scene.field.splash_height = TP_FX(0.1);
    scene.pool.cols = 0;
    const tp_push push = poke_point(&scene, 4);
    assert_int_equal(push.height, TP_FX(0.1));
    assert_int_equal(push.x, TP_FX(-20));
}

static void there_must_be_water_and_a_point(void **state)
{
    (void)state;
    tp_scene scene = pool();

    assert_int_equal(poke_point(&scene, POKE_POINTS).height, 0);
    scene.pool.cols = 0;
    assert_int_equal(poke_point(&scene, 0).height, 0);
    assert_int_equal(poke_make_push(&scene, 9, 9).height, 0);
}

/* -- several pokes in a tick --------------------------------------------------------- */

/* Six splashes in one tick compared with one splash in each of six worlds: far enough apart
 * to add up cell by cell, except for the last bits of the water that runs between. */
static void all_pokes_of_a_tick_act(void **state)
{
    (void)state;
    const tp_scene scene = pool();
    tp_input all = { 0 };
    tp_world *together = scene_world(&scene, NULL), *one[POKE_POINTS];

    for (uint32_t i = 0; i < POKE_POINTS; i++) {
        const tp_input in = { .push[0] = poke_point(&scene, i) };
        all.push[i] = in.push[0];
        one[i] = scene_world(&scene, NULL);
        tp_world_step(&tp_program_all, one[i], &scene, &in);
    }
    tp_world_step(&tp_program_all, together, &scene, &all);
    for (uint32_t k = 0; k < 48 * 32; k++) {
        int32_t sum = 0;
        for (uint32_t i = 0; i < POKE_POINTS; i++)
            sum += tp_pool_height_lsb(tp_world_pool(one[i]), k % 48, k / 48);
        const int32_t got = tp_pool_height_lsb(tp_world_pool(together), k % 48, k / 48);
        assert_in_range(got - sum + TP_FX(0.01), 0, TP_FX(0.02));
    }
    for (uint32_t i = 0; i < POKE_POINTS; i++)
        free(one[i]);
    free(together);
}

static tp_push numbered(int32_t n)
{
    return (tp_push){ .height = n, .x = 10 * n, .z = -n };
}

static void an_input_has_room_for_so_many(void **state)
{
    (void)state;
    tp_input in = { .forward = 7 };

    for (int32_t n = 1; n <= TP_PUSHES; n++) {
        const tp_push push = numbered(n);
        assert_true(poke_put(&in, &push));
    }
    const tp_input full = in;
    const tp_push more = numbered(99);
    assert_false(poke_put(&in, &more));
    assert_memory_equal(&in, &full, sizeof in);
    in.push[3].height = 0;
    assert_true(poke_put(&in, &more));
    assert_int_equal(in.push[3].x, 990);
    assert_int_equal(in.forward, 7);
}

static void what_does_not_fit_waits_for_the_next_tick(void **state)
{
    (void)state;
    const tp_scene scene = pool();
    poke_queue queue = { .count = 0 };
    int32_t next = 1, taken = 1;

    for (int round = 0; round < 40; round++) {
        for (int i = 0; i < 11 && queue.count < POKE_WAITS; i++) {
            const tp_push push = numbered(next++);
            assert_true(poke_add(&queue, &push));
        }
        tp_input in = { .push[2].height = -1 };         /* already in use */
        poke_take(&queue, &scene, &in);
        for (int i = 0; i < TP_PUSHES; i++)
            if (i != 2)
                assert_int_equal(in.push[i].height, taken++);
        assert_int_equal(in.push[2].height, -1);
    }
    assert_true(next > taken + 40);
}

static void beyond_what_can_wait_it_is_told(void **state)
{
    (void)state;
    poke_queue queue = { .count = 0 };
    const tp_push push = numbered(1), nothing = { .x = 5 };

    for (int i = 0; i < POKE_WAITS; i++)
        assert_true(poke_add(&queue, &push));
    assert_false(poke_add(&queue, &push));
    assert_true(poke_add(&queue, &nothing));
    assert_int_equal(queue.count, POKE_WAITS);
}

/* -- stirs --------------------------------------------------------------------------- */

static void a_stir_is_a_third_of_a_poke(void **state)
{
    (void)state;
    const tp_scene scene = pool();
    poke_queue queue = { .count = 0 };
    tp_input in = { 0 };

    poke_stir(&queue, TP_FX(1), TP_FX(2));
    poke_take(&queue, &scene, &in);
    assert_int_equal(in.push[0].height, scene.pool.splash_height / 3);
    assert_int_equal(in.push[0].x, TP_FX(1));
    assert_int_equal(in.push[0].z, TP_FX(2));
    assert_int_equal(in.push[1].height, 0);
}

/* For any number of reported positions: all of a short path, some of a long path, and
 * always its end. */
static void a_path_shares_the_stir_of_a_tick(void **state)
{
    (void)state;
    const tp_scene scene = pool();

    for (int32_t places = 1; places < 100; places++) {
        poke_queue queue = { .count = 0 };
        tp_input in = { .push[0].height = 1 };
        tp_fx sum = 0, last = 0;
        int32_t n = 0;
        for (int32_t i = 1; i <= places; i++)
            poke_stir(&queue, i, -i);
        poke_take(&queue, &scene, &in);
        for (int i = 1; i < TP_PUSHES && in.push[i].height; i++, n++) {
            assert_true(in.push[i].x > last);
            assert_int_equal(in.push[i].z, -in.push[i].x);
            last = in.push[i].x;
            sum += in.push[i].height;
        }
        assert_int_equal(n, places < TP_PUSHES - 1 ? places : TP_PUSHES - 1);
        assert_int_equal(last, places);
        assert_in_range(scene.pool.splash_height / 3 - sum, 0, TP_PUSHES);
        assert_int_equal(queue.places, 0);
    }
}

static void a_path_waits_where_pokes_fill_the_tick(void **state)
{
    (void)state;
    const tp_scene scene = pool();
    poke_queue queue = { .count = 0 };
    tp_input in = { 0 }, after = { 0 };

    poke_stir(&queue, 5, 5);
    for (int32_t n = 1; n <= TP_PUSHES; n++) {
        const tp_push push = numbered(n);
        poke_add(&queue, &push);
    }
    poke_take(&queue, &scene, &in);
    assert_int_equal(in.push[TP_PUSHES - 1].height, TP_PUSHES);
    poke_take(&queue, &scene, &after);
    assert_int_equal(after.push[0].x, 5);
    assert_int_equal(after.push[0].height, scene.pool.splash_height / 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_lie_as_they_are_seen_from_the_south),
        cmocka_unit_test(the_water_rises_where_it_was_poked),
        cmocka_unit_test(without_a_pool_it_is_the_field),
        cmocka_unit_test(there_must_be_water_and_a_point),
        cmocka_unit_test(all_pokes_of_a_tick_act),
        cmocka_unit_test(an_input_has_room_for_so_many),
        cmocka_unit_test(what_does_not_fit_waits_for_the_next_tick),
        cmocka_unit_test(beyond_what_can_wait_it_is_told),
        cmocka_unit_test(a_stir_is_a_third_of_a_poke),
        cmocka_unit_test(a_path_shares_the_stir_of_a_tick),
        cmocka_unit_test(a_path_waits_where_pokes_fill_the_tick),
    };
    return cmocka_run_group_tests_name("interact/poke", tests, NULL, NULL);
}
