/* SPDX-License-Identifier: MIT */
/* A buoy with a flag: a module that a program brings itself.  It shows the parts of a
 * module: a state that moves with the water, geometry, a span stage, and rows of
 * parameters.
 *
 *     buoy_rows.h      its settings
 *     buoy.c           how it moves
 *     buoy_drawing.c   how it is drawn */
#ifndef BUOY_H
#define BUOY_H
#include "tidepool/fixed.h"
#include "world/module.h"

#define BUOY_ID TP_MODULE_ID('b', 'u', 'o', 'y')

/* The buoy's state: its height above still water, m, and the lean of its mast along x and
 * z, m for each metre of mast. */
typedef struct {
    tp_fx height, lean_x, lean_z;
} buoy_pose;

typedef struct {
    buoy_pose now, last;        /* at this tick, at the tick before */
    tp_fx     rise;             /* vertical speed, m per tick */
    int32_t   afloat;           /* 1: it has been placed on the water */
} buoy_state;
#endif
