/* SPDX-License-Identifier: MIT */
/* Data of pools that bend the normals and leave the mesh flat (water.pool_bump). */
#ifndef TP_WATER_BUMPS_H
#define TP_WATER_BUMPS_H
#include "pool/pool.h"
#include "scene/module.h"
#include "tidepool/modules.h"

#define TP_BUMPS_ID TP_MODULE_ID('b', 'u', 'm', 'p')

typedef struct {
    const tp_pool_slope *slope; /* see tp_pool_slopes; NULL: no such pool */
    uint32_t cols, rows;
    tp_fx    x, z;              /* centre of the field, m */
    uint64_t turns_x, turns_z;  /* fields per metre, Q48 over Q16.16 */
    uint32_t side_x, side_z;    /* sides, m, 16.16; 0: tiled */
    int32_t  lod;               /* mipmap level of the cells at 1 m, as in tp_layer */
} tp_pool_bump;

/* Returns the data of a pool, except the lod. */
tp_pool_bump tp_pool_bump_make(const tp_pool *pool, const tp_pool_slope *slope);

#define TP_POOL_BUMPS 2         /* the scene's pool and field */

typedef struct {
    tp_pool_bump pool[TP_POOL_BUMPS];
} tp_pool_bumps;
#endif
