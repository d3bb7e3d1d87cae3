/* SPDX-License-Identifier: MIT */
/* The sky's and the camera's part of a plan: tables of a scene that has more than the
 * plain gradient, and which stages look into them. */
#include "frame/frame.h"
#include "scene/light.h"

/* A kind that the scene takes up later has no tables here: it stays the gradient. */
void tp_frame_carve_sky(tp_frame_parts *parts, tp_arena *arena, const tp_kit *kit,
                        const tp_scene *scene, const tp_assets *assets)
{
    const tp_draws *draw = &kit->draw;
    tp_frame_sky *sky = &parts->heaven;
    bool cube = tp_frame_wants(parts, tp_has_cube(scene, assets), draw->cube);
    bool stars = tp_frame_wants(parts, scene->sky.kind == TP_SKY_NIGHT, draw->stars);

    if (tp_frame_wants(parts, tp_has_dome(scene), draw->dome))
        sky->dome = tp_arena_take(arena, 1, sizeof *sky->dome);
    if (sky->dome)
        sky->dome->made_of.sun = -1;    /* of nothing yet */
    if (cube)
        sky->cube = tp_arena_take(arena, 1, sizeof *sky->cube);
    if (cube || stars)
        sky->recip = tp_arena_take(arena, TP_RECIP + 2, sizeof *sky->recip);
}

void tp_frame_init_sky(tp_frame *frame)
{
    const tp_draws *draw = &frame->kit->draw;

    if (frame->parts.heaven.cube)
        draw->cube->init(frame);
    else if (frame->parts.heaven.recip)
        draw->stars->init(frame);
}

static void init_cube(tp_frame *frame)
{
    tp_cube_init(frame->parts.heaven.cube, frame->assets.sky);
    tp_recip_init(frame->parts.heaven.recip);
}

static void init_stars(tp_frame *frame)
{
    tp_recip_init(frame->parts.heaven.recip);
}

/* -- each frame ----------------------------------------------------------------------- */

static bool is_same(const tp_dome_config *a, const tp_dome_config *b)
{
    return a->kind == b->kind && a->horizon == b->horizon && a->zenith == b->zenith
        && a->light == b->light && a->sun == b->sun;
}

static void plan_dome(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    const tp_dome_config config = tp_dome_of(scene);

    if (!is_same(&config, &frame->parts.heaven.dome->made_of))
        tp_dome_init(frame->parts.heaven.dome, &config);
    if (scene->water.specular > 0)      /* the disc's image is the glitter */
        frame->shade.env.least = TP_DISC_END;
    frame->shade.env.kind = TP_ENV_DOME;
    frame->shade.env.dome = frame->parts.heaven.dome;
}

/* A face spans 90 degrees: half its texels to the tangent 1. */
static void plan_cube(tp_frame *frame)
{
    tp_cube *cube = frame->parts.heaven.cube;
    int32_t  focal = tp_log2_q8((uint32_t)frame->lens.focal) - 16 * 256;

    cube->lod = (cube->face[0]->log2_w - 1) * 256 - focal;
    frame->shade.env.kind = TP_ENV_CUBE;
    frame->shade.env.cube = cube;
}

/* Stars are 0.85 pixels in radius, a pixel being 65536 / 2 / focal of a face's units;
 * within the margin that they keep in their cells. */
static void plan_stars(tp_frame *frame)
{
    TP_ASSERT(frame->shade.env.recip != NULL);
    uint32_t focal = (uint32_t)frame->lens.focal >> 16;
    uint32_t radius = 32768 * 85 / 100 / (focal > 110 ? focal : 110);

    radius = radius > 8 ? radius : 8;
    frame->shade.env.stars = (uint32_t)frame->scene->sky.stars >> 10;
    frame->shade.env.star = (1u << 24) / (radius * radius);
}

static void plan_fresnel(tp_frame *frame)
{
    const bool shortcut = frame->scene->water.fresnel == TP_FRESNEL_SCHLICK;
    frame->shade.fresnel = shortcut ? tp_schlick_table : tp_fresnel_table;
}

