/* SPDX-License-Identifier: MIT */
/* Check of a pool that was stored outside of the program.
 *
 * Cells of 8 and 16 bits: the height and the height before the last step lie within the
 * range [C5].  Cells of 32 bits: the same holds, and a flux is at most half of the range,
 * the most that one giver can spare [C17].  A flux into a wall is 0.  A step leads from
 * valid cells to valid cells, and none of its sums leaves 32 bits. */
#include "pool/pool.h"
#include "base/base.h"

static bool is_within_limit(int64_t x, int64_t most)
{
    return x >= -most && x <= most;
}

/* Compares all fields of the head except the fields that steps change. */
static bool is_same_config(const tp_pool *pool, const tp_pool *fresh)
{
    tp_pool head = *fresh;

    head.drive_peak = pool->drive_peak;
    head.drive_ticks = pool->drive_ticks;
    head.drive_hits = pool->drive_hits;
    head.random = pool->random;
    head.injections = pool->injections;
    head.gear = pool->gear;
    head.at_rest = pool->at_rest;
    head.no_flux = pool->no_flux;
    return memcmp(&head, pool, offsetof(tp_pool, first) + sizeof head.first) == 0;
}

static bool is_same_part(const tp_pool *pool, const tp_pool *fresh, uint32_t at,
                         uint32_t bytes)
{
    return at == 0
           || memcmp(tp_pool_const_pointer(pool, at), tp_pool_const_pointer(fresh, at),
                     bytes)
                  == 0;
}

static bool are_cells_valid(const tp_pool *pool)
{
    const int32_t full = tp_pool_max_lsb(pool);

    for (uint32_t row = 0; row < pool->rows; row++) {
        for (uint32_t col = 0; col < pool->cols; col++) {
            const int32_t h = tp_pool_height(pool, col, row);
            const int32_t v = tp_pool_velocity(pool, col, row);
            const int32_t most = tp_pool_is_wall_or_outside(pool, col, row) ? 0 : full;
            if (!is_within_limit(h, most) || !is_within_limit(v, most)
                || !is_within_limit(h - v, most))
                return false;
        }
    }
    return true;
}

/* True if water can flow from a cell, not a wall, to the right (or down). */
static bool can_flow(const tp_pool *pool, uint32_t col, uint32_t row, bool down)
{
    const bool last = down ? row + 1 == pool->rows : col + 1 == pool->cols;
    const uint8_t *walls = tp_pool_const_pointer(pool, pool->walls);

    if (pool->walls != 0)
        return walls[row * pool->cols + col] & (down ? TP_OPEN_DOWN : TP_OPEN_RIGHT);
    return !last || pool->edges == TP_EDGES_TILE;
}

static bool is_flux_valid(int32_t flux, bool goes)
{
    return is_within_limit(flux, goes ? TP_FULL_32 / 2 : 0);
}

static bool are_fluxes_valid(const tp_pool *pool)
{
    const uint32_t cols = pool->cols, count = tp_pool_count(pool);
    const int32_t *const right =
        (const int32_t *)tp_pool_const_pointer(pool, sizeof *pool) + count;

    for (uint32_t i = 0; i < count; i++) {
        const uint32_t col = i % cols, row = i / cols;
        if (!is_flux_valid(right[i], can_flow(pool, col, row, false))
            || !is_flux_valid(right[count + i], can_flow(pool, col, row, true)))
            return false;
    }
    return true;
}

/* Four valid fluxes add up to 2^31 - 4 at the most. */
static bool are_heights_valid(const tp_pool *pool)
{
    for (uint32_t row = 0; row < pool->rows; row++) {
        for (uint32_t col = 0; col < pool->cols; col++) {
            const int64_t h = tp_pool_height(pool, col, row);
            const int64_t gain = tp_pool_net_inflow(pool, col, row);
            const int32_t most =
                tp_pool_is_wall_or_outside(pool, col, row) ? 0 : TP_FULL_32;
            if (!is_within_limit(h, most) || !is_within_limit(h - gain, TP_FULL_32))
                return false;
        }
    }
    return true;
}

bool tp_pool_is_valid(const tp_pool *pool, const tp_pool *fresh)
{
    if (!is_same_config(pool, fresh)
        || !is_same_part(pool, fresh, pool->walls, tp_pool_count(pool))
        || !is_same_part(pool, fresh, pool->sponge, pool->cols + pool->rows)
        || pool->drive_peak < 0 || pool->drive_peak > tp_pool_max_lsb(pool)
        || pool->drive_ticks >= TP_DRIVE_WINDOW || pool->drive_hits > pool->drive_ticks
        || pool->at_rest > 1 || pool->no_flux > 1)
        return false;
    return pool->cells == TP_CELLS_32 ? are_fluxes_valid(pool) && are_heights_valid(pool)
                                      : are_cells_valid(pool);
}
