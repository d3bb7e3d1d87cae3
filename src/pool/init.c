/* SPDX-License-Identifier: MIT */
/* Check of a pool's config, layout of its memory block, and set-up of still water.
 *
 * The sponge of [C15] covers the outer W cells.  At d cells from the edge a cell loses
 * delta = dmax ((W - d) / W)^2 of its motion per tick, rounded to a power of 2 and at least
 * the damping of the field.  dmax = 8 / W, at most 1/2: the two measured sponges of
 * [C15]. */
#include "base/fail.h"
#include "pool/pool.h"
#include "base/base.h"
#include "base/given.h"

static bool is_in_range(int64_t x, int64_t low, int64_t high)
{
    return x >= low && x <= high;
}

/* The largest stable r^2 of [C9] in 1/1024, rounded down: 1024 (1 - 1 / (2 - delta)) / 2 =
 * 512 (2^m - 1) / (2^(m+1) - 1). */
static uint32_t max_stable_courant_sq(uint32_t damping)
{
    return 512 * ((1u << damping) - 1) / ((2u << damping) - 1);
}

/* Each S has an error: the outgoing carry less the incoming carry, of mean square 1/6.
 * Half of the mean square is energy added per tick.  Damping removes 2^-m of the
 * energy of waves of rms h, r^2 / 2 x 4 h^2.  Both are equal at h^2 = 2^m / (24 r^2).
 * 52 bits at the most. */
tp_fx tp_pool_noise(tp_fx courant, uint32_t damping)
{
    const uint32_t courant_sq_q10 = tp_pool_square_courant(courant),
                   m = damping < 10 ? damping : 10;
    return (tp_fx)tp_isqrt64(((uint64_t)1 << (42 + m))
                             / (24 * (courant_sq_q10 ? courant_sq_q10 : 1)));
}

#define RANGE(field, good) \
    if (!(good)) \
        return tp_error_blame(err, TP_FAIL(err, TP_E_POOL_RANGE, 0, 0, 0), field)

static tp_status check_numbers(const tp_pool_config *c, tp_error *err)
{
    RANGE("cells", is_in_range((int)c->cells, TP_CELLS_8, TP_CELLS_32));
    RANGE("edges", is_in_range((int)c->edges, TP_EDGES_WALL, TP_EDGES_TILE));
    RANGE("courant", is_in_range(c->courant, TP_FX(0.05), TP_FX(0.8)));
    RANGE("damping", is_in_range(c->damping, 4, 10));
    RANGE("sponge", c->edges != TP_EDGES_SPONGE || is_in_range(c->sponge, 4, 64));
    RANGE("range",
          c->cells == TP_CELLS_32 || is_in_range(c->range, TP_FX(0.01), TP_FX(64)));
    RANGE("cell", is_in_range(c->cell, TP_FX(0.01), TP_FX(50)));
    RANGE("feed_low", c->drive_min >= 0);
    RANGE("feed", c->drive_amplitude >= 0);
    if (c->drive_min > c->drive_max)
        return tp_error_blame(err, TP_FAIL(err, TP_E_POOL_FEED, 0, 0, 0), "feed_low");
    return TP_OK;
}

static tp_status check_size(const tp_pool_config *c, tp_error *err)
{
    const bool good_cols = is_in_range(c->cols, 16, 512);

    if (good_cols && is_in_range(c->rows, 16, 512))
        return TP_OK;
    return tp_error_blame(err, TP_FAIL(err, TP_E_POOL_SIZE, 0, c->cols, c->rows),
                          good_cols ? "rows" : "cols");
}

/* The message prints both numbers to three places.  A refused Courant number is 0.491 to
 * 0.8.  Its rounded value is always above the printed bound, which is rounded down. */
static tp_status check_courant(const tp_pool_config *c, tp_error *err)
{
    const uint32_t bound = max_stable_courant_sq(c->damping);
    const uint32_t asked = ((uint32_t)c->courant * 1000 + 0x8000) >> 16;

    if (tp_pool_square_courant(c->courant) <= bound)
        return TP_OK;
    return tp_error_blame(err, TP_FAIL(err, TP_E_POOL_COURANT, 0, asked,
                                       tp_isqrt64((uint64_t)bound * 1000000 / 1024)),
                          "courant");
}

tp_status tp_pool_check(const tp_pool_config *config, tp_error *err)
{
    tp_status status = tp_given_check(config, "config", err);

    if (status == TP_OK)
        status = check_size(config, err);
    if (status == TP_OK)
        status = check_numbers(config, err);
    if (status == TP_OK)
        status = check_courant(config, err);
    if (status != TP_OK)
        return status;
    const tp_grey *mask = config->mask;
    if (mask != NULL && (mask->cols == 0 || mask->rows == 0 || mask->sample == NULL))
        return tp_error_blame(err, TP_FAIL(err, TP_E_POOL_MASK, 0, mask->cols, mask->rows),
                              "mask");
    return TP_OK;
}

