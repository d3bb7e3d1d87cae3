/* SPDX-License-Identifier: MIT */
/* Culling of waves as a program links it: leaves out, or draws lower, waves too faint to be
 * seen. */
#include "frame/frame.h"
#include "frame/renderers.h"
#include "quality/prices.h"

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

const struct tp_draw_culling tp_draw_culling = { layout_culled_water, cull_faint_waves };
