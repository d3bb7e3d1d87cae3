/* SPDX-License-Identifier: MIT */
/* The water's modules, and the data of their stages in tp_run.mine.
 *
 *     water.c            the modules: their conditions
 *     NAME_drawing.c     the data of a frame, and the choice of stages
 *     NAME_stage.c       the span stages */
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

#define TP_LAYERS_ADDED 2       /* layers added to the base layer */

typedef struct {
    tp_layer added[TP_LAYERS_ADDED];            /* texture NULL: no such layer */
    uint32_t colour[TP_LAYERS_ADDED];
    bool     graded[TP_LAYERS_ADDED];           /* false: only times the colour */
    tp_grade grade[TP_LAYERS_ADDED];
    tp_layer bend;                              /* the distortion */
    tp_fx    strength;                          /* largest displacement, m */
} tp_layers;

#define TP_RIPPLE_LOD 224       /* Q8: mean normals lose the glitter */

typedef struct {
    tp_layer layer;
    int32_t  gain;              /* of its slopes; 256: as drawn */
} tp_ripple;

/* name, linear filter, tinted by the water's colour */
#define TP_TEXTURE_STAGES(X) \
    X(texture,              0, 0) \
    X(texture_tinted,       0, 1) \
    X(texture_linear,       1, 0) \
    X(texture_linear_tinted, 1, 1)
#endif
