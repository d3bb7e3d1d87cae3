/* SPDX-License-Identifier: MIT */
/* Cover within the window, and the parts of the window without cover. */
#ifndef TP_FEATURES_FOAM_FOAM_WINDOW_H
#define TP_FEATURES_FOAM_FOAM_WINDOW_H
#include "features/foam/foam.h"
#include "shade/shade.h"

/* Returns the cover 0..255, bilinear between cell centres.  u and w: cells from the
 * window's low corner, Q16. */
TP_ALWAYS_INLINE uint32_t tp_foam_sample_cover(const tp_shade_foam *f, uint32_t u,
                                               uint32_t w)
{
    uint32_t n = f->cells;
    uint32_t a = u + 32768, b = w + 32768;      /* half a cell back, and one cell ahead */
    uint32_t i = (a >> 16) + f->col, j = (b >> 16) + f->row;

    i -= i >= n ? n : 0;
    j -= j >= n ? n : 0;
    uint32_t i1 = i + 1 < n ? i + 1 : 0, j1 = j + 1 < n ? j + 1 : 0;
    const uint8_t *here = f->cover + (size_t)j * n, *below = f->cover + (size_t)j1 * n;
    if ((here[i] | here[i1] | below[i] | below[i1]) == 0)
        return 0;
    uint32_t fs = a >> 8 & 0xff, ft = b >> 8 & 0xff;
    uint32_t over = here[i] * (256 - fs) + here[i1] * fs;
    uint32_t under = below[i] * (256 - fs) + below[i1] * fs;
    return (over * (256 - ft) + under * ft + 0x8000) >> 16;
}

/* Returns the weight of the cover against the mean: 256 inside, 0 from the window's
 * inscribed circle on.  The weight falls with the square of the distance, from 3/4 of the
 * radius on. */
TP_ALWAYS_INLINE uint32_t tp_foam_window_weight(const tp_shade_foam *f, uint32_t u,
                                                uint32_t w)
{
    const uint32_t r = f->cells * 128;
    const int32_t du = (int32_t)(u >> 8) - (int32_t)r, dw = (int32_t)(w >> 8) - (int32_t)r;
    const uint32_t square = (uint32_t)(du * du) + (uint32_t)(dw * dw);

    if (square <= (r * r >> 4) * 9 || f->edge == UINT32_MAX)
        return 256;
    if (square >= r * r)
        return 0;
    const uint64_t share = (uint64_t)(r * r - square) * f->edge >> 32;
    return share < 256 ? (uint32_t)share : 256;
}

/* Returns cells, Q16, of a distance from the window's low side, m. */
TP_ALWAYS_INLINE uint32_t tp_foam_cells(const tp_shade_foam *f, uint32_t metres)
{
    return (uint32_t)(metres * f->per_metre >> 32);
}

/* Returns the cover 0..255 at a place and its weight, 0 outside of the window. */
TP_ALWAYS_INLINE uint32_t tp_foam_sample_window(const tp_shade_foam *f, uint32_t s,
                                                uint32_t t, uint32_t *weight)
{
    uint32_t ds = s - (uint32_t)f->low_s, dt = t - (uint32_t)f->low_t;

    *weight = 0;
    if (ds >= f->side || dt >= f->side)
        return 0;
    const uint32_t u = tp_foam_cells(f, ds), w = tp_foam_cells(f, dt);
    *weight = tp_foam_window_weight(f, u, w);
    return *weight ? tp_foam_sample_cover(f, u, w) : 0;
}

/* -- blocks of samples --------------------------------------------------------------- */

/* Rest positions in a block's box, around the middle of the window. */
typedef enum {
    TP_FOAM_BLOCK_MIXED,
    TP_FOAM_BLOCK_EMPTY,        /* no foam in the box */
    TP_FOAM_BLOCK_INSIDE,       /* weight 256 in the box */
    TP_FOAM_BLOCK_OUTSIDE       /* weight 0 in the box */
} tp_foam_block_kind;

/* Returns the kind of the samples i..stop of a run, or TP_FOAM_BLOCK_MIXED. */
tp_foam_block_kind tp_foam_block_classify(const tp_shade_foam *f, const tp_run *run,
                                          int32_t i, int32_t stop);

/* A box of rest positions: distances from the window's low sides, m, and half sides below
 * 2^29. */
typedef struct {
    uint32_t ds, dt, half_s, half_t;
} tp_foam_box;

tp_foam_block_kind tp_foam_box_classify(const tp_shade_foam *f, const tp_foam_box *box);

/* True if the cells of samples between two distances from the window's low sides, cells Q16,
 * lie in squares without cover. */
bool tp_foam_is_range_empty(const tp_shade_foam *f, const uint32_t u[2],
                            const uint32_t w[2]);

/* Finds the squares of 4 x 4 cells, of 8 x 8 in fields above 128 cells, whose cover is below
 * `least`, a power of 2, everywhere.  Returns true if any square has more. */
bool tp_foam_find_empty_squares(tp_shade_foam *f, uint32_t least);

#endif
