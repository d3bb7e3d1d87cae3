/* SPDX-License-Identifier: MIT */
/* A pool whose config changes while its water moves. */
#include "pool/pool.h"

static bool is_same_block(const tp_pool *pool, const tp_pool_config *c)
{
    return pool->cols == c->cols && pool->rows == c->rows && pool->cells == c->cells
        && pool->edges == c->edges && pool->cell == c->cell
        && (pool->range == c->range || pool->cells == TP_CELLS_32);
}

bool tp_pool_tune(tp_pool *pool, const tp_pool_config *config)
{
    if (!is_same_block(pool, config) || tp_pool_check(config, NULL) != TP_OK)
        return false;
    pool->r2q = tp_pool_r2q_of(config->courant);
    pool->damping = config->damping;
    pool->range = config->range;        /* of 32-bit cells it may differ: they ignore it */
    if (pool->sponge != 0)              /* none of its cells is damped less */
        tp_pool_set_sponge(pool, config->sponge);
    pool->x = config->x;
    pool->z = config->z;
    pool->feed_low = config->feed_low;
    pool->feed_high = config->feed_high;
    if (pool->feed != config->feed)
        pool->feed_peak = tp_pool_lsb(pool, config->feed);
    pool->feed = config->feed;
    return true;
}

/* 8- and 16-bit cells are held to their range; 32-bit ones are looked at: a tick ago, or
 * between, water stood no higher than its height and what the tick added. */
tp_fx tp_pool_highest(const tp_pool *pool)
{
    if (pool->cells != TP_CELLS_32)
        return pool->range;
    tp_pool_state state = tp_pool_look(pool);
    return (tp_fx)((((int64_t)state.highest + state.fastest) >> 8) + 1);
}
