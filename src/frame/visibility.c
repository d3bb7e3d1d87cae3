/* SPDX-License-Identifier: MIT */
/* By which method a frame's water is drawn: the plan's, where that holds for this camera
 * and this sea.  Decided from them alone, without memory of the frame before. */
#include "frame/frame.h"

void tp_frame_set_rungs(tp_frame *frame, const tp_rungs *rungs)
{
    frame->steered = rungs != NULL;
    if (rungs)
        frame->asked = *rungs;
}

/* What the scene asks for, and the first rung of a kind where it does not. */
static tp_rungs named(const tp_scene *scene)
{
    const int visibility = scene->quality.visibility, shading = scene->quality.shading;
    const int rate = scene->quality.rate, lod = scene->quality.lod;

    return (tp_rungs){
        visibility ? (tp_visibility)visibility : TP_VISIBILITY_TRIANGLES,
        shading ? (tp_shading)shading : TP_SHADING_EXACT,
        rate ? (tp_rate)rate : TP_RATE_FULL, lod ? (tp_lod)lod : TP_LOD_OFF,
    };
}

/* None is planned at first. */
void tp_frame_choose_rungs(tp_frame *frame)
{
    const struct tp_draw_rungs *rungs = frame->kit->draw.rungs;
    const tp_scene *scene = frame->scene;

    if (frame->planned.visibility == TP_VISIBILITY_AUTO
        || memcmp(frame->quality, &scene->quality, sizeof frame->quality) != 0) {
        memcpy(frame->quality, &scene->quality, sizeof frame->quality);
        frame->planned = rungs ? rungs->of(scene, &frame->assets, frame->config.width,
                                           frame->config.height) : named(scene);
    }
    frame->rungs = frame->steered ? frame->asked : frame->planned;
}

void tp_frame_choose_visibility(tp_frame *frame)
{
    frame->visibility = TP_VISIBILITY_TRIANGLES;
}

/* NULL: the kit has none, and no water is drawn. */
static const struct tp_method *method_of(const tp_frame *frame)
{
    return frame->kit->method.triangles;
}

void tp_frame_place_surface(tp_frame *frame)
{
    const struct tp_method *method = method_of(frame);

    if (method)
        method->place(frame);
}

void tp_frame_draw_surface(const tp_frame *frame, tp_samples *tile)
{
    const struct tp_method *method = method_of(frame);

    if (method)
        method->draw(frame, tile);
}
