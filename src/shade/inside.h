/* SPDX-License-Identifier: MIT */
/* The water's inside: what a ray meets that goes through the water from a point in it.
 *
 * The water is a box: its floor is level, or an ocean's, or there is none; its four walls
 * are those of a tank, or there are none; its surface, seen from below, is taken as level
 * there.  What is met is laid with a picture, lit by the sun as still water bends it, and
 * loses light on the way [Beer].
 *
 * Under level water the sun is steeper and its beam narrower: of N.L in the water a share
 * of cos i / cos t counts, so that a level floor is as bright as it would be dry, and
 * shores show no seam.
 *
 * These are its numbers; shade/beam.h has what is done with them. */
#ifndef TP_SHADE_INSIDE_H
#define TP_SHADE_INSIDE_H
#include <stdbool.h>
#include "shade/absorb.h"
#include "wave/ocean.h"

/* A picture laid over still things in world metres, or a plain colour. */
typedef struct {
    const tp_texture *texture;  /* NULL: plain */
    uint32_t colour;            /* times the texture */
    uint32_t per_metre;         /* repeats a metre, Q0.32 over Q16.16 */
    int32_t  lod;               /* level at 1 m, Q8 */
} tp_coat;

/* A map of the light that falls through the surface on to the floor. */
typedef struct {
    const uint16_t *light;      /* cells x cells, 256 is even light */
    tp_fx    x, z;              /* of its north-west corner */
    uint32_t cells;
    uint32_t per_metre_x, per_metre_z;  /* cells, 16.16 */
    uint32_t per_depth;         /* 256 over the depth that it was made for, 16.16 */
    int32_t  lean_x, lean_z;    /* of the sun's way back up, metres a metre, Q1.14 */
    int32_t  strength;          /* 256 is as much as there is */
    bool     fades;             /* to even light at its edges */
} tp_caustic;

/* The floor around a place, as a plane. */
typedef struct {
    tp_fx   x, z, depth;
    tp_fx   rise_x, rise_z;     /* metres a metre */
    int32_t nl;                 /* the sun on it, Q1.14 */
} tp_bed;

typedef struct {
    bool    walled, floored;
    tp_fx   x0, x1, z0, z1;     /* the walls */
    const tp_ocean *ocean;      /* whose floor it is; NULL: `bed` */
    tp_bed  bed;
    tp_coat wall, floor;
    uint32_t deep;              /* what comes from bottomless water, */
    tp_absorb absorb;           /* and what becomes of other light on its way */
    int32_t sun_x, sun_y, sun_z;/* towards the sun in the water, by its share; Q1.14 */
    int32_t eta[3], eta2[3];    /* of red, green, blue from air, and squared; Q1.14 */
    tp_fx   zi_near;            /* as of the lens */
    int64_t right[3], up[3];    /* of the view, a 16th of a pixel at 1 m, Q42 */
} tp_inside;
#endif
