/* SPDX-License-Identifier: MIT */
/* Fewer lines of the grid where they lie close on the screen.
 *
 * A line at distance d beside the eye (along x for columns, z for rows) is nowhere in the
 * picture at less than some depth c d, c the camera's, so cells there may be 12 pixels of
 * that depth wide, and are no less than 6.  Where that is 2, 4, 8 ... cells, every 2nd,
 * 4th, 8th ... line is kept, counted from the world's origin: a line comes and goes, but
 * never moves.
 *
 * Waves fade by what may be, not by what is: those that the next step would not carry
 * are gone before it is taken, and nothing jumps.  Heights go first (between 6 and 3
 * steps a wave), then slopes (between 4 and 2).  Waves that the grid itself carries no
 * better fade while the step goes from one cell to two. */
#ifndef TP_GEOM_LOD_H
#define TP_GEOM_LOD_H
#include "geom/grid.h"

#define TP_LOD_PIXELS 12
#define TP_LOD_LEVELS 6         /* every 64th line at the most */

/* One way: of columns, or of rows. */
typedef struct tp_thinning {
    tp_fx   eye, cell;
    tp_fx   least;              /* step anywhere, m */
    int32_t rate[2];            /* step over distance, Q.24: before the eye, and behind */
} tp_thinning;

/* How far apart lines may lie at a place, m. */
tp_fx tp_lod_step(const tp_thinning *lod, tp_fx place);

/* Takes memory; leaves out lines of a grid that has some and is laid. */
void tp_lod_carve(tp_grid *grid, tp_arena *arena);
void tp_lod_thin(tp_grid *grid, const tp_grid_view *view);

/* What is left of a wave, Q0.32 turns a metre this way: of its heights, of its slopes. */
typedef struct {
    tp_fx height, slope;
} tp_lod_share;

tp_lod_share tp_lod_share_of(const tp_thinning *lod, tp_fx step, int64_t turns);

/* The functions that a program links for it. */
struct tp_water_lod {
    void (*carve)(tp_grid *grid, tp_arena *arena);
    void (*thin)(tp_grid *grid, const tp_grid_view *view);
    tp_fx (*step)(const tp_thinning *lod, tp_fx place);
    tp_lod_share (*share)(const tp_thinning *lod, tp_fx step, int64_t turns);
};
#endif
