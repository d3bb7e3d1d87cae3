/* SPDX-License-Identifier: MIT */
/* Parameter rows of spray. */
#ifndef TP_SPRAY_ROWS_H
#define TP_SPRAY_ROWS_H
#include "tidepool/modules.h"

#define TP_SPRAY_ROWS \
    TP_ROW_COUNT("spray.count", spray.count, "", 0, 1024, 0, \
        "most specks of spray and bubbles at once; 0: none"), \
    TP_ROW_NUMBER("spray.crest", spray.crest, "", 0, 4, 1, \
        "amount of spray from breaking crests"), \
    TP_ROW_NUMBER("spray.impact", spray.impact, "", 0, 4, 1, \
        "amount of spray from drops"), \
    TP_ROW_NUMBER("spray.size", spray.size, "m", 0.001, 1, 0.03, "size of a speck")
#endif
