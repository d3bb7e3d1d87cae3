/* SPDX-License-Identifier: MIT */
/* The corners of a polygon, sorted into a grid of square cells over its extent.  A cell has
 * 8 to 32 corners on average: the test of a small triangle meets only few corners. */
#ifndef TP_ASSET_CUT_GRID_H
#define TP_ASSET_CUT_GRID_H
#include "asset/cut.h"

/* True if the corner has been cut off. */
static inline bool tp_cut_is_removed(const struct tp_obj_cut *cut, uint32_t corner)
{
    return cut->before[cut->after[corner]] != corner;
}

/* Returns the number of cells for a polygon of n corners. */
uint32_t tp_cut_grid_cells(uint32_t n);

/* Sorts the n corners into their cells; u and v lie within 0..extent. */
void tp_cut_grid_fill(struct tp_obj_cut *cut, uint32_t n, uint32_t extent_u,
                      uint32_t extent_v);

/* A walk over the corners in the cells within reach of a triangle. */
typedef struct {
    struct tp_obj_cut *cut;
    const uint32_t    *triangle;
    uint32_t          *link;            /* link to the next corner */
    uint32_t row, last_row;             /* row of the cell; last row of the walk */
    uint32_t col, last_col, low_col, high_col;
    uint32_t steps;                     /* corners and cells visited */
} tp_cut_walk;

/* `from` is the corner after which the walk begins, where an earlier walk over the same
 * triangle stopped, or TP_NO_CORNER. */
tp_cut_walk tp_cut_walk_begin(struct tp_obj_cut *cut, const uint32_t triangle[3],
                              uint32_t from);

/* Returns the next corner that is not cut off, TP_NO_CORNER at the end. */
uint32_t tp_cut_walk_next_corner(tp_cut_walk *walk);
#endif
