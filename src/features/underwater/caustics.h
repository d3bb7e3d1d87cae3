/* SPDX-License-Identifier: MIT */
/* A frame's map of caustics. */
#ifndef TP_CAUSTICS_H
#define TP_CAUSTICS_H
#include "scene/sides.h"
#include "shade/inside.h"

/* A corner of the surface and where its light falls: map cells, Q8. */
typedef struct {
    int32_t x, z, lit_x, lit_z;
} tp_caustic_corner;

/* Level metres that sunlight goes for each metre down, 16.16. */
typedef struct {
    int32_t x, z;
} tp_fall;

typedef struct {
    tp_caustic         look;    /* what shading reads */
    uint16_t          *light;   /* cells^2 */
    tp_caustic_corner *row;     /* two rows of cells + 1 */
    tp_rectangle       place;
    tp_fall            still;   /* through still water */
} tp_caustics;
#endif
