/* SPDX-License-Identifier: MIT */
/* Chooses the stages of haze, makes the horizon's colours, and estimates the cost. */
#include "features/sky/sky.h"
#include "frame/frame.h"
#include "quality/prices.h"

/* A stage in every shader list except the sky's. */

enum { HAZE_FAST = TP_ENV_CUBE + 1 };   /* the first stages are in the order of tp_env_kind */

/* True if the fast stage needs the colours around the horizon. */
static bool needs_horizon(const tp_scene *scene)
{
    return scene->quality.haze == TP_RUNG_FAST && scene->sky.kind != TP_SKY_GRADIENT;
}

static void init_haze(tp_frame *frame, void *mine)
{
    tp_haze *haze = mine;

    haze->laid = needs_horizon(frame->scene);
    if (haze->laid)
        ((tp_horizon *)mine)->made_of.kind = -1;
}

static bool is_same_source(const tp_horizon_source *a, const tp_horizon_source *b)
{
    return a->kind == b->kind && a->level == b->level && a->beyond == b->beyond
        && a->lx == b->lx && a->ly == b->ly && a->lz == b->lz
        && tp_dome_config_equal(&a->dome, &b->dome);
}

/* Makes the horizon's colours if the sky or the light has changed. */
static void refresh_horizon(tp_horizon *horizon, const tp_shade *shade)
{
    const tp_env *env = &shade->env;
    tp_horizon_source source = {
        .kind = (int32_t)env->kind, .level = tp_env_mip_level(shade, env->kind, 0),
        .beyond = env->beyond,
    };

    if (env->kind == TP_ENV_DOME) {
        source.dome = env->dome->made_of;
        source.lx = shade->world.lx;
        source.ly = shade->world.ly;
        source.lz = shade->world.lz;
    }
    if (is_same_source(&source, &horizon->made_of))
        return;
    tp_horizon_make(horizon->colour, shade);
    horizon->made_of = source;
}

const struct tp_draw_horizon tp_draw_horizon = { refresh_horizon };

/* Without the horizon's colours the exact stages draw. */
static void begin_haze(tp_frame *frame, void *mine)
{
    tp_haze *haze = mine;

    TP_ASSERT(frame->projection.zi_near > 0);
    haze->scale =
        (uint32_t)tp_quotient((int64_t)frame->scene->sky.haze * 64, frame->projection.zi_near);
    haze->around = haze->laid && frame->shade.env.kind != TP_ENV_GRADIENT
                   && frame->scene->quality.haze == TP_RUNG_FAST
                   && frame->program->draw.horizon;
    if (haze->around)
        frame->program->draw.horizon->refresh(mine, &frame->shade);
}

/* Returns the stage for the kind of sky.  Without memory for the horizon's colours the fast
 * stage draws below the gradient only. */
static tp_stage select_haze_stage(const tp_frame *frame, const tp_haze *haze,
                                  const tp_stage *stage)
{
    const tp_env_kind kind = frame->shade.env.kind;

    if (frame->scene->quality.haze == TP_RUNG_FAST && stage[HAZE_FAST]
        && (haze->around || kind == TP_ENV_GRADIENT))
        return stage[HAZE_FAST];
    return stage[kind];
}

/* Under water there is no haze. */
static void add_haze_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                           tp_shaders *list)
{
    if (list->kind != TP_LIST_SKY && !frame->under)
        tp_shaders_add(list, TP_AT_AIR, select_haze_stage(frame, mine, stage), mine);
}

/* -- the module haze ----------------------------------------------------------------- */

bool tp_haze_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->sky.haze > 0;
}

static void *layout_haze(tp_arena *arena, const tp_module_conditions *conditions)
{
    const bool fast = needs_horizon(conditions->scene);

    return tp_arena_alloc(arena, 1, fast ? sizeof(tp_horizon) : sizeof(tp_haze));
}

const tp_module tp_haze_module = {
    .name = "haze", .id = TP_HAZE_ID, .trait = TP_TRAIT_haze, .enabled = tp_haze_enabled,
};

const tp_drawing tp_haze_drawing = {
    .layout = layout_haze, .init = init_haze, .begin = begin_haze,
    .stages = add_haze_stage,
};

/* -- cost ---------------------------------------------------------------------------- */

/* Haze over solids.  With a dome or a cube haze costs more, over water too. */
static void count_haze_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    uint32_t *work = w->fixed_cost.of;

    work[TP_WORK_haze] = px->solid;
    work[TP_WORK_haze_dome] = w->is & TP_MODULE_DOME ? px->water + px->solid : 0;
    work[TP_WORK_haze_cube] = w->is & TP_MODULE_CUBE ? px->water + px->solid : 0;
}

const tp_cost tp_haze_cost = { .pixels = count_haze_pixel_work };
