/* SPDX-License-Identifier: MIT */
/* Changes of a pool's config while the water moves. */
#include "pool/pool.h"

static bool is_same_block(const tp_pool *pool, const tp_pool_config *c)
{
    return pool->cols == c->cols && pool->rows == c->rows && pool->cells == c->cells
        && pool->edges == c->edges && pool->cell == c->cell
        && (pool->range == c->range || pool->cells == TP_CELLS_32);
}

bool tp_pool_set_config(tp_pool *pool, const tp_pool_config *config)
{
    if (!is_same_block(pool, config) || tp_pool_check(config, NULL) != TP_OK)
        return false;
    pool->courant_sq_q10 = tp_pool_square_courant(config->courant);
    pool->damping = config->damping;
    pool->range = config->range;        /* 32-bit cells ignore the range; it may differ */
    if (pool->sponge != 0)              /* the sponge is never weaker than the field */
        tp_pool_set_sponge(pool, config->sponge);
    pool->x = config->x;
    pool->z = config->z;
    pool->drive_min = config->drive_min;
    pool->drive_max = config->drive_max;
    if (pool->drive_amplitude != config->drive_amplitude)
        pool->drive_peak = tp_pool_from_metres(pool, config->drive_amplitude);
    pool->drive_amplitude = config->drive_amplitude;
    return true;
}

/* 8- and 16-bit cells are clamped to their range.  32-bit cells are searched.  At a time
 * between the last two ticks the water stood no higher than the highest cell plus the
 * largest change of the tick. */
tp_fx tp_pool_height_bound(const tp_pool *pool)
{
    if (pool->cells != TP_CELLS_32)
        return pool->range;
    tp_pool_state state = tp_pool_stats(pool);
    return (tp_fx)((((int64_t)state.highest + state.fastest) >> 8) + 1);
}
