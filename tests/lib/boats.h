/* SPDX-License-Identifier: MIT */
/* Worlds with a boat: on swells, afloat by [E3], in a pool with a wake. */
#ifndef TP_TESTS_LIB_BOATS_H
#define TP_TESTS_LIB_BOATS_H
#include "features/boat/boat.h"
#include "world/pools.h"
#include "world/world.h"
#include "tests/lib/frames.h"
#include "tests/lib/scenes.h"
#include "tidepool/modules.h"

#define LSB (1 / 65536.0)

/* Initialises the world of a scene that needs no memory behind the world's head. */
static inline tp_world boat_world(const tp_scene *scene)
{
    tp_world world;

    assert_int_equal(tp_world_bytes(&tp_program_all, scene, NULL), sizeof world);
    assert_int_equal(
        tp_world_init(&tp_program_all, &world, sizeof world, scene, NULL, NULL), TP_OK);
    return world;
}

/* Still water, and a boat away from the origin. */
static inline tp_scene boat_calm_scene(void)
{
    tp_scene scene;

    tp_scene_level(&scene);
    strcpy(scene.boat.mesh, "boat.obj");
    for (int i = 0; i < TP_WAVES; i++)
        scene.wave[i].amplitude = 0;
    scene.boat.x = TP_FX(12.5);
    scene.boat.z = TP_FX(-31.25);
    return scene;
}

static inline void boat_steps(tp_world *world, const tp_scene *scene,
                              const tp_input *in, int ticks)
{
    for (int t = 0; t < ticks; t++)
        tp_world_step(&tp_program_all, world, scene, in);
}

/* Three swells under a boat of any size and heading. */
static inline tp_scene boat_swells(uint64_t *chance, double steepness)
{
    tp_scene scene = scene_plain();

    for (int i = 0; i < 3; i++) {
        scene.wave[i].amplitude = chance_fx(chance, 0.05, 0.5);
        scene.wave[i].length = chance_fx(chance, 8, 40);
        scene.wave[i].steepness = chance_fx(chance, 0, steepness / 3);
        scene.wave[i].heading = chance_fx(chance, -360, 360);
    }
    scene.boat.heading = chance_fx(chance, -720, 720);
    scene.boat.length = chance_fx(chance, 2, 20);
    scene.boat.beam = chance_fx(chance, 2, 6);
    scene.boat.lift = chance_fx(chance, -3, 3);
    return scene;
}

/* -- floating boats ------------------------------------------------------------------ */

#define Q40 1099511627776.0
#define LSB (1 / 65536.0)

/* A boat from the whole ranges of the parameter table. */
static inline tp_scene any_boat(uint64_t *chance, tp_boat_mode mode)
{
    tp_scene s;

    tp_scene_level(&s);
    s.boat.mode = (int32_t)mode;
    s.boat.draft = chance_scale(chance, 0.05, 20);
    s.boat.drag = chance_fx(chance, 0.05, 2);
    s.water.gravity = chance_scale(chance, 0.1, 100);
    return s;
}

/* omega dt of [E3] for one tick; omega_step() is omega dt of a substep, at most 1/8. */
static inline double omega_tick(const tp_scene *s)
{
    return sqrt((double)s->water.gravity / s->boat.draft) / TP_TICKS_PER_SECOND;
}

static inline int steps_of(const tp_scene *s)
{
    return (int)fmax(1, ceil(omega_tick(s) * 8));
}

static inline double omega_step(const tp_scene *s)
{
    return omega_tick(s) / steps_of(s);
}

static inline void flat(tp_fx water[4], tp_fx height)
{
    for (int i = 0; i < 4; i++)
        water[i] = height;
}

/* -- a boat in a pool ---------------------------------------------------------------- */

/* A pool of 96 x 96 cells of 1/4 m, with a boat of 4 m in the middle. */
static inline tp_scene pool_scene(tp_cells cells, tp_edges edges)
{
    tp_scene s;

    tp_scene_level(&s);
    strcpy(s.boat.mesh, "boat.obj");
    s.pool.cols = s.pool.rows = 96;
    s.pool.cell_bits = (int32_t)cells;
    s.pool.boundary = (int32_t)edges;
    s.pool.max_height = 2 * TP_FX_ONE;
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
    return tp_pool_from_metres(pool, TP_FX_ONE / 2) * 2;
}
#endif
