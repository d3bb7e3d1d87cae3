/* SPDX-License-Identifier: MIT */
/* Parameter rows of clear water. */
#ifndef TP_UNDERWATER_ROWS_H
#define TP_UNDERWATER_ROWS_H
#include "tidepool/modules.h"

#define TP_UNDERWATER_ROWS \
    TP_ROW_NUMBER("water.clear", water.clear, "m", 0, 200, 0, \
        "of water that turn white into the tint; 0: it is not seen through"), \
    TP_ROW_COLOUR("water.tint", water.tint, 0x2f8f9f, \
        "of white seen through so much water"), \
    TP_ROW_COLOUR("water.deep", water.deep, 0x0a3040, "of bottomless water"), \
    TP_ROW_NUMBER("water.dispersion", water.dispersion, "", 0, 1, 0, \
        "spread of the refractive index, red to violet; 0.02 is nature's")
#endif
