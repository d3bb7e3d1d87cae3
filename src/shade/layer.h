/* SPDX-License-Identifier: MIT */
/* Drifting textures on the water, as a frame stores them. */
#ifndef TP_SHADE_LAYER_H
#define TP_SHADE_LAYER_H
#include "tidepool/assets.h"

/* A texture with the numbers that a span stage samples it by. */
typedef struct {
    const tp_texture *texture;
    uint32_t per_metre;         /* repeats a metre, Q0.32 over Q16.16: s x this wraps */
    uint32_t drift_s, drift_t;  /* offsets in repeats, Q0.32 */
    int32_t  lod;               /* mipmap level at 1 m, Q8, for tp_mip_level_choose */
} tp_layer;
#endif
