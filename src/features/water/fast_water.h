/* SPDX-License-Identifier: MIT */
/* Water by fast stages: one rung for pictures, ripples, light, the mirrored sky and
 * glints.
 *
 *     fast_water_drawing.c   its list and its tables
 *     quick_pictures.c       makes prepared pictures, for frames and for bake
 *     quick_layers_drawing.c a frame's prepared pictures
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

/* The numbers that a picture was made for: saturation, strength or bump. */
typedef struct {
    tp_fx    amount, clamp;
    uint32_t colour;
} tp_quick_wish;

typedef struct {
    tp_quick_layers layers;     /* the stages': first */
    struct tp_quick_light light;
    void         *memory[TP_PREPARED];  /* NULL: not made here */
    tp_texture    picture[TP_PREPARED]; /* no levels: not made yet */
    tp_quick_wish made[TP_PREPARED];
} tp_fast_water;

/* quick_layers_drawing.c: takes memory for the pictures that the assets lack; then sets the
 * layers of this frame, once the water's colour is known. */
void tp_quick_layout_pictures(void *memory[TP_PREPARED], tp_arena *arena,
                              const tp_assets *assets);
void tp_quick_begin_layers(tp_frame *frame, tp_fast_water *fast);
#endif
