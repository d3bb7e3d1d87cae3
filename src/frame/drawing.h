/* SPDX-License-Identifier: MIT */
/* A module as a picture asks it: memory, numbers, stages.  scene/module.h has the module as
 * the world asks it, and says when the feature is on. */
#ifndef TP_FRAME_DRAWING_H
#define TP_FRAME_DRAWING_H
#include "frame/shaders.h"
#include "raster/raster.h"
#include "scene/module.h"

struct tp_frame;
struct tp_frame_parts;

/* All members may be NULL.  `mine` is the memory that `layout` returned; without that hook
 * it is not to be looked into. */
typedef struct tp_drawing {
    /* Takes memory that lasts as long as the frame.  It is called twice: with an arena that
     * only counts, where it returns NULL, then with the frame's block. */
    void *(*layout)(tp_arena *arena, const tp_want *want);
    void  (*init)(struct tp_frame *frame, void *mine);

    /* Sets the numbers of a picture.  Camera, light and surface are known. */
    void  (*begin)(struct tp_frame *frame, void *mine);

    /* Draws a picture that the water's stages read, such as a mirror.  All lists and
     * numbers are known. */
    void  (*look)(struct tp_frame *frame, void *mine);

    /* Projects the things that `over` draws.  Everything else is projected. */
    void  (*place)(struct tp_frame *frame, void *mine);

    /* Draws over the finished water: sets samples to `mark`.  Those samples go through the
     * stage that `first` returns, then through air and exposure; under water through the
     * water before them. */
    void  (*over)(const struct tp_frame *frame, const void *mine, const tp_samples *samples,
                  uint32_t mark);
    tp_stage (*first)(const struct tp_frame *frame, const void *mine, const tp_stage *stage);

    /* Adds stages to a list, the water's or another kind's, after the modules above.
     * `stage` is the program's table of the module. */
    void  (*stages)(const struct tp_frame *frame, const void *mine, const tp_stage *stage,
                    tp_shaders *list);
} tp_drawing;

/* -- drawing.c: loops over the program's list ----------------------------------------- */

/* Lays out the memory of all enabled modules, an array of pointers first. */
void tp_frame_layout_modules(const tp_kit *kit, struct tp_frame_parts *parts,
                             tp_arena *arena, tp_want want);

/* Asks which modules are on in this picture; those alone take part in it. */
void tp_frame_enable_modules(struct tp_frame *frame);

void tp_frame_init_modules(struct tp_frame *frame);
void tp_frame_begin_modules(struct tp_frame *frame);
void tp_frame_look_modules(struct tp_frame *frame);
void tp_frame_add_modules(const struct tp_frame *frame, tp_shaders *list);
void tp_frame_list_modules(struct tp_frame *frame);
void tp_frame_place_modules(struct tp_frame *frame);
void tp_frame_draw_modules(const struct tp_frame *frame, const tp_samples *samples);

/* True if this picture has a module with one of these bits of tp_module.is. */
bool tp_frame_has_module(const struct tp_frame *frame, uint32_t is);

/* The memory of a module that is on in this picture, or NULL. */
void *tp_frame_part(const struct tp_frame *frame, uint32_t id);
#endif
