/* SPDX-License-Identifier: MIT */
/* Pools of a scene:
 *
 *     pool.c     the modules: random splashes, pool and field
 *     paddle.c   waves made at a pool's edge
 *
 * The wave equation is in src/pool. */
#ifndef TP_FEATURES_POOL_POOL_MODULE_H
#define TP_FEATURES_POOL_POOL_MODULE_H
#include "pool/pool.h"
#include "scene/pools.h"

/* Pushes the water by the paddle for one tick.  `scene` must be the parameters of
 * `pool`. */
void tp_paddle_push(tp_pool *pool, const tp_scene_pool *scene, uint64_t tick);
#endif
