/* SPDX-License-Identifier: MIT */
/* The releasing sphere and the block that holds drops and rings: release, lack of
 * room, removal.  Blocks have exact size so that the sanitizer sees any access
 * beyond. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/random.h"
#include "features/drops/drops.h"

#define G   TP_FX(9.81)
#define FAR (1000 * TP_FX_ONE)

static uint64_t chance;

static tp_scene_drops config_of(int32_t count, int32_t rings)
{
    return (tp_scene_drops){
        .count = count, .rings = rings, .x = TP_FX(5), .y = TP_FX(3), .z = TP_FX(-7),
        .radius = TP_FX(0.06), .density = TP_FX(1000), .drag = TP_FX(0.47),
        .bounce = TP_FX(0.65), .impacts = 6, .efficiency = TP_FX(0.2),
        .ring_speed = TP_FX(1.2), .ring_decay = TP_FX(2), .ring_spread = TP_FX_ONE,
        .ring_rise_time = TP_FX(0.1),
    };
}

static tp_drops *block_of(const tp_scene_drops *c)
{
    const size_t bytes = tp_drops_bytes(c);
    tp_drops *const drops = malloc(bytes);
    assert_non_null(drops);
    memset(drops, 0xa5, bytes);
    tp_drops_init(drops, c);
    return drops;
}

/* One tick as a world makes it, over still water; returns the number of impacts. */
static uint32_t tick_of(tp_drops *drops, const tp_scene_drops *c, uint64_t tick)
{
    uint32_t struck = 0;
    for (uint32_t i = 0; i < drops->count; i++) {
        tp_impact impact;
        if (!tp_drops_step_drop(drops, c, i, G, 0, tick, &impact))
            continue;
        struck++;
        tp_drops_add_ring(drops, c, &impact);
    }
    tp_drops_rings_remove_spent(drops, (int64_t)tick * 65536, FAR);
    return struck;
}

static void without_drops_there_is_no_block(void **state)
{
    (void)state;
    const tp_scene_drops none = config_of(0, 64), some = config_of(3, 5);
    assert_int_equal(tp_drops_bytes(&none), 0);
    assert_in_range(tp_drops_bytes(&some),
                    sizeof(tp_drops) + 3 * sizeof(tp_drop) + 5 * sizeof(tp_ring),
                    sizeof(tp_drops) + 3 * sizeof(tp_drop) + 5 * sizeof(tp_ring) + 7);
    assert_int_equal(tp_drops_bytes(&some) % 8, 0);
}

static void one_drop_falls_from_the_middle_of_the_sphere(void **state)
{
    (void)state;
    const tp_scene_drops c = config_of(4, 4);
    tp_drops *const drops = block_of(&c);
    tp_drops_release(drops, &c, 1);
    const tp_drop *const drop = tp_drops_list(drops);
    assert_int_equal(drops->count, 1);
    assert_int_equal(drop->place.x, c.x);
    assert_int_equal(drop->place.y, c.y);
    assert_int_equal(drop->place.z, c.z);
    assert_int_equal(drops->sphere_radius, 2 * c.radius);
    free(drops);
}

static void many_at_once_are_counted_and_apart(void **state)
{
    (void)state;
    const tp_scene_drops c = config_of(300, 0);
    tp_drops *const drops = block_of(&c);
    tp_drops_release(drops, &c, 200);
    tp_drops_release(drops, &c, 0);
    tp_drops_release(drops, &c, 200);
    assert_int_equal(drops->count, 300);
    assert_int_equal(drops->released, 300);
    assert_int_equal(drops->dropped, 100);
    const tp_drop *const list = tp_drops_list(drops);
    for (uint32_t i = 0; i < drops->count; i++) {
        const double x = list[i].place.x - c.x, z = list[i].place.z - c.z;
        assert_true(hypot(x, z) <= 2 * c.radius + 1);
        for (uint32_t k = 0; k < i; k++)
            assert_true(list[i].place.x != list[k].place.x
                        || list[i].place.z != list[k].place.z);
    }
    tp_drops_release(drops, &c, UINT32_MAX);
    tp_drops_release(drops, &c, UINT32_MAX);
    assert_true(drops->dropped == UINT32_MAX);
    free(drops);
}

