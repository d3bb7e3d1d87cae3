/* SPDX-License-Identifier: MIT */
/* Parameter rows of caustics. */
#ifndef TP_CAUSTICS_ROWS_H
#define TP_CAUSTICS_ROWS_H
#include "tidepool/modules.h"

#define TP_CAUSTICS_ROWS \
    TP_ROW_NUMBER("water.caustics", water.caustics, "", 0, 4, 0, \
        "strength of light that waves focus on the floor; 0: none"), \
    TP_ROW_COUNT("water.caustic_cells", water.caustic_cells, "cells", 16, 256, 64, \
        "cells along a side of the caustics map"), \
    TP_ROW_NUMBER("water.caustic_size", water.caustic_size, "m", 1, 1000, 20, \
        "side of the caustics map if there is no pool")
#endif
