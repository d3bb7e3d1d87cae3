/* SPDX-License-Identifier: MIT */
/* The object cube map: five small pictures of the objects around a point on the water;
 * the data of its stage in tp_run.mine.
 *
 *     object_cube_drawing.c   the module, and its pictures
 *     object_cube_stage.c     its span stage */
#ifndef TP_OBJECT_CUBE_H
#define TP_OBJECT_CUBE_H
#include "scene/module.h"
#include "tidepool/fixed.h"

#define TP_OBJECT_CUBE_ID TP_MODULE_ID('c', 'u', 'b', 'e')

#define TP_OBJECT_CUBE_SIDE  32
#define TP_OBJECT_CUBE_FACES 5         /* +x -x +z -z +y; -y is below the water's level */

typedef struct {
    const uint32_t *colour;     /* texels 0xAARRGGBB, face by face; NULL: empty */
    tp_vec3  from;              /* eye - the point, m */
    tp_vec3  to;                /* middle of the objects - the point, m */
    int32_t  nx, nz;            /* horizontal direction of `to`, Q1.14 */
    tp_fx    zi_near;
} tp_object_cube;
#endif
