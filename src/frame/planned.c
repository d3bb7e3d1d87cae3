/* SPDX-License-Identifier: MIT */
/* The quality plan as a program links it: chooses the rungs and drops waves too faint to
 * be seen.  A program without the plan uses the rungs named by the scene, and the exact
 * rung of each kind left open. */
#include "frame/frame.h"
#include "scene/wave_culling.h"
#include "scene/prices.h"

static tp_rungs choose_rungs_by_cost(const tp_plan_input *in)
{
    return tp_rungs_choose_priced(&tp_prices_measured, in);
}

static tp_ladder make_ladder_by_cost(const tp_plan_input *in)
{
    return tp_ladder_make_priced(&tp_prices_measured, in);
}

static void carve_culled_sea(tp_frame_parts *parts, tp_arena *arena,
                             const tp_plan_input *in)
{
    if (tp_thins_sea(in))
        parts->thin = tp_arena_alloc(arena, 1, sizeof *parts->thin);
}

/* Drops faint waves for this frame's camera, by the plan's rule for the scene's start
 * camera. */
static void cull_faint_waves(tp_frame *frame)
{
    const tp_projection *projection = &frame->projection;
    tp_surface *surface = &frame->surface;
    tp_thin_sea *thin = frame->parts.thin;
    const tp_fx slope_colour = tp_prices_measured.slope_colour;

    if (!thin || surface->ocean)
        return;
    tp_wave_cull_limits limits = tp_wave_cull_limits_make(frame->scene, surface->sea->count,
                                                slope_colour);
    limits.focal = projection->focal >> 16;
    limits.near = tp_wave_cull_near(
        tp_fx_saturate((int64_t)projection->eye.y - surface->sea->height),
        &projection->turn, frame->scene->camera.fov);
    if (tp_wave_cull_sea(&thin->sea, thin->phases, surface->sea, surface->phases, &limits)) {
        surface->sea = &thin->sea;
        surface->phases = thin->phases;
    }
}

const struct tp_draw_rungs tp_draw_rungs = {
    carve_culled_sea, make_ladder_by_cost, choose_rungs_by_cost, cull_faint_waves
};
