/* SPDX-License-Identifier: MIT */
/* Pictures that scenes read as numbers: heights of a sea floor, walls of a harbour. */
#ifndef MAPS_H
#define MAPS_H
#include "canvas.h"

void paint_shoal(canvas *to);       /* 0 deepest .. 255 highest; a bank before a beach */
void paint_harbour(canvas *to);     /* black wall, white water: a breakwater with one gap */
#endif
