/* SPDX-License-Identifier: MIT */
/* Cuts a polygon into triangles of its corners.
 *
 *     place n corners in cut->at, then
 *     tp_cut_begin(cut, n);
 *     while (tp_cut_next(cut, triangle))      n - 2 times
 *
 * The triangles turn the same way as the polygon and use every corner. */
#ifndef TP_ASSET_CUT_H
#define TP_ASSET_CUT_H
#include <stdbool.h>
#include <stdint.h>
#include "base/arena.h"

#define TP_NO_CORNER UINT32_MAX

struct tp_obj_cut {
    int32_t  *at[3];                    /* coordinates of each corner, within +-2^30 */
    uint32_t *before, *after;           /* neighbours of the remaining corners */
    const int32_t *u, *v;               /* projected corners, turning left: 0..2^27 */
    uint32_t  start, left;              /* first corner to try; corners left */
    uint64_t  steps;                    /* steps left for tests */
    bool      flat;                     /* no area: corners are cut in order */
    uint32_t *tried;                    /* per corner: what blocked its last test */
    /* The grid of cut_grid.c: */
    uint32_t *cell, *next;              /* first corner of a cell; next in the cell */
    uint32_t  cols, shift;              /* cells in a row; a cell is 2^shift units square */
};

/* Allocates memory for polygons of up to `corners` corners. */
struct tp_obj_cut *tp_cut_layout(tp_arena *arena, uint32_t corners);

/* Begins a polygon of n corners; 3 <= n <= allocated number.  Changes cut->at. */
void tp_cut_begin(struct tp_obj_cut *cut, uint32_t n);

/* Returns the next triangle as three corner numbers; false at the end. */
bool tp_cut_next(struct tp_obj_cut *cut, uint32_t triangle[3]);
#endif
