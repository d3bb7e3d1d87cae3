/* SPDX-License-Identifier: MIT */
/* The object cube map: five small pictures of the objects around a point on the water; the
 * data of its stage in tp_run.mine.
 *
 *     object_cube_drawing.c   the module, and its pictures
 *     object_cube_stage.c     its span stage */
#ifndef TP_OBJECT_CUBE_H
#define TP_OBJECT_CUBE_H
#include "scene/module.h"
#include "tidepool/fixed.h"

#define TP_OBJECT_CUBE_ID TP_MODULE_ID('c', 'u', 'b', 'e')

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
