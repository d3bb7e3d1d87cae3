/* SPDX-License-Identifier: MIT */
/* Pools of a scene:
 *
 *     pool.c     the modules: pokes, pool and field
 *     paddle.c   waves made at a pool's edge
 *
 * src/pool has the water's equations. */
#ifndef TP_POOL_MODULE_H
#define TP_POOL_MODULE_H
#include "pool/pool.h"
#include "scene/pools.h"

/* Makes the waves of scene->paddle, at a tick; the pool is the scene's. */
void tp_paddle_push(tp_pool *pool, const tp_scene_pool *scene, uint64_t tick);
#endif
