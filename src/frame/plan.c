/* SPDX-License-Identifier: MIT */
/* Shader lists of a frame and the numbers for their stages.  A list contains only stages
 * needed by the scene. */
#include "frame/frame.h"
#include "scene/light.h"

static void set_light_direction(tp_frame *frame)
{
    tp_view_axes *axes = &frame->shade.world;
    tp_dir3 light = tp_light_direction(frame->drawn.light_heading,
                                       frame->drawn.light_elevation);

    axes->lx = light.x >> 16;
    axes->ly = light.y >> 16;
    axes->lz = light.z >> 16;
}

/* Fills the water's list with fast stages if the plan says so and the program has all
 * stages for the picture; else with exact stages. */
static void fill_water_shaders(tp_frame *frame)
{
    tp_shaders *water = tp_frame_list(frame, TP_MARK_WATER);

    tp_shaders_clear(water);
    water->kind = TP_LIST_FAST;
    if (frame->rungs.shading == TP_SHADING_QUICK
        && tp_frame_has_module(frame, TP_MODULE_FAST))
        tp_frame_add_stages(frame, water);
    if (tp_shaders_has(water, TP_AT_COLOUR))
        return;
    tp_shaders_clear(water);
    water->kind = TP_LIST_WATER;
    tp_frame_add_stages(frame, water);
    if (!tp_shaders_has(water, TP_AT_COLOUR))
        tp_shaders_add_colour(water, frame->program->stage.plain);
}

/* Fills the water's list for the surface seen from below. */
static void fill_underside_shaders(tp_frame *frame)
{
    tp_shaders *water = tp_frame_list(frame, TP_MARK_WATER);

    tp_shaders_clear(water);
    water->kind = TP_LIST_UNDERSIDE;
    tp_shaders_add(water, TP_AT_VIEW, frame->program->stage.view, NULL);
    tp_frame_add_stages(frame, water);
}

/* Fills the sky's list.  A sky without a module becomes the gradient. */
static void fill_sky_shaders(tp_frame *frame)
{
    const bool named = tp_has_dome(frame->scene)
                    || tp_has_cube(frame->scene, &frame->assets);
    tp_shaders *sky = tp_frame_list(frame, TP_MARK_SKY);

    tp_shaders_clear(sky);
    tp_frame_add_stages(frame, sky);
    if (!tp_shaders_has(sky, TP_AT_COLOUR))
        tp_shaders_add_colour(sky, frame->program->stage.sky);
    if (named && frame->shade.env.kind == TP_ENV_GRADIENT)
        sky->lacks++;
}

/* Counts missing stages.  `base` is the name to report if no module lacks the stage. */
static void count_missing_stages(tp_frame *frame, const tp_shaders *list, uint8_t base)
{
    frame->stats.dropped += list->lacks;
    if (list->lacks && !frame->lacking)
        frame->lacking = list->lacking ? list->lacking : base;
}

static void fill_shader_lists(tp_frame *frame)
{
    fill_sky_shaders(frame);
    count_missing_stages(frame, tp_frame_list(frame, TP_MARK_SKY), TP_LACKING_SKY);
    tp_frame_fill_module_lists(frame);
    if (frame->under)
        fill_underside_shaders(frame);
    else
        fill_water_shaders(frame);
    count_missing_stages(frame, tp_frame_list(frame, TP_MARK_WATER), 0);
}

void tp_frame_plan_shaders(tp_frame *frame)
{
    TP_ASSERT(frame->projection.zi_near > 0);
    const tp_scene *scene = frame->scene;
    tp_shade *shade = &frame->shade;

    tp_view_set_shade(frame, &frame->projection);
    shade->ambient = scene->light.ambient >> 8;
    shade->mirror = scene->water.reflection >> 8;
    shade->light_colour = (uint32_t)scene->light.colour;
    set_light_direction(frame);
    shade->water_colour = (uint32_t)scene->water.colour;
    shade->shine = NULL;
    shade->fresnel = tp_fresnel_table;
    tp_shade_sky(shade, (uint32_t)scene->sky.horizon, (uint32_t)scene->sky.zenith);
    shade->env = (tp_env){ .beyond = (uint32_t)scene->hdr.share * TP_WHITES >> 8 };
    frame->tone_map = NULL;
    tp_frame_begin_modules(frame);
    fill_shader_lists(frame);
}
