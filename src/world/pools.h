/* SPDX-License-Identifier: MIT */
/*
 * The water's bounds and pools in a scene: the sides of the pool, a tank around the pool,
 * a floor; the configurations of the two pools, [pool] and [field], and their states in a
 * world. features/pool initialises and steps them.
 */
#ifndef TP_WORLD_POOLS_H
#define TP_WORLD_POOLS_H
#include "fixed/arithmetic.h"
#include "tidepool/scene.h"
#include "view/grid.h"
#include "world/module.h"

static inline tp_rectangle tp_rectangle_make(tp_fx x, tp_fx z, int64_t half_x,
                                               int64_t half_z)
{
    return (tp_rectangle){ tp_fx_saturate(x - half_x), tp_fx_saturate(x + half_x),
                           tp_fx_saturate(z - half_z), tp_fx_saturate(z + half_z) };
}

static inline tp_rectangle tp_pool_sides(const tp_scene *scene)
{
    const tp_scene_pool *pool = &scene->pool;

    return tp_rectangle_make(pool->x, pool->z, (int64_t)pool->cell * pool->cols / 2,
                               (int64_t)pool->cell * pool->rows / 2);
}

static inline bool tp_has_tank(const tp_scene *scene)
{
    return scene->tank.kind != TP_TANK_NONE && scene->pool.cols > 0;
}

/* True if the water ends at the tank's walls; else a calm sea lies around them. */
static inline bool tp_is_walled(const tp_scene *scene)
{
    return tp_has_tank(scene) && !scene->tank.sea;
}

/* True if there is a sea floor. The floor may rise above the water as land. */
static inline bool tp_has_floor(const tp_scene *scene)
{
    return scene->floor.depth > 0 || scene->floor.map[0];
}

/* True if pools or drops stir the water. */
static inline bool tp_has_pools_or_drops(const tp_scene *scene)
{
    return scene->pool.cols > 0 || scene->field.cols > 0 || scene->drops.count > 0;
}

/* Returns the budget of vertices of the water's grid.  The defaults show the shipped
 * waves, the rings of raindrops, and the pool of a tank. */
static inline uint32_t tp_fan_budget(const tp_scene *scene)
{
    const int32_t vertices = scene->grid.vertices > 0 ? scene->grid.vertices
                           : tp_is_walled(scene) ? 10000
                           : tp_has_pools_or_drops(scene) ? 6000 : 1400;

    return vertices > 64 ? (uint32_t)vertices : 64;
}

/* True if the pool has inner walls. */
static inline bool tp_has_inner_walls(const tp_scene *scene)
{
    return scene->pool.cols > 0 && scene->pool.mask[0];
}

/* -- states in a world, or NULL ------------------------------------------------------ */

const tp_pool  *tp_world_pool(const tp_world *world);
const tp_pool  *tp_world_field(const tp_world *world);

#define TP_POOL_ID  TP_MODULE_ID('p', 'o', 'o', 'l')
#define TP_FIELD_ID TP_MODULE_ID('f', 'i', 'e', 'l')

/* State of the pool module and of the field module. */
typedef struct {
    uint32_t poke_wait;         /* ticks until the next random poke */
    uint32_t unused;
    tp_pool  pool;              /* the cells follow the struct */
} tp_basin;

/* Returns the configuration of the pool or the field. NULL assets: no mask. */
tp_pool_config tp_pools_config(const tp_scene *scene, const tp_assets *assets, bool field);

/* Runs tp_pool_check if the scene has this pool; err->word is the parameter at fault. */
tp_status tp_pools_check(const tp_scene *scene, const tp_assets *assets, bool field,
                         tp_error *err);

/* Returns the pool or the field of a world, or NULL. */
tp_pool *tp_world_mutable_pool(const tp_world *world);
tp_pool *tp_world_mutable_field(const tp_world *world);

#endif
