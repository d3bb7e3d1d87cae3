/* SPDX-License-Identifier: MIT */
/* Draws a generated sky.  Its tables are rebuilt when the scene's sky numbers have
 * changed. */
#include "features/sky/sky.h"
#include "frame/frame.h"

/* Indices in the program's table of stages. */
enum { EMPTY, EMPTY_HDR, EMPTY_QUICK, REFLECT };

static bool is_same(const tp_dome_config *a, const tp_dome_config *b)
{
    return a->kind == b->kind && a->horizon == b->horizon && a->zenith == b->zenith
        && a->light == b->light && a->sun == b->sun;
}

static void init(tp_frame *frame, void *mine)
{
    tp_dome *dome = mine;

    (void)frame;
    dome->made_of.sun = -1;     /* tables not built yet */
}

static void begin(tp_frame *frame, void *mine)
{
    const tp_scene *scene = frame->scene;
    const tp_dome_config config = tp_dome_config_make(scene);
    tp_dome *dome = mine;
    tp_env  *env = &frame->shade.env;

    if (!is_same(&config, &dome->made_of))
        tp_dome_init(dome, &config);
    if (scene->water.specular > 0)      /* the glitter is the disc's reflection */
        env->least = TP_DISC_END;
    env->kind = TP_ENV_DOME;
    env->dome = dome;
}

/* Returns the stage of the visible sky.  The fast stage does not compute the view vectors
 * needed by stars, so stars exclude the fast stage. */
static tp_stage select_sky_stage(const tp_frame *frame, const tp_stage *stage)
{
    const tp_env *env = &frame->shade.env;

    if (env->beyond)
        return stage[EMPTY_HDR];
    if (frame->rungs.shading == TP_SHADING_QUICK && env->stars == 0 && stage[EMPTY_QUICK])
        return stage[EMPTY_QUICK];
    return stage[EMPTY];
}

static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    if (list->kind == TP_LIST_SKY && !frame->under)
        tp_shaders_add(list, TP_AT_COLOUR, select_sky_stage(frame, stage), mine);
    if (tp_frame_reflects_sky(frame, list))
        tp_shaders_add(list, TP_AT_REFLECT, stage[REFLECT], mine);
}

/* -- the module ---------------------------------------------------------------------- */

bool tp_sky_dome_enabled(const tp_want *want)
{
    return tp_has_dome(want->scene);
}

static void *layout(tp_arena *arena, const tp_want *want)
{
    (void)want;
    return tp_arena_alloc(arena, 1, sizeof(tp_dome));
}

const tp_module tp_sky_dome_module = {
    .name = "sky_dome", .id = TP_SKY_DOME_ID, .is = TP_MODULE_DOME,
    .trait = TP_TRAIT_dome, .enabled = tp_sky_dome_enabled,
};

const tp_drawing tp_sky_dome_drawing = {
    .layout = layout, .init = init, .begin = begin, .stages = add_stages,
};
