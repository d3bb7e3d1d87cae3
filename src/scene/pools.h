/* SPDX-License-Identifier: MIT */
/* The two pools of a scene, [pool] and [field]: their configurations, and their states in
 * a world. features/pool initialises and steps them. */
#ifndef TP_SCENE_POOLS_H
#define TP_SCENE_POOLS_H
#include "scene/module.h"

/* -- states in a world, or NULL ---------------------------------------------------- */

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
