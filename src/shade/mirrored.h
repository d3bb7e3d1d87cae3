/* SPDX-License-Identifier: MIT */
/* What the mirrored picture's stage reads beside the picture itself. */
#ifndef TP_SHADE_MIRRORED_H
#define TP_SHADE_MIRRORED_H
#include <stdint.h>

/* Of a column's nearest and farthest object, Q1.31. */
typedef struct {
    uint32_t near, far;
} tp_mirrored_zi;

typedef struct {
    int32_t  bend;              /* share of the slopes, 256 is as nature has it */
    int64_t  height;            /* of the eye over the mirror's level, Q12 near planes */
    const tp_mirrored_zi *zi;   /* of each column, from x0 on */
} tp_mirrored;
#endif
