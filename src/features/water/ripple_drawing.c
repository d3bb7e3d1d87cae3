/* SPDX-License-Identifier: MIT */
/* Capillary waves: their normal map, and the choice of the stage that applies the map. */
#include "features/water/water.h"
#include "frame/frame.h"

static void *layout(tp_arena *arena, const tp_want *want)
{
    (void)want;
    return tp_arena_alloc(arena, 1, sizeof(tp_ripple));
}

static void begin(tp_frame *frame, void *mine)
{
    const tp_scene *scene = frame->scene;
    tp_ripple *ripple = mine;

    ripple->layer = tp_frame_layer(frame, frame->assets.ripple, &scene->ripple.map);
    ripple->layer.lod += TP_RIPPLE_LOD;
    ripple->gain = scene->ripple.bump >> 8;
}

/* True if slopes of the mesh are at most 1/4: sum kA / (1 - sum QkA). */
static bool is_gentle(const tp_surface *surface)
{
    const tp_deep_water *deep = surface->deep;
    int64_t tilt = 0;

    if (surface->coastal || tp_surface_has_rings_or_pools(surface))
        return false;
    for (uint32_t i = 0; i < deep->count; i++)
        tilt += deep->swell[i].tilt;
    return 4 * tilt <= (TP_Q30_ONE - deep->steepness_sum) >> 14;
}

/* Adds the ripple stage.  Ripples are applied after the slopes of pools. */
static void add_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    const tp_ripple *ripple = mine;
    tp_stage how = stage[TP_NTH_ripple];

    if (!tp_shaders_is_exact_water(list) || !ripple->layer.texture)
        return;
    if (list->rippled)
        how = stage[TP_NTH_ripple_pool_slopes];
    else if (stage[TP_NTH_ripple_gentle] && is_gentle(&frame->surface))
        how = stage[TP_NTH_ripple_gentle];
    tp_shaders_add(list, TP_AT_SLOPE, how, mine);
    list->rippled |= how != NULL;
}

const tp_drawing tp_ripple_drawing = {
    .layout = layout, .begin = begin, .stages = add_stage,
};
