/* SPDX-License-Identifier: MIT */
/*
 * A block of columns of the fast view into the water: set up in fast_refraction_stage.c,
 * shaded in fast_floor_stage.c, with caustics and walls from fast_walls_stage.c.
 */
#ifndef TP_FEATURES_UNDERWATER_FAST_REFRACTION_H
#define TP_FEATURES_UNDERWATER_FAST_REFRACTION_H
#include "base/base.h"
#include "shade/refracted_ray.h"
#include "shade/shade.h"

/* Entry n is 65536 / n; entry 0 serves blocks of one column. */
extern const uint32_t tp_fast_over[TP_UNDERWATER_ROW];

/* Samples of a block: every second column, and the last one. */
#define TP_FAST_SAMPLES (TP_UNDERWATER_ROW / 2 + 1)

/* Up to 16 columns.  The place of a column on the floor is its rest position plus (x, z)
 * plus the derivatives by its slopes.  A channel is the floor's texel and the water's own
 * colour times the weights, Q14 in the upper and the lower half. */
typedef struct {
    int32_t  first, count;      /* of the run's columns */
    int32_t  samples;           /* columns that are computed, see TP_FAST_SAMPLES */
    tp_fx    x, z, step_x, step_z;      /* in the first column; per column */
    uint32_t by_slope_x, by_slope_z;    /* derivatives of x and z by slopes x:z, Q10 */
    tp_fx    path, far;         /* to the floor: in the water; from the eye; m */
    tp_fx    at_y, floor_y;     /* heights of the surface and of the floor, m */
    int32_t  light, sun;        /* of the floor without caustics, its direct part; Q8 */
    uint32_t weights[3], weights_step[3];
    uint32_t lit;               /* light on level water, Q8 */
    tp_fx    shift_x, shift_z;  /* of red's place on the floor in the first column; blue's */
    tp_fx    shift_step_x, shift_step_z;        /* is the opposite; per column; m */
} tp_floor_block;

/* Place of a sample on the floor, and its rest position on the surface, m, 16.16. */
typedef struct {
    uint32_t x, z, s, t;
} tp_floor_place;

/* Returns the column of a sample. */
static inline int32_t tp_fast_column(const tp_floor_block *block, int32_t sample)
{
    return sample + 1 < block->samples ? 2 * sample : block->count - 1;
}

/* Returns the water's own colour: three parts of deep water, one of the lit colour. */
static inline uint32_t tp_fast_own_colour(uint32_t deep, uint32_t colour, uint32_t lit)
{
    return tp_colour_mix(deep, tp_colour_scale(colour, lit), 64);
}

/* Shades the columns of a block, with red and blue at the places of green, or shifted. */
void tp_fast_floor_shade(const tp_shade *shade, const tp_floor_block *block, tp_run *run);
void tp_fast_floor_shade_shifted(const tp_shade *shade, const tp_floor_block *block,
                                 tp_run *run);

/* Multiplies the texels of the samples by the light at their places. */
void tp_fast_caustics_light(const tp_shade *shade, const tp_floor_block *block,
                            const tp_floor_place *place, uint32_t *texel);

/* Replaces the colours of samples whose rays meet a wall, or that lie outside of the walls
 * of an island.  `own` are the water's unlit colours in the block's columns. */
void tp_fast_walls(const tp_shade *shade, const tp_floor_block *block,
                   const tp_floor_place *place, const uint32_t *own, uint32_t *mixed);

#endif
