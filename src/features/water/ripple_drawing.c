/* SPDX-License-Identifier: MIT */
/* Capillary waves in a frame: their texture, its slope variance, and the choice of the
 * stage. */
#include "features/water/water.h"
#include "frame/frame.h"
#include "shade/rough_lobe.h"

typedef struct {
    tp_ripple look;             /* data of the stage; first member */
    tp_ripple_variance variance;
    tp_own_table *own;          /* sums of the texture; NULL: baked */
} ripples;

static void *layout_ripple(tp_arena *arena, const tp_module_conditions *conditions)
{
    ripples *made = tp_arena_alloc(arena, 1, sizeof *made);
    tp_own_table *own = tp_table_layout(arena, conditions->assets, TP_TABLE_ripples,
                                        sizeof made->variance.lost);

    if (made)
        made->own = own;
    return made;
}

/* Returns the slopes of a normal; its z is at least 1/8. */
static tp_texel_slopes normal_slopes(uint32_t texel)
{
    const int32_t up = tp_clamp((int32_t)(texel & 0xff) - 128, 16, 127);

    return (tp_texel_slopes){ ((int32_t)(texel >> 16 & 0xff) - 128) * 4096 / up,
                              ((int32_t)(texel >> 8 & 0xff) - 128) * 4096 / up };
}

static void make_sums(const tp_frame *frame, const void *from, void *entries)
{
    tp_ripple_variance made = { .levels = 0 };

    (void)from;
    tp_ripple_variance_init(&made, frame->assets.ripple, normal_slopes);
    memcpy(entries, made.lost, sizeof made.lost);
}

const struct tp_draw_ripple_sums tp_draw_ripple_sums = { { make_sums } };

/* Returns the sums of a texture. */
static const void *find_sums(tp_frame *frame, const ripples *own, const tp_texture *texture)
{
    const int32_t numbers[] = { texture->log2_w, texture->log2_h };

    return tp_frame_table(frame, TP_TABLE_ripples, own->own, numbers,
                          TP_TABLE_MAKER(frame->program->draw.ripple_sums), NULL);
}

/* Returns the texture whose sums are known: the ripples', or with baked sums that of their
 * baked slopes, which has the same sides; NULL: none. */
static const tp_texture *summed_texture(const tp_frame *frame, const ripples *own)
{
    const tp_assets *assets = &frame->assets;

    return assets->ripple ? assets->ripple : own->own ? NULL : assets->baked_slope;
}

/* Makes the sums before the first picture: they need all texels. */
static void init_ripple(tp_frame *frame, void *mine)
{
    const tp_texture *texture = summed_texture(frame, mine);

    if (texture && frame->scene->water.rough)
        find_sums(frame, mine, texture);
}

/* Sets the variance of this frame. */
static void begin_variance(tp_frame *frame, ripples *own, const tp_texture *texture)
{
    memcpy(own->variance.lost, find_sums(frame, own, texture), sizeof own->variance.lost);
    own->variance.levels = texture->levels;
    own->variance.gain_square = (uint32_t)(own->look.gain * own->look.gain);
    own->variance.lod = own->look.layer.lod;
    frame->shade.ripple = &own->variance;
}

static void begin_ripple(tp_frame *frame, void *mine)
{
    const tp_scene *scene = frame->scene;
    const tp_texture *texture = summed_texture(frame, mine);
    tp_ripple *ripple = mine;

    ripple->layer = tp_frame_layer(frame, texture, &scene->ripple.map);
    ripple->layer.texture = frame->assets.ripple;
    ripple->gain = scene->ripple.bump >> 8;
    if (texture && scene->water.rough)
        begin_variance(frame, mine, texture);
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
