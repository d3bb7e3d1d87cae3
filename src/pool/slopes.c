/* SPDX-License-Identifier: MIT */
/* The slopes of all cells as a table, for code that samples slopes at every pixel.  A slope
 * is the central difference of the two neighbours of a cell [A6]. */
#include "base/assert.h"
#include "pool/fine.h"

/* One row of the table: the row of cells at its height, the row above (up)
 * and below (down). */
typedef struct {
    const tp_pool *pool;
    uint32_t row, up, down;
    tp_fx    lag, gain;
} pool_row;

/* Slopes in 16.16 are far below 2^31: 64 m over two cells of a centimetre are 2^27. */
static int16_t scale_slope(const pool_row *l, int32_t difference)
{
    const tp_pool *const pool = l->pool;
    const int64_t slope = (int64_t)difference * pool->slope_q >> pool->slope_shift;
    const int64_t held = (slope * l->gain + ((int64_t)1 << 19)) >> 20;

    return (int16_t)(held < -16383 ? -16383 : held > 16383 ? 16383 : held);
}

/* A row of a pool without walls.  `cells` and `moves` are literals. */
TP_ALWAYS_INLINE void write_open_row(const pool_row *l, tp_pool_slope *to, tp_cells cells,
                                     int interpolates)
{
    const tp_pool *const pool = l->pool;
    const uint32_t cols = pool->cols, base = l->row * cols;
    const bool     tiled = pool->edges == TP_EDGES_TILE;

    for (int32_t col = -1; col <= (int32_t)cols; col++) {
        const uint32_t at = tp_pool_folded(col, cols, tiled);
        const uint32_t left = tp_pool_folded(col - 1, cols, tiled);
        const uint32_t right = tp_pool_folded(col + 1, cols, tiled);
        const int32_t x =
            tp_pool_fine_height(pool, right, l->row, base, l->lag, cells, interpolates)
            - tp_pool_fine_height(pool, left, l->row, base, l->lag, cells, interpolates);
        const int32_t z = tp_pool_fine_height(pool, at, l->down, l->down * cols, l->lag,
                                              cells, interpolates)
                          - tp_pool_fine_height(pool, at, l->up, l->up * cols, l->lag,
                                                cells, interpolates);
        *to++ = (tp_pool_slope){ scale_slope(l, x), scale_slope(l, z) };
    }
}

/* A row of a pool with walls.  Deep inside walls all neighbours are 0, and the slope is
 * 0. */
static void write_walled_row(const pool_row *l, tp_pool_slope *to)
{
    const tp_pool *const pool = l->pool;
    const uint32_t cols = pool->cols;
    const bool     tiled = pool->edges == TP_EDGES_TILE;

    for (int32_t col = -1; col <= (int32_t)cols; col++) {
        const uint32_t at = tp_pool_folded(col, cols, tiled);
        const uint32_t left = tp_pool_folded(col - 1, cols, tiled);
        const uint32_t right = tp_pool_folded(col + 1, cols, tiled);
        const int32_t  own = tp_pool_fine_height_or_wall(pool, at, l->row, l->lag, 0);
        const int32_t  x = tp_pool_fine_height_or_wall(pool, right, l->row, l->lag, own)
                         - tp_pool_fine_height_or_wall(pool, left, l->row, l->lag, own);
        const int32_t  z = tp_pool_fine_height_or_wall(pool, at, l->down, l->lag, own)
                         - tp_pool_fine_height_or_wall(pool, at, l->up, l->lag, own);
        *to++ = (tp_pool_slope){ scale_slope(l, x), scale_slope(l, z) };
    }
}

static void write_slope_row(const pool_row *l, tp_pool_slope *to)
{
    const tp_cells cells = (tp_cells)l->pool->cells;

    if (l->pool->walls != 0)
        write_walled_row(l, to);
    else if (cells == TP_CELLS_8)
        write_open_row(l, to, TP_CELLS_8, 1);
    else if (cells == TP_CELLS_16)
        write_open_row(l, to, TP_CELLS_16, 1);
    else
        write_open_row(l, to, TP_CELLS_32, 1);
}

void tp_pool_slopes(const tp_pool *pool, tp_fx lag, tp_fx gain, tp_pool_slope *to)
{
    TP_ASSERT(lag >= 0 && lag <= TP_FX_ONE);
    TP_ASSERT(to != NULL);
    const bool tiled = pool->edges == TP_EDGES_TILE;

    for (int32_t row = -1; row <= (int32_t)pool->rows; row++) {
        const pool_row l = { pool, tp_pool_folded(row, pool->rows, tiled),
                         tp_pool_folded(row - 1, pool->rows, tiled),
                         tp_pool_folded(row + 1, pool->rows, tiled), lag, gain };
        write_slope_row(&l, to);
        to += pool->cols + 2;
    }
}
