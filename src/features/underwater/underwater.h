/* SPDX-License-Identifier: MIT */
/*
 * The inside of the water, by four modules, and their parameters:
 *
 *     underwater_drawing.c   the module underwater: the data of the inside and the view
 *                            from under water
 *     refraction_drawing.c   the modules clear_water (the view through the surface from above)
 *                            and refraction (a planar map of the objects under the level)
 *     underwater_stage.c     the span stages of both views
 *     fast_refraction_stage.c  the fast span stages of the view from above;
 *     fast_refraction.c        their numbers of a frame,
 *     fast_floor_stage.c       its floor,
 *     fast_walls_stage.c       its caustics and walls
 *     caustics_drawing.c     the module caustics: sunlight focused on the floor by waves
 */
#ifndef TP_FEATURES_UNDERWATER_UNDERWATER_H
#define TP_FEATURES_UNDERWATER_UNDERWATER_H
#include "shade/optics.h"
#include "shade/shade.h"
#include "tidepool/modules.h"
#include "world/module.h"
#include "world/pools.h"

#define TP_UNDERWATER_ID  TP_MODULE_ID('u', 'n', 'd', 'r')
#define TP_CAUSTICS_ID    TP_MODULE_ID('c', 'a', 'u', 's')
#define TP_REFRACTION_ID  TP_MODULE_ID('r', 'f', 'r', 'a')
#define TP_CLEAR_WATER_ID TP_MODULE_ID('c', 'l', 'e', 'a')

/* Numbers of a frame for the fast view into the water, see fast_refraction_stage.c. */
typedef struct {
    bool     plane;             /* true: the floor is one plane */
    tp_floor_plane floor;       /* if it is; with N.L */
    tp_fx    opaque;            /* path in the water, m, after which nothing is seen */
    uint32_t lit;               /* light on level water, Q8 */
} tp_fast_refraction;

/* Data of the clear water stages, in tp_run.mine. */
typedef struct {
    const tp_planar_map *refraction_map;      /* refraction map, or NULL */
    uint32_t (*mix)(const tp_shade *shade, const tp_planar_map *map, const tp_run *run,
                    int32_t i, tp_fx depth, int32_t nx, int32_t nz, uint32_t colour);
    tp_fast_refraction fast;    /* mix: tp_refraction_map_mix, if there is a map */
} tp_clear_water;

/* fast_refraction.c.  Sets the numbers of the fast stage. */
void tp_fast_refraction_begin(const tp_shade *shade, tp_fast_refraction *fast);

/* underwater_stage.c.  Returns a colour with the refraction map mixed over it, at sample i
 * of a run: `depth` of the sample, m, and x and z of its normal, Q1.14. */
uint32_t tp_refraction_map_mix(const tp_shade *shade, const tp_planar_map *map,
                               const tp_run *run, int32_t i, tp_fx depth, int32_t nx,
                               int32_t nz, uint32_t colour);

/* name, slopes bent by a ripple, dispersion: 0 none, 1 a ray for each colour, 2 shifted
 * places */
#define TP_CLEAR_WATER_STAGES(X) \
    X(refract,                   0, 0) \
    X(refract_rippled,           1, 0) \
    X(refract_dispersed,         0, 1) \
    X(refract_rippled_dispersed, 1, 1) \
    X(refract_shifted,           0, 2) \
    X(refract_rippled_shifted,   1, 2)

/* -- the caustics map of a frame ----------------------------------------------------- */

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
    tp_fall            level_fall;   /* of the light through still water */
    tp_fall            sun_fall;     /* of the light above the water */
    uint32_t           cells, room;  /* of the exact rung; that the memory holds; a side */
} tp_caustics;

/* -- parameters ---------------------------------------------------------------------- */

#define TP_UNDERWATER_ROWS \
    TP_ROW_NUMBER("water.clarity", water.clarity, "m", 0, 200, 0, \
        "distance in water after which white is the tint; 0: opaque water"), \
    TP_ROW_COLOUR("water.tint", water.tint, 0x2f8f9f, \
        "colour of white seen through water.clarity metres of water"), \
    TP_ROW_COLOUR("water.deep_colour", water.deep_colour, 0x0a3040, \
        "colour of bottomless water"), \
    TP_ROW_NUMBER("water.dispersion", water.dispersion, "", 0, 1, 0, \
        "spread of the refractive index, red to violet; real water: 0.02")

#define TP_CAUSTICS_ROWS \
    TP_ROW_NUMBER("water.caustics", water.caustics, "", 0, 4, 0, \
        "strength of light that waves focus on the floor; 0: none"), \
    TP_ROW_COUNT("water.caustic_cells", water.caustic_cells, "cells", 16, 256, 64, \
        "cells along a side of the caustics map"), \
    TP_ROW_NUMBER("water.caustic_size", water.caustic_size, "m", 1, 1000, 20, \
        "side of the caustics map if there is no pool")

#endif
