/* SPDX-License-Identifier: MIT */
/* Methods of finding the water, and the plan, as a program links them.  A program's pointer
 * to a method or to the plan is NULL if the program lacks it. */
#ifndef TP_FRAME_PARTS_H
#define TP_FRAME_PARTS_H
#include "frame/frame.h"

/* A way to find the water: visibility.c.  `memory` is free until there are pixels, and of
 * tp_method_bytes() for each of the tile's columns; behind it, if crossings are streamed,
 * a window's. */
struct tp_method {
    void (*carve)(tp_frame_parts *parts, tp_arena *arena, const tp_program *program,
                  const tp_scene *scene, const tp_config *config);
    bool (*holds)(tp_frame *frame);     /* for this frame; NULL: always */
    void (*place)(tp_frame *frame);
    void (*draw)(const tp_frame *frame, tp_samples *tile, void *memory);
    bool streams;                       /* of triangles: crossings are not stored */
};

#define TP_METHOD_BYTES sizeof(tp_row_column)

/* None where no method goes by columns. */
static inline size_t tp_method_bytes(const tp_program *program)
{
    return program->method.rows || program->method.projected ? TP_METHOD_BYTES : 0;
}

/* The plan: planned.c. */
struct tp_draw_rungs {
    void (*carve)(tp_frame_parts *parts, tp_arena *arena, const tp_plan_input *in);
    tp_ladder (*ladder)(const tp_plan_input *in);
    tp_rungs (*rungs)(const tp_plan_input *in);
    void (*thin)(tp_frame *frame);
};
#endif
