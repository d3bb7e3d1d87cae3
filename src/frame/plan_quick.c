/* SPDX-License-Identifier: MIT */
/* The quick rung's plan for water: prepared pictures, then one stage of light, then air
 * and exposure.  It knows a sky's mirror, ripples and glints; what scenes ask for beyond
 * (objects in the mirror, foam, clear water, bumps of pools, light beyond white, smooth
 * water under a dome or a cube) they get by exact stages alone, as those hand on more
 * than a colour. */
#include "frame/parts.h"
#include "shade/quick_light.h"

static bool is_rippled(const tp_frame *frame)
{
    return frame->shade.quick_layers.ripple.level && frame->scene->ripple.bump > 0;
}

/* Smooth water would show the cells of a dome or a cube. */
static bool has_beyond(const tp_frame *frame)
{
    const tp_pool_bump *pool = frame->shade.bumps.pool;

    return frame->shade.env.beyond > 0
        || (frame->shade.env.kind != TP_ENV_GRADIENT && !is_rippled(frame))
        || pool[0].slope || pool[1].slope
        || tp_frame_has_module(frame, TP_MODULE_EXACT);
}

/* A dome's glow is in its lobe's table: it always has one. */
static tp_lobe lobe_of(const tp_frame *frame)
{
    if (frame->scene->water.specular <= 0 && frame->shade.env.kind != TP_ENV_DOME)
        return TP_LOBE_NONE;
    return frame->scene->light.model == TP_LIGHT_BLINN ? TP_LOBE_BLINN : TP_LOBE_PHONG;
}

static tp_stage stage_of(const tp_frame *frame, tp_lobe lobe)
{
    const tp_stages *s = &frame->kit->stage;
    const tp_stage stage[3][3] = {
        { s->quick_gradient, s->quick_gradient_phong, s->quick_gradient_blinn },
        { NULL,              s->quick_dome_phong,     s->quick_dome_blinn },
        { s->quick_cube,     s->quick_cube_phong,     s->quick_cube_blinn },
    };
    return stage[frame->shade.env.kind][lobe];
}

/* Light and mirror of every second column. */
static void add_halves(const tp_frame *frame, tp_shaders *water, tp_lobe lobe)
{
    const tp_stages *s = &frame->kit->stage;
    const tp_stage light[] = { s->quick_gradient_even, s->quick_dome_even,
                               s->quick_cube_even };
    const tp_stage rest[] = { s->quick_between, s->quick_glint_phong,
                              s->quick_glint_blinn };

    tp_plan_add_quick_layers(frame, water, true);
    tp_shaders_add_colour(water, light[frame->shade.env.kind]);
    tp_shaders_add_colour(water, rest[lobe]);
}

static void add_columns(const tp_frame *frame, tp_shaders *water, tp_lobe lobe)
{
    tp_plan_add_quick_layers(frame, water, false);
    tp_shaders_add_colour(water, stage_of(frame, lobe));
}

/* A stage reads what the one before left, so a list is whole or empty.  False: the kit
 * lacks a stage of it. */
static bool add_list(const tp_frame *frame, tp_shaders *water, tp_lobe lobe, bool halves)
{
    if (halves)
        add_halves(frame, water, lobe);
    else
        add_columns(frame, water, lobe);
    if (water->lacks == 0)
        return true;
    tp_shaders_clear(water);
    return false;
}

/* All that the tables are made of; of the camera's pitch, what a dome's lobe has of it. */
static void key_of(int32_t key[TP_QUICK_KEY], const tp_frame *frame, tp_lobe lobe)
{
    const tp_scene *scene = frame->scene;
    const tp_shade *shade = &frame->shade;
    const int32_t numbers[TP_QUICK_KEY] = {
        (int32_t)shade->env.kind, (int32_t)lobe, shade->world.lx, shade->world.ly,
        shade->world.lz, shade->mirror, scene->light.colour,
        scene->water.shininess, scene->water.specular, scene->water.fresnel,
        scene->sky.horizon, scene->sky.zenith, scene->sky.kind,
        shade->env.kind == TP_ENV_DOME ? (int32_t)tp_quick_share_at_sun(shade) : 0,
        (int32_t)shade->env.least, is_rippled(frame),
    };
    memcpy(key, numbers, sizeof numbers);
}

static void make_tables(tp_frame *frame, tp_lobe lobe)
{
    TP_ASSERT(frame->parts.quick_light != NULL);
    struct tp_quick_light *quick = frame->parts.quick_light;
    int32_t key[TP_QUICK_KEY];

    key_of(key, frame, lobe);
    frame->shade.quick = quick;
    if (memcmp(key, quick->made_for, sizeof key) == 0)
        return;
    memcpy(quick->made_for, key, sizeof key);
    tp_quick_light_init(quick, &frame->shade, lobe, frame->scene->water.specular > 0,
                        is_rippled(frame));
}

static void carve(tp_frame_parts *parts, tp_arena *arena)
{
    parts->quick_light = tp_arena_take(arena, 1, sizeof *parts->quick_light);
    if (parts->quick_light)
        parts->quick_light->made_for[0] = -1;
}

static bool plan(tp_frame *frame, tp_shaders *water)
{
    const tp_lobe lobe = lobe_of(frame);

    if (!frame->parts.quick_light || has_beyond(frame))
        return false;
    const bool halves = frame->rungs.rate == TP_RATE_COLOUR
                     && add_list(frame, water, lobe, true);
    if (!halves && !add_list(frame, water, lobe, false))
        return false;
    make_tables(frame, lobe);
    return true;
}

const struct tp_draw_quick_light tp_draw_quick_light = { carve, plan };
