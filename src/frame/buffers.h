/* SPDX-License-Identifier: MIT */
/* Interfaces between the frame and the water renderers and the quality plan, as a program
 * links them.  A program's pointer to a renderer or to the plan is NULL if the program
 * lacks it. */
#ifndef TP_FRAME_BUFFERS_H
#define TP_FRAME_BUFFERS_H
#include "frame/frame.h"

/* A water renderer, see visibility.c.  `memory` is scratch, free until pixels are
 * stored: tp_renderer_column_bytes() for each column of the tile, then a window if
 * grid vertices are streamed. */
struct tp_water_renderer {
    void (*layout)(tp_frame_buffers *parts, tp_arena *arena, const tp_program *program,
                   const tp_scene *scene, const tp_config *config);
    bool (*holds)(tp_frame *frame);     /* true if it can draw this frame; NULL: always */
    void (*place)(tp_frame *frame);
    void (*draw)(const tp_frame *frame, tp_gbuffer *tile, void *memory);
    bool streams;                       /* triangles: grid vertices are not stored */
};

#define TP_RENDERER_BYTES sizeof(tp_row_column)

/* Scratch bytes per column; 0 if no renderer of the program works by columns. */
static inline size_t tp_renderer_column_bytes(const tp_program *program)
{
    return program->method.rows || program->method.projected ? TP_RENDERER_BYTES : 0;
}

/* The quality plan, see planned.c. */
struct tp_draw_rungs {
    void (*layout)(tp_frame_buffers *parts, tp_arena *arena, const tp_plan_input *in);
    tp_ladder (*ladder)(const tp_plan_input *in);
    tp_rungs (*rungs)(const tp_plan_input *in);
    void (*thin)(tp_frame *frame);
};
#endif
