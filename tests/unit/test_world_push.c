/* SPDX-License-Identifier: MIT */
/* Pushes between ticks: the water that takes a push, and the same bits as a push within a
 * tick. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/drops/drops.h"
#include "tests/lib/worlds.h"
#include "world/pools.h"

static uint64_t chance;

static tp_scene scene_pools(bool pool, bool field)
{
    tp_scene s = scene_with(&chance, (pool ? 4u : 0u) + (field ? 8u : 0u));

    s.boat.mesh[0] = '\0';
    s.pool.cell = TP_FX(0.25);
    return s;
}

static bool push(tp_world *world, const tp_scene *scene, const tp_push *p)
{
    return tp_world_push(&tp_program_all, world, scene, p->x, p->z,
                         scene->pool.splash_width, p->height);
}

/* A push within the pool, or anywhere. */
static tp_push push_any(const tp_scene *s)
{
    const tp_fx half = s->pool.cell * s->pool.cols / 2;

    return (tp_push){ .height = chance_fx(&chance, -0.2, 0.2) | 1,
                      .x = s->pool.x
                           + chance_int(&chance, -half - half / 4, half + half / 4),
                      .z = s->pool.z + chance_int(&chance, -half / 2, half / 2) };
}

static void a_pool_takes_the_bits_of_a_ticks_own_pushes(void **state)
{
    (void)state;
    uint32_t taken = 0, missed = 0;
    for (int n = 0; n < 60; n++) {
        const tp_scene scene = scene_pools(true, false);
        tp_world *a = scene_world(&scene, NULL), *b = scene_world(&scene, NULL);
        const int most = chance_int(&chance, 1, TP_PUSHES);
        for (int tick = 0; tick < 20; tick++) {
            tp_input in = { 0 };
            for (int i = 0; i < most; i++) {
                in.push[i] = push_any(&scene);
                *(push(b, &scene, &in.push[i]) ? &taken : &missed) += 1;
            }
            tp_world_step(&tp_program_all, a, &scene, &in);
            tp_world_step(&tp_program_all, b, &scene, &(tp_input){ 0 });
            assert_memory_equal(a, b, a->layout.bytes);
        }
        free(a);
        free(b);
    }
    assert_true(taken > 1000 && missed > 100);
}

/* More pushes than a tick accepts: the water's sum stays 0, the waves add up. */
static void any_number_is_taken(void **state)
{
    (void)state;
    tp_scene scene = scene_pools(true, false);
    scene.pool.cell_bits = TP_CELLS_32;
    scene.pool.boundary = TP_EDGES_WALL;
    tp_world *w = scene_world(&scene, NULL);

    for (int i = 0; i < 500; i++)
        tp_world_push(&tp_program_all, w, &scene, scene.pool.x, scene.pool.z,
                      scene.pool.splash_width, TP_FX(0.01));
    const tp_pool_state look = tp_pool_stats(tp_world_pool(w));
    assert_true(look.highest > 3 << 24); /* 5 m less the mean of a splash */
    assert_int_equal(look.sum, 0);
    free(w);
}

/* The pool lies on the field and has priority; beside the pool the field takes the push; a
 * height of 0 is no push. */
static void a_pool_goes_before_a_field(void **state)
{
    (void)state;
    tp_scene scene = scene_pools(true, true);
    scene.field.boundary = TP_EDGES_TILE;
    scene.pool.boundary = TP_EDGES_WALL;
    tp_world *w = scene_world(&scene, NULL);

    assert_false(tp_world_push(&tp_program_all, w, &scene, scene.pool.x, scene.pool.z,
                               TP_FX_ONE, 0));
    assert_true(tp_pool_stats(tp_world_pool(w)).at_rest);
    assert_true(tp_world_push(&tp_program_all, w, &scene, scene.pool.x, scene.pool.z,
                              TP_FX_ONE, TP_FX(0.3)));
    assert_true(tp_pool_stats(tp_world_pool(w)).highest > 0);
    assert_int_equal(tp_pool_stats(tp_world_field(w)).highest, 0);
    assert_true(tp_world_push(&tp_program_all, w, &scene, scene.pool.x + 500 * TP_FX_ONE,
                              scene.pool.z, TP_FX_ONE, TP_FX(0.3)));
    assert_true(tp_pool_stats(tp_world_field(w)).highest > 0);
    free(w);
}

