/* SPDX-License-Identifier: MIT */
/* A boat in a pool, for tests. */
#ifndef TP_TESTS_WAKES_H
#define TP_TESTS_WAKES_H
#include "features/boat/boat.h"
#include "scene/pools.h"
#include "scenes.h"

/* A pool of 96 x 96 cells of 1/4 m, with a boat of 4 m in the middle. */
static inline tp_scene pool_scene(tp_cells cells, tp_edges edges)
{
    tp_scene s;

    tp_scene_level(&s);
    strcpy(s.boat.mesh, "boat.obj");
    s.pool.cols = s.pool.rows = 96;
    s.pool.cells = (int32_t)cells;
    s.pool.edges = (int32_t)edges;
    s.pool.range = 2 * TP_FX_ONE;
    s.boat.x = s.boat.z = 0;
    s.boat.length = 4 * TP_FX_ONE;
    s.boat.beam = TP_FX(1.6);
    s.boat.draft = TP_FX(0.5);
    s.boat.wake = TP_FX_ONE;
    return s;
}

static inline tp_world *wake_world(const tp_scene *scene)
{
    const size_t bytes = tp_world_bytes(&tp_program_all, scene, NULL);
    tp_world *world = malloc(bytes);

    assert_non_null(world);
    assert_int_equal(tp_world_init(&tp_program_all, world, bytes, scene, NULL, NULL),
                     TP_OK);
    return world;
}

static inline tp_pool *water_of(tp_world *world)
{
    return tp_world_mutable_pool(world) ? tp_world_mutable_pool(world)
                                        : tp_world_mutable_field(world);
}

/* Advances the boat and its wake by one tick, nothing else. */
static inline void sail(tp_world *world, const tp_scene *scene, const tp_input *in)
{
    tp_boat_step(&tp_program_all, world, scene, in);
    tp_boat_stir_pool(world, scene);
}

/* Size of the pool's height LSB in m. */
static inline double lsb_of(const tp_pool *pool)
{
    return tp_pool_lsb(pool, TP_FX_ONE / 2) * 2;
}
#endif
