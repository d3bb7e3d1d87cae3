/* SPDX-License-Identifier: MIT */
/* Parameter rows of clear water. */
#ifndef TP_UNDERWATER_ROWS_H
#define TP_UNDERWATER_ROWS_H
#include "tidepool/modules.h"

#define TP_UNDERWATER_ROWS \
    TP_ROW_NUMBER("water.clear", water.clear, "m", 0, 200, 0, \
        "distance in water after which white is the tint; 0: opaque water"), \
    TP_ROW_COLOUR("water.tint", water.tint, 0x2f8f9f, \
        "colour of white seen through water.clear metres of water"), \
    TP_ROW_COLOUR("water.deep", water.deep, 0x0a3040, "colour of bottomless water"), \
    TP_ROW_NUMBER("water.dispersion", water.dispersion, "", 0, 1, 0, \
        "spread of the refractive index, red to violet; real water: 0.02")
#endif
