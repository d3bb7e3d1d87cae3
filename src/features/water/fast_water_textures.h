/* SPDX-License-Identifier: MIT */
/*
 * The baked textures of fast water in a frame: layers, offsets of the distortion, slopes of
 * the ripples; fast_water_textures.c.
 */
#ifndef TP_FEATURES_WATER_FAST_WATER_TEXTURES_H
#define TP_FEATURES_WATER_FAST_WATER_TEXTURES_H
#include "features/water/fast_shading.h"
#include "features/water/water.h"
#include "frame/frame.h"

/* Parameters of a baked texture; `amount` is saturation, strength or bump. */
typedef struct {
    tp_fx    amount, clamp;
    uint32_t colour;
} tp_quick_wish;

typedef struct {
    void         *memory[TP_BAKED_LAYERS];  /* NULL: not baked here */
    tp_texture    picture[TP_BAKED_LAYERS]; /* levels 0: not baked yet */
    tp_quick_wish made[TP_BAKED_LAYERS];
} tp_fast_textures;

/* Takes memory for the baked textures missing in the assets. */
void tp_fast_textures_layout(tp_fast_textures *textures, tp_arena *arena,
                             const tp_assets *assets);
void tp_fast_textures_init(tp_fast_textures *textures);

/* Sets the layers of a picture, and bakes textures whose parameters have changed.  Call
 * after the water's colour is set.  Returns the number of textures that are missing in the
 * assets and that the program cannot bake. */
uint32_t tp_fast_textures_begin(tp_fast_textures *textures, const tp_frame *frame,
                                tp_quick_layers *layers);

/* Bakes texture i if a parameter has changed, and returns the texture. */
struct tp_draw_baking {
    const tp_texture *(*update)(const tp_frame *frame, tp_fast_textures *textures, int i);
};

#endif
