/* SPDX-License-Identifier: MIT */
/* The drive: random splashes that keep the water moving [C16].  Each tick whose heights
 * have an rms below `feed_low` injects one splash at a random place.
 *
 * A splash of too small a height never lifts the rms into the band.  The height of the
 * splashes therefore adapts, once in a window of 64 ticks.  If at least half of the ticks
 * injected, the height grows by an eighth.  Otherwise, if the rms is above `feed_high`, the
 * height shrinks again, but not below the configured height. */
#include "pool/pool.h"
#include "base/base.h"

static const tp_fx drive_sigma = TP_FX(2.5);     /* cells; waves of some 11 cells */

/* sum_of_squares adds the squares of all heights.  energy_limit gives the same sum for
 * a pool with the height `rms` in each cell.  32-bit heights are cut to Q8.16: 2^18
 * cells of (2^22)^2 are below 2^63. */
static int64_t sum_of_squares(const tp_pool *pool)
{
    const uint32_t count = tp_pool_count(pool);
    const int shift = pool->cells == TP_CELLS_32 ? 8 : 0;
    int64_t sum = 0;

    for (uint32_t i = 0; i < count; i++) {
        const int64_t h = tp_pool_cell_height(pool, i) >> shift;
        sum += h * h;
    }
    return sum;
}

static int64_t energy_limit(const tp_pool *pool, tp_fx rms)
{
    const int64_t lsb = tp_pool_from_metres(pool, rms);
    const int64_t h = pool->cells == TP_CELLS_32 ? lsb >> 8 : lsb;
    return h * h * tp_pool_count(pool);
}

static uint32_t random_index(tp_pool *pool, uint32_t end)
{
    return (uint32_t)((uint64_t)tp_random(&pool->random) * end >> 32);
}

static void inject(tp_pool *pool)
{
    TP_ASSERT(pool->drive_peak >= 0 && pool->drive_peak <= tp_pool_max_lsb(pool));
    const uint32_t col = random_index(pool, pool->cols);
    const uint32_t row = random_index(pool, pool->rows);
    const uint64_t half = (uint64_t)1 << 31;

    pool->drive_hits++;
    if (tp_pool_is_wall_or_outside(pool, col, row))
        return;                                 /* the next tick tries another place */
    tp_pool_add_splash_cells(pool, ((uint64_t)col << 32) + half,
                             ((uint64_t)row << 32) + half, drive_sigma, pool->drive_peak);
    pool->injections++;
}

static void adapt_splash_height(tp_pool *pool, bool high)
{
    const int32_t asked = tp_pool_from_metres(pool, pool->drive_amplitude),
                  full = tp_pool_max_lsb(pool);
    const int32_t step = pool->drive_peak / 8 + 1;

    if (2 * pool->drive_hits >= TP_DRIVE_WINDOW)
        pool->drive_peak = pool->drive_peak < full - step ? pool->drive_peak + step : full;
    else if (high)
        pool->drive_peak =
            pool->drive_peak - step > asked ? pool->drive_peak - step : asked;
    pool->drive_ticks = pool->drive_hits = 0;
}

void tp_pool_drive(tp_pool *pool)
{
    const int64_t sum = sum_of_squares(pool);

    if (sum < energy_limit(pool, pool->drive_min))
        inject(pool);
    if (++pool->drive_ticks == TP_DRIVE_WINDOW)
        adapt_splash_height(pool, sum > energy_limit(pool, pool->drive_max));
}
