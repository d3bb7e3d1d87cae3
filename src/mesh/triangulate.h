/* SPDX-License-Identifier: MIT */
/* Cuts a polygon into triangles of its corners.
 *
 *     place n corners in cut->at, then
 *     tp_cut_begin(cut, n);
 *     while (tp_cut_next(cut, triangle))      n - 2 times
 *
 * The triangles turn the same way as the polygon and use every corner.  The test of a
 * triangle finds the corners near it by a grid (corner_grid.c). */
#ifndef TP_MESH_TRIANGULATE_H
#define TP_MESH_TRIANGULATE_H
#include <stdbool.h>
#include <stdint.h>
#include "base/arena.h"

/* -- triangles of a polygon ---------------------------------------------------------- */

#define TP_NO_CORNER UINT32_MAX

struct tp_obj_cut {
    int32_t  *at[3];                    /* coordinates of each corner, within +-2^30 */
    uint32_t *before, *after;           /* neighbours of the remaining corners */
    const int32_t *u, *v;               /* projected corners, turning left: 0..2^27 */
    uint32_t  start, left;              /* first corner to try; corners left */
    uint64_t  steps;                    /* steps left for tests */
    bool      flat;                     /* no area: corners are cut in order */
    uint32_t *tried;                    /* per corner: what blocked its last test */
    /* The grid of corner_grid.c: */
    uint32_t *cell, *next;              /* first corner of a cell; next in the cell */
    uint32_t  cols, shift;              /* cells in a row; a cell is 2^shift units square */
};

/* Allocates memory for polygons of up to `corners` corners. */
struct tp_obj_cut *tp_cut_layout(tp_arena *arena, uint32_t corners);

/* Begins a polygon of n corners; 3 <= n <= allocated number.  Changes cut->at. */
void tp_cut_begin(struct tp_obj_cut *cut, uint32_t n);

/* Returns the next triangle as three corner numbers; false at the end. */
bool tp_cut_next(struct tp_obj_cut *cut, uint32_t triangle[3]);

/* -- the grid of corners ------------------------------------------------------------- */

/* The corners of a polygon, sorted into a grid of square cells over its extent.  A cell has
 * 8 to 32 corners on average: the test of a small triangle meets only few corners. */

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
