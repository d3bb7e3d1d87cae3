/* SPDX-License-Identifier: MIT */
/* Parameter rows of ripples. */
#ifndef TP_RIPPLE_ROWS_H
#define TP_RIPPLE_ROWS_H
#include "tidepool/modules.h"

#define TP_RIPPLE_ROWS \
    TP_ROW_MAP("ripple", ripple.map, 4, \
        "PNG normal map of capillary waves; empty: none"), \
    TP_ROW_NUMBER("ripple.bump", ripple.bump, "", 0, 4, 1, \
        "strength of ripples; 1: as steep as the PNG says")
#endif
