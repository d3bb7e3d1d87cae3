/* SPDX-License-Identifier: MIT */
/* Textures of fast shading in a frame.  The assets contain a texture already baked, or
 * the frame bakes the texture into its own block, again whenever a parameter of the
 * texture has changed. */
#include "features/water/fast_water.h"
#include "features/water/grade.h"

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

void tp_quick_layout_pictures(void *memory[TP_BAKED_LAYERS], tp_arena *arena,
                              const tp_assets *assets)
{
    for (int i = 0; i < TP_BAKED_LAYERS; i++) {
        const tp_texture *source = source_texture(assets, i);
        const bool made_here = source && !baked_texture(assets, i);
        memory[i] = made_here ? tp_arena_alloc(arena, 1, tp_quick_bytes(source)) : NULL;
    }
}

/* -- parameters of baked textures ---------------------------------------------------- */

/* Returns the colour of layer i.  The base layer includes the water's colour, as in
 * layers_drawing.c. */
static uint32_t layer_colour(const tp_scene *scene, const tp_assets *assets, int i)
{
    const uint32_t colour = (uint32_t)scene->layer[i].colour;

    if (i > 0)
        return colour;
    return assets->layer[0] ? tp_colour_times((uint32_t)scene->water.colour, colour)
                            : (uint32_t)scene->water.colour;
}

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

/* Returns the baked texture i, baked now if needed; NULL: none. */
static const tp_texture *provide_baked_texture(const tp_frame *frame, tp_fast_water *fast,
                                               int i)
{
    const tp_quick_wish wish = bake_parameters(frame->scene, &frame->assets, i);

    if (baked_texture(&frame->assets, i))
        return baked_texture(&frame->assets, i);
    if (!fast->memory[i])
        return NULL;
    if (fast->picture[i].levels == 0 || !is_same(&fast->made[i], &wish))
        bake_texture(&fast->picture[i], i, source_texture(&frame->assets, i), &wish,
                     fast->memory[i]);
    fast->made[i] = wish;
    return &fast->picture[i];
}

static tp_quick_map make_map(const tp_frame *frame, tp_fast_water *fast, int i,
                             const tp_scene_map *map, int32_t lod)
{
    tp_layer layer = tp_frame_layer(frame, provide_baked_texture(frame, fast, i), map);

    layer.lod += lod;
    return tp_quick_map_make(&layer);
}

void tp_quick_begin_layers(tp_frame *frame, tp_fast_water *fast)
{
    const tp_scene *scene = frame->scene;
    tp_quick_layers *layers = &fast->layers;

    for (int k = 0; k < TP_LAYERS; k++)
        layers->layer[k] = make_map(frame, fast, k, &scene->layer[k].map, 0);
    layers->bend = make_map(frame, fast, OFFSETS, &scene->distortion.map, 0);
    layers->ripple = make_map(frame, fast, SLOPES, &scene->ripple.map, TP_RIPPLE_LOD);
}
