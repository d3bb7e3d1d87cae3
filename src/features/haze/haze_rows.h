/* SPDX-License-Identifier: MIT */
/* Parameter rows of haze. */
#ifndef TP_HAZE_ROWS_H
#define TP_HAZE_ROWS_H
#include "tidepool/modules.h"

#define TP_HAZE_ROWS \
    TP_ROW_NUMBER("sky.haze", sky.haze, "m", 0, 32000, 2000, \
        "distance at which a colour is half the horizon's; 0: no haze")
#endif
