/* SPDX-License-Identifier: MIT */
/* The inside of the water, by four modules:
 *
 *     underwater_drawing.c    its data (shade/inside.h), and the view from under water
 *     underwater_stage.c      span stages of the view from under water
 *     caustics_drawing.c      sunlight focused on the floor by waves
 *     refraction_drawing.c    a planar map of the objects under the level
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

/* Data of the clear water stages, in tp_run.mine. */
typedef struct {
    const tp_planar_map *refraction_map;      /* refraction map, or NULL */
} tp_clear_water;

/* name, slopes bent by a ripple, dispersed colours; in the order of the stage table */
#define TP_CLEAR_WATER_STAGES(X) \
    X(refract,                   0, 0) \
    X(refract_rippled,           1, 0) \
    X(refract_dispersed,         0, 1) \
    X(refract_rippled_dispersed, 1, 1)
#endif
