/* SPDX-License-Identifier: MIT */
/* Parameter rows of foam. */
#ifndef TP_FOAM_ROWS_H
#define TP_FOAM_ROWS_H
#include "tidepool/modules.h"

#define TP_FOAM_ROWS \
    TP_ROW_COUNT("foam.cells", foam.cells, "cells", 0, 256, 0, \
        "of the side of its field; 0: no foam"), \
    TP_ROW_NUMBER("foam.cell", foam.cell, "m", 0.01, 50, 0.5, "side of such a cell"), \
    TP_ROW_NUMBER("foam.crest", foam.crest, "", 0, 2, 0.6, \
        "crests squeezed to so much foam; 0: never"), \
    TP_ROW_NUMBER("foam.breaking", foam.breaking, "", 0, 2, 1, "of breaking crests"), \
    TP_ROW_NUMBER("foam.shore", foam.shore, "m", 0, 20, 0.3, "shallower water foams"), \
    TP_ROW_NUMBER("foam.wall", foam.wall, "", 0, 2, 0.5, \
        "of water that moves along walls"), \
    TP_ROW_NUMBER("foam.hull", foam.hull, "", 0, 2, 0.5, \
        "around the boat and behind it"), \
    TP_ROW_NUMBER("foam.fade", foam.fade, "s", 0.1, 600, 4, \
        "in which it is down to a third"), \
    TP_ROW_MAP("foam", foam.map, 4, "PNG of its bubbles; empty: plain"), \
    TP_ROW_COLOUR("foam.colour", foam.colour, 0xf4f8fa, "in full light")
#endif
