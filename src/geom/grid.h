/* SPDX-License-Identifier: MIT */
/* The water's grid: lines across and along, their crossings displaced and projected.
 *
 * The middle of the grid has square cells of one size.  If the scene asks for water
 * that reaches farther, the outer eighth of the lines at each side (TP_GRID_FLANK at the
 * most) stretches out to it in steps that grow by one ratio, flat: the waves fade out
 * before, over the last eighth of the middle.  A grid that follows the camera moves by
 * whole cells, so that its crossings stay where they were in the world: nothing swims.
 *
 * Texture coordinates are the places at rest, so a column has one s and a row one t;
 * phases are linear in them, so each wave costs one addition per crossing. */
#ifndef TP_GEOM_GRID_H
#define TP_GEOM_GRID_H
#include "geom/geom.h"
#include "tidepool/arena.h"
#include "tidepool/wave.h"

#define TP_GRID_FLANK 12
#define TP_GRID_BLOCK 16        /* cells of a row that share a bounding box */

/* A crossing: displaced, projected, packed. */
typedef struct {
    int32_t  u, v;              /* 28.4; u = TP_GRID_CUT: must be clipped */
    uint32_t zi;                /* Q1.31 */
    int16_t  slope_x, slope_z;  /* Q3.12 */
} tp_grid_vertex;

#define TP_GRID_CUT INT32_MIN

typedef struct {
    tp_fx   place;              /* world x or z at rest */
    tp_fx   fade;               /* of the waves, 0..1 */
    tp_turn turns[TP_WAVES];    /* k D place of each wave; rows also hold its phase */
} tp_grid_line;

/* Whole pixels, x1 and y1 included. */
typedef struct {
    int16_t x0, y0, x1, y1;
} tp_grid_box;

typedef struct {
    uint16_t first, end;        /* cells of this row that may be seen */
} tp_grid_span;

typedef struct {
    uint32_t cols, rows;        /* lines; cells are one less */
    uint32_t blocks;            /* of a row of cells */
    tp_grid_line   *column, *row;
    tp_grid_vertex *vertex;     /* rows x cols */
    tp_grid_span   *span;       /* of each row of cells */
    tp_grid_box    *box;        /* (rows - 1) x blocks */
    uint32_t vertices;          /* evaluated by the last tp_grid_place */
} tp_grid;

void tp_grid_carve(tp_grid *grid, tp_arena *arena, uint32_t cols, uint32_t rows);

/* What the grid shows, taken together. */
typedef struct {
    const tp_lens *lens;
    const tp_sea  *sea;
    const tp_turn *phases;
    uint32_t width, height;     /* of the picture */
    tp_fx cell, reach;
    bool  follow;
} tp_grid_view;

/* Lays the lines, evaluates the crossings that may be seen. */
void tp_grid_place(tp_grid *grid, const tp_grid_view *view);

/* One crossing again, before projection: for cells that must be clipped. */
tp_view_corner tp_grid_corner(const tp_grid *grid, const tp_grid_view *view,
                              uint32_t i, uint32_t j);
#endif
