/* SPDX-License-Identifier: MIT */
/* A buoy with a flag: a module that a program brings itself.  It shows what a module is
 * made of: a state that moves with the water, things to draw, a span stage of its own, and
 * rows of parameters.
 *
 *     buoy.c           how it moves
 *     buoy_drawing.c   how it is drawn */
#ifndef BUOY_H
#define BUOY_H
#include "scene/module.h"
#include "tidepool/rows.h"
#include TP_MORE                /* the program's list, which deals out BUOY_AT */

/* Its settings, words of tp_scene.own. */
enum { BUOY_ON = BUOY_AT, BUOY_X, BUOY_Z, BUOY_SIZE, BUOY_COLOUR, BUOY_FLAG };

#define BUOY_ROWS \
    TP_ROW_SWITCH("buoy.on", own[BUOY_ON], 0, "a buoy floats on the water"), \
    TP_ROW_NUMBER("buoy.x", own[BUOY_X], "m", -8000, 8000, 0, \
        "to the right of the origin"), \
    TP_ROW_NUMBER("buoy.z", own[BUOY_Z], "m", -8000, 8000, -8, "towards the viewer"), \
    TP_ROW_NUMBER("buoy.size", own[BUOY_SIZE], "m", 0.05, 10, 0.5, "radius of its body"), \
    TP_ROW_COLOUR("buoy.colour", own[BUOY_COLOUR], 0xe8a010, "of its body"), \
    TP_ROW_COLOUR("buoy.flag", own[BUOY_FLAG], 0xd02020, "of its flag")

#define BUOY_ID TP_MODULE_ID('b', 'u', 'o', 'y')

/* How it floats: m above the level of still water, and how far its mast leans for each
 * metre of height, along x and z. */
typedef struct {
    tp_fx height, lean_x, lean_z;
} buoy_pose;

typedef struct {
    buoy_pose now, last;        /* of this tick and the one before */
    tp_fx     rise;             /* m a tick */
    int32_t   afloat;           /* it has been put on the water */
} buoy_state;

/* What TP_USE(buoy) names. */
extern const tp_module tp_buoy_module;
extern const struct tp_drawing tp_buoy_drawing;
extern const tp_stage tp_buoy_stages[];
#endif