/* Reserves `size` bytes and returns their offset, or 0 if size is 0.  A pool has at most 3
 * MiB of cells: offsets fit 32 bits.  Each part begins at a multiple of 4. */
static uint32_t reserve_bytes(uint32_t *bytes, uint32_t size)
{
    const uint32_t at = *bytes;
    *bytes += (size + 3) & ~3u;
    return size != 0 ? at : 0;
}

tp_pool_layout tp_pool_layout_make(const tp_pool_config *config)
{
    TP_ASSERT(config->cols >= 16 && config->cols <= 512);
    TP_ASSERT(config->rows >= 16 && config->rows <= 512);
    const uint32_t cols = config->cols, count = cols * config->rows;
    const uint32_t lsb = config->cells == TP_CELLS_8 ? 1 : 2;
    const bool gears = config->cells != TP_CELLS_32;
    const bool tiled = config->edges == TP_EDGES_TILE;
    const bool sponge = config->edges == TP_EDGES_SPONGE;
    tp_pool_layout at = { .bytes = sizeof(tp_pool) };

    reserve_bytes(&at.bytes, gears ? count * 2 * lsb : count * 12);
    at.walls = reserve_bytes(&at.bytes, config->mask != NULL || sponge ? count : 0);
    at.sponge = reserve_bytes(&at.bytes, sponge ? cols + config->rows : 0);
    at.scratch = reserve_bytes(&at.bytes, gears ? (cols + 1) * lsb : 0);
    at.first = reserve_bytes(&at.bytes, gears && tiled ? cols * 2 * lsb : 0);
    at.bytes = (at.bytes + 7) & ~7u;
    return at;
}

size_t tp_pool_bytes(const tp_pool_config *config)
{
    return tp_pool_check(config, NULL) == TP_OK ? tp_pool_layout_make(config).bytes : 0;
}

/* Returns q with num / den = q / 2^shift, 2^29 <= q <= 2^30; num < 2^47, 0 < den < 2^34. */
static int32_t normalised_ratio(uint64_t num, uint64_t den, int32_t *shift)
{
    TP_ASSERT(num >> 47 == 0 && den > 0 && den >> 34 == 0);
    *shift = 0;
    for (; num >= den << 30; den <<= 1)
        --*shift;
    for (; num < den << 29; num <<= 1)
        ++*shift;
    return (int32_t)((num + den / 2) / den);
}

/* Sets the factor from a fine height (see fine.h) to metres in 16.16: range / full
 * range for 8 and 16 bits, 2^-8 for Q8.24; then the factor from a difference over two
 * cells to a slope. */
static void set_scale_factors(tp_pool *pool)
{
    int32_t shift;

    if (pool->cells == TP_CELLS_8)
        pool->unit_q =
            normalised_ratio((uint32_t)pool->range, (uint64_t)TP_FULL_8 << 16, &shift);
    else if (pool->cells == TP_CELLS_16)
        pool->unit_q =
            normalised_ratio((uint32_t)pool->range, (uint64_t)TP_FULL_16 << 8, &shift);
    else
        pool->unit_q = normalised_ratio(1, 256, &shift);
    pool->unit_shift = shift;
    pool->slope_q =
        normalised_ratio((uint64_t)pool->unit_q, 2 * (uint32_t)pool->cell, &shift);
    pool->slope_shift = pool->unit_shift + shift - 16;
}

/* Returns 2^64 / n, n > 1, rounded down. */
static uint64_t reciprocal_q64(uint64_t n)
{
    TP_ASSERT(n > 1);
    return (UINT64_MAX - (n - 1)) / n + 1;
}

tp_status tp_pool_init(tp_pool *pool, const tp_pool_config *config, tp_error *err)
{
    tp_status status = tp_given_block(pool, 8, "pool", err);

    if (status == TP_OK)
        status = tp_pool_check(config, err);
    if (status != TP_OK)
        return status;
    const tp_pool_layout at = tp_pool_layout_make(config);
    memset(pool, 0, at.bytes);
    *pool = (tp_pool){
        .cols = config->cols,
        .rows = config->rows,
        .cells = config->cells,
        .edges = config->edges,
        .courant_sq_q10 = tp_pool_square_courant(config->courant),
        .damping = config->damping,
        .range = config->range,
        .cell = config->cell,
        .x = config->x,
        .z = config->z,
        .turns_x = reciprocal_q64((uint64_t)config->cell * config->cols),
        .turns_z = reciprocal_q64((uint64_t)config->cell * config->rows),
        .drive_min = config->drive_min, .drive_max = config->drive_max,
        .drive_amplitude = config->drive_amplitude, .random = 1, .at_rest = 1, .no_flux = 1,
        .walls = at.walls, .sponge = at.sponge, .scratch = at.scratch, .first = at.first,
    };
    set_scale_factors(pool);
    pool->drive_peak = tp_pool_from_metres(pool, config->drive_amplitude);
    if (pool->walls != 0)
        tp_pool_set_walls(pool, config->mask);
    if (pool->sponge != 0)
        tp_pool_set_sponge(pool, config->sponge);
    return TP_OK;
}
