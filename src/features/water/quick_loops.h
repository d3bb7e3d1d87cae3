/* SPDX-License-Identifier: MIT */
/* Definitions shared by the loops of fast shading.  Each loop reads one mipmap level of a
 * baked texture at the places of a run.
 *
 * Places are 16.16 m.  Times repeats per metre they are Q0.32 repeats, which wrap; the
 * highest bits are a texel's column and row.  The places of layers are an array of 2
 * TP_RUN words, s in the first half and t in the second. */
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

TP_ALWAYS_INLINE tp_lookup tp_lookup_make(const tp_quick_map *map, int32_t far)
{
    TP_ASSERT(map->level != NULL && map->last >= 0 && map->last <= (int32_t)map->log2);
    int32_t  level = tp_clamp((map->lod + far) >> 8, 0, map->last);
    uint32_t log2 = map->log2 - (uint32_t)level;

    return (tp_lookup){ map->level[level], map->per_metre, map->drift_s, map->drift_t,
                        32 - log2, 1u << log2 };
}

/* A loop stays a separate function: inlined in its caller it would run out of registers. */
#if defined(__GNUC__)
#define TP_LOOP static __attribute__((noinline)) void
#else
#define TP_LOOP static void
#endif

/* Samples of a run from a column on: rest positions s and t, and slopes n. */
typedef struct {
    const uint32_t *s, *t, *n;
    int32_t  count;
    uint32_t odd;               /* 1: the first column is odd */
} tp_columns;
#endif
