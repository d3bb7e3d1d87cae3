/* SPDX-License-Identifier: MIT */
/* Parameter rows of reflected objects. */
#ifndef TP_REFLECTION_ROWS_H
#define TP_REFLECTION_ROWS_H
#include "tidepool/modules.h"

#define TP_REFLECTION_ROWS \
    TP_ROW_CHOICE("mirror.objects", mirror.objects, "none|stencil|cube", \
        TP_MIRROR_CUBE, TP_MIRROR_NONE, \
        "boat and drops in the water: sharp, or by a small cube"), \
    TP_ROW_CHOICE("mirror.size", mirror.size, "half|quarter", TP_MIRROR_QUARTER, \
        TP_MIRROR_HALF, "a side of stencil's picture of them, of the whole one's"), \
    TP_ROW_NUMBER("mirror.bend", mirror.bend, "", 0, 4, 1, \
        "how far slopes push the mirrored picture")
#endif
