/* SPDX-License-Identifier: MIT */
/* Draws stars over a night's dome. */
#include "features/sky/sky.h"
#include "frame/frame.h"

typedef struct {
    uint32_t recip[TP_RECIP + 2];
} stars;

static void init(tp_frame *frame, void *mine)
{
    stars *s = mine;

    (void)frame;
    tp_recip_init(s->recip);
}

/* Sets the stars' count and size.  A star's radius is 0.85 px; a pixel is
 * 65536 / 2 / focal units of a face.  The radius stays within the margin of the stars'
 * cells. */
static void begin(tp_frame *frame, void *mine)
{
    const stars *s = mine;
    tp_env  *env = &frame->shade.env;
    uint32_t focal = (uint32_t)frame->projection.focal >> 16;
    uint32_t radius = 32768 * 85 / 100 / (focal > 110 ? focal : 110);

    radius = radius > 8 ? radius : 8;
    env->stars = (uint32_t)frame->scene->sky.stars >> 10;
    env->star = (1u << 24) / (radius * radius);
    env->recip = s->recip;
}

/* Adds the stars' stage.  It reads the view vectors of the dome's stage, which may be
 * missing. */
static void add_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    if (list->kind == TP_LIST_SKY && !frame->under && frame->shade.env.stars > 0
        && tp_shaders_has(list, TP_AT_COLOUR))
        tp_shaders_add(list, TP_AT_COLOUR, stage[0], mine);
}

/* -- the module ---------------------------------------------------------------------- */

bool tp_stars_enabled(const tp_want *want)
{
    return want->scene->sky.kind == TP_SKY_NIGHT && want->above & TP_MODULE_DOME;
}

static void *layout(tp_arena *arena, const tp_want *want)
{
    (void)want;
    return tp_arena_alloc(arena, 1, sizeof(stars));
}

const tp_module tp_stars_module = {
    .name = "stars", .id = TP_STARS_ID, .is = TP_MODULE_STARS,
    .enabled = tp_stars_enabled,
};

const tp_drawing tp_stars_drawing = {
    .layout = layout, .init = init, .begin = begin, .stages = add_stage,
};
