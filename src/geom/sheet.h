/* SPDX-License-Identifier: MIT */
/* The grid of coastal water.  Each vertex is displaced by the wave model.  Waves may
 * break and overhang, so slopes are differences between the four neighbours of a vertex.
 * Three displaced rows are kept; each is evaluated once. */
#ifndef TP_GEOM_SHEET_H
#define TP_GEOM_SHEET_H
#include "geom/grid.h"

static inline bool tp_grid_is_coastal(const tp_grid *grid)
{
    return grid->frame.surface->coastal && grid->dry;
}

/* Returns the vertices of row j, first to end - 1, that the cells on both sides need. */
tp_grid_span tp_grid_needed_vertices(const tp_grid *grid, uint32_t j);

/* Evaluates a row; rows must be called in order. */
void tp_sheet_place_row(tp_grid *grid, uint32_t j, tp_grid_span needed);

/* Returns a vertex before projection; its slopes stay 0. */
tp_view_vertex tp_sheet_make_view_vertex(const tp_grid *grid, uint32_t i, uint32_t j);
#endif
