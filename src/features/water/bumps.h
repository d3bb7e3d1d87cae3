/* SPDX-License-Identifier: MIT */
/* Pools that bend the light and not the mesh: what a frame says of them. */
#ifndef TP_WATER_BUMPS_H
#define TP_WATER_BUMPS_H
#include "pool/pool.h"
#include "scene/module.h"
#include "tidepool/modules.h"

#define TP_BUMPS_ID TP_MODULE_ID('b', 'u', 'm', 'p')

typedef struct {
    const tp_pool_slope *slope; /* see tp_pool_slopes; NULL: there is no such pool */
    uint32_t cols, rows;
    tp_fx    x, z;              /* the field's middle */
    uint64_t turns_x, turns_z;  /* fields a metre, Q48 over Q16.16 */
    uint32_t side_x, side_z;    /* 16.16 m; 0: it is tiled */
    int32_t  lod;               /* level of its cells at 1 m, as of a tp_layer */
} tp_pool_bump;

/* All but the lod. */
tp_pool_bump tp_pool_bump_of(const tp_pool *pool, const tp_pool_slope *slope);

#define TP_POOL_BUMPS 2         /* the scene's pool and its field */

typedef struct {
    tp_pool_bump pool[TP_POOL_BUMPS];
} tp_pool_bumps;
#endif
