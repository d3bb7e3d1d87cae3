/* SPDX-License-Identifier: MIT */
/* Parameter rows of the sky: its kind, colours, lights and textures. */
#ifndef TP_SKY_ROWS_H
#define TP_SKY_ROWS_H
#include "tidepool/modules.h"

#define TP_ROW_FACE(name, part, help) TP_ROW_NAME("sky." name, sky.part, TEXTURE, help)

#define TP_SKY_COLOUR_ROWS \
    TP_ROW_CHOICE("sky.kind", sky.kind, "gradient|day|dusk|night|cube", TP_SKY_CUBE, \
        TP_SKY_GRADIENT, "two colours, a generated sky, or a cube map of six PNGs"), \
    TP_ROW_COLOUR("sky.horizon", sky.horizon, 0xc8d8e4, \
        "colour at the horizon, for gradient and day"), \
    TP_ROW_COLOUR("sky.zenith", sky.zenith, 0x3a6ea5, \
        "colour overhead, for gradient and day")

#define TP_SKY_LIGHT_ROWS \
    TP_ROW_NUMBER("sky.sun", sky.sun, "", 0, 16, 1, \
        "brightness of a generated sun; above 1 needs hdr.share"), \
    TP_ROW_NUMBER("sky.stars", sky.stars, "", 0, 1, 0.5, \
        "density of stars in a night sky"), \
    TP_ROW_FACE("east", east, \
        "PNG of the cube's face towards +x; alpha: light above white"), \
    TP_ROW_FACE("west", west, "PNG of the face towards -x"), \
    TP_ROW_FACE("up", up, "PNG overhead; its lower edge joins the south face"), \
    TP_ROW_FACE("down", down, "PNG underfoot; its upper edge joins the south face"), \
    TP_ROW_FACE("south", south, "PNG of the face towards +z"), \
    TP_ROW_FACE("north", north, "PNG of the face towards -z")
#endif
