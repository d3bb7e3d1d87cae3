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

/* What the scene names, else the first of a kind, which is exact. */
static int first_or(int32_t named, int last)
{
    return named > 0 && named <= last ? named : 1;
}

static tp_rungs named(const tp_scene *scene)
{
    return (tp_rungs){
        (tp_visibility)first_or(scene->quality.visibility, TP_VISIBILITY_FLAT),
        (tp_shading)first_or(scene->quality.shading, TP_SHADING_QUICK),
        (tp_rate)first_or(scene->quality.rate, TP_RATE_COLOUR),
        (tp_lod)first_or(scene->quality.lod, TP_LOD_ON),
    };
}

tp_reach tp_frame_reach(const tp_kit *kit, const tp_scene *scene, const tp_assets *assets,
                        const tp_frame_config *config)
{
    const struct tp_draw_rungs *rungs = kit->draw.rungs;
    const tp_ladder ladder = rungs ? rungs->ladder(scene, assets, config->width,
                                                   config->height)
                                   : (tp_ladder){ { named(scene) }, 1 };
    return tp_reach_of(&ladder);
}

static bool has(uint8_t bits, unsigned rung)
{
    return rung < 8 && (bits >> rung & 1);
}

/* Exact where there is no memory for a rung, and where it is none. */
static tp_rungs within(tp_reach reach, tp_rungs r)
{
    return (tp_rungs){
        has(reach.visibility, r.visibility) ? r.visibility : TP_VISIBILITY_TRIANGLES,
        has(reach.shading, r.shading) ? r.shading : TP_SHADING_EXACT,
        has(reach.rate, r.rate) ? r.rate : TP_RATE_FULL,
        has(reach.lod, r.lod) ? r.lod : TP_LOD_OFF,
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
    frame->rungs = within(frame->parts.reach, frame->steered ? frame->asked
                                                             : frame->planned);
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
