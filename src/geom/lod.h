/* SPDX-License-Identifier: MIT */
/* Level of detail of the grid: removes lines where they are dense on the screen.
 *
 * A line at distance d beside the eye (along x for columns, z for rows) never appears in
 * the picture at a depth below c d; c depends on the camera.  Cells there may be 12 px
 * wide at that depth, and are at least 6 px wide.  Where 12 px are 2, 4, 8 ... cells,
 * every 2nd, 4th, 8th ... line is kept, counted from the world's origin.  Lines appear
 * and disappear but never move.
 *
 * Waves fade by the allowed step, not by the current step: waves too short for the next
 * step are gone before that step is used, so nothing jumps.  Heights fade first (between
 * 6 and 3 steps per wave), then slopes (between 4 and 2).  Waves too short for the full
 * grid fade while the step grows from one cell to two. */
#ifndef TP_GEOM_LOD_H
#define TP_GEOM_LOD_H
#include "geom/grid.h"

#define TP_LOD_PIXELS 12
#define TP_LOD_LEVELS 6         /* at most every 64th line is kept */

/* State of an axis: of columns, or of rows. */
typedef struct tp_lod_axis {
    tp_fx   eye, cell;
    tp_fx   least;              /* smallest step anywhere, m */
    int32_t rate[2];            /* step per distance, Q.24: on the lower side, on the
                                 * higher */
} tp_lod_axis;

/* Returns the allowed distance of lines at a position, m. */
tp_fx tp_lod_step(const tp_lod_axis *lod, tp_fx place);

/* tp_lod_layout allocates the memory. tp_lod_thin removes lines of a grid with this
 * memory, after the lines have been placed. */
void tp_lod_layout(tp_grid *grid, tp_arena *arena);
void tp_lod_thin(tp_grid *grid, const tp_grid_view *view);

/* Remaining weights of a wave for a step: of its heights, of its slopes.  `turns` is
 * Q0.32 turns per metre along the axis. */
typedef struct {
    tp_fx height, slope;
} tp_lod_share;

tp_lod_share tp_lod_swell_share(const tp_lod_axis *lod, tp_fx step, int64_t turns);

/* Functions that a program links for level of detail. */
struct tp_water_lod {
    void (*layout)(tp_grid *grid, tp_arena *arena);
    void (*thin)(tp_grid *grid, const tp_grid_view *view);
    tp_fx (*step)(const tp_lod_axis *lod, tp_fx place);
    tp_lod_share (*share)(const tp_lod_axis *lod, tp_fx step, int64_t turns);
};
#endif
