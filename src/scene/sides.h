/* SPDX-License-Identifier: MIT */
/* The bounds of a scene's water: the sides of its pool, a tank around the pool, a floor. */
#ifndef TP_SCENE_SIDES_H
#define TP_SCENE_SIDES_H
#include "fx/fx.h"
#include "tidepool/scene.h"

/* A horizontal rectangle in world coordinates, m. */
typedef struct {
    tp_fx x0, x1, z0, z1;
} tp_rectangle;

static inline tp_rectangle tp_pool_sides(const tp_scene *scene)
{
    int64_t wide = (int64_t)scene->pool.cell * scene->pool.cols / 2;
    int64_t deep = (int64_t)scene->pool.cell * scene->pool.rows / 2;

    return (tp_rectangle){ tp_fx_saturate(scene->pool.x - wide),
                           tp_fx_saturate(scene->pool.x + wide),
                           tp_fx_saturate(scene->pool.z - deep),
                           tp_fx_saturate(scene->pool.z + deep) };
}

static inline bool tp_has_tank(const tp_scene *scene)
{
    return scene->tank.kind != TP_TANK_NONE && scene->pool.cols > 0;
}

/* True if there is a sea floor. The floor may rise above the water as land. */
static inline bool tp_has_floor(const tp_scene *scene)
{
    return scene->floor.depth > 0 || scene->floor.map[0];
}

/* True if the pool has inner walls. */
static inline bool tp_has_inner_walls(const tp_scene *scene)
{
    return scene->pool.cols > 0 && scene->pool.mask[0];
}
#endif
