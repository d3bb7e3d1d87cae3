/* SPDX-License-Identifier: MIT */
/* The bounds of a scene's water: its pool's sides, a tank around them, a floor. */
#ifndef TP_SCENE_SIDES_H
#define TP_SCENE_SIDES_H
#include "fx/fx.h"
#include "tidepool/scene.h"

/* A level rectangle, in the world's metres. */
typedef struct {
    tp_fx x0, x1, z0, z1;
} tp_rectangle;

static inline tp_rectangle tp_pool_sides(const tp_scene *scene)
{
    int64_t wide = (int64_t)scene->pool.cell * scene->pool.cols / 2;
    int64_t deep = (int64_t)scene->pool.cell * scene->pool.rows / 2;

    return (tp_rectangle){ tp_fx_held(scene->pool.x - wide),
                           tp_fx_held(scene->pool.x + wide),
                           tp_fx_held(scene->pool.z - deep),
                           tp_fx_held(scene->pool.z + deep) };
}

static inline bool tp_has_tank(const tp_scene *scene)
{
    return scene->tank.kind != TP_TANK_NONE && scene->pool.cols > 0;
}

/* A floor under the sea, which may rise out of it as land. */
static inline bool tp_has_floor(const tp_scene *scene)
{
    return scene->floor.depth > 0 || scene->floor.map[0];
}

/* Inner walls of the pool. */
static inline bool tp_has_stone(const tp_scene *scene)
{
    return scene->pool.cols > 0 && scene->pool.mask[0];
}
#endif
