/* SPDX-License-Identifier: MIT */
/* Parameter rows of light above white and of the camera's exposure. */
#ifndef TP_EXPOSURE_ROWS_H
#define TP_EXPOSURE_ROWS_H
#include "tidepool/modules.h"

#define TP_EXPOSURE_ROWS \
    TP_ROW_NUMBER("hdr.share", hdr.share, "", 0, 1, 0, \
        "share of sun and sky light above white; 0: no HDR"), \
    TP_ROW_CHOICE("hdr.exposure", hdr.exposure, "fixed|auto", TP_EXPOSURE_AUTO, \
        TP_EXPOSURE_FIXED, "fixed or automatic exposure of the camera"), \
    TP_ROW_NUMBER("hdr.value", hdr.value, "", 0.125, 8, 1, \
        "exposure; start value of automatic exposure"), \
    TP_ROW_NUMBER("hdr.rate", hdr.rate, "", 0, 1, 0.03, \
        "automatic exposure: share of the difference made up each tick")
#endif
