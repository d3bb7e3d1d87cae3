/* SPDX-License-Identifier: MIT */
/* The water's modules, and the data of their stages in tp_run.mine.
 *
 *     water.c            the modules: when each is on
 *     NAME_drawing.c     their numbers, and which of their stages a list gets
 *     NAME_stage.c       their span stages */
#ifndef TP_WATER_MODULES_H
#define TP_WATER_MODULES_H
#include "features/water/bumps.h"
#include "features/water/grade.h"
#include "scene/module.h"
#include "shade/shade.h"

#define TP_RIPPLE_ID TP_MODULE_ID('r', 'i', 'p', 'l')

typedef struct {
    tp_layer layer;
    tp_grade grade;
} tp_base_layer;

#define TP_LAYERS_ADDED 2       /* to the first */

typedef struct {
    tp_layer added[TP_LAYERS_ADDED];            /* texture NULL: it is not there */
    uint32_t colour[TP_LAYERS_ADDED];
    bool     graded[TP_LAYERS_ADDED];           /* else times the colour */
    tp_grade grade[TP_LAYERS_ADDED];
    tp_layer bend;                              /* the distortion */
    tp_fx    strength;                          /* m that it moves places at the most */
} tp_layers;

#define TP_RIPPLE_LOD 224       /* Q8: a mean of normals loses what glitters */

typedef struct {
    tp_layer layer;
    int32_t  gain;              /* of its slopes: 256 is as drawn */
} tp_ripple;

/* name, linear filter, tinted by the water's colour */
#define TP_TEXTURE_STAGES(X) \
    X(texture,              0, 0) \
    X(texture_tinted,       0, 1) \
    X(texture_linear,       1, 0) \
    X(texture_linear_tinted, 1, 1)
#endif
