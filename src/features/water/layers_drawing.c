/* SPDX-License-Identifier: MIT */
/* The water's textures: the base layer, then the added layers and the distortion. */
#include "features/water/water.h"
#include "frame/frame.h"

/* -- the base layer ------------------------------------------------------------------ */

static void *layout_base(tp_arena *arena, const tp_want *want)
{
    (void)want;
    return tp_arena_alloc(arena, 1, sizeof(tp_base_layer));
}

/* Sets the base layer; its colour and the water's colour are multiplied into one. */
static void begin_base(tp_frame *frame, void *mine)
{
    const tp_scene_layer *layer = &frame->scene->layer[0];
    tp_base_layer *base = mine;
    tp_shade *shade = &frame->shade;

    base->layer = tp_frame_layer(frame, frame->assets.layer[0], &layer->map);
    if (!base->layer.texture)
        return;
    shade->water_colour = tp_colour_times(shade->water_colour, (uint32_t)layer->colour);
    base->grade = tp_grade_make(layer->saturation, layer->clamp, shade->water_colour);
}

static tp_stage texture_stage(const tp_frame *frame, const tp_stage *stage)
{
    const tp_scene_layer *layer = &frame->scene->layer[0];
    const bool linear = frame->scene->water.filter == TP_FILTER_LINEAR;

    if (tp_is_graded(layer->saturation, layer->clamp))
        return stage[TP_NTH_texture_graded + linear];
    return stage[2 * linear + (frame->shade.water_colour != 0xffffff)];
}

static void add_base(const tp_frame *frame, const void *mine, const tp_stage *stage,
                     tp_shaders *list)
{
    const tp_base_layer *base = mine;

    if (list->kind != TP_LIST_WATER || !base->layer.texture)
        return;
    tp_shaders_add(list, TP_AT_COLOUR,
                   tp_shaders_pick(list, texture_stage(frame, stage),
                                   stage[TP_NTH_texture] ? stage[TP_NTH_texture]
                                                         : frame->program->stage.plain),
                   mine);
}

const tp_drawing tp_base_layer_drawing = {
    .layout = layout_base, .begin = begin_base, .stages = add_base,
};

/* -- the added layers ---------------------------------------------------------------- */

static void *layout_layers(tp_arena *arena, const tp_want *want)
{
    (void)want;
    return tp_arena_alloc(arena, 1, sizeof(tp_layers));
}

static void begin_layer(const tp_frame *frame, tp_layers *layers, int k)
{
    const tp_scene_layer *layer = &frame->scene->layer[1 + k];
    const uint32_t colour = (uint32_t)layer->colour;

    layers->added[k] = tp_frame_layer(frame, frame->assets.layer[1 + k], &layer->map);
    layers->colour[k] = colour;
    layers->graded[k] = tp_is_graded(layer->saturation, layer->clamp);
    layers->grade[k] = tp_grade_make(layer->saturation, layer->clamp, colour);
}

static void begin_layers(tp_frame *frame, void *mine)
{
    tp_layers *layers = mine;

    for (int k = 0; k < TP_LAYERS_ADDED; k++)
        begin_layer(frame, layers, k);
    layers->bend = tp_frame_layer(frame, frame->assets.distortion,
                                  &frame->scene->distortion.map);
    layers->strength = frame->scene->distortion.strength;
}

/* Adds the stages.  Without a base layer the other layers are added to the water's plain
 * colour. */
static void add_layers(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    const tp_layers *layers = mine;
    const bool added = layers->added[0].texture || layers->added[1].texture;
    const bool base = tp_shaders_has(list, TP_AT_COLOUR);
    const bool linear = frame->scene->water.filter == TP_FILTER_LINEAR;

    if (list->kind != TP_LIST_WATER)
        return;
    if (layers->bend.texture && layers->strength > 0 && (added || base))
        tp_shaders_add(list, TP_AT_PLACE, stage[TP_NTH_bend], mine);
    if (added && !base)
        tp_shaders_add(list, TP_AT_COLOUR, frame->program->stage.plain, NULL);
    if (added)
        tp_shaders_add(list, TP_AT_COLOUR, stage[TP_NTH_layers + linear], mine);
}

const tp_drawing tp_layers_drawing = {
    .layout = layout_layers, .begin = begin_layers, .stages = add_layers,
};
