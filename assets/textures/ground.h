/* SPDX-License-Identifier: MIT */
/* Ground under water and walls around water, lit from the upper left: colours for
 * multiplication. */
#ifndef GROUND_H
#define GROUND_H
#include "canvas.h"

void paint_tiles(canvas *to); /* 4 x 4 glazed tiles */
void paint_stone(canvas *to); /* a quay's wall in four courses */
void paint_sand(canvas *to);  /* ripples from waves that run up and down the picture */
void paint_pebbles(canvas *to);
#endif
