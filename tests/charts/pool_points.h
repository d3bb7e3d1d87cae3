/* SPDX-License-Identifier: MIT */
/* Pools of the chart `pool`: a grid of cell sizes, tank sizes, r and dampings, and the
 * pools of the shipped scenes. */
#ifndef TP_TESTS_CHARTS_POOL_POINTS_H
#define TP_TESTS_CHARTS_POOL_POINTS_H
#include "tidepool/scene.h"

typedef struct {
    tp_cells cells;
    uint32_t cols, rows, damping;
    tp_fx    courant;
    const char *keys;           /* "16;64;6;0.484": bits, side (or 80x64), m and r */
} pool_point;

/* List as C, written by pool_points.c, which can read scenes; a row of zeros ends the
 * list. */
extern const pool_point pool_points[];
#endif
