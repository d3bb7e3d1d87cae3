/* SPDX-License-Identifier: MIT */
/* A tank around the pool, by two modules:
 *
 *     tank_drawing.c    its stone, and the walls in the pool
 *     tank_stage.c      their span stage
 *     glass_drawing.c   its walls of glass: the water behind them, and the panes
 *     glass_stage.c     their span stages */
#ifndef TP_TANK_H
#define TP_TANK_H
#include "geom/geom.h"
#include "scene/module.h"
#include "scene/sides.h"
#include "tidepool/frame.h"

struct tp_frame;

#define TP_TANK_ID  TP_MODULE_ID('t', 'a', 'n', 'k')
#define TP_GLASS_ID TP_MODULE_ID('g', 'l', 'a', 's')

#define TP_BLOCKS 256           /* of a pool's inner walls */

typedef struct {
    tp_rectangle *block;        /* TP_BLOCKS; NULL: the pool has no walls in it */
    uint32_t blocks, dropped;
    tp_fx    low, high;         /* of all blocks */
    bool     made;
} tp_tank;

/* True if the eye stands outside of wall `face` (+x, -x, +z, -z), which is of glass. */
bool tp_tank_is_glass(const struct tp_frame *frame, uint32_t face);

/* The water's edge along a wall of glass. */
typedef struct {
    tp_fx along, high;
} tp_side_post;

/* Half of a wall of glass, projected and clipped; 28.4 pixels. */
typedef struct {
    int     count;
    int32_t u[TP_CLIP_CORNERS], v[TP_CLIP_CORNERS];
} tp_pane;

/* A wall of glass that the eye stands outside of. */
typedef struct {
    uint32_t      face, posts;
    tp_side_post *post;
    tp_pane       pane[2];
    int32_t       x0, x1, y0, y1;   /* pixels that both may cover, x1 and y1 not included */
    int64_t       gap, right, up, ahead;    /* its depth over the picture, see place_depth */
} tp_glass_wall;

#define TP_GLASSES 2            /* an eye stands outside of two walls at the most */

/* The panes' stage reads it in tp_run.mine. */
typedef struct {
    uint32_t      walls;        /* 0: an eye in the water, or above the tank */
    tp_glass_wall wall[TP_GLASSES];
    uint32_t      colour, share;    /* of the glass, and how much of it: 0..256 */
} tp_glass;
#endif
