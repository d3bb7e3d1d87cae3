/* SPDX-License-Identifier: MIT */
/* The mirror of objects, and the data of its stage in tp_run.mine.
 *
 *     mirror_drawing.c   the module, and its planar map
 *     mirror_stage.c     its span stage */
#ifndef TP_MIRROR_MODULE_H
#define TP_MIRROR_MODULE_H
#include "scene/module.h"
#include "shade/shade.h"

#define TP_MIRROR_ID TP_MODULE_ID('m', 'i', 'r', 'r')

/* Depths of a column's nearest and farthest object, Q1.31. */
typedef struct {
    uint32_t near, far;
} tp_mirrored_zi;

typedef struct {
    tp_half  half;              /* objects above the level, upside down */
    int32_t  bend;              /* share of the slopes, 256 is as nature has it */
    int64_t  height;            /* of the eye over the mirror's level, Q12 near planes */
    const tp_mirrored_zi *zi;   /* of each column, from x0 on */
} tp_mirror;
#endif
