/* SPDX-License-Identifier: MIT */
/* Parameter rows of the water's colour, glitter and reflection. */
#ifndef TP_WATER_ROWS_H
#define TP_WATER_ROWS_H
#include "tidepool/modules.h"

#define TP_WATER_ROWS \
    TP_ROW_COLOUR("water.colour", water.colour, 0x2a5a6e, \
        "colour that multiplies the first layer"), \
    TP_ROW_CHOICE("water.filter", water.filter, "nearest|linear", TP_FILTER_LINEAR, \
        TP_FILTER_LINEAR, "filter of the layers' textures"), \
    TP_ROW_NUMBER("water.specular", water.specular, "", 0, 4, 1, \
        "brightness of the sun's glitter"), \
    TP_ROW_NUMBER("water.shininess", water.shininess, "", 1, 1000, 80, \
        "exponent of the glitter: higher is smaller and sharper"), \
    TP_ROW_NUMBER("water.reflection", water.reflection, "", 0, 1, 0.6, \
        "share of sky in the colour at grazing angles"), \
    TP_ROW_CHOICE("water.fresnel", water.fresnel, "table|schlick", TP_FRESNEL_SCHLICK, \
        TP_FRESNEL_TABLE, \
        "exact Fresnel reflection from a table, or Schlick's approximation")
#endif
