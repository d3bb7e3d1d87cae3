/* SPDX-License-Identifier: MIT */
/* Chooses the water's lighting: view-dependent light, or diffuse light only. */
#include "frame/frame.h"

/* Sets a dark lobe, for water without glitter. */
static void begin(tp_frame *frame, void *mine)
{
    static const tp_entry16 dark[TP_SHINE + 1];

    (void)mine;
    frame->shade.shine = dark;
}

/* Adds the view stage and the light stage together: a list with view vectors is always
 * lit. */
static void add_light(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    const bool blinn = frame->scene->light.model == TP_LIGHT_BLINN;
    const tp_stage light = stage[2 * blinn + list->rippled];
    const tp_stage view = frame->program->stage.view;

    if (list->kind != TP_LIST_WATER)
        return;
    tp_shaders_add(list, TP_AT_VIEW, light ? view : NULL, NULL);
    if (view && light)
        tp_shaders_add(list, TP_AT_LIGHT, light, mine);
}

const tp_drawing tp_lighting_drawing = { .begin = begin, .stages = add_light };

static void add_diffuse(const tp_frame *frame, const void *mine, const tp_stage *stage,
                        tp_shaders *list)
{
    (void)frame;
    if (list->kind == TP_LIST_WATER)
        tp_shaders_add(list, TP_AT_LIGHT, stage[list->rippled], mine);
}

const tp_drawing tp_diffuse_drawing = { .stages = add_diffuse };
