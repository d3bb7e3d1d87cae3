/* SPDX-License-Identifier: MIT */
/* The inside of the water, by four modules:
 *
 *     underwater_drawing.c    its numbers (shade/inside.h), and the view of an eye in it
 *     underwater_stage.c      span stages of that view
 *     caustics_drawing.c      the light that waves gather on the floor
 *     refraction_drawing.c    a picture of the objects under the level
 *     clear_water_drawing.c   the view through clear water from above
 *     clear_water_stage.c     its span stages */
#ifndef TP_UNDERWATER_H
#define TP_UNDERWATER_H
#include "scene/module.h"
#include "shade/shade.h"

#define TP_UNDERWATER_ID  TP_MODULE_ID('u', 'n', 'd', 'r')
#define TP_CAUSTICS_ID    TP_MODULE_ID('c', 'a', 'u', 's')
#define TP_REFRACTION_ID  TP_MODULE_ID('r', 'f', 'r', 'a')
#define TP_CLEAR_WATER_ID TP_MODULE_ID('c', 'l', 'e', 'a')

/* The stages of clear water read it in tp_run.mine. */
typedef struct {
    const tp_half *sunken;      /* objects under the level, as flat water shows them, or
                                 * NULL */
} tp_clear_water;

/* name, slopes that a ripple has bent, dispersed colours; in the order of the table */
#define TP_CLEAR_WATER_STAGES(X) \
    X(behind,                   0, 0) \
    X(behind_rippled,           1, 0) \
    X(behind_dispersed,         0, 1) \
    X(behind_rippled_dispersed, 1, 1)
#endif
