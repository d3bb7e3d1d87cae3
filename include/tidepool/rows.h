/* SPDX-License-Identifier: MIT */
/* Rows of the table of parameters, as a table writes them: a name, where its value lies in
 * tp_scene, a unit, the range, the default, one line of help.
 *
 *     static const tp_param rows[] = {
 *         TP_ROW_NUMBER("foam.cell", foam.cell, "m", 0.01, 50, 0.5, "side of such a cell"),
 *     };
 *
 * Numbers of the range are as a person writes them; a row has them in 16.16.
 *
 * A module that a program brings itself keeps its settings in tp_scene.own, and its rows
 * name their words there; scene files, snapshots, tapes and baked scenes know them then:
 *
 *     enum { BUOY_ON = BUOY_AT, BUOY_HEIGHT };
 *     TP_ROW_SWITCH("buoy.on", own[BUOY_ON], 0, "a buoy floats on the water"),
 *     TP_ROW_NUMBER("buoy.height", own[BUOY_HEIGHT], "m", 0.1, 20, 2, "of its mast"),
 *
 * The header that lists a program's own modules deals the words out (BUOY_AT), and tells
 * the library of them by TP_MORE; see ports/README.md. */
#ifndef TP_ROWS_H
#define TP_ROWS_H
#include <stddef.h>
#include "tidepool/scene.h"

#define TP_ROW_AT(member) (uint32_t)offsetof(tp_scene, member)

#define TP_ROW_NUMBER(name, member, unit, low, high, normal, help) \
    { name, unit, help, TP_PARAM_FX, TP_FX(low), TP_FX(high), TP_FX(normal), "", \
      TP_ROW_AT(member) }
#define TP_ROW_COUNT(name, member, unit, low, high, normal, help) \
    { name, unit, help, TP_PARAM_INT, low, high, normal, "", TP_ROW_AT(member) }
#define TP_ROW_SWITCH(name, member, normal, help) \
    { name, "", help, TP_PARAM_BOOL, 0, 1, normal, "", TP_ROW_AT(member) }
#define TP_ROW_COLOUR(name, member, normal, help) \
    { name, "", help, TP_PARAM_COLOUR, 0, 0xffffff, normal, "", TP_ROW_AT(member) }

/* `words`: "nearest|linear"; the value is a word's place, up to `last`. */
#define TP_ROW_CHOICE(name, member, words, last, normal, help) \
    { name, words, help, TP_PARAM_CHOICE, 0, last, normal, "", TP_ROW_AT(member) }

/* A file's name or a text; `kind`: MESH, TEXTURE, GREY, TEXT. */
#define TP_ROW_NAME(name, member, kind, help) \
    { name, "", help, TP_PARAM_##kind, 0, 0, 0, "", TP_ROW_AT(member) }

/* 90 whole turns: 16.16 ends before 91.02. */
#define TP_ROW_HEADING(name, member, normal, help) \
    TP_ROW_NUMBER(name, member, "degrees", -32400, 32400, normal, help)

/* Four rows of a picture that drifts over the water, a tp_scene_map. */
#define TP_ROW_MAP(name, part, normal, help) \
    TP_ROW_NAME(name ".texture", part.texture, TEXTURE, help), \
    TP_ROW_NUMBER(name ".size", part.size, "m", 0.1, 1000, normal, \
        "side of the square that one repeat covers"), \
    TP_ROW_NUMBER(name ".drift_x", part.drift_x, "m/s", -20, 20, 0, "along x"), \
    TP_ROW_NUMBER(name ".drift_z", part.drift_z, "m/s", -20, 20, 0, "along z")
#endif
