/* SPDX-License-Identifier: MIT */
/* The plan of what lies on the water: layers, their distortion, ripples, bumps. */
#include "frame/frame.h"

/* Metres drifted by `time`, ticks x 65536; 16.16, wrapping. */
static uint32_t drifted(tp_fx metres_per_second, int64_t time)
{
    int64_t step = (int64_t)metres_per_second * ((int64_t)1 << 32) / TP_TICKS_PER_SECOND;
    uint64_t part = (uint64_t)(step >> 16) * (uint32_t)(time & 0xffff);
    return (uint32_t)(((uint64_t)step * (uint64_t)(time >> 16) + part) >> 32);
}

/* Levels: texels a metre over pixels a metre at 1 m, and half the eye's height for the
 * slant (see tp_level_of). */
int32_t tp_frame_lod(const tp_frame *frame, tp_fx texels_per_metre, bool level_ground)
{
    TP_ASSERT(frame->lens.focal > 0);
    int32_t lod = tp_log2_q8((uint32_t)(texels_per_metre > 0 ? texels_per_metre : 1))
                - tp_log2_q8((uint32_t)frame->lens.focal);
    tp_fx height = tp_abs(frame->lens.eye.y);

    if (height < TP_FX_ONE)
        height = TP_FX_ONE;
    return level_ground ? lod - (tp_log2_q8((uint32_t)height) - 16 * 256) / 2 : lod;
}

uint32_t tp_frame_repeats(tp_fx size)
{
    TP_ASSERT(size > 0);
    return (uint32_t)((((uint64_t)1 << 32) + (uint32_t)size / 2) / (uint32_t)size);
}

/* Of a picture's longer side: of 4096 on 0.1 m they are more than 16.16 holds. */
static tp_fx texels_a_metre(const tp_texture *texture, tp_fx size)
{
    TP_ASSERT(texture->levels > 0 && texture->levels <= TP_TEXTURE_LEVELS);
    return tp_fx_div(TP_FX_ONE << (texture->levels - 1), size);
}

tp_layer tp_frame_layer(const tp_frame *frame, const tp_texture *texture,
                        const tp_scene_map *map)
{
    const int64_t time = frame->drawn.time;
    tp_layer layer = { .texture = texture };

    if (!texture)
        return layer;
    layer.per_metre = tp_frame_repeats(map->size);
    layer.drift_s = 0u - drifted(map->drift_x, time) * layer.per_metre;
    layer.drift_t = 0u - drifted(map->drift_z, time) * layer.per_metre;
    layer.lod = tp_frame_lod(frame, texels_a_metre(texture, map->size), true);
    return layer;
}

static bool is_graded(const tp_scene_layer *layer)
{
    return layer->saturation != TP_FX_ONE || layer->clamp > 0;
}

static void plan_added(tp_frame *frame, int k)
{
    const tp_scene_layer *layer = &frame->scene->layer[1 + k];
    tp_layers *layers = &frame->shade.layers;

    layers->added[k] = tp_frame_layer(frame, frame->assets.layer[1 + k], &layer->map);
    layers->colour[k] = (uint32_t)layer->colour;
    layers->graded[k] = is_graded(layer);
    layers->grade[1 + k] = tp_grade_of(layer->saturation, layer->clamp,
                                        (uint32_t)layer->colour);
}

void tp_frame_plan_layers(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    const tp_draws *draw = &frame->kit->draw;
    tp_shade *shade = &frame->shade;

    shade->water = tp_frame_layer(frame, frame->assets.layer[0], &scene->layer[0].map);
    shade->water_colour = (uint32_t)scene->water.colour;
    if (shade->water.texture)
        shade->water_colour = tp_colour_times(shade->water_colour,
                                              (uint32_t)scene->layer[0].colour);
    shade->layers.grade[0] = tp_grade_of(scene->layer[0].saturation,
                                         scene->layer[0].clamp, shade->water_colour);
    if (draw->layers)
        draw->layers->plan(frame);
    if (draw->ripple)
        draw->ripple->plan(frame);
    if (draw->bumps)
        draw->bumps->place(frame);
}

