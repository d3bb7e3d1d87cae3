/* SPDX-License-Identifier: MIT */
/* Parameter rows of the water's layers and of their distortion. */
#ifndef TP_LAYERS_ROWS_H
#define TP_LAYERS_ROWS_H
#include "tidepool/modules.h"

#define TP_ROW_LAYER(n, help) \
    TP_ROW_MAP("layer" #n, layer[n].map, 8, help), \
    TP_ROW_NUMBER("layer" #n ".saturation", layer[n].saturation, "", 0, 4, 1, \
        "0: grey; 1: the PNG's own colours"), \
    TP_ROW_NUMBER("layer" #n ".clamp", layer[n].clamp, "", 0, 0.95, 0, \
        "darker texels turn black, brighter texels fill the whole range"), \
    TP_ROW_COLOUR("layer" #n ".colour", layer[n].colour, 0xffffff, \
        "colour that multiplies the layer")

#define TP_LAYERS_ROWS \
    TP_ROW_LAYER(0, "PNG over the water; empty: none"), \
    TP_ROW_LAYER(1, "PNG added to the first; empty: none"), \
    TP_ROW_LAYER(2, "PNG added to the first; empty: none"), \
    TP_ROW_MAP("distortion", distortion.map, 8, \
        "PNG whose red and green shift the layers; empty: none"), \
    TP_ROW_NUMBER("distortion.strength", distortion.strength, "m", 0, 20, 0.5, \
        "greatest shift of the layers")
#endif
