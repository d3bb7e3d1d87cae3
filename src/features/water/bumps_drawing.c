/* SPDX-License-Identifier: MIT */
/* Pools that bend the normals only (water.pool_bump).  The mesh stays flat; the water's
 * normals get the pools' slopes.  The slope maps lie in the frame's block and are made at
 * the start of a frame.  A pool without room for its map stays flat. */
#include "features/water/bumps.h"
#include "frame/frame.h"
#include "scene/pools.h"

typedef struct {
    tp_pool_bumps  look;        /* data of the stage; first member */
    tp_pool_slope *slope[TP_POOL_BUMPS];
    uint32_t       cells[TP_POOL_BUMPS];    /* capacity of each slope map */
} bumps;

/* Returns the cells of a slope map: the pool and one more cell on each side. */
static uint32_t padded_cell_count(const tp_scene_pool *pool)
{
    return pool->cols <= 0 ? 0 : (uint32_t)(pool->cols + 2) * (uint32_t)(pool->rows + 2);
}

static void *layout(tp_arena *arena, const tp_want *want)
{
    const tp_scene_pool *pool[] = { &want->scene->pool, &want->scene->field };
    bumps *b = tp_arena_alloc(arena, 1, sizeof *b), made = { .cells = { 0 } };

    for (int k = 0; k < TP_POOL_BUMPS; k++) {
        made.cells[k] = padded_cell_count(pool[k]);
        made.slope[k] = tp_arena_alloc(arena, made.cells[k], sizeof *made.slope[k]);
    }
    if (b)
        *b = made;
    return b;
}

/* True if a pool is at rest and therefore flat; 32-bit pools never count as flat. */
static bool is_flat(const tp_pool *pool)
{
    return pool->at_rest && pool->cells != TP_CELLS_32;
}

static void begin(tp_frame *frame, void *mine)
{
    const tp_pool *pools[] = { tp_world_pool(frame->world), tp_world_field(frame->world) };
    bumps *b = mine;

    for (int k = 0; k < TP_POOL_BUMPS; k++) {
        const tp_pool *pool = pools[k];
        tp_pool_bump *bump = &b->look.pool[k];
        bump->slope = NULL;
        if (!pool || is_flat(pool) || (pool->cols + 2) * (pool->rows + 2) > b->cells[k])
            continue;
        *bump = tp_pool_bump_make(pool, b->slope[k]);
        bump->lod = tp_frame_lod(frame, tp_fx_recip(pool->cell), true);
        tp_pool_slopes(pool, frame->world->lag, frame->scene->water.pool_bump,
                       b->slope[k]);
    }
}

static void add_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    const tp_pool_bump *pool = ((const bumps *)mine)->look.pool;

    (void)frame;
    if (!tp_shaders_is_exact_water(list) || !(pool[0].slope || pool[1].slope))
        return;
    tp_shaders_add(list, TP_AT_SLOPE, stage[0], mine);
    list->rippled |= stage[0] != NULL;
}

const tp_drawing tp_bumps_drawing = {
    .layout = layout, .begin = begin, .stages = add_stage,
};