static void plan_layers(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    tp_layers *layers = &frame->shade.layers;

    for (int k = 0; k < TP_LAYERS_ADDED; k++)
        plan_added(frame, k);
    layers->bend = tp_frame_layer(frame, frame->assets.distortion,
                                  &scene->distortion.map);
    layers->strength = scene->distortion.strength;
}

static void plan_ripple(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    tp_layer *ripple = &frame->shade.ripple;

    *ripple = tp_frame_layer(frame, frame->assets.ripple, &scene->ripple.map);
    ripple->lod += 224;             /* a mean of normals: what is lost glitters */
    ripple->slope_gain = scene->ripple.bump >> 8;
}

const struct tp_draw_layers tp_draw_layers = { plan_layers };
const struct tp_draw_ripple tp_draw_ripple = { plan_ripple };

static tp_stage texture_stage(const tp_frame *frame, tp_shaders *water, bool linear)
{
    const tp_stages *stages = &frame->kit->stage;
    const tp_stage stage[] = {
#define X(name, filter, tinted) [2 * (filter) + (tinted)] = stages->name,
        TP_TEXTURE_STAGES(X)
#undef X
    };
    const tp_shade *shade = &frame->shade;

    if (!shade->water.texture)
        return stages->plain;
    tp_stage wanted = stage[2 * linear + (shade->water_colour != 0xffffff)];
    if (is_graded(&frame->scene->layer[0]))
        wanted = linear ? stages->texture_linear_graded : stages->texture_graded;
    return tp_shaders_pick(water, wanted, stages->texture ? stages->texture : stages->plain);
}

/* Slopes of the mesh are 1/4 at the most: sum kA / (1 - sum QkA). */
static bool is_gentle(const tp_surface *surface)
{
    const tp_sea *sea = surface->sea;
    int64_t tilt = 0;

    if (surface->ocean || tp_surface_has_relief(surface))
        return false;
    for (uint32_t i = 0; i < sea->count; i++)
        tilt += sea->swell[i].tilt;
    return 4 * tilt <= (TP_Q30_ONE - sea->bend) >> 14;
}

/* Ripples lie on what pools make of the slopes. */
bool tp_plan_add_bumps(const tp_frame *frame, tp_shaders *water)
{
    const tp_stages *stages = &frame->kit->stage;
    const tp_pool_bump *pool = frame->shade.bumps.pool;
    bool ripples = frame->shade.ripple.texture && frame->scene->ripple.bump > 0;
    tp_stage bump = NULL, ripple = NULL;

    if (pool[0].slope || pool[1].slope)
        tp_shaders_add(water, TP_AT_SLOPE, bump = stages->pool_bump, NULL);
    if (ripples && bump)
        tp_shaders_add(water, TP_AT_SLOPE, ripple = stages->ripple_over, NULL);
    else if (ripples && stages->ripple_gentle && is_gentle(&frame->surface))
        tp_shaders_add(water, TP_AT_SLOPE, ripple = stages->ripple_gentle, NULL);
    else if (ripples)
        tp_shaders_add(water, TP_AT_SLOPE, ripple = stages->ripple, NULL);
    return bump || ripple;
}

bool tp_plan_add_layers(const tp_frame *frame, tp_shaders *water)
{
    const tp_stages *stages = &frame->kit->stage;
    const tp_layers *layers = &frame->shade.layers;
    bool added = layers->added[0].texture || layers->added[1].texture;
    bool linear = frame->scene->water.filter == TP_FILTER_LINEAR;

    if (layers->bend.texture && layers->strength > 0
        && (added || frame->shade.water.texture))
        tp_shaders_add_colour(water, stages->bend);
    tp_shaders_add_colour(water, texture_stage(frame, water, linear));
    if (added)
        tp_shaders_add_colour(water, linear ? stages->layers_linear : stages->layers);
    return tp_plan_add_bumps(frame, water);
}
