/* SPDX-License-Identifier: MIT */
/* Shared by the loops of the quick rung.  Each loop looks into one level of a prepared picture at
 * places of a run.
 *
 * Places are 16.16 m; times repeats a metre they are Q0.32 repeats, which wrap: a texel's
 * column and row are their highest bits.  Places of layers are an array of 2 TP_RUN
 * words, s in its first half and t in the second. */
#ifndef TP_WATER_QUICK_LOOPS_H
#define TP_WATER_QUICK_LOOPS_H
#include "base/base.h"
#include "features/water/quick_layers.h"
#include "fx/fx.h"
#include "shade/shade.h"

typedef struct {
    const uint32_t *texel;
    uint32_t per_metre, drift_s, drift_t;
    uint32_t down, side;        /* 32 - log2 of the side, 24..31; the side */
} tp_lookup;

TP_ALWAYS_INLINE tp_lookup tp_lookup_at(const tp_quick_map *map, int32_t far)
{
    TP_ASSERT(map->level != NULL && map->last >= 0 && map->last <= (int32_t)map->log2);
    int32_t  level = tp_clamp((map->lod + far) >> 8, 0, map->last);
    uint32_t log2 = map->log2 - (uint32_t)level;

    return (tp_lookup){ map->level[level], map->per_metre, map->drift_s, map->drift_t,
                        32 - log2, 1u << log2 };
}

/* Loops stay functions: opened in their callers they would be short of registers. */
#if defined(__GNUC__)
#define TP_LOOP static __attribute__((noinline)) void
#else
#define TP_LOOP static void
#endif

/* Samples of a run from a column on: places at rest, and slopes. */
typedef struct {
    const uint32_t *s, *t, *n;
    int32_t  count;
    uint32_t odd;               /* the first column is */
} tp_columns;
#endif
