/* SPDX-License-Identifier: MIT */
/* The pools of the chart `pool`: a grid of cells, sizes, r and dampings, and those of the
 * shipped scenes. */
#ifndef POOL_POINTS_H
#define POOL_POINTS_H
#include "tidepool/scene.h"

typedef struct {
    tp_cells cells;
    uint32_t cols, rows, damping;
    tp_fx    courant;
    const char *keys;           /* "16;64;6;0.484": bits, side (or 80x64), m and r */
} pool_point;

/* As C, by `pools points`, which can read scenes; a row of zeros ends it. */
extern const pool_point pool_points[];
#endif
