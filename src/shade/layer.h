/* SPDX-License-Identifier: MIT */
/* The water's drifting pictures: what a frame says of them. */
#ifndef TP_SHADE_LAYER_H
#define TP_SHADE_LAYER_H
#include "tidepool/asset.h"
#include "tidepool/fx.h"

/* A texture as a stage samples it. */
typedef struct {
    const tp_texture *texture;
    uint32_t per_metre;         /* repeats a metre, Q0.32 over Q16.16: s x this wraps */
    uint32_t drift_s, drift_t;  /* Q0.32 repeats */
    int32_t  lod;               /* level at 1 m, Q8, for tp_level_of */
    int32_t  slope_gain;        /* normal maps: 256 is as drawn */
} tp_layer;

/* What is done to a texel.  Levels of 255 are Q8 here. */
typedef struct {
    int32_t  saturation;        /* 0 is its grey, 256 leaves it as it is, 1024 at most */
    int32_t  clamp;             /* darker is black, 0..0.95 of white */
    int32_t  span;              /* white less the clamp */
    uint32_t gain[3];           /* red, green, blue of the colour / span, Q24 */
} tp_grade;

/* saturation 0..4, clamp 0..0.95 */
tp_grade tp_grade_of(tp_fx saturation, tp_fx clamp, uint32_t colour);

#define TP_LAYERS_ADDED 2       /* to the first */

/* The first layer is tp_shade.water. */
typedef struct {
    tp_layer added[TP_LAYERS_ADDED];            /* texture NULL: it is not there */
    uint32_t colour[TP_LAYERS_ADDED];
    bool     graded[TP_LAYERS_ADDED];           /* else the colour is all */
    tp_grade grade[1 + TP_LAYERS_ADDED];
    tp_layer bend;                              /* the distortion */
    tp_fx    strength;                          /* m that it moves places at the most */
} tp_layers;
#endif
