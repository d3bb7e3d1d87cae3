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

void tp_plan_add(tp_plan *plan, tp_stage stage)
{
    int i = 0;
    if (!stage)
        plan->lacks++;
    while (plan->stage[i])
        i++;
    TP_ASSERT(i + 1 < TP_STAGES);
    plan->stage[i] = stage;
}

tp_stage tp_plan_pick(tp_plan *plan, tp_stage wanted, tp_stage plainer)
{
    if (wanted)
        return wanted;
    plan->lacks++;
    return plainer;
}

/* NULL: the kit has none. */
static tp_stage light_stage(const tp_frame *frame, tp_plan *water, bool rippled)
{
    const tp_stages *stages = &frame->kit->stage;
    tp_stage plain = rippled && stages->light_rippled ? stages->light_rippled
                                                      : stages->light;

    if (!stages->view)
        return NULL;
    if (frame->scene->light.model == TP_LIGHT_BLINN)
        return tp_plan_pick(water, rippled ? stages->light_blinn_rippled
                                           : stages->light_blinn, plain);
    return rippled ? tp_plan_pick(water, stages->light_rippled, plain) : plain;
}

/* Objects over it: what the scene asks for and had memory for at init. */
static void add_objects(const tp_frame *frame, tp_plan *water)
{
    const tp_stages *stages = &frame->kit->stage;
    const int kind = frame->scene->mirror.objects;

    if (kind == TP_MIRROR_STENCIL && frame->parts.mirrored.colour)
        tp_plan_add(water, stages->mirrored);
    if (kind == TP_MIRROR_CUBE && frame->parts.around.colour)
        tp_plan_add(water, stages->mirrored_cube);
}

static void add_mirror(const tp_frame *frame, tp_plan *water, bool rippled)
{
    const tp_stages *stages = &frame->kit->stage;

    if (!tp_frame_mirrors_apart(frame)) {
        tp_plan_add(water, stages->mirror);
        return;
    }
    if (!tp_frame_add_reflection(frame, water, rippled))
        return;
    add_objects(frame, water);
    tp_frame_add_fresnel(frame, water);
}

/* Light, and what needs a view besides; whether it has a glint. */
static bool add_light(tp_frame *frame, tp_plan *water, bool rippled, bool shines)
{
    const tp_scene  *scene = frame->scene;
    const tp_stages *stages = &frame->kit->stage;
    bool mirrors = scene->water.reflection > 0, clear = scene->water.clear > 0;
    tp_stage light = NULL;

    if (shines || mirrors || clear)
        light = tp_plan_pick(water, light_stage(frame, water, rippled), NULL);
    if (!light) {
        tp_plan_add(water, rippled ? stages->diffuse_rippled : stages->diffuse);
        return false;
    }
    tp_plan_add(water, stages->view);
    tp_plan_add(water, light);
    if (clear && frame->kit->draw.inside)
        tp_plan_add(water, frame->kit->draw.inside->behind(frame, rippled));
    if (mirrors)
        add_mirror(frame, water, rippled);
    return shines;
}

/* The water's list: a view only if it shines or mirrors. */
static void choose_water(tp_frame *frame)
{
    const tp_stages *stages = &frame->kit->stage;
    tp_plan *water = &frame->water;
    bool shines = frame->scene->water.specular > 0;

    *water = (tp_plan){ .lacks = 0 };
    if (frame->rungs.shading == TP_SHADING_QUICK && frame->kit->draw.quick_light
        && frame->kit->draw.quick_light->plan(frame, water)) {
        tp_frame_add_air(frame, water);
        return;
    }
    bool rippled = tp_plan_add_layers(frame, water);
    shines = add_light(frame, water, rippled, shines);
    if (frame->kit->draw.foam && tp_world_foam(frame->world))
        tp_plan_add(water, frame->kit->draw.foam->stage(frame, rippled, shines));
    if (shines)
        tp_plan_add(water, stages->glint);
    tp_frame_add_air(frame, water);
}

static tp_plan plan_of(tp_stage wanted, tp_stage plainer)
{
    return (tp_plan){ .stage = { wanted ? wanted : plainer } };
}

static void choose_stages(tp_frame *frame)
{
    const tp_stages *stages = &frame->kit->stage;
    const bool blinn = frame->scene->light.model == TP_LIGHT_BLINN;
    const bool ground = frame->kit->draw.inside
                     && (frame->assets.floor_texture || frame->scene->water.clear > 0);

    frame->sky = (tp_plan){ .lacks = 0 };
    tp_frame_add_sky(frame, &frame->sky);
    tp_frame_add_exposure(frame, &frame->sky);
    frame->solids = plan_of(blinn ? stages->solid_blinn : stages->solid, stages->solid);
    frame->land = plan_of(ground ? stages->ground : stages->land, stages->land);
    frame->drops = plan_of(stages->drop, NULL);
    frame->tank = plan_of(stages->wall, NULL);
    frame->side = plan_of(stages->side, NULL);
    frame->spray = plan_of(stages->spray, NULL);
    tp_frame_add_air(frame, &frame->solids);
    tp_frame_add_air(frame, &frame->land);
    tp_frame_add_air(frame, &frame->drops);
    tp_frame_add_air(frame, &frame->tank);
    tp_frame_add_air(frame, &frame->side);
    tp_frame_add_air(frame, &frame->spray);
    choose_water(frame);
    frame->stats.dropped += frame->sky.lacks + frame->water.lacks;
}

void tp_frame_plan(tp_frame *frame)
{
    TP_ASSERT(frame->lens.zi_near > 0 && frame->scene->sky.haze >= 0);
    const tp_scene *scene = frame->scene;
    const tp_draws *draw = &frame->kit->draw;
    tp_shade *shade = &frame->shade;

    tp_sight_look(frame, &frame->lens);
    shade->haze_scale = (uint32_t)((int64_t)scene->sky.haze * 64 / frame->lens.zi_near);
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
    if (frame->assets.boat)
        draw->boat->plan(frame);
    shade->land = (tp_solid){ .diffuse = (uint32_t)scene->floor.colour,
                              .gloss = tp_drop_gloss };
    shade->drop = (tp_solid){ .diffuse = (uint32_t)scene->drops.colour,
                              .specular = 0xffffff, .gloss = tp_drop_gloss };
    if (draw->foam)
        draw->foam->plan(frame);
    choose_stages(frame);
    if (draw->inside)
        draw->inside->plan(frame);
}
