/* SPDX-License-Identifier: MIT */
/* A tank around the pool, by two modules:
 *
 *     tank_drawing.c    stone walls, and the inner walls of a pool
 *     tank_stage.c      their span stage
 *     glass_drawing.c   walls of glass: the water's side, and the panes
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

#define TP_BLOCKS 256           /* maximum of a pool's inner wall blocks */

typedef struct {
    tp_rectangle *block;        /* room for TP_BLOCKS; NULL: no inner walls */
    uint32_t blocks, dropped;
    tp_fx    low, high;         /* height range of all blocks, m */
    bool     made;
} tp_tank;

/* True if wall `face` (+x, -x, +z, -z) is of glass and the eye is on its outer side. */
bool tp_tank_is_front_glass(const struct tp_frame *frame, uint32_t face);

/* A point of the water's edge along a wall of glass, m. */
typedef struct {
    tp_fx along, high;
} tp_tank_side_post;

/* Half of a wall of glass, projected and clipped; 28.4 px. */
typedef struct {
    int     count;
    int32_t u[TP_CLIP_VERTICES], v[TP_CLIP_VERTICES];
} tp_pane;

/* A wall of glass with the eye on its outer side. */
typedef struct {
    uint32_t      face, posts;
    tp_tank_side_post *post;
    tp_pane       pane[2];
    int32_t       x0, x1, y0, y1;   /* pixel box of both panes, x1 and y1 excluded */
    int64_t       gap, right, up, ahead;    /* plane of its depth, see place_depth */
} tp_glass_wall;

#define TP_GLASSES 2            /* an eye is outside of two walls at most */

/* Data of the panes' stage, in tp_run.mine. */
typedef struct {
    uint32_t      walls;        /* 0: eye in the water, or above the tank */
    tp_glass_wall wall[TP_GLASSES];
    uint32_t      colour, share;    /* of the glass; its opacity 0..256 */
} tp_glass;
#endif
