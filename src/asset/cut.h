/* SPDX-License-Identifier: MIT */
/* Cuts a polygon into triangles of its corners.
 *
 *     place n corners in cut->at, then
 *     tp_cut_begin(cut, n);
 *     while (tp_cut_next(cut, triangle))      n - 2 times
 *
 * The triangles turn as the polygon does and use every corner. */
#ifndef TP_ASSET_CUT_H
#define TP_ASSET_CUT_H
#include <stdbool.h>
#include <stdint.h>
#include "base/arena.h"

#define TP_NO_CORNER UINT32_MAX

struct tp_obj_cut {
    int32_t  *at[3];                    /* of each corner, within +-2^30 */
    uint32_t *before, *after;           /* neighbours of the corners that are left */
    const int32_t *u, *v;               /* seen along the axis, turning left: 0..2^27 */
    uint32_t  start, left;              /* the corner to try first; corners not cut off */
    uint64_t  steps;                    /* that tests may still take */
    bool      flat;                     /* no area: it is cut as it comes */
    uint32_t *tried;                    /* by corner: where its last test stopped, or none */
    /* The grid, cut_grid.c: */
    uint32_t *cell, *next;              /* first corner of a cell; the next in its cell */
    uint32_t  cols, shift;              /* cells in a row; a cell is 2^shift units square */
};

/* Room for a polygon of so many corners. */
struct tp_obj_cut *tp_cut_carve(tp_arena *arena, uint32_t corners);

/* 3 <= n, and no more than there is room for; changes cut->at. */
void tp_cut_begin(struct tp_obj_cut *cut, uint32_t n);

/* The next triangle, corners by their number; false: all is cut. */
bool tp_cut_next(struct tp_obj_cut *cut, uint32_t triangle[3]);
#endif
