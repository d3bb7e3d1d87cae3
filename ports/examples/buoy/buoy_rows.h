/* SPDX-License-Identifier: MIT */
/* The buoy's settings and their rows of parameters, see tidepool/modules.h. */
#ifndef BUOY_ROWS_H
#define BUOY_ROWS_H
#include "tidepool/modules.h"

/* Indices of the settings in tp_scene.own; list.h defines BUOY_AT, the first. */
#define BUOY_ON     (BUOY_AT + 0)
#define BUOY_X      (BUOY_AT + 1)       /* position, m, 16.16 */
#define BUOY_Z      (BUOY_AT + 2)
#define BUOY_SIZE   (BUOY_AT + 3)
#define BUOY_COLOUR (BUOY_AT + 4)
#define BUOY_FLAG   (BUOY_AT + 5)

#define BUOY_ROWS \
    TP_ROW_SWITCH("buoy.on", own[BUOY_ON], 0, "a buoy floats on the water"), \
    TP_ROW_NUMBER("buoy.x", own[BUOY_X], "m", -8000, 8000, 0, \
        "position, to the right of the origin"), \
    TP_ROW_NUMBER("buoy.z", own[BUOY_Z], "m", -8000, 8000, -8, \
        "position, from the origin towards the viewer"), \
    TP_ROW_NUMBER("buoy.size", own[BUOY_SIZE], "m", 0.05, 10, 0.5, "radius of its body"), \
    TP_ROW_COLOUR("buoy.colour", own[BUOY_COLOUR], 0xe8a010, "colour of its body"), \
    TP_ROW_COLOUR("buoy.flag", own[BUOY_FLAG], 0xd02020, "colour of its flag")
#endif