/* Glitter of the water, by the light's model. */
static void plan_glint(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;

    if (scene->light.model == TP_LIGHT_BLINN)
        tp_shade_shine_blinn(&frame->shade, scene->water.shininess,
                             scene->water.specular);
    else
        tp_shade_shine(&frame->shade, scene->water.shininess, scene->water.specular);
}

const struct tp_draw_dome tp_draw_dome = { plan_dome };
const struct tp_draw_cube tp_draw_cube = { init_cube, plan_cube };
const struct tp_draw_stars tp_draw_stars = { init_stars, plan_stars };
const struct tp_draw_fresnel tp_draw_fresnel = { plan_fresnel };
const struct tp_draw_glint tp_draw_glint = { plan_glint };

void tp_frame_plan_sky(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    static const tp_entry8 none[257] = { 0 };
    const tp_draws *draw = &frame->kit->draw;
    tp_shade *shade = &frame->shade;

    shade->fresnel = none;
    if (draw->fresnel)
        draw->fresnel->plan(frame);
    tp_shade_sky(shade, (uint32_t)scene->sky.horizon, (uint32_t)scene->sky.zenith);
    shade->env = (tp_env){ .recip = frame->parts.heaven.recip,
                           .beyond = (uint32_t)scene->hdr.share * TP_WHITES >> 8 };
    if (tp_has_dome(scene) && frame->parts.heaven.dome)
        draw->dome->plan(frame);
    else if (scene->sky.kind == TP_SKY_CUBE && frame->parts.heaven.cube)
        draw->cube->plan(frame);
    if (scene->sky.kind == TP_SKY_NIGHT && frame->parts.heaven.recip && draw->stars)
        draw->stars->plan(frame);
}

/* -- stages ---------------------------------------------------------------------------- */

void tp_frame_add_sky(const tp_frame *frame, tp_shaders *plan)
{
    const tp_stages *stages = &frame->kit->stage;
    const tp_env *env = &frame->shade.env;
    tp_stage sky = stages->sky;

    if (env->kind == TP_ENV_DOME)
        sky = env->beyond ? stages->sky_dome_hdr
            : frame->rungs.shading == TP_SHADING_QUICK && env->stars == 0
              && stages->quick_sky_dome ? stages->quick_sky_dome : stages->sky_dome;
    else if (env->kind == TP_ENV_CUBE)
        sky = env->beyond ? stages->sky_cube_hdr : stages->sky_cube;
    tp_shaders_add_colour(plan, tp_shaders_pick(plan, sky, stages->sky));
    if (env->kind == TP_ENV_DOME && env->stars > 0 && sky)
        tp_shaders_add_colour(plan, stages->stars);
}

/* The plain gradient has no light beyond white; only objects in the mirror ask for more
 * than the fused stage. */
bool tp_frame_mirrors_apart(const tp_frame *frame)
{
    return frame->shade.env.kind != TP_ENV_GRADIENT
        || frame->scene->mirror.objects != TP_MIRROR_NONE;
}

/* What mirrors nothing of the sky mirrors no objects either. */
bool tp_frame_add_reflection(const tp_frame *frame, tp_shaders *plan, bool rippled)
{
    const tp_stages *stages = &frame->kit->stage;
    const tp_env_kind kind = frame->shade.env.kind;
    const tp_stage wanted = kind == TP_ENV_DOME ? stages->reflect_dome
                          : kind == TP_ENV_CUBE ? stages->reflect_cube
                                                : stages->reflect_gradient;
    const tp_stage found = tp_shaders_pick(plan, wanted, stages->reflect_gradient);

    if (!found || !stages->fresnel || (!rippled && !stages->slopes)) {
        plan->lacks++;
        return false;
    }
    if (!rippled)
        tp_shaders_add(plan, TP_AT_REFLECT, stages->slopes, NULL);
    tp_shaders_add(plan, TP_AT_REFLECT, found, NULL);
    return true;
}

void tp_frame_add_fresnel(const tp_frame *frame, tp_shaders *plan)
{
    const tp_stages *stages = &frame->kit->stage;
    const bool hdr = frame->shade.env.beyond && stages->fresnel_hdr;

    tp_shaders_add(plan, TP_AT_FRESNEL, hdr ? stages->fresnel_hdr : stages->fresnel, NULL);
}
