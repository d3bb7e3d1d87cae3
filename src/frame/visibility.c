/* SPDX-License-Identifier: MIT */
/* By which method a frame's water is drawn: the plan's, where that holds for this camera
 * and this sea.  Decided from them alone, without memory of the frame before. */
#include "frame/frame.h"
#include "scene/faint.h"
#include "scene/prices.h"

void tp_frame_set_rungs(tp_frame *frame, const tp_rungs *rungs)
{
    frame->steered = rungs != NULL;
    if (rungs)
        frame->asked = *rungs;
}

/* None is planned at first. */
void tp_frame_choose_rungs(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;

    if (frame->planned.visibility == TP_VISIBILITY_AUTO
        || memcmp(frame->quality, &scene->quality, sizeof frame->quality) != 0) {
        memcpy(frame->quality, &scene->quality, sizeof frame->quality);
        frame->planned = tp_rungs_of(scene, &frame->assets, frame->config.width,
                                     frame->config.height);
    }
    frame->rungs = frame->steered ? frame->asked : frame->planned;
}

/* By this frame's camera, as the scene's own was planned for. */
void tp_frame_thin_sea(tp_frame *frame)
{
    const tp_lens *lens = &frame->lens;
    tp_surface *surface = &frame->surface;
    tp_thin_sea *thin = frame->parts.thin;
    const tp_fx slope_colour = tp_prices_measured.slope_colour;

    if (!thin || surface->ocean)
        return;
    tp_faint_limits limits = tp_faint_limits_of(frame->scene, surface->sea->count,
                                                slope_colour);
    limits.focal = lens->focal >> 16;
    limits.near = tp_faint_near(tp_fx_held((int64_t)lens->eye.y - surface->sea->height),
                                &lens->turn, frame->scene->camera.fov);
    if (tp_faint_sea(&thin->sea, thin->phases, surface->sea, surface->phases, &limits)) {
        surface->sea = &thin->sea;
        surface->phases = thin->phases;
    }
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
