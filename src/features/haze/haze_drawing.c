/* SPDX-License-Identifier: MIT */
/* Adds haze: a stage in every shader list except the sky's. */
#include "features/haze/haze.h"
#include "frame/frame.h"

static void begin(tp_frame *frame, void *mine)
{
    tp_haze *haze = mine;

    TP_ASSERT(frame->projection.zi_near > 0);
    haze->scale =
        (uint32_t)((int64_t)frame->scene->sky.haze * 64 / frame->projection.zi_near);
}

/* Adds the stage for the kind of sky; `stage` is in the order of tp_env_kind.  Under
 * water there is no haze. */
static void add_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    if (list->kind != TP_LIST_SKY && !frame->under)
        tp_shaders_add(list, TP_AT_AIR, stage[frame->shade.env.kind], mine);
}

/* -- the module ---------------------------------------------------------------------- */

bool tp_haze_enabled(const tp_want *want)
{
    return want->scene->sky.haze > 0;
}

static void *layout(tp_arena *arena, const tp_want *want)
{
    (void)want;
    return tp_arena_alloc(arena, 1, sizeof(tp_haze));
}

const tp_module tp_haze_module = {
    .name = "haze", .id = TP_HAZE_ID, .trait = TP_TRAIT_haze, .enabled = tp_haze_enabled,
};

const tp_drawing tp_haze_drawing = {
    .layout = layout, .begin = begin, .stages = add_stage,
};
