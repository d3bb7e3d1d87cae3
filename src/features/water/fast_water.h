/* SPDX-License-Identifier: MIT */
/* Water by fast shading: stages for layers, ripples, light, the reflected sky and glints.
 *
 *     fast_water_drawing.c   its shader list and its tables
 *     quick_pictures.c       bakes textures, for frames and for `tidepool bake`
 *     quick_layers_drawing.c a frame's baked textures
 *     quick_tables.c         tables of light
 *     quick_NAME_stage.c     its span stages */
#ifndef TP_FAST_WATER_H
#define TP_FAST_WATER_H
#include "base/arena.h"
#include "features/water/quick_layers.h"
#include "features/water/quick_light.h"
#include "features/water/water.h"
#include "frame/frame.h"
#include "frame/tools.h"

/* Parameters of a baked texture; `amount` is saturation, strength or bump. */
typedef struct {
    tp_fx    amount, clamp;
    uint32_t colour;
} tp_quick_wish;

typedef struct {
    tp_quick_layers layers;     /* data of the stages; first member */
    struct tp_quick_light light;
    void         *memory[TP_BAKED_LAYERS];  /* NULL: not baked here */
    tp_texture    picture[TP_BAKED_LAYERS]; /* levels 0: not baked yet */
    tp_quick_wish made[TP_BAKED_LAYERS];
} tp_fast_water;

/* quick_layers_drawing.c.  tp_quick_layout_pictures takes memory for the textures missing
 * in the assets.  tp_quick_begin_layers sets the layers of this frame; call after the
 * water's colour is set. */
void tp_quick_layout_pictures(void *memory[TP_BAKED_LAYERS], tp_arena *arena,
                              const tp_assets *assets);
void tp_quick_begin_layers(tp_frame *frame, tp_fast_water *fast);
#endif
