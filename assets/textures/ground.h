/* SPDX-License-Identifier: MIT */
/* What lies under water and around it, lit from the upper left: colours to multiply. */
#ifndef GROUND_H
#define GROUND_H
#include "canvas.h"

void paint_tiles(canvas *to); /* 4 x 4 glazed ones */
void paint_stone(canvas *to); /* a quay's wall in four courses */
void paint_sand(canvas *to);  /* combed by waves that run up and down the picture */
void paint_pebbles(canvas *to);
#endif
