/* SPDX-License-Identifier: MIT */
/* The rungs of a frame, named by the scene or asked for by a tool, and the choice of its
 * water renderer: the renderer of the rung if it can draw this camera and this sea, else
 * triangles.  The choice does not depend on the frame before. */
#include "frame/frame.h"
#include "frame/renderers.h"
#include "frame/tools.h"
#include "world/pools.h"

void tp_frame_set_rungs(tp_frame *frame, const tp_rungs *rungs)
{
    frame->asked = rungs ? *rungs : (tp_rungs){ .visibility = TP_VISIBILITY_AUTO };
}

/* Returns the rung named by the scene, else 1, the exact rung of its kind. */
static int rung_or_exact(int32_t named, int last)
{
    return named > 0 && named <= last ? named : 1;
}

tp_rungs tp_frame_named_rungs(const tp_scene *scene)
{
    return (tp_rungs){
        (tp_visibility)rung_or_exact(scene->quality.visibility, TP_VISIBILITY_WALK),
        (tp_shading)rung_or_exact(scene->quality.shading, TP_SHADING_QUICK),
        (tp_rate)rung_or_exact(scene->quality.rate, TP_RATE_COLOUR),
    };
}

tp_rung_mask tp_frame_rung_mask(tp_rungs named)
{
    return (tp_rung_mask){
        (uint8_t)(1u << TP_VISIBILITY_TRIANGLES | 1u << named.visibility),
        (uint8_t)(1u << TP_SHADING_EXACT | 1u << named.shading),
        (uint8_t)(1u << TP_RATE_FULL | 1u << named.rate),
    };
}

static bool has_rung(uint8_t bits, unsigned rung)
{
    return rung < 8 && (bits >> rung & 1);
}

/* Replaces rungs without memory, or out of range, by the exact rung. */
static tp_rungs replace_unavailable_rungs(tp_rung_mask available, tp_rungs r)
{
    return (tp_rungs){
        has_rung(available.visibility, r.visibility) ? r.visibility
                                                     : TP_VISIBILITY_TRIANGLES,
        has_rung(available.shading, r.shading) ? r.shading : TP_SHADING_EXACT,
        has_rung(available.rate, r.rate) ? r.rate : TP_RATE_FULL,
    };
}

/* Returns the renderer, or NULL if the program lacks it. */
const struct tp_water_renderer *tp_frame_renderer(const tp_program *program,
                                                  tp_visibility visibility)
{
    const tp_water_renderers *method = &program->method;
    return visibility == TP_VISIBILITY_TRIANGLES ? method->triangles
         : visibility == TP_VISIBILITY_ROWS ? method->rows
         : visibility == TP_VISIBILITY_PROJECTED ? method->projected
         : visibility == TP_VISIBILITY_FLAT ? method->flat
         : visibility == TP_VISIBILITY_WALK ? method->walk : NULL;
}

/* Returns the width of the columns of fast rows and of walked water, log2 of 28.4 px; 0:
 * other water. */
static uint8_t fast_column_bits(const tp_frame *frame)
{
    const int32_t rung = frame->scene->quality.rows;
    const uint8_t pairs = tp_frame_pair_bits(&frame->config);

    if (frame->visibility == TP_VISIBILITY_WALK)
        return pairs;
    if (frame->visibility != TP_VISIBILITY_ROWS || !frame->buffers.fast_lines
        || rung < TP_RUNG_FAST)
        return 0;
    return rung >= TP_RUNG_PAIRS ? pairs : 4;
}

/* True if the renderer has no grid, and so filters no waves. */
static bool is_level(tp_visibility visibility)
{
    return visibility == TP_VISIBILITY_PROJECTED || visibility == TP_VISIBILITY_FLAT
        || visibility == TP_VISIBILITY_WALK;
}

/* Returns the renderer of this frame; NULL: none, or nothing places its rows. */
static const struct tp_water_renderer *chosen_renderer(const tp_frame *frame)
{
    if (!is_level(frame->visibility) && !tp_frame_has_grid_rows(frame))
        return NULL;
    return frame->visibility == TP_VISIBILITY_ROWS && frame->column_bits
               ? frame->program->method.lines
               : tp_frame_renderer(frame->program, frame->visibility);
}

void tp_frame_choose_rungs(tp_frame *frame)
{
    frame->rungs = replace_unavailable_rungs(
        frame->buffers.rung_mask,
        frame->asked.visibility != TP_VISIBILITY_AUTO ? frame->asked
                                                      : tp_frame_named_rungs(frame->scene));
}

/* Sets the grid's placement, needed by all renderers. */
static void set_grid_view(tp_frame *frame)
{
    frame->grid_view = (tp_grid_view){
        .projection = &frame->projection,
        .surface = &frame->surface,
        .width = frame->config.width,
        .height = frame->config.height,
        .vertices = tp_fan_budget(frame->scene),
    };
    const bool flat = tp_frame_has_module(frame, TP_MODULE_SLOPES);
    for (const tp_use *u = frame->program->modules; u && u->module; u++)
        if (u->module->detail)
            u->module->detail(frame->scene, flat, &frame->grid_view.detail);
}

void tp_frame_choose_visibility(tp_frame *frame)
{
    const struct tp_water_renderer *method =
        tp_frame_renderer(frame->program, frame->rungs.visibility);

    set_grid_view(frame);
    frame->visibility = frame->rungs.visibility;
    if (!method || (method->holds && !method->holds(frame)))
        frame->visibility = TP_VISIBILITY_TRIANGLES;
    frame->column_bits = fast_column_bits(frame);
    frame->level_keys = NULL;
    const struct tp_water_renderer *chosen = chosen_renderer(frame);
    if (chosen && frame->column_bits && !tp_frame_has_module(frame, TP_MODULE_MIRROR))
        frame->level_keys = chosen->level_keys;
    if (frame->buffers.filtered && is_level(frame->visibility))
        tp_filtered_waves_clear(frame->buffers.filtered);
}

/* Places the surface.  Without a valid renderer no water is drawn. */
void tp_frame_place_surface(tp_frame *frame)
{
    const struct tp_water_renderer *method = chosen_renderer(frame);

    TP_ASSERT(frame->visibility != TP_VISIBILITY_AUTO);
    if (method)
        method->place(frame);
    else
        tp_frame_count_lack(frame, tp_frame_has_grid_rows(frame) ? 0 : TP_LACKING_ROWS);
}

void tp_frame_draw_surface(const tp_frame *frame, tp_gbuffer *tile, void *memory)
{
    const struct tp_water_renderer *method = chosen_renderer(frame);

    if (method)
        method->draw(frame, tile, memory);
}

bool tp_frame_draw_surface_alone(const tp_frame *frame, const tp_gbuffer *tile,
                                 void *memory, tp_water_rows *found)
{
    const struct tp_water_renderer *method = chosen_renderer(frame);

    return method && method->draw_alone && frame->level_keys && !frame->config.depth
           && !frame->config.overlay.draw
           && !(tp_frame_has_solids(frame) && tp_box_overlaps_tile(&frame->solids, tile))
           && method->draw_alone(frame, tile, memory, found);
}
