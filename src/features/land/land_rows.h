/* SPDX-License-Identifier: MIT */
/* Parameter rows of the land's look. */
#ifndef TP_LAND_ROWS_H
#define TP_LAND_ROWS_H
#include "tidepool/modules.h"

#define TP_LAND_ROWS \
    TP_ROW_COLOUR("floor.colour", floor.colour, 0xc8b48c, \
        "colour of the land; multiplies the texture"), \
    TP_ROW_NAME("floor.texture", floor.texture, TEXTURE, \
        "PNG over the land; empty: none"), \
    TP_ROW_NUMBER("floor.texture_size", floor.texture_size, "m", 0.1, 1000, 8, \
        "side of the square that one repeat covers")
#endif
