/* SPDX-License-Identifier: MIT */
/* Parameter rows of foam. */
#ifndef TP_FOAM_ROWS_H
#define TP_FOAM_ROWS_H
#include "tidepool/modules.h"

#define TP_FOAM_ROWS \
    TP_ROW_COUNT("foam.cells", foam.cells, "cells", 0, 256, 0, \
        "cells along a side of the foam field; 0: no foam"), \
    TP_ROW_NUMBER("foam.cell", foam.cell, "m", 0.01, 50, 0.5, "side of a cell"), \
    TP_ROW_NUMBER("foam.crest", foam.crest, "", 0, 2, 0.6, \
        "crests whose Jacobian is below this value foam; 0: none"), \
    TP_ROW_NUMBER("foam.breaking", foam.breaking, "", 0, 2, 1, \
        "strength of foam on breaking crests"), \
    TP_ROW_NUMBER("foam.shore", foam.shore, "m", 0, 20, 0.3, \
        "moving water shallower than this foams"), \
    TP_ROW_NUMBER("foam.wall", foam.wall, "", 0, 2, 0.5, \
        "strength of foam from water that moves along walls"), \
    TP_ROW_NUMBER("foam.hull", foam.hull, "", 0, 2, 0.5, \
        "strength of foam around and behind the boat"), \
    TP_ROW_NUMBER("foam.fade", foam.fade, "s", 0.1, 600, 4, \
        "time in which foam fades to about a third"), \
    TP_ROW_MAP("foam", foam.map, 4, "PNG of the bubbles; empty: plain foam"), \
    TP_ROW_COLOUR("foam.colour", foam.colour, 0xf4f8fa, "colour of foam in full light")
#endif