/* A quarter of the drops lies within half the radius: the distribution is uniform by
 * area. */
static void scatter_is_even_and_ends_where_it_says(void **state)
{
    (void)state;
    tp_scene_drops c = config_of(1024, 0);
    c.scatter_radius = TP_FX(20);
    tp_drops *const drops = block_of(&c);
    int inner = 0, right = 0;
    for (int n = 0; n < 1024; n++)
        tp_drops_release(drops, &c, 1);
    for (uint32_t i = 0; i < drops->count; i++) {
        const double x = tp_drops_list(drops)[i].place.x - c.x;
        const double z = tp_drops_list(drops)[i].place.z - c.z;
        assert_true(hypot(x, z) <= c.scatter_radius + 1);
        inner += hypot(x, z) < c.scatter_radius / 2.0;
        right += x > 0;
    }
    assert_in_range(inner, 200, 312);
    assert_in_range(right, 448, 576);
    free(drops);
}

static void drops_fall_by_themselves_every_so_often(void **state)
{
    (void)state;
    tp_scene_drops c = config_of(1024, 0);
    tp_drops *const drops = block_of(&c);
    for (int tick = 0; tick < 100; tick++)
        tp_drops_release_by_interval(drops, &c);
    assert_int_equal(drops->released, 0);               /* `every` is 0 */
    c.interval = TP_FX(0.5);
    for (int tick = 0; tick < 600; tick++)
        tp_drops_release_by_interval(drops, &c);
    assert_int_equal(drops->released, 20);
    c.interval = TP_FX_ONE / 180;                       /* about three per tick */
    drops->count = 0;
    for (int tick = 0; tick < 60; tick++)
        tp_drops_release_by_interval(drops, &c);
    assert_in_range(drops->released, 20 + 178, 20 + 182);
    c.interval = 1;
    tp_drops_release_by_interval(drops, &c);
    assert_int_equal(drops->count, 1024);               /* 1092 were due */
    free(drops);
}

static void a_shorter_pause_is_felt_at_once(void **state)
{
    (void)state;
    tp_scene_drops c = config_of(16, 0);
    tp_drops *const drops = block_of(&c);
    c.interval = TP_FX(60);
    tp_drops_release_by_interval(drops, &c);
    assert_int_equal(drops->released, 1);
    c.interval = TP_FX(0.25);
    for (int tick = 0; tick < 16; tick++)
        tp_drops_release_by_interval(drops, &c);
    assert_int_equal(drops->released, 2);
    free(drops);
}

static void the_sphere_is_steered_at_its_height(void **state)
{
    (void)state;
    const tp_scene_drops c = config_of(1, 0);
    tp_drops *const drops = block_of(&c);
    tp_drops_move_releasing_sphere(drops, TP_FX(0.5), TP_FX(-1));
    assert_int_equal(drops->sphere.x, TP_FX(5.5));
    assert_int_equal(drops->sphere.z, TP_FX(-8));
    assert_int_equal(drops->sphere.y, TP_FX(3));
    assert_int_equal(drops->last_sphere.x, TP_FX(5));
    tp_drops_move_releasing_sphere(drops, TP_FX_MAX, TP_FX_MIN);
    assert_int_equal(drops->sphere.x, 8000 * TP_FX_ONE);
    assert_int_equal(drops->sphere.z, -8000 * TP_FX_ONE);
    free(drops);
}

