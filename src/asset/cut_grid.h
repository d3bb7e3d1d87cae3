/* SPDX-License-Identifier: MIT */
/* The corners of a polygon that is being cut, by place: a grid of square cells over its
 * extent, of 8 to 32 corners in the mean, so that a test of a small triangle meets few. */
#ifndef TP_ASSET_CUT_GRID_H
#define TP_ASSET_CUT_GRID_H
#include "asset/cut.h"

/* Has the corner been cut off? */
static inline bool tp_cut_is_off(const struct tp_obj_cut *cut, uint32_t corner)
{
    return cut->before[cut->after[corner]] != corner;
}

/* Cells that a polygon of n corners has. */
uint32_t tp_cut_cells(uint32_t n);

/* Puts the n corners into their cells; u and v lie within 0..extent. */
void tp_cut_grid_fill(struct tp_obj_cut *cut, uint32_t n, uint32_t extent_u,
                      uint32_t extent_v);

/* A walk over the corners in the cells that a triangle reaches. */
typedef struct {
    struct tp_obj_cut *cut;
    const uint32_t    *triangle;
    uint32_t          *link;            /* to the corner that comes next */
    uint32_t row, last_row;             /* the cell's, and where the walk ends */
    uint32_t col, last_col, low_col, high_col;
    uint32_t steps;                     /* corners and cells that were met */
} tp_cut_walk;

/* `from`: the corner behind which the walk begins, where an earlier one over the same
 * triangle stopped, or TP_NO_CORNER. */
tp_cut_walk tp_cut_walk_begin(struct tp_obj_cut *cut, const uint32_t triangle[3],
                              uint32_t from);

/* The next corner that is not cut off, TP_NO_CORNER at the end. */
uint32_t tp_cut_walk_next(tp_cut_walk *walk);
#endif
