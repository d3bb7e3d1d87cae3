/* SPDX-License-Identifier: MIT */
/* Data of the water volume: the surfaces that a ray meets on its way through the water.
 *
 * The water is a box.  Its floor is level, or the floor of coastal water, or absent.  Its
 * four walls are a tank's walls or absent.  Its surface, seen from below, is taken as
 * level at each point.  Floor and walls have a texture, are lit by the sun as still water
 * refracts its rays, and their light is absorbed on the way to the eye [Beer].
 *
 * Under level water sunlight is steeper and its beam narrower.  The share cos i / cos t of
 * the refracted N.L counts: a level floor is as bright as it would be when dry, and shores
 * show no seam.
 *
 * shade/refracted_ray.h declares the functions on this data. */
#ifndef TP_SHADE_WATER_VOLUME_H
#define TP_SHADE_WATER_VOLUME_H
#include <stdbool.h>
#include "shade/optics.h"
#include "waves/coastal_water.h"

/* Material of static geometry: a texture laid out in world metres, or a plain colour. */
typedef struct {
    const tp_texture *texture;  /* NULL: plain colour */
    uint32_t colour;            /* multiplies the texture */
    uint32_t per_metre;         /* texture repeats per metre, Q0.32 per Q16.16 metre */
    int32_t  lod;               /* mipmap level at 1 m, Q8 */
} tp_wall_material;

/* Caustics map: the light that falls through the surface on to the floor. */
typedef struct {
    const uint16_t *light;      /* cells x cells entries, 256 is even light */
    tp_fx    x, z;              /* north-west corner, m */
    uint32_t cells;
    uint32_t per_metre_x, per_metre_z;  /* cells per metre, 16.16 */
    uint32_t per_depth;         /* 256 / (the depth that the map was made for, m), 16.16 */
    int32_t  lean_x, lean_z;    /* slope of rays back to the sun, m per m, Q1.14 */
    int32_t  strength;          /* contrast, 256 is full */
    bool     fades;             /* true: fades to even light at the map's edges */
} tp_caustic;

/* The floor around a point as a plane: a point (x, z) on it, and the depth there in m. */
typedef struct {
    tp_fx   x, z, depth;
    tp_fx   rise_x, rise_z;     /* slope, m per m */
    int32_t nl;                 /* N.L of the sun, Q1.14 */
} tp_floor_plane;

typedef struct {
    bool    walled, floored;
    tp_fx   x0, x1, z0, z1;     /* walls, m */
    const tp_coastal_water
        *coastal; /* coastal water whose floor counts; NULL: `floor_plane` counts */
    tp_floor_plane floor_plane;
    tp_wall_material wall, floor;
    uint32_t deep;              /* colour of bottomless water */
    tp_absorb absorb;           /* attenuation of other light on its path */
    int32_t sun_x, sun_y, sun_z;/* direction to the sun in water, scaled by cos i / cos t;
                                 * Q1.14 */
    int32_t eta[3], eta2[3];    /* 1 / index of red, green, blue; squared; Q1.14 */
    tp_fx   zi_near;            /* of the projection, m: depth = zi_near / zi */
    int64_t right[3], up[3];    /* view axes, steps of 1/16 px at 1 m depth, Q42 */
} tp_underwater;
#endif
