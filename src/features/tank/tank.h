/* SPDX-License-Identifier: MIT */
/*
 * A tank around the pool, by two modules, and its parameters:
 *
 *     tank_drawing.c    stone walls, and the inner walls of a pool
 *     glass_drawing.c   walls of glass: the water's side, and the panes
 *     tank_stage.c      the span stages of stone and glass, exact and fast
 *     fast_stone_stage.c  the fast stage of stone
 *     tank_rungs.c      the cost of both
 */
#ifndef TP_FEATURES_TANK_TANK_H
#define TP_FEATURES_TANK_TANK_H
#include "tidepool/frame.h"
#include "tidepool/modules.h"
#include "view/projection.h"
#include "world/module.h"
#include "world/pools.h"

struct tp_frame;

#define TP_TANK_ID  TP_MODULE_ID('t', 'a', 'n', 'k')
#define TP_GLASS_ID TP_MODULE_ID('g', 'l', 'a', 's')

#define TP_BLOCKS 256           /* maximum of a pool's inner wall blocks */

/* The quads of a wall or a block in the view placed last that cover a pixel's centre. */
typedef struct {
    int16_t first, end;         /* their rows, px, end not included */
    uint8_t quads;              /* bit k: quad k does */
} tp_tank_seen;

typedef struct {
    tp_rectangle *block;        /* inner walls, room for TP_BLOCKS; NULL: none */
    tp_tank_seen *block_seen;   /* array, one for each block */
    tp_tank_seen  wall_seen[4];
    uint32_t blocks, dropped;
    tp_fx    low, high;         /* height range of all blocks, m */
    bool     made;
} tp_tank;

/* Returns the outer sides of the tank's walls around the water's sides, m. */
tp_rectangle tp_tank_outer_sides(const tp_scene *scene, const tp_rectangle *water);

/* True if wall `face` (+x, -x, +z, -z) is of glass and the eye is on its outer side. */
bool tp_tank_is_front_glass(const struct tp_frame *frame, uint32_t face);

/* A point of the water's edge along a wall of glass, m, and the pixel rows of the water's
 * side up to the next post, the last one included; y0 > y1: none. */
typedef struct {
    tp_fx   along, high;
    int16_t y0, y1;
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
    int64_t       gap, right, up, ahead;    /* plane of its depth, see glass_drawing.c */
} tp_glass_wall;

#define TP_GLASSES 2            /* an eye is outside of two walls at most */

/* Data of the panes' stage, in tp_run.mine. */
typedef struct {
    uint32_t      walls;        /* number of walls; 0: eye in the water or above the
                                 * tank */
    tp_glass_wall wall[TP_GLASSES];
    uint32_t      colour, share;    /* colour of the glass; its opacity, 0..256 */
} tp_glass;

#define TP_TANK_ROWS \
    TP_ROW_CHOICE("tank.kind", tank.kind, "none|stone|glass", TP_TANK_GLASS, \
        TP_TANK_NONE, "walls around the pool; front walls of glass are transparent"), \
    TP_ROW_SWITCH("tank.sea", tank.sea, 1, \
        "a calm sea lies around the walls; off: the water ends at the walls"), \
    TP_ROW_NUMBER("tank.depth", tank.depth, "m", 0.05, 100, 1, \
        "depth of the tank's floor"), \
    TP_ROW_NUMBER("tank.rim", tank.rim, "m", 0, 20, 0.2, \
        "height of the walls above still water"), \
    TP_ROW_NUMBER("tank.tile", tank.tile, "m", 0.05, 100, 1, \
        "side of the square that one repeat of a texture covers"), \
    TP_ROW_NAME("tank.wall", tank.wall, TEXTURE, "PNG of the walls; empty: plain"), \
    TP_ROW_NAME("tank.floor", tank.floor, TEXTURE, "PNG of the floor; empty: plain"), \
    TP_ROW_COLOUR("tank.wall_colour", tank.wall_colour, 0xc0ccd0, \
        "colour of the walls; multiplies the texture"), \
    TP_ROW_COLOUR("tank.floor_colour", tank.floor_colour, 0xd8dcd8, \
        "colour of the floor; multiplies the texture"), \
    TP_ROW_COLOUR("tank.glass_colour", tank.glass_colour, 0x9cc8c0, \
        "colour of the glass"), \
    TP_ROW_NUMBER("tank.glass", tank.glass, "", 0, 1, 0.15, "opacity of the glass")

#endif
