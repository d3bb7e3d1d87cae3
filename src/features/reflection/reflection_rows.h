/* SPDX-License-Identifier: MIT */
/* Parameter rows of reflected objects. */
#ifndef TP_REFLECTION_ROWS_H
#define TP_REFLECTION_ROWS_H
#include "tidepool/modules.h"

#define TP_REFLECTION_ROWS \
    TP_ROW_CHOICE("mirror.objects", mirror.objects, "none|stencil|cube", \
        TP_MIRROR_CUBE, TP_MIRROR_NONE, \
        "boat and drops in the water: sharp (stencil), or from a small cube"), \
    TP_ROW_CHOICE("mirror.size", mirror.size, "half|quarter", TP_MIRROR_QUARTER, \
        TP_MIRROR_HALF, \
        "side of the stencil's mirrored image, relative to the picture"), \
    TP_ROW_NUMBER("mirror.bend", mirror.bend, "", 0, 4, 1, \
        "strength with which waves distort the mirrored image")
#endif
