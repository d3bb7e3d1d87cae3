/* SPDX-License-Identifier: MIT */
/* Parameter rows of the sky: its kind, colours, lights and textures. */
#ifndef TP_SKY_ROWS_H
#define TP_SKY_ROWS_H
#include "tidepool/modules.h"

#define TP_ROW_FACE(name, part, help) TP_ROW_NAME("sky." name, sky.part, TEXTURE, help)

#define TP_SKY_COLOUR_ROWS \
    TP_ROW_CHOICE("sky.kind", sky.kind, "gradient|day|dusk|night|cube", TP_SKY_CUBE, \
        TP_SKY_GRADIENT, "two colours, a generated sky, or six pictures"), \
    TP_ROW_COLOUR("sky.horizon", sky.horizon, 0xc8d8e4, \
        "of a gradient's or day's sky at the horizon"), \
    TP_ROW_COLOUR("sky.zenith", sky.zenith, 0x3a6ea5, \
        "of a gradient's or day's sky overhead")

#define TP_SKY_LIGHT_ROWS \
    TP_ROW_NUMBER("sky.sun", sky.sun, "", 0, 16, 1, \
        "of a generated sky's disc; what is above 1 shows by hdr.share"), \
    TP_ROW_NUMBER("sky.stars", sky.stars, "", 0, 1, 0.5, \
        "how many stars a night has"), \
    TP_ROW_FACE("east", east, \
        "PNG of a cube's side towards +x; alpha is light beyond white"), \
    TP_ROW_FACE("west", west, "towards -x"), \
    TP_ROW_FACE("up", up, "overhead; its lower edge joins the south"), \
    TP_ROW_FACE("down", down, "underfoot; its upper edge joins the south"), \
    TP_ROW_FACE("south", south, "towards +z"), \
    TP_ROW_FACE("north", north, "towards -z")
#endif
