/* SPDX-License-Identifier: MIT */
/* A small cube of pictures: what a point on the water sees of the objects around it. */
#ifndef TP_SHADE_AROUND_H
#define TP_SHADE_AROUND_H
#include "tidepool/fx.h"

#define TP_AROUND_SIDE  32
#define TP_AROUND_FACES 5         /* +x -x +z -z +y: nothing lies under the water's level */

typedef struct {
    const uint32_t *colour;     /* 0xAARRGGBB, face after face; NULL: nothing is there */
    tp_vec3  from;              /* eye - the point, m */
    tp_vec3  to;                /* the objects' middle - the point */
    int32_t  nx, nz;            /* the level way from one to the other, Q1.14 */
    tp_fx    zi_near;
} tp_around;
#endif
