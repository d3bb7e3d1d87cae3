/* SPDX-License-Identifier: MIT */
/* The grid over a sea floor: each crossing is displaced by the ocean, which may break and
 * overhang, so slopes are those of the sheet between a crossing's four neighbours.  Three
 * displaced rows are kept, evaluated once each. */
#ifndef TP_GEOM_SHEET_H
#define TP_GEOM_SHEET_H
#include "geom/grid.h"

static inline bool tp_sheet_is(const tp_grid *grid)
{
    return grid->frame.surface->ocean && grid->dry;
}

/* Columns of row j that the cells at either side need, first to end - 1. */
tp_grid_span tp_grid_needed(const tp_grid *grid, uint32_t j);

/* Rows one after the other. */
void tp_sheet_place_row(tp_grid *grid, uint32_t j, tp_grid_span needed);

/* Its slopes are left 0. */
tp_view_corner tp_sheet_corner(const tp_grid *grid, uint32_t i, uint32_t j);
#endif
