/* SPDX-License-Identifier: MIT */
/* The plan of a frame: which stages, and the numbers that they read.  A stage that the
 * scene does not need is not in the list. */
#include "frame/frame.h"
#include "scene/light.h"

static void light_from(tp_frame *frame)
{
    tp_view_axes *axes = &frame->shade.world;
    tp_dir3 light = tp_light_direction(frame->drawn.light_heading,
                                       frame->drawn.light_elevation);

    axes->lx = light.x >> 16;
    axes->ly = light.y >> 16;
    axes->lz = light.z >> 16;
}

/* NULL: the kit has none. */
static tp_stage light_stage(const tp_frame *frame, tp_shaders *water, bool rippled)
{
    const tp_stages *stages = &frame->kit->stage;
    tp_stage plain = rippled && stages->light_rippled ? stages->light_rippled
                                                      : stages->light;

    if (!stages->view)
        return NULL;
    if (frame->scene->light.model == TP_LIGHT_BLINN)
        return tp_shaders_pick(water, rippled ? stages->light_blinn_rippled
                                           : stages->light_blinn, plain);
    return rippled ? tp_shaders_pick(water, stages->light_rippled, plain) : plain;
}

static void add_mirror(const tp_frame *frame, tp_shaders *water, bool rippled)
{
    const tp_stages *stages = &frame->kit->stage;

    if (!tp_frame_mirrors_apart(frame)) {
        tp_shaders_add(water, TP_AT_FRESNEL, stages->mirror, NULL);
        return;
    }
    if (!stages->fresnel || (!rippled && !stages->slopes)) {
        water->lacks++;
        return;
    }
    if (!rippled)
        tp_shaders_add(water, TP_AT_SLOPE, stages->slopes, NULL);
    water->mirrors = true;
    if (frame->shade.env.kind == TP_ENV_GRADIENT)
        tp_shaders_add(water, TP_AT_REFLECT, stages->reflect_gradient, NULL);
}

/* A sky whose stage the program lacks is not mirrored. */
static void add_fresnel(const tp_frame *frame, tp_shaders *water)
{
    const tp_stages *stages = &frame->kit->stage;
    const bool hdr = frame->shade.env.beyond && stages->fresnel_hdr;

    if (tp_shaders_has(water, TP_AT_REFLECT))
        tp_shaders_add(water, TP_AT_FRESNEL, hdr ? stages->fresnel_hdr : stages->fresnel,
                       NULL);
}

/* Light, and what needs a view besides; whether it has a glint. */
static bool add_light(tp_frame *frame, tp_shaders *water, bool rippled, bool shines)
{
    const tp_scene  *scene = frame->scene;
    const tp_stages *stages = &frame->kit->stage;
    bool mirrors = scene->water.reflection > 0;
    tp_stage light = NULL;

    if (shines || mirrors || tp_frame_has_module(frame, TP_MODULE_VIEW))
        light = tp_shaders_pick(water, light_stage(frame, water, rippled), NULL);
    if (!light) {
        tp_shaders_add(water, TP_AT_LIGHT, rippled ? stages->diffuse_rippled
                                                   : stages->diffuse, NULL);
        return false;
    }
    tp_shaders_add(water, TP_AT_VIEW, stages->view, NULL);
    tp_shaders_add(water, TP_AT_LIGHT, light, NULL);
    if (mirrors)
        add_mirror(frame, water, rippled);
    return shines;
}

/* The water's list: a view only if it shines or mirrors. */
static void choose_water(tp_frame *frame)
{
    const tp_stages *stages = &frame->kit->stage;
    tp_shaders *water = tp_frame_list(frame, TP_MARK_WATER);

    tp_shaders_clear(water);
    water->kind = TP_LIST_WATER;
    if (frame->rungs.shading == TP_SHADING_QUICK && frame->kit->draw.quick_light
        && frame->kit->draw.quick_light->plan(frame, water)) {
        water->kind = TP_LIST_FAST;
        tp_frame_add_modules(frame, water);
        return;
    }
    water->rippled = tp_plan_add_layers(frame, water);
    water->shines = add_light(frame, water, water->rippled,
                              frame->scene->water.specular > 0);
    if (water->shines)
        tp_shaders_add(water, TP_AT_GLINT, stages->glint, NULL);
    tp_frame_add_modules(frame, water);
    add_fresnel(frame, water);
}

/* The surface from below. */
static void choose_below(tp_frame *frame)
{
    tp_shaders *water = tp_frame_list(frame, TP_MARK_WATER);

    tp_shaders_clear(water);
    water->kind = TP_LIST_BELOW;
    water->rippled = tp_plan_add_bumps(frame, water);
    tp_shaders_add(water, TP_AT_VIEW, frame->kit->stage.view, NULL);
    tp_frame_add_modules(frame, water);
}

/* A sky that the scene names and the program cannot draw is the gradient. */
static void choose_sky(tp_frame *frame)
{
    const bool named = tp_has_dome(frame->scene)
                    || tp_has_cube(frame->scene, &frame->assets);
    tp_shaders *sky = tp_frame_list(frame, TP_MARK_SKY);

    tp_shaders_clear(sky);
    tp_frame_add_modules(frame, sky);
    if (!tp_shaders_has(sky, TP_AT_COLOUR))
        tp_shaders_add_colour(sky, frame->kit->stage.sky);
    if (named && frame->shade.env.kind == TP_ENV_GRADIENT)
        sky->lacks++;
}

static void choose_stages(tp_frame *frame)
{
    choose_sky(frame);
    tp_frame_list_modules(frame);
    if (frame->under)
        choose_below(frame);
    else
        choose_water(frame);
    frame->stats.dropped += tp_frame_list(frame, TP_MARK_SKY)->lacks
                          + tp_frame_list(frame, TP_MARK_WATER)->lacks;
}

void tp_frame_plan(tp_frame *frame)
{
    TP_ASSERT(frame->lens.zi_near > 0);
    const tp_scene *scene = frame->scene;
    const tp_draws *draw = &frame->kit->draw;
    tp_shade *shade = &frame->shade;

    tp_sight_look(frame, &frame->lens);
    shade->ambient = scene->light.ambient >> 8;
    shade->mirror = scene->water.reflection >> 8;
    shade->light_colour = (uint32_t)scene->light.colour;
    light_from(frame);
    tp_frame_plan_layers(frame);
    if (frame->rungs.shading == TP_SHADING_QUICK
        && !(draw->quick_layers && draw->quick_layers->plan(frame)))
        frame->rungs.shading = TP_SHADING_EXACT;
    tp_frame_plan_sky(frame);
    if (draw->glint && scene->water.specular > 0)
        draw->glint->plan(frame);
    frame->toned = NULL;
    tp_frame_begin_modules(frame);
    choose_stages(frame);
}
