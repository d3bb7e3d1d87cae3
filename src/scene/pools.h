/* SPDX-License-Identifier: MIT */
/* The two pools of a scene, [pool] and [field]: their configs, and where a world keeps
 * them.  features/pool makes and moves them. */
#ifndef TP_SCENE_POOLS_H
#define TP_SCENE_POOLS_H
#include "scene/module.h"

/* -- the parts, or NULL ------------------------------------------------------------ */

const tp_pool  *tp_world_pool(const tp_world *world);
const tp_pool  *tp_world_field(const tp_world *world);

#define TP_POOL_ID  TP_MODULE_ID('p', 'o', 'o', 'l')
#define TP_FIELD_ID TP_MODULE_ID('f', 'i', 'e', 'l')

/* The state of either module. */
typedef struct {
    uint32_t poke_wait;         /* ticks until the next poke by chance */
    uint32_t unused;
    tp_pool  pool;              /* its cells follow */
} tp_basin;

/* NULL assets: without a mask. */
tp_pool_config tp_pools_config(const tp_scene *scene, const tp_assets *assets, bool field);

/* tp_pool_check of a pool that the scene has; err->word is the parameter at fault. */
tp_status tp_pools_check(const tp_scene *scene, const tp_assets *assets, bool field,
                         tp_error *err);

/* Pool and field of a world, or NULL. */
tp_pool *tp_parts_pool(const tp_world *world);
tp_pool *tp_parts_field(const tp_world *world);
#endif
