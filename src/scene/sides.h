/* SPDX-License-Identifier: MIT */
/* The sides of a scene's pool, and whether a tank stands around them. */
#ifndef TP_SCENE_SIDES_H
#define TP_SCENE_SIDES_H
#include "tidepool/scene.h"

/* Level, in the world's metres. */
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
#endif
