/* SPDX-License-Identifier: MIT */
/*
 * Begins a picture: sets the water's surface, projection, rungs and shader lists, draws the
 * maps and places the solids.  Tiles then read the frame and change nothing.
 */
#include "base/base.h"
#include "frame/frame.h"
#include "frame/renderers.h"
#include "frame/tools.h"
#include "view/wave_models.h"
#include "world/module.h"
#include "world/pools.h"

static void set_water_surface(tp_frame *frame)
{
    TP_ASSERT(frame->world->lag >= 0 && frame->world->lag <= TP_FX_ONE);
    const tp_world *world = frame->world;
    tp_surface *surface = &frame->surface;

    *surface = tp_world_surface(frame->program, world);
    surface->phases = frame->drawn.phases;
    surface->lag = world->lag;
    surface->ring = NULL;
    surface->rings = 0;
    if (tp_frame_has_module(frame, TP_MODULE_SLOPES))
        surface->pool = surface->field = NULL;
    tp_frame_add_displacements(frame, surface);
}

/* Without samples, things in the water take swells for level. */
static void count_missing_samples(tp_frame *frame)
{
    const tp_surface *surface = &frame->surface;

    if (frame->needs_samples && !surface->coastal && tp_surface_has_swells(surface))
        tp_frame_count_lack(frame, TP_LACKING_SAMPLES);
}

tp_surface tp_frame_surface_with_all_pools(const tp_frame *frame)
{
    tp_surface surface = frame->surface;

    if (surface.pool_kind)
        surface.pool = tp_world_pool(frame->world);
    if (surface.field_kind)
        surface.field = tp_world_field(frame->world);
    return surface;
}

/* Draws the pictures sampled by the water, then places the picture's own solids.  Both
 * share memory; the numbers left at the end are the picture's. */
static void draw_maps_and_place_solids(tp_frame *frame)
{
    const tp_draw_stats stats = frame->stats;

    tp_frame_draw_maps(frame);
    frame->stats = stats;
    frame->view =
        (tp_view){ .projection = &frame->projection, .picture = true, .walls = true };
    tp_view_begin(frame, &frame->view);
    frame->solids = tp_view_project_solids(frame, &frame->view);
}

void tp_frame_begin(tp_frame *frame, const tp_world *world)
{
    TP_ASSERT(frame != NULL && frame->program != NULL && world != NULL);
    const tp_scene *scene = frame->scene;
    const tp_draws *draw = &frame->program->draw;

    frame->stats = (tp_draw_stats){ .dropped = frame->buffers.lacks };
    frame->lacking = 0;
    frame->picture++;
    frame->world = world;
    frame->drawn = tp_program_interpolate(frame->program, world);
    if (frame->read_scene)
        frame->read_scene(frame);
    else
        frame->modules_on = frame->buffers.laid;
    set_water_surface(frame);
    count_missing_samples(frame);
    tp_projection_init_turned(
        &frame->projection, frame->drawn.camera.eye, frame->drawn.camera.turn,
        scene->camera.fov, scene->camera.near, frame->config.width, frame->config.height);
    if (world->aboard == TP_ABOARD_DECK)
        frame->projection.lean = 0; /* golden frames of the deck camera have no lean */
    if (draw->culling)
        draw->culling->cull_waves(frame);
    tp_frame_set_up_shading(frame);
    tp_frame_choose_visibility(frame);
    tp_frame_place_surface(frame);
    draw_maps_and_place_solids(frame);
}
