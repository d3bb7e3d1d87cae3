/* SPDX-License-Identifier: MIT */
/* A buoy with a flag: a module that a program brings itself.  It shows what a module is
 * made of: a state that moves with the water, things to draw, a span stage of its own, and
 * rows of parameters.
 *
 *     buoy_rows.h      its settings
 *     buoy.c           how it moves
 *     buoy_drawing.c   how it is drawn */
#ifndef BUOY_H
#define BUOY_H
#include "scene/module.h"
#include "tidepool/fixed.h"

#define BUOY_ID TP_MODULE_ID('b', 'u', 'o', 'y')

/* The buoy's state: its height above still water, m, and the lean of its mast along x and
 * z, m for each metre of mast. */
typedef struct {
    tp_fx height, lean_x, lean_z;
} buoy_pose;

typedef struct {
    buoy_pose now, last;        /* of this tick and the one before */
    tp_fx     rise;             /* m a tick */
    int32_t   afloat;           /* it has been put on the water */
} buoy_state;
#endif
