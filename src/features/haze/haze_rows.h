/* SPDX-License-Identifier: MIT */
/* Parameter rows of haze. */
#ifndef TP_HAZE_ROWS_H
#define TP_HAZE_ROWS_H
#include "tidepool/modules.h"

#define TP_HAZE_ROWS \
    TP_ROW_NUMBER("sky.haze", sky.haze, "m", 0, 32000, 2000, \
        "distance at which half of a colour has gone into the horizon")
#endif
