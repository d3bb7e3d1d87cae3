/* SPDX-License-Identifier: MIT */
/* Land: a sea floor near the water's level or above it.
 *
 *     land_drawing.c   the module, and its triangles
 *     land_stage.c     its shading, plain or with the floor's texture */
#ifndef TP_LAND_MODULE_H
#define TP_LAND_MODULE_H
#include "scene/module.h"

#define TP_LAND_ID TP_MODULE_ID('l', 'a', 'n', 'd')
#endif
