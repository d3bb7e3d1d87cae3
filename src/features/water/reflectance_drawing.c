/* SPDX-License-Identifier: MIT */
/* The reflectance of the water: selects Fresnel's table and the stages of the reflected
 * sky. */
#include "frame/frame.h"

static void begin(tp_frame *frame, void *mine)
{
    (void)mine;
    if (frame->scene->water.fresnel == TP_FRESNEL_SCHLICK)
        frame->shade.fresnel = tp_schlick_table;
}

/* Adds separate stages for reflection and mixing.  If the program lacks the sky's stage,
 * neither sky nor objects are mixed in. */
static void add_separate_stages(const tp_frame *frame, const tp_stage *stage,
                                tp_shaders *list)
{
    const bool hdr = frame->shade.env.beyond && stage[TP_NTH_fresnel_hdr];

    if (frame->shade.env.kind == TP_ENV_GRADIENT)
        tp_shaders_add(list, TP_AT_REFLECT, stage[TP_NTH_reflect_gradient], NULL);
    if (!list->rippled)
        tp_shaders_add(list, TP_AT_SLOPE, stage[TP_NTH_slopes], NULL);
    if (tp_shaders_has(list, TP_AT_REFLECT) && (list->rippled || stage[TP_NTH_slopes]))
        tp_shaders_add(list, TP_AT_FRESNEL, stage[TP_NTH_fresnel + hdr], NULL);
}

/* Adds the stages.  The plain gradient has no light above white, so one combined stage is
 * enough unless objects are reflected. */
static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    (void)mine;
    if (!tp_frame_reflects_sky(frame, list))
        return;
    if (frame->shade.env.kind == TP_ENV_GRADIENT
        && frame->scene->mirror.objects == TP_MIRROR_NONE)
        tp_shaders_add(list, TP_AT_FRESNEL, stage[TP_NTH_mirror], NULL);
    else
        add_separate_stages(frame, stage, list);
}

const tp_drawing tp_reflectance_drawing = { .begin = begin, .stages = add_stages };
