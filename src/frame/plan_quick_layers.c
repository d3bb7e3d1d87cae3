/* SPDX-License-Identifier: MIT */
/* The quick rung's pictures of a frame: prepared by whoever made the assets, or here, into
 * the frame's block, and again whenever a number changes that they were made for. */
#include "frame/parts.h"
#include "shade/colour.h"

enum { OFFSETS = TP_LAYERS, SLOPES };

static const tp_texture *source_of(const tp_assets *assets, int i)
{
    return i == OFFSETS ? assets->distortion : i == SLOPES ? assets->ripple
         : assets->layer[i];
}

static const tp_texture *ready_of(const tp_assets *assets, int i)
{
    return i == OFFSETS ? assets->offsets : i == SLOPES ? assets->slopes
         : assets->graded[i];
}

static tp_frame_quick *carve_quick(tp_arena *arena, const tp_assets *assets)
{
    tp_frame_quick *quick = tp_arena_take(arena, 1, sizeof *quick);

    if (quick)
        *quick = (tp_frame_quick){ .memory = { NULL } };
    for (int i = 0; i < TP_QUICK_PICTURES; i++) {
        const tp_texture *source = source_of(assets, i);
        if (!source || ready_of(assets, i))
            continue;
        void *memory = tp_arena_take(arena, 1, tp_quick_bytes(source));
        if (quick)
            quick->memory[i] = memory;
    }
    return quick;
}

/* -- what pictures are made for -------------------------------------------------------- */

/* The first layer's with the water's colour, as plan_layers.c has it. */
static uint32_t colour_of(const tp_scene *scene, const tp_assets *assets, int i)
{
    const uint32_t colour = (uint32_t)scene->layer[i].colour;

    if (i > 0)
        return colour;
    return assets->layer[0] ? tp_colour_times((uint32_t)scene->water.colour, colour)
                            : (uint32_t)scene->water.colour;
}

static tp_quick_wish wish_of(const tp_scene *scene, const tp_assets *assets, int i)
{
    if (i == OFFSETS)
        return (tp_quick_wish){ .amount = scene->distortion.strength };
    if (i == SLOPES)
        return (tp_quick_wish){ .amount = scene->ripple.bump };
    return (tp_quick_wish){
        .amount = scene->layer[i].saturation, .clamp = scene->layer[i].clamp,
        .colour = colour_of(scene, assets, i),
    };
}

static bool is_same(const tp_quick_wish *a, const tp_quick_wish *b)
{
    return a->amount == b->amount && a->clamp == b->clamp && a->colour == b->colour;
}

static void make(tp_texture *to, int i, const tp_texture *source,
                 const tp_quick_wish *wish, void *memory)
{
    if (i == OFFSETS)
        tp_quick_offsets(to, source, wish->amount, memory);
    else if (i == SLOPES)
        tp_quick_slopes(to, source, wish->amount, memory);
    else
        tp_quick_graded(to, source, wish->amount, wish->clamp, wish->colour, memory);
}

size_t tp_prepared_bytes(const tp_assets *assets, int i)
{
    TP_ASSERT(assets != NULL && i >= 0 && i < TP_PREPARED);
    const tp_texture *source = source_of(assets, i);
    return source ? tp_quick_bytes(source) : 0;
}

void tp_prepare(tp_texture *to, const tp_scene *scene, const tp_assets *assets, int i,
                void *memory)
{
    TP_ASSERT(i >= 0 && i < TP_PREPARED);
    const tp_quick_wish wish = wish_of(scene, assets, i);
    make(to, i, source_of(assets, i), &wish, memory);
}

/* NULL: there is none. */
static const tp_texture *picture_of(tp_frame *frame, int i)
{
    tp_frame_quick *quick = frame->parts.quick;
    const tp_quick_wish wish = wish_of(frame->scene, &frame->assets, i);

    if (ready_of(&frame->assets, i))
        return ready_of(&frame->assets, i);
    if (!quick || !quick->memory[i])
        return NULL;
    if (quick->picture[i].levels == 0 || !is_same(&quick->made[i], &wish))
        make(&quick->picture[i], i, source_of(&frame->assets, i), &wish,
             quick->memory[i]);
    quick->made[i] = wish;
    return &quick->picture[i];
}

static tp_quick_map map_of(tp_frame *frame, int i, const tp_scene_map *map, int32_t lod)
{
    tp_layer layer = tp_frame_layer(frame, picture_of(frame, i), map);

    layer.lod += lod;
    return tp_quick_map_of(&layer);
}

/* -- a frame's numbers and stages ------------------------------------------------------ */

/* After tp_frame_plan_layers, which knows the water's colour. */
static bool plan_quick(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    tp_quick_layers *quick = &frame->shade.quick_layers;

    for (int i = 0; i < TP_QUICK_PICTURES; i++)
        if (source_of(&frame->assets, i) && !ready_of(&frame->assets, i)
            && !(frame->parts.quick && frame->parts.quick->memory[i]))
            return false;
    for (int k = 0; k < TP_LAYERS; k++)
        quick->layer[k] = map_of(frame, k, &scene->layer[k].map, 0);
    quick->bend = map_of(frame, OFFSETS, &scene->distortion.map, 0);
    quick->ripple = map_of(frame, SLOPES, &scene->ripple.map, 224);     /* as exact ones */
    return true;
}

const struct tp_draw_quick_layers tp_draw_quick_layers = { carve_quick, plan_quick };

static bool has_layers(const tp_quick_layers *quick)
{
    for (int k = 0; k < TP_LAYERS; k++)
        if (quick->layer[k].level)
            return true;
    return false;
}

void tp_plan_add_quick_layers(const tp_frame *frame, tp_shaders *water, bool even)
{
    const tp_stages *stages = &frame->kit->stage;
    const tp_quick_layers *quick = &frame->shade.quick_layers;
    bool layers = has_layers(quick);
    bool thin = even || frame->rungs.rate == TP_RATE_LAYERS;
    bool ripples = quick->ripple.level && frame->scene->ripple.bump > 0;
    bool bends = quick->bend.level && frame->scene->distortion.strength > 0;

    if (layers || ripples)
        tp_shaders_add_colour(water, stages->quick_far);
    if (layers && thin)
        tp_shaders_add_colour(water, bends ? stages->quick_bend_thin
                                           : stages->quick_still_thin);
    else if (layers)
        tp_shaders_add_colour(water, bends ? stages->quick_bend : stages->quick_still);
    tp_shaders_add_colour(water, even ? stages->quick_layers_even
                               : !layers ? stages->plain
                               : thin ? stages->quick_layers_thin
                                      : stages->quick_layers);
    tp_shaders_add_colour(water, ripples ? stages->quick_ripple : stages->quick_slopes);
}
