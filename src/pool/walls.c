/* SPDX-License-Identifier: MIT */
/* Walls and sponge of a pool, computed once at init [C15]. */
#include "base/assert.h"
#include "pool/pool.h"

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

void tp_pool_set_walls(tp_pool *pool, const tp_grey *mask)
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

/* Returns the j >= 1 with 2^-j nearest to delta = 8 (W - d)^2 / (max(W, 16) W^2), nearest
 * in the exponent: the first j with delta^2 2^(2j+1) >= 1, at most `most`.  Both sides of
 * the comparison are below 2^52. */
static uint8_t sponge_exponent(uint32_t d, uint32_t width, uint32_t most)
{
    const uint64_t least = width > 16 ? width : 16, w2 = width * width;
    const uint64_t depth2 = d < width ? (uint64_t)(width - d) * (width - d) : 0;
    uint8_t j = 1;

    while (j < most && (depth2 * depth2 << (2 * j + 7)) < least * least * w2 * w2)
        j++;
    return j;
}

void tp_pool_set_sponge(tp_pool *pool, uint32_t width)
{
    TP_ASSERT(pool->sponge != 0 && width >= 4 && width <= 64);
    uint8_t *const column = tp_pool_pointer(pool, pool->sponge);
    uint8_t *const row = column + pool->cols;
    const uint32_t right = pool->cols - 1, bottom = pool->rows - 1;

    for (uint32_t x = 0; x <= right; x++)
        column[x] = sponge_exponent(x < right - x ? x : right - x, width, pool->damping);
    for (uint32_t y = 0; y <= bottom; y++)
        row[y] = sponge_exponent(y < bottom - y ? y : bottom - y, width, pool->damping);
}
