/* SPDX-License-Identifier: MIT */
/* A pool's config: its check, the layout of the memory block, walls and sponge, the
 * set-up of still water, and changes of the config while the water moves. */
#include "base/base.h"
#include "pool/pool.h"

/* -- walls and sponge ---------------------------------------------------------------- */

/* Walls and sponge of a pool, computed once at init [C15]. */

/* The mask is stretched over all cells; a cell takes the sample under its centre. */
static bool is_dark(const tp_grey *mask, const tp_pool *pool, uint32_t x, uint32_t y)
{
    const uint64_t col = (2 * x + 1) * (uint64_t)mask->cols / (2 * pool->cols);
    const uint64_t row = (2 * y + 1) * (uint64_t)mask->rows / (2 * pool->rows);
    return mask->sample[row * mask->cols + col] < 0x8000;
}

/* True if water can flow from an open cell to its neighbour (x, y).  The neighbour may lie
 * one cell outside of the field. */
static bool is_open(const tp_pool *pool, uint32_t x, uint32_t y)
{
    const bool beyond = x >= pool->cols || y >= pool->rows;     /* -1 wraps around */

    if (beyond && pool->edges != TP_EDGES_TILE)
        return false;
    x = x == pool->cols ? 0 : x > pool->cols ? pool->cols - 1 : x;
    y = y == pool->rows ? 0 : y > pool->rows ? pool->rows - 1 : y;
    return !tp_pool_is_wall(pool, y * pool->cols + x);
}

static uint8_t open_neighbour_bits(const tp_pool *pool, uint32_t x, uint32_t y)
{
    return (uint8_t)((is_open(pool, x - 1, y) ? TP_OPEN_LEFT : 0)
                     | (is_open(pool, x + 1, y) ? TP_OPEN_RIGHT : 0)
                     | (is_open(pool, x, y - 1) ? TP_OPEN_UP : 0)
                     | (is_open(pool, x, y + 1) ? TP_OPEN_DOWN : 0));
}

/* Marks the walls of `mask` (may be NULL) and of the edges.  The sizes must already be
 * set. */
static void pool_set_walls(tp_pool *pool, const tp_grey *mask)
{
    TP_ASSERT(pool->walls != 0);
    uint8_t *const walls = tp_pool_pointer(pool, pool->walls);

    for (uint32_t y = 0; mask != NULL && y < pool->rows; y++)
        for (uint32_t x = 0; x < pool->cols; x++)
            walls[y * pool->cols + x] = is_dark(mask, pool, x, y) ? TP_WALL : 0;
    for (uint32_t y = 0; y < pool->rows; y++)
        for (uint32_t x = 0; x < pool->cols; x++)
            if (walls[y * pool->cols + x] != TP_WALL)
                walls[y * pool->cols + x] = open_neighbour_bits(pool, x, y);
}

/* Returns the j >= 1 with 2^-j nearest to delta = 8 (W - d)^2 / (max(W, 16) W^2),
 * nearest in the exponent: the first j with delta^2 2^(2j+1) >= 1, at most
 * `max_exponent`.  Both sides of the comparison are below 2^52. */
static uint8_t sponge_exponent(uint32_t edge_distance, uint32_t width,
                               uint32_t max_exponent)
{
    const uint64_t least = width > 16 ? width : 16, w2 = width * width;
    const uint64_t depth2 = edge_distance < width ? (uint64_t)(width - edge_distance)
                                                        * (width - edge_distance)
                                                  : 0;
    uint8_t j = 1;

    while (j < max_exponent && (depth2 * depth2 << (2 * j + 7)) < least * least * w2 * w2)
        j++;
    return j;
}

/* Returns the exponent of a step at a distance from the edge. */
static uint8_t step_sponge_exponent(const tp_pool *pool, uint32_t edge_distance,
                                    uint32_t width)
{
    const uint32_t n = pool->interval;
    const uint32_t tick = sponge_exponent(edge_distance, width, pool->damping + n);

    return (uint8_t)(tick > n ? tick - n : 1);
}