static tp_scene scene_rings(int32_t rings)
{
    tp_scene s = scene_with(&chance, 16);

    s.drops.target = TP_DROPS_RINGS;
    s.drops.interval = 0;
    s.drops.rings = rings;
    s.boat.mesh[0] = '\0';
    return s;
}

/* A crest as high as the push, up or down, and a ring as long as four radii. */
static void open_water_takes_a_ring(void **state)
{
    (void)state;
    for (int n = 0; n < 100; n++) {
        const tp_scene scene = scene_rings(4);
        tp_world *w = scene_world(&scene, NULL);
        const tp_world *fresh = scene_world(&scene, NULL);
        const tp_fx height = chance_fx(&chance, -6, 6) | 1,
                    radius = chance_fx(&chance, -1, 40);
        for (int i = chance_int(&chance, 0, 9); i > 0; i--)
            tp_world_step(&tp_program_all, w, &scene, NULL);
        const bool far = n % 10 == 0;
        const tp_fx x = far ? TP_FX_MIN : chance_fx(&chance, -9000, 9000);
        assert_int_equal(tp_world_push(&tp_program_all, w, &scene, x, 5, radius, height),
                         !far);
        const tp_drops *drops = tp_world_drops(w);
        assert_int_equal(drops->rings, !far);
        if (!far) {
            const tp_ring *ring = tp_drops_rings(drops);
            assert_int_equal(ring->amplitude,
                             abs(height) < TP_FX(4) ? abs(height) : TP_FX(4));
            assert_int_equal(ring->length, tp_clamp(tp_clamp(radius, 0, TP_FX(16)) * 4,
                                                    TP_FX(0.02), TP_FX(64)));
            assert_int_equal(ring->start, w->tick << 16);
        }
        tp_world_step(&tp_program_all, w, &scene, NULL);
        assert_int_equal(tp_world_check(&tp_program_all, w, w->layout.bytes, fresh, NULL),
                         TP_OK);
        free(w);
        free((void *)(uintptr_t)fresh);
    }
}

/* Refused pushes: without water that takes a push, without room for another ring, and with
 * drops that stir pools and make no rings. */
static void what_nothing_takes_is_told(void **state)
{
    (void)state;
    const tp_scene still = scene_with(&chance, 0), rings = scene_rings(3);
    tp_scene into_pool = scene_rings(3);
    into_pool.drops.target = !TP_DROPS_RINGS;
    tp_world *a = scene_world(&still, NULL), *b = scene_world(&rings, NULL);
    tp_world *c = scene_world(&into_pool, NULL);

    assert_false(tp_world_push(&tp_program_all, a, &still, 0, 0, TP_FX_ONE, TP_FX_ONE));
    for (int i = 0; i < 5; i++)
        assert_int_equal(
            tp_world_push(&tp_program_all, b, &rings, 0, 0, TP_FX_ONE, TP_FX_ONE), i < 3);
    assert_false(
        tp_world_push(&tp_program_all, c, &into_pool, 0, 0, TP_FX_ONE, TP_FX_ONE));
    tp_program bare = tp_program_all;
    bare.water.rings = NULL;
    tp_world *d = scene_world(&rings, NULL);
    assert_false(tp_world_push(&bare, d, &rings, 0, 0, TP_FX_ONE, TP_FX_ONE));
    free(a);
    free(b);
    free(c);
    free(d);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pool_takes_the_bits_of_a_ticks_own_pushes),
        cmocka_unit_test(any_number_is_taken),
        cmocka_unit_test(a_pool_goes_before_a_field),
        cmocka_unit_test(open_water_takes_a_ring),
        cmocka_unit_test(what_nothing_takes_is_told),
    };
    return cmocka_run_group_tests_name("world/push", tests, NULL, NULL);
}
