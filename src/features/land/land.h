/* SPDX-License-Identifier: MIT */
/*
 * Land: a sea floor near the water's level or above it.
 *
 *     land_drawing.c   the module, and its triangles
 *     land_stage.c     its shading, plain or with the floor's texture
 *     land_rungs.c     the cost of its rows of cells
 */
#ifndef TP_FEATURES_LAND_LAND_H
#define TP_FEATURES_LAND_LAND_H
#include "shade/shade.h"
#include "tidepool/modules.h"
#include "world/module.h"

#define TP_LAND_ID TP_MODULE_ID('l', 'a', 'n', 'd')

/* Data of the stages, in tp_run.mine: the material, and the swash, the sheet of water that
 * a wave sends up the beach. */
typedef struct {
    tp_solid look;
    tp_fx    runup;             /* m: height of the highest swash; 0: none */
    tp_turn  phase;             /* the wave's phase at the drawn moment */
    uint32_t foam;              /* colour of foam at the front */
} tp_land_look;

#define TP_LAND_ROWS \
    TP_ROW_COLOUR("floor.colour", floor.colour, 0xc8b48c, \
        "colour of the land; multiplies the texture"), \
    TP_ROW_NAME("floor.texture", floor.texture, TEXTURE, \
        "PNG over the land; empty: none"), \
    TP_ROW_NUMBER("floor.texture_size", floor.texture_size, "m", 0.1, 1000, 8, \
        "side of the square that one repeat covers")

#endif
