/* SPDX-License-Identifier: MIT */
/* Fine heights of cells: the stored height with extra fraction bits for interpolation.
 * 8-bit cells get 16 more bits, 16-bit cells 8 more, 32-bit cells none.  `back` is a
 * fraction of a tick into the past: the height was then H - back V.  Neither the
 * height H nor the last one, H - V, leaves the range of the cell, and all heights
 * between fit 31 bits. */
#ifndef TP_POOL_FINE_H
#define TP_POOL_FINE_H
#include "base/base.h"
#include "pool/pool.h"

/* Returns a fine height.  `base` is the index of the first cell of the row.  `moves` is
 * true if back is not 0.  `cells` and `moves` are literals in fast loops. */
TP_ALWAYS_INLINE int32_t tp_pool_fine_height(const tp_pool *pool, uint32_t col,
                                             uint32_t row, uint32_t base, tp_fx lag,
                                             tp_cells cells, int interpolates)
{
    const void *const from = tp_pool_const_pointer(pool, sizeof *pool);
    const uint32_t i = base + col;

    if (cells == TP_CELLS_8) {
        const tp_pool_pair_8 *const cell = (const tp_pool_pair_8 *)from + i;
        return cell->h * 65536 - (interpolates ? cell->v * lag : 0);
    }
    if (cells == TP_CELLS_16) {             /* 32767 x 2^16 fits */
        const tp_pool_pair_16 *const cell = (const tp_pool_pair_16 *)from + i;
        return cell->h * 256 - (interpolates ? (cell->v * lag + 128) >> 8 : 0);
    }
    const int32_t h = ((const int32_t *)from)[i];
    if (!interpolates)
        return h;
    return h
           - (int32_t)(((int64_t)tp_pool_net_inflow(pool, col, row) * lag + 0x8000)
                       >> 16);
}

/* Returns column or row i, wrapped or mirrored into the field; i may lie one or
 * two cells outside. */
static inline uint32_t tp_pool_folded(int32_t i, uint32_t cells, bool tiled)
{
    const int32_t n = (int32_t)cells;

    if (tiled)
        return (uint32_t)(i < 0 ? i + n : i < n ? i : i - n);
    return (uint32_t)(i < 0 ? -1 - i : i < n ? i : 2 * n - 1 - i);
}

/* Returns the fine height of a cell.  A wall cell gets the mean of the open cells beside
 * the wall: a flat wall mirrors, and the surface beside a wall does not depend on the side
 * it is sampled from.  A wall cell without open neighbours gets `inside`. */
int32_t tp_pool_fine_height_or_wall(const tp_pool *pool, uint32_t col, uint32_t row,
                                    tp_fx lag, int32_t inside);
#endif
