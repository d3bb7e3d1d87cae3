/* SPDX-License-Identifier: MIT */
/* The caustics map of a frame. */
#ifndef TP_CAUSTICS_H
#define TP_CAUSTICS_H
#include "scene/sides.h"
#include "shade/inside.h"

/* A surface vertex (x, z) and the place of its light on the floor; map cells, Q8. */
typedef struct {
    int32_t x, z, lit_x, lit_z;
} tp_caustic_vertex;

/* Horizontal metres travelled by sunlight per metre of depth, 16.16. */
typedef struct {
    int32_t x, z;
} tp_fall;

typedef struct {
    tp_caustic         look;    /* data for the shading */
    uint16_t          *light;   /* cells x cells */
    tp_caustic_vertex *row;     /* two rows of cells + 1 vertices */
    tp_rectangle       place;
    tp_fall            level_fall;   /* through still water */
} tp_caustics;
#endif
