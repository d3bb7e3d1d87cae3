/* SPDX-License-Identifier: MIT */
/* Capillary waves in a frame: their texture, its slope variance, and the choice of the
 * stage. */
#include "features/water/water.h"
#include "frame/frame.h"
#include "shade/rough_lobe.h"

typedef struct {
    tp_ripple look;             /* data of the stage; first member */
    tp_ripple_variance variance;
    const tp_texture *made_of;  /* texture of the variance; NULL: none yet */
} ripples;

static void *layout_ripple(tp_arena *arena, const tp_module_conditions *conditions)
{
    (void)conditions;
    return tp_arena_alloc(arena, 1, sizeof(ripples));
}

/* Returns the slopes of a normal; its z is at least 1/8. */
static tp_texel_slopes normal_slopes(uint32_t texel)
{
    const int32_t up = tp_clamp((int32_t)(texel & 0xff) - 128, 16, 127);

    return (tp_texel_slopes){ ((int32_t)(texel >> 16 & 0xff) - 128) * 4096 / up,
                              ((int32_t)(texel >> 8 & 0xff) - 128) * 4096 / up };
}

/* Sums up a texture that is new. */
static void sum_variance(ripples *own, const tp_texture *texture)
{
    if (texture && own->made_of != texture)
        tp_ripple_variance_init(&own->variance, texture, normal_slopes);
    own->made_of = texture;
}

static void init_ripple(tp_frame *frame, void *mine)
{
    ((ripples *)mine)->made_of = NULL;
    sum_variance(mine, frame->assets.ripple);
}

/* Sets the variance of this frame. */
static void begin_variance(tp_frame *frame, ripples *own)
{
    sum_variance(own, own->look.layer.texture);
    if (!own->made_of || !frame->scene->water.rough)
        return;
    own->variance.gain_square = (uint32_t)(own->look.gain * own->look.gain);
    own->variance.lod = own->look.layer.lod;
    frame->shade.ripple = &own->variance;
}

static void begin_ripple(tp_frame *frame, void *mine)
{
    const tp_scene *scene = frame->scene;
    tp_ripple *ripple = mine;

    ripple->layer = tp_frame_layer(frame, frame->assets.ripple, &scene->ripple.map);
    ripple->gain = scene->ripple.bump >> 8;
    begin_variance(frame, mine);
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
static void add_ripple_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
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
    .layout = layout_ripple, .init = init_ripple, .begin = begin_ripple,
    .stages = add_ripple_stage,
};