/* Sets one damping exponent per column and per row; a cell has the smaller of its two. */
static void pool_set_sponge(tp_pool *pool, uint32_t width)
{
    TP_ASSERT(pool->sponge != 0 && width >= 4 && width <= 64);
    uint8_t *const column = tp_pool_pointer(pool, pool->sponge);
    uint8_t *const row = column + pool->cols;
    const uint32_t right = pool->cols - 1, bottom = pool->rows - 1;

    for (uint32_t x = 0; x <= right; x++)
        column[x] = step_sponge_exponent(pool, x < right - x ? x : right - x, width);
    for (uint32_t y = 0; y <= bottom; y++)
        row[y] = step_sponge_exponent(pool, y < bottom - y ? y : bottom - y, width);
}

/* -- check, layout, still water ------------------------------------------------------ */

/* The sponge of [C15] covers the outer W cells.  At d cells from the edge a cell loses
 * delta = dmax ((W - d) / W)^2 of its motion per tick, rounded to a power of 2 and at least
 * the damping of the field.  dmax = 8 / W, at most 1/2: the two measured sponges of
 * [C15].  A step of 2^n ticks loses 2^n delta, at most 1/2. */

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
tp_fx tp_pool_rounding_noise(tp_fx courant, uint32_t damping)
{
    const uint32_t courant_sq_q10 = tp_pool_square_courant(courant),
                   m = damping < 10 ? damping : 10;
    return (tp_fx)tp_isqrt64(((uint64_t)1 << (42 + m))
                             / (24 * (courant_sq_q10 ? courant_sq_q10 : 1)));
}

#define RANGE(field, good) \
    if (!(good)) \
        return tp_error_add_word(err, TP_FAIL(err, TP_E_POOL_RANGE, 0, 0, 0), field)

static tp_status check_numbers(const tp_pool_config *c, tp_error *err)
{
    RANGE("cell_bits", is_in_range((int)c->cells, TP_CELLS_8, TP_CELLS_32));
    RANGE("boundary", is_in_range((int)c->edges, TP_EDGES_WALL, TP_EDGES_TILE));
    RANGE("courant", is_in_range(c->courant, TP_FX(0.05), TP_FX(0.8)));
    RANGE("damping", is_in_range(c->damping, 4, 10));
    RANGE("interval", c->interval <= 2);
    RANGE("sponge", c->edges != TP_EDGES_SPONGE || is_in_range(c->sponge, 4, 64));
    RANGE("max_height",
          c->cells == TP_CELLS_32 || is_in_range(c->range, TP_FX(0.01), TP_FX(64)));
    RANGE("cell", is_in_range(c->cell, TP_FX(0.01), TP_FX(50)));
    RANGE("drive_min", c->drive_min >= 0);
    RANGE("drive_amplitude", c->drive_amplitude >= 0);
    if (c->drive_min > c->drive_max)
        return tp_error_add_word(err, TP_FAIL(err, TP_E_POOL_FEED, 0, 0, 0), "drive_min");
    return TP_OK;
}

static tp_status check_size(const tp_pool_config *c, tp_error *err)
{
    const bool good_cols = is_in_range(c->cols, 16, 512);

    if (good_cols && is_in_range(c->rows, 16, 512))
        return TP_OK;
    return tp_error_add_word(err, TP_FAIL(err, TP_E_POOL_SIZE, 0, c->cols, c->rows),
                             good_cols ? "rows" : "cols");
}

static tp_fx step_courant(const tp_pool_config *c)
{
    return c->courant * (1 << c->interval);
}

/* The message prints both numbers to three places.  A refused Courant number is 0.491 to
 * 0.8.  Its rounded value is always above the printed bound, which is rounded down. */
static tp_status check_courant(const tp_pool_config *c, tp_error *err)
{
    const uint32_t bound = max_stable_courant_sq(c->damping);
    const uint32_t asked = ((uint32_t)c->courant * 1000 + 0x8000) >> 16;

    if (tp_pool_square_courant(c->courant) <= bound)
        return TP_OK;
    return tp_error_add_word(err, TP_FAIL(err, TP_E_POOL_COURANT, 0, asked,
                                       tp_isqrt64((uint64_t)bound * 1000000 / 1024)),
                          "courant");
}

/* Checks the steps of several ticks; the bound is printed as a Courant number of a tick, to
 * three places. */
