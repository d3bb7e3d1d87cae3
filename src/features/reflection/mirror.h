/* SPDX-License-Identifier: MIT */
/* The planar reflection of objects, and the data of its stage in tp_run.mine.
 *
 *     mirror_drawing.c   the module, and its planar map
 *     mirror_stage.c     its span stage */
#ifndef TP_MIRROR_MODULE_H
#define TP_MIRROR_MODULE_H
#include "scene/module.h"
#include "shade/shade.h"

#define TP_MIRROR_ID TP_MODULE_ID('m', 'i', 'r', 'r')

/* Inverse depths (zi) of the nearest and farthest object in a column, Q1.31. */
typedef struct {
    uint32_t near, far;
} tp_mirrored_zi;

typedef struct {
    tp_planar_map map;          /* planar map of objects above the level, upside down */
    int32_t  bend;              /* effect of slopes; 256 is physical */
    int64_t  height;            /* eye over the mirror's level, Q12 near planes */
    const tp_mirrored_zi *zi;   /* array, one for each column from x0 on */
} tp_mirror;
#endif
