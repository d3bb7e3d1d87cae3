/* SPDX-License-Identifier: MIT */
/* The water's drifting pictures: what a frame says of them. */
#ifndef TP_SHADE_LAYER_H
#define TP_SHADE_LAYER_H
#include "tidepool/assets.h"

/* A texture as a stage samples it. */
typedef struct {
    const tp_texture *texture;
    uint32_t per_metre;         /* repeats a metre, Q0.32 over Q16.16: s x this wraps */
    uint32_t drift_s, drift_t;  /* Q0.32 repeats */
    int32_t  lod;               /* level at 1 m, Q8, for tp_level_of */
} tp_layer;
#endif
