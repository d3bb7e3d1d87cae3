/* SPDX-License-Identifier: MIT */
/* A module's part that a picture asks: memory, numbers, stages.  scene/module.h has the
 * part that the world asks, and says when the feature is on. */
#ifndef TP_FRAME_DRAWING_H
#define TP_FRAME_DRAWING_H
#include "frame/shaders.h"
#include "scene/module.h"

struct tp_frame;

/* All may be NULL.  `mine` is what `layout` returned. */
typedef struct tp_drawing {
    /* Memory that lasts as long as the frame.  With an arena that only counts it returns
     * NULL, and is asked again; NULL for good: nothing is drawn. */
    void *(*layout)(tp_arena *arena, const tp_want *want);
    void  (*init)(struct tp_frame *frame, void *mine);

    /* The numbers of a picture; camera, light and surface are known. */
    void  (*begin)(struct tp_frame *frame, void *mine);

    /* The stages that it adds to the water's list.  `stage` is the program's table. */
    void  (*water)(const struct tp_frame *frame, const void *mine, const tp_stage *stage,
                   tp_shaders *list);
} tp_drawing;

/* -- modules.c: loops over the program's list ----------------------------------------- */

/* Lays out the memory of all enabled modules, an array of pointers first; returns that. */
void **tp_frame_layout_modules(const tp_kit *kit, tp_arena *arena, const tp_want *want);

void tp_frame_init_modules(struct tp_frame *frame);
void tp_frame_begin_modules(struct tp_frame *frame);
void tp_frame_add_modules(const struct tp_frame *frame, tp_shaders *water);

/* True if the frame draws a module that has one of these bits of tp_module.is. */
bool tp_frame_has_module(const struct tp_frame *frame, uint32_t is);
#endif
