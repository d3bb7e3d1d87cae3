/* SPDX-License-Identifier: MIT */
/* Glitter: makes the lobe's table for the light model. */
#include "frame/frame.h"

static void *layout(tp_arena *arena, const tp_want *want)
{
    (void)want;
    return tp_arena_alloc(arena, TP_SHINE + 1, sizeof(tp_entry16));
}

static void begin(tp_frame *frame, void *mine)
{
    const tp_scene *scene = frame->scene;

    if (scene->light.model == TP_LIGHT_BLINN)
        tp_shade_shine_blinn(mine, scene->water.shininess, scene->water.specular);
    else
        tp_shade_shine(mine, scene->water.shininess, scene->water.specular);
    frame->shade.shine = mine;
}

static void add_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    (void)frame;
    if (list->kind != TP_LIST_WATER || !tp_shaders_has(list, TP_AT_VIEW))
        return;
    tp_shaders_add(list, TP_AT_GLINT, stage[0], mine);
    list->shines = stage[0] != NULL;
}

const tp_drawing tp_glint_drawing = {
    .layout = layout, .begin = begin, .stages = add_stage,
};
