/* SPDX-License-Identifier: MIT */
/*
 * The baked textures of fast water in a frame: their parameters, their memory, and the maps
 * of a picture.
 */
#include "base/base.h"
#include "features/water/fast_water_textures.h"
#include "frame/tools.h"

/* The assets contain a texture already baked, or the frame bakes the texture into its own
 * block, again whenever a parameter of the texture has changed. */

enum { OFFSETS = TP_LAYERS, SLOPES };

static const tp_texture *source_texture(const tp_assets *assets, int i)
{
    return i == OFFSETS ? assets->distortion : i == SLOPES ? assets->ripple
         : assets->layer[i];
}

static const tp_texture *baked_texture(const tp_assets *assets, int i)
{
    return i == OFFSETS ? assets->baked_offset : i == SLOPES ? assets->baked_slope
         : assets->baked_layer[i];
}

void tp_fast_textures_layout(tp_fast_textures *textures, tp_arena *arena,
                             const tp_assets *assets)
{
    for (int i = 0; i < TP_BAKED_LAYERS; i++) {
        const tp_texture *source = source_texture(assets, i);
        const bool made_here = source && !baked_texture(assets, i);
        textures->memory[i] =
            made_here ? tp_arena_alloc(arena, 1, tp_quick_bytes(source)) : NULL;
    }
}

void tp_fast_textures_init(tp_fast_textures *textures)
{
    for (int i = 0; i < TP_BAKED_LAYERS; i++)
        textures->picture[i].levels = 0;
}

/* -- parameters of baked textures ---------------------------------------------------- */

/* Returns the colour of layer i.  The base layer includes the water's colour, as in
 * water_drawing.c. */
static uint32_t layer_colour(const tp_scene *scene, const tp_assets *assets, int i)
{
    const uint32_t colour = (uint32_t)scene->layer[i].colour;

    if (i > 0)
        return colour;
    return assets->layer[0] ? tp_colour_times((uint32_t)scene->water.colour, colour)
                            : (uint32_t)scene->water.colour;
}

/* Returns the parameters to bake texture i with: a layer, OFFSETS or SLOPES. */
static tp_quick_wish bake_parameters(const tp_scene *scene, const tp_assets *assets, int i)
{
    if (i == OFFSETS)
        return (tp_quick_wish){ .amount = scene->distortion.strength };
    if (i == SLOPES)
        return (tp_quick_wish){ .amount = scene->ripple.bump };
    return (tp_quick_wish){
        .amount = scene->layer[i].saturation, .clamp = scene->layer[i].clamp,
        .colour = layer_colour(scene, assets, i),
    };
}

static bool is_same(const tp_quick_wish *a, const tp_quick_wish *b)
{
    return a->amount == b->amount && a->clamp == b->clamp && a->colour == b->colour;
}

static void bake_texture(tp_texture *to, int i, const tp_texture *source,
                         const tp_quick_wish *wish, void *memory)
{
    if (i == OFFSETS)
        tp_quick_offsets(to, source, wish->amount, memory);
    else if (i == SLOPES)
        tp_quick_slopes(to, source, wish->amount, memory);
    else
        tp_quick_graded(to, source, wish->amount, wish->clamp, wish->colour, memory);
}

size_t tp_baked_layer_bytes(const tp_assets *assets, int i)
{
    TP_ASSERT(assets != NULL && i >= 0 && i < TP_BAKED_LAYERS);
    const tp_texture *source = source_texture(assets, i);
    return source ? tp_quick_bytes(source) : 0;
}

void tp_bake_layer(tp_texture *to, const tp_scene *scene, const tp_assets *assets, int i,
                   void *memory)
{
    TP_ASSERT(i >= 0 && i < TP_BAKED_LAYERS);
    const tp_quick_wish wish = bake_parameters(scene, assets, i);
    bake_texture(to, i, source_texture(assets, i), &wish, memory);
}

static const tp_texture *update_texture(const tp_frame *frame, tp_fast_textures *textures,
                                        int i)
{
    const tp_quick_wish wish = bake_parameters(frame->scene, &frame->assets, i);

    if (textures->picture[i].levels == 0 || !is_same(&textures->made[i], &wish))
        bake_texture(&textures->picture[i], i, source_texture(&frame->assets, i), &wish,
                     textures->memory[i]);
    textures->made[i] = wish;
    return &textures->picture[i];
}

const struct tp_draw_baking tp_draw_baking = { update_texture };

/* Returns the baked texture i, baked now if needed; NULL: none. */
static const tp_texture *provide_baked_texture(const tp_frame *frame,
                                               tp_fast_textures *textures, int i)
{
    const struct tp_draw_baking *baking = frame->program->draw.baking;

    if (baked_texture(&frame->assets, i))
        return baked_texture(&frame->assets, i);
    return textures->memory[i] && baking ? baking->update(frame, textures, i) : NULL;
}

/* Returns the number of textures that the program cannot bake. */
static uint32_t count_unbaked(const tp_fast_textures *textures, const tp_frame *frame)
{
    uint32_t count = 0;

    for (int i = 0; i < TP_BAKED_LAYERS; i++)
        count += textures->memory[i] != NULL;
    return frame->program->draw.baking ? 0 : count;
}

/* Returns baked texture i, placed on the water as `map` says; `lod_bias` is added to the
 * level of detail of the frame. */
static tp_quick_map make_baked_map(const tp_frame *frame, tp_fast_textures *textures,
                                   int texture_index, const tp_scene_map *map,
                                   int32_t lod_bias)
{
    tp_layer layer =
        tp_frame_layer(frame, provide_baked_texture(frame, textures, texture_index), map);

    layer.lod += lod_bias;
    return tp_quick_map_make(&layer);
}

uint32_t tp_fast_textures_begin(tp_fast_textures *textures, const tp_frame *frame,
                                tp_quick_layers *layers)
{
    const tp_scene *scene = frame->scene;

    for (int k = 0; k < TP_LAYERS; k++)
        layers->layer[k] = make_baked_map(frame, textures, k, &scene->layer[k].map, 0);
    layers->bend = make_baked_map(frame, textures, OFFSETS, &scene->distortion.map, 0);
    layers->ripple =        /* a bilinear look-up blurs as the exact stages do */
        make_baked_map(frame, textures, SLOPES, &scene->ripple.map,
                       scene->quality.ripple <= TP_RUNG_EXACT ? 0 : TP_RIPPLE_LOD);
    return count_unbaked(textures, frame);
}
