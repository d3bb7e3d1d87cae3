/* SPDX-License-Identifier: MIT */
/* Parameter rows of a tank around the pool. */
#ifndef TP_TANK_ROWS_H
#define TP_TANK_ROWS_H
#include "tidepool/modules.h"

#define TP_TANK_ROWS \
    TP_ROW_CHOICE("tank.kind", tank.kind, "none|stone|glass", TP_TANK_GLASS, \
        TP_TANK_NONE, "walls around the pool; front walls of glass are transparent"), \
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
