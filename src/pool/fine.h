/* SPDX-License-Identifier: MIT */
/* Fine heights of cells: 8-bit ones have 16 bits more, 16-bit ones 8 more, 32-bit ones
 * are fine as they are; `back` of a tick ago the height was H - back V, of which neither
 * end leaves the range, so all fit 31 bits. */
#ifndef TP_POOL_FINE_H
#define TP_POOL_FINE_H
#include "base/base.h"
#include "pool/pool.h"

/* A fine height; `base` is that of the row's first cell, `cells` and `moves` (whether
 * back is not 0) are literals where it matters. */
TP_ALWAYS_INLINE int32_t tp_pool_fine(const tp_pool *pool, uint32_t col, uint32_t row,
                                      uint32_t base, tp_fx back, tp_cells cells,
                                      int moves)
{
    const void *const from = tp_pool_from(pool, sizeof *pool);
    const uint32_t i = base + col;

    if (cells == TP_CELLS_8) {
        const tp_pool_pair_8 *const cell = (const tp_pool_pair_8 *)from + i;
        return cell->h * 65536 - (moves ? cell->v * back : 0);
    }
    if (cells == TP_CELLS_16) {             /* 32767 x 2^16 fits */
        const tp_pool_pair_16 *const cell = (const tp_pool_pair_16 *)from + i;
        return cell->h * 256 - (moves ? (cell->v * back + 128) >> 8 : 0);
    }
    const int32_t h = ((const int32_t *)from)[i];
    if (!moves)
        return h;
    return h - (int32_t)(((int64_t)tp_pool_gain(pool, col, row) * back + 0x8000) >> 16);
}

/* Column or row i, which may lie one or two beyond: wrapped or mirrored. */
static inline uint32_t tp_pool_folded(int32_t i, uint32_t cells, bool tiled)
{
    const int32_t n = (int32_t)cells;

    if (tiled)
        return (uint32_t)(i < 0 ? i + n : i < n ? i : i - n);
    return (uint32_t)(i < 0 ? -1 - i : i < n ? i : 2 * n - 1 - i);
}

/* Of a wall: the mean of the open cells beside it, so that a flat wall mirrors and the
 * surface beside a wall is one however it is reached; deep inside of walls `inside`. */
int32_t tp_pool_fine_or_wall(const tp_pool *pool, uint32_t col, uint32_t row, tp_fx back,
                             int32_t inside);
#endif
