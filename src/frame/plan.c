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
    while (plan->stage[i])
        i++;
    plan->stage[i] = stage;
}

static tp_stage light_stage(const tp_frame *frame, bool rippled)
{
    if (frame->scene->light.model == TP_LIGHT_BLINN)
        return rippled ? tp_stage_light_blinn_rippled : tp_stage_light_blinn;
    return rippled ? tp_stage_light_rippled : tp_stage_light;
}

/* Objects over it: what the scene asks for and had memory for at init. */
static void add_objects(const tp_frame *frame, tp_plan *water)
{
    const int kind = frame->scene->mirror.objects;

    if (kind == TP_MIRROR_STENCIL && frame->parts.mirrored.colour)
        tp_plan_add(water, tp_stage_mirrored);
    if (kind == TP_MIRROR_CUBE && frame->parts.around.colour)
        tp_plan_add(water, tp_stage_mirrored_cube);
}

static void add_mirror(const tp_frame *frame, tp_plan *water, bool rippled)
{
    if (!tp_frame_mirrors_apart(frame)) {
        tp_plan_add(water, tp_stage_mirror);
        return;
    }
    if (!rippled)
        tp_plan_add(water, tp_stage_slopes);
    tp_frame_add_reflection(frame, water);
    add_objects(frame, water);
    tp_frame_add_fresnel(frame, water);
}

/* The water's list: a view only if it shines or mirrors. */
static void choose_water(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    tp_plan *water = &frame->water;
    bool shines = scene->water.specular > 0, mirrors = scene->water.reflection > 0;
    bool clear = scene->water.clear > 0;

    *water = (tp_plan){ { NULL } };
    bool rippled = tp_plan_add_layers(frame, water);
    if (shines || mirrors || clear) {
        tp_plan_add(water, tp_stage_view);
        tp_plan_add(water, light_stage(frame, rippled));
    } else {
        tp_plan_add(water, rippled ? tp_stage_diffuse_rippled : tp_stage_diffuse);
    }
    if (clear)
        tp_plan_add(water, tp_frame_behind_stage(frame, rippled));
    if (mirrors)
        add_mirror(frame, water, rippled);
    if (tp_world_foam(frame->world))
        tp_plan_add(water, tp_frame_foam_stage(rippled, shines));
    if (shines)
        tp_plan_add(water, tp_stage_glint);
    tp_frame_add_air(frame, water);
}

static void choose_stages(tp_frame *frame)
{
    const bool blinn = frame->scene->light.model == TP_LIGHT_BLINN;
    const bool ground = frame->assets.floor_texture || frame->scene->water.clear > 0;

    frame->sky = (tp_plan){ { NULL } };
    tp_frame_add_sky(frame, &frame->sky);
    tp_frame_add_exposure(frame, &frame->sky);
    frame->solids = (tp_plan){ { blinn ? tp_stage_solid_blinn : tp_stage_solid } };
    frame->land = (tp_plan){ { ground ? tp_stage_ground : tp_stage_land } };
    frame->drops = (tp_plan){ { tp_stage_drop } };
    frame->tank = (tp_plan){ { tp_stage_wall } };
    frame->side = (tp_plan){ { tp_stage_side } };
    frame->spray = (tp_plan){ { tp_stage_spray } };
    tp_frame_add_air(frame, &frame->solids);
    tp_frame_add_air(frame, &frame->land);
    tp_frame_add_air(frame, &frame->drops);
    tp_frame_add_air(frame, &frame->tank);
    tp_frame_add_air(frame, &frame->side);
    tp_frame_add_air(frame, &frame->spray);
    choose_water(frame);
}

/* Glitter of the water, by the light's model. */
static void plan_shine(tp_shade *shade, const tp_scene *scene)
{
    if (scene->water.specular <= 0)
        return;
    if (scene->light.model == TP_LIGHT_BLINN)
        tp_shade_shine_blinn(shade, scene->water.shininess, scene->water.specular);
    else
        tp_shade_shine(shade, scene->water.shininess, scene->water.specular);
}

static void plan_materials(tp_frame *frame)
{
    const tp_mesh *mesh = frame->assets.boat;
    uint32_t count = tp_frame_materials(&frame->assets);

    for (uint32_t i = 0; i < count; i++) {
        const tp_material *m = &mesh->materials[i];
        tp_fx texels = tp_fx_div(m->texels, frame->scene->boat.scale);
        frame->parts.solid[i] = (tp_solid){
            .diffuse = m->diffuse,
            .specular = m->specular,
            .lod = tp_frame_lod(frame, texels, false) + 96,  /* one texel: grain glitters */
            .bump = tp_clamp(m->bump, -16 * TP_FX_ONE, 16 * TP_FX_ONE) >> 8,
            .diffuse_map = m->diffuse_map,
            .normal_map = m->normal_map,
            .gloss = frame->parts.gloss + (size_t)i * TP_GLOSS,
        };
    }
}

void tp_frame_plan(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    tp_shade *shade = &frame->shade;

    tp_sight_look(frame, &frame->lens);
    shade->haze_scale = (uint32_t)((int64_t)scene->sky.haze * 64 / frame->lens.zi_near);
    shade->ambient = scene->light.ambient >> 8;
    shade->mirror = scene->water.reflection >> 8;
    shade->light_colour = (uint32_t)scene->light.colour;
    light_from(frame);
    tp_frame_plan_layers(frame);
    tp_frame_plan_sky(frame);
    plan_shine(shade, scene);
    if (frame->model != scene->light.model)
        tp_frame_make_gloss(frame);
    if (frame->assets.boat)
        plan_materials(frame);
    shade->land = (tp_solid){ .diffuse = (uint32_t)scene->floor.colour,
                              .gloss = frame->drop_gloss };
    shade->drop = (tp_solid){ .diffuse = (uint32_t)scene->drops.colour,
                              .specular = 0xffffff, .gloss = frame->drop_gloss };
    tp_frame_plan_foam(frame);
    choose_stages(frame);
    tp_frame_plan_depth(frame);
}