static void each_impact_raises_one_ring(void **state)
{
    (void)state;
    const tp_scene_drops c = config_of(1, 64);
    tp_drops *const drops = block_of(&c);
    uint32_t impacts = 0;
    tp_drops_release(drops, &c, 1);
    for (uint64_t tick = 1; drops->count > 0; tick++) {
        const uint32_t rings = drops->rings, struck = tick_of(drops, &c, tick);
        impacts += struck;
        if (struck && drops->rings > rings) {
            const tp_ring *const ring = &tp_drops_rings(drops)[drops->rings - 1];
            assert_in_range(ring->start, (tick - 1) * 65536, tick * 65536);
            assert_int_equal(ring->x, c.x);
            assert_int_equal(ring->speed, c.ring_speed);
            assert_true(ring->amplitude > 0 && ring->amplitude * 14 <= ring->length);
        }
    }
    assert_int_equal(impacts, c.impacts);
    assert_int_equal(drops->impacts, impacts);
    for (uint64_t tick = 1; tick < 6000; tick++)
        tp_drops_rings_remove_spent(drops, (int64_t)tick * 65536, FAR);
    assert_int_equal(drops->rings, 0);
    free(drops);
}

static void rings_without_room_are_counted(void **state)
{
    (void)state;
    const tp_scene_drops c = config_of(1, 2), none = config_of(1, 0);
    const tp_impact impact = { .amplitude = TP_FX(0.1), .length = TP_FX_ONE };
    const tp_impact tiny = { .amplitude = 1, .length = 1 };
    const tp_impact still = { .length = TP_FX_ONE };
    tp_drops *drops = block_of(&c);
    tp_drops_add_ring(drops, &c, &still);
    assert_int_equal(drops->rings, 0);
    tp_drops_add_ring(drops, &c, &tiny);
    assert_int_equal(tp_drops_rings(drops)[0].length, TP_FX(0.02));
    tp_drops_add_ring(drops, &c, &impact);
    tp_drops_add_ring(drops, &c, &impact);
    assert_int_equal(drops->rings, 2);
    assert_int_equal(drops->rings_dropped, 1);
    free(drops);
    drops = block_of(&none);
    tp_drops_add_ring(drops, &none, &impact);
    assert_int_equal(drops->rings_dropped, 1);
    free(drops);
}

/* Blocks with the same history have the same bytes. */
static void a_story_repeats_bit_for_bit(void **state)
{
    (void)state;
    tp_scene_drops c = config_of(40, 30);
    c.interval = TP_FX(0.1);
    c.scatter_radius = TP_FX(2);
    tp_drops *const a = block_of(&c), *const b = block_of(&c);
    for (uint64_t tick = 1; tick < 900; tick++) {
        const tp_fx x = random_number(&chance) / 65536;
        const uint32_t more = random_below(&chance, 40) == 0 ? 7 : 0;
        for (int k = 0; k < 2; k++) {
            tp_drops *const drops = k ? a : b;
            tp_drops_move_releasing_sphere(drops, x, -x);
            tp_drops_release(drops, &c, more);
            tp_drops_release_by_interval(drops, &c);
            tick_of(drops, &c, tick);
        }
        assert_memory_equal(a, b, tp_drops_bytes(&c));
    }
    assert_true(a->impacts > 100 && a->rings > 0);
    free(a);
    free(b);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_drops_there_is_no_block),
        cmocka_unit_test(one_drop_falls_from_the_middle_of_the_sphere),
        cmocka_unit_test(many_at_once_are_counted_and_apart),
        cmocka_unit_test(scatter_is_even_and_ends_where_it_says),
        cmocka_unit_test(drops_fall_by_themselves_every_so_often),
        cmocka_unit_test(a_shorter_pause_is_felt_at_once),
        cmocka_unit_test(the_sphere_is_steered_at_its_height),
        cmocka_unit_test(each_impact_raises_one_ring),
        cmocka_unit_test(rings_without_room_are_counted),
        cmocka_unit_test(a_story_repeats_bit_for_bit),
    };
    return cmocka_run_group_tests_name("features/drops", tests, NULL, NULL);
}
