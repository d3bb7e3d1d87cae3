/* SPDX-License-Identifier: MIT */
/* The quality plan as a program links it: chooses the rungs and drops waves too faint to
 * be seen.  A program without the plan uses the rungs named by the scene, and the exact
 * rung of each kind left open. */
#include "frame/frame.h"
#include "quality/prices.h"

static tp_rungs choose_rungs_by_measured_prices(const tp_plan_input *in)
{
    return tp_rungs_choose_priced(&tp_prices_measured, in);
}

static tp_ladder make_ladder_by_measured_prices(const tp_plan_input *in)
{
    return tp_ladder_make_priced(&tp_prices_measured, in);
}

static void layout_culled_water(tp_frame_buffers *buffers, tp_arena *arena,
                                const tp_plan_input *in)
{
    if (tp_plan_culls_waves(in))
        buffers->culled = tp_arena_alloc(arena, 1, sizeof *buffers->culled);
}

/* Drops faint waves for this frame's camera, by the plan's rule for the scene's start
 * camera. */
static void cull_faint_waves(tp_frame *frame)
{
    const tp_projection *projection = &frame->projection;
    tp_surface *surface = &frame->surface;
    tp_culled_deep_water *culled = frame->buffers.culled;
    const tp_fx slope_colour = tp_prices_measured.slope_colour;

    if (!culled || surface->coastal)
        return;
    tp_wave_cull_limits limits =
        tp_wave_cull_limits_make(frame->scene, surface->deep->count, slope_colour);
    limits.focal = projection->focal >> 16;
    limits.near = tp_nearest_water_distance(
        tp_fx_saturate((int64_t)projection->eye.y - surface->deep->height),
        &projection->turn, frame->scene->camera.fov);
    if (tp_wave_cull_deep_water(&culled->deep, culled->phases, surface->deep,
                                surface->phases, &limits)) {
        surface->deep = &culled->deep;
        surface->phases = culled->phases;
    }
}

const struct tp_draw_rungs tp_draw_rungs = { layout_culled_water,
                                             make_ladder_by_measured_prices,
                                             choose_rungs_by_measured_prices,
                                             cull_faint_waves };