static tp_status check_interval(const tp_pool_config *c, tp_error *err)
{
    const uint32_t ticks = 1u << c->interval;

    if (c->damping < 4 + c->interval)
        return tp_error_add_word(err, TP_FAIL(err, TP_E_POOL_DAMPING, 0, ticks,
                                              4 + c->interval), "interval");
    const uint32_t bound = max_stable_courant_sq(c->damping - c->interval);
    if (tp_pool_square_courant(step_courant(c)) <= bound)
        return TP_OK;
    return tp_error_add_word(err, TP_FAIL(err, TP_E_POOL_INTERVAL, 0, ticks,
                                       tp_isqrt64((uint64_t)bound * 1000000 / 1024) / ticks),
                          "interval");
}

tp_status tp_pool_check(const tp_pool_config *config, tp_error *err)
{
    tp_status status = tp_pointer_check(config, "config", err);

    if (status == TP_OK)
        status = check_size(config, err);
    if (status == TP_OK)
        status = check_numbers(config, err);
    if (status == TP_OK)
        status = check_courant(config, err);
    if (status == TP_OK && config->interval > 0)
        status = check_interval(config, err);
    if (status != TP_OK)
        return status;
    const tp_grey *mask = config->mask;
    if (mask != NULL && (mask->cols == 0 || mask->rows == 0 || mask->sample == NULL))
        return tp_error_add_word(
            err, TP_FAIL(err, TP_E_POOL_MASK, 0, mask->cols, mask->rows), "mask");
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

static tp_pool_layout pool_layout_make(const tp_pool_config *config)
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
    return tp_pool_check(config, NULL) == TP_OK ? pool_layout_make(config).bytes : 0;
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

/* Sets the factor from a fine height (see subcell.c) to metres in 16.16: range / full
 * range for 8 and 16 bits, 2^-8 for Q8.24; then the factor from a difference over two
 * cells to a slope. */
static void set_height_and_slope_factors(tp_pool *pool)
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
    tp_status status = tp_pointer_check_aligned(pool, 8, "pool", err);

    if (status == TP_OK)
        status = tp_pool_check(config, err);
    if (status != TP_OK)
        return status;
    const tp_pool_layout at = pool_layout_make(config);
    memset(pool, 0, at.bytes);
    *pool = (tp_pool){
        .cols = config->cols,
        .rows = config->rows,
        .cells = config->cells,
        .edges = config->edges,
        .courant_sq_q10 = tp_pool_square_courant(step_courant(config)),
        .damping = config->damping - config->interval,
        .range = config->range,
        .cell = config->cell,
        .x = config->x,
        .z = config->z,
        .turns_x = reciprocal_q64((uint64_t)config->cell * config->cols),
        .turns_z = reciprocal_q64((uint64_t)config->cell * config->rows),
        .drive_min = config->drive_min, .drive_max = config->drive_max,
        .drive_amplitude = config->drive_amplitude, .random = 1, .at_rest = 1, .no_flux = 1,
        .walls = at.walls, .sponge = at.sponge, .scratch = at.scratch, .first = at.first,
        .interval = config->interval,
    };
    set_height_and_slope_factors(pool);
    pool->drive_peak = tp_pool_from_metres(pool, config->drive_amplitude);
    if (pool->walls != 0)
        pool_set_walls(pool, config->mask);
    if (pool->sponge != 0)
        pool_set_sponge(pool, config->sponge);
    return TP_OK;
}

/* -- changes while the water moves --------------------------------------------------- */

static bool is_same_block(const tp_pool *pool, const tp_pool_config *c)
{
    return pool->cols == c->cols && pool->rows == c->rows && pool->cells == c->cells
        && pool->edges == c->edges && pool->cell == c->cell
        && pool->interval == c->interval
        && (pool->range == c->range || pool->cells == TP_CELLS_32);
}

bool tp_pool_set_config(tp_pool *pool, const tp_pool_config *config)
{
    if (!is_same_block(pool, config) || tp_pool_check(config, NULL) != TP_OK)
        return false;
    pool->courant_sq_q10 = tp_pool_square_courant(step_courant(config));
    pool->damping = config->damping - config->interval;
    pool->range = config->range;        /* 32-bit cells ignore the range; it may differ */
    if (pool->sponge != 0)              /* the sponge is never weaker than the field */
        pool_set_sponge(pool, config->sponge);
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
