/* SPDX-License-Identifier: MIT */
/*
 * The shader list of fast water: baked textures and slopes, then one stage of light, or
 * two at half rate.
 */
#include "base/base.h"
#include "features/water/fast_water_textures.h"
#include "frame/frame.h"
#include "frame/tools.h"

/* -- data of a frame ----------------------------------------------------------------- */

typedef struct {
    tp_quick_layers layers;     /* data of the stages; first member */
    struct tp_quick_light light;
    tp_own_table *own;          /* light's tables; NULL: baked */
    uint32_t levels;            /* of roughness; in light's tables */
    tp_fast_textures textures;
} tp_fast_water;

/* -- tables of light ----------------------------------------------------------------- */

static bool has_ripples(const tp_frame *frame, const tp_quick_layers *layers)
{
    return layers->ripple.level && frame->scene->ripple.bump > 0;
}

/* True if a texture or a pool bends the normals of flat water. */
static bool bends_normals(const tp_frame *frame, const tp_quick_layers *layers)
{
    return has_ripples(frame, layers) || tp_frame_has_module(frame, TP_MODULE_SLOPES);
}

/* Returns the lobe.  A dome always needs a lobe, because its glow is in the lobe's
 * table. */
static tp_lobe select_lobe(const tp_frame *frame)
{
    if (frame->scene->water.specular <= 0 && frame->shade.env.kind != TP_ENV_DOME)
        return TP_LOBE_NONE;
    return frame->scene->light.model == TP_LIGHT_BLINN ? TP_LOBE_BLINN : TP_LOBE_PHONG;
}

/* Numbers that the makers of tables take beside those of the frame. */
typedef struct {
    uint32_t laid, levels;      /* levels of roughness: with memory; in use */
    bool     ripples;
} light_needs;

static void make_light(const tp_frame *frame, const void *from, void *entries)
{
    const light_needs *needs = from;
    const bool specular = frame->scene->water.specular > 0 && frame->shade.shine;
    tp_quick_rough *rough = entries;
    const tp_quick_tables to = { rough, (uint32_t *)(rough + needs->laid), needs->levels };

    tp_quick_light_init(&to, &frame->shade, select_lobe(frame), specular, needs->ripples);
    if (frame->shade.env.kind == TP_ENV_CUBE && frame->program->draw.cube_map)
        frame->program->draw.cube_map->fill(&to, &frame->shade);
}

const struct tp_draw_light tp_draw_light = { { make_light } };

enum { KIND = 0, LEVELS = 16 };     /* numbers of the tables */

/* Sets the tables by all numbers that they use.  The camera's pitch enters only through a
 * dome's share at the sun.  A program without the module `glint` has no table of glints. */
static void set_tables(tp_frame *frame, tp_fast_water *fast, bool ripples)
{
    const tp_scene *scene = frame->scene;
    const tp_shade *shade = &frame->shade;
    const uint32_t levels = fast->light.levels;
    const bool dome = shade->env.kind == TP_ENV_DOME;
    const light_needs needs = { fast->levels, levels, ripples };
    const int32_t numbers[] = {
        (int32_t)shade->env.kind, (int32_t)select_lobe(frame), shade->world.lx,
        shade->world.ly, shade->world.lz, shade->mirror, scene->light.colour,
        scene->water.shininess, scene->water.specular, scene->water.fresnel,
        scene->sky.horizon, scene->sky.zenith, scene->sky.kind,
        dome ? (int32_t)tp_quick_share_at_sun(shade) : 0, dome ? scene->sky.sun : 0,
        (int32_t)shade->env.least, (int32_t)levels << 1 | ripples,
        levels > 1 ? (int32_t)tp_quick_ripple_variance(shade) : 0,
        (int32_t)shade->env.beyond,
    };

    fast->light.rough = tp_frame_table(frame, TP_TABLE_light, fast->own, numbers,
                                       TP_TABLE_MAKER(frame->program->draw.light), &needs);
    fast->light.sky = (const uint32_t *)(fast->light.rough + fast->levels);
}

/* Sets the layers and tables of fast shading, if this picture uses fast shading. */
static void begin_fast_water(tp_frame *frame, void *mine)
{
    tp_fast_water *fast = mine;

    if (frame->rungs.shading != TP_SHADING_QUICK)
        return;
    frame->stats.dropped +=
        tp_fast_textures_begin(&fast->textures, frame, &fast->layers)
        + (frame->shade.env.kind == TP_ENV_CUBE && fast->own
           && !frame->program->draw.cube_map);
    const bool ripples = bends_normals(frame, &fast->layers);
    tp_frame_use_fresnel(frame);
    frame->shade.quick = &fast->light;
    fast->light.lit = tp_frame_has_module(frame, TP_MODULE_CLEAR);
    fast->light.levels =
        frame->shade.ripple || frame->shade.filtered ? fast->levels : 1;
    set_tables(frame, fast, ripples);
}

/* True if the assets have the tables of such a sky and so many levels. */
static bool has_baked_light(const tp_assets *assets, int env, uint32_t levels)
{
    const tp_table *baked = tp_assets_table(assets, TP_TABLE_light);

    return baked && baked->made_of[KIND] == env
           && baked->made_of[LEVELS] >> 1 == (int32_t)levels;
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    const uint32_t levels = conditions->scene->water.rough ? TP_QUICK_LEVELS : 1;
    tp_fast_water *fast = tp_arena_alloc(arena, 1, sizeof *fast);
    const int env = conditions->above & TP_MODULE_CUBE ? TP_ENV_CUBE
                  : conditions->above & TP_MODULE_DOME ? TP_ENV_DOME : TP_ENV_GRADIENT;
    const size_t bytes = levels * sizeof(tp_quick_rough)
                       + tp_quick_sky_words(env, levels) * sizeof(uint32_t);
    tp_own_table *own = has_baked_light(conditions->assets, env, levels)
                            ? NULL : tp_table_layout_own(arena, TP_TABLE_light, bytes);
    tp_fast_textures counted;

    if (fast) {
        fast->own = own;
        fast->levels = levels;
    }

    tp_fast_textures_layout(fast ? &fast->textures : &counted, arena, conditions->assets);
    return fast;
}

static void init(tp_frame *frame, void *mine)
{
    tp_fast_water *fast = mine;

    (void)frame;
    tp_fast_textures_init(&fast->textures);
}

/* -- the shader list ----------------------------------------------------------------- */

#define MOST 6                  /* maximum of stages in a list */

/* Stages; those from `light` on come after the stages of other modules that change slopes
 * and colours. */
typedef struct {
    tp_stage stage[MOST];
    uint32_t count, light;
    bool     halved;            /* true: the last stage lights every second column */
} chain;

static void append_stage(chain *c, tp_stage stage)
{
    TP_ASSERT(c->count < MOST);
    c->stage[c->count++] = stage;
}

/* True if the scene asks fast shading for bilinear textures, by a rung. */
static bool is_linear(const tp_frame *frame, int32_t rung)
{
    return rung <= TP_RUNG_EXACT && frame->scene->water.filter == TP_FILTER_LINEAR;
}

static tp_stage places_stage(const tp_stage *stage, bool bends, bool half_rate, bool linear)
{
    const int bend = linear ? TP_NTH_quick_bend_linear : TP_NTH_quick_bend;
    const int bend_thin = linear ? TP_NTH_quick_bend_linear_thin : TP_NTH_quick_bend_thin;

    return stage[bends ? half_rate ? bend_thin : bend
                       : half_rate ? TP_NTH_quick_still_thin : TP_NTH_quick_still];
}

static tp_stage layers_stage(const tp_stage *stage, bool half_rate, bool linear)
{
    const int layers = linear ? TP_NTH_quick_layers_linear : TP_NTH_quick_layers;
    const int thin = linear ? TP_NTH_quick_layers_linear_thin : TP_NTH_quick_layers_thin;

    return stage[half_rate ? thin : layers];
}

static tp_stage ripples_stage(const tp_frame *frame, const tp_stage *stage, bool ripples)
{
    const bool linear = frame->scene->quality.ripple <= TP_RUNG_EXACT;

    return stage[!ripples ? TP_NTH_quick_slopes
                 : linear ? TP_NTH_quick_ripple_linear : TP_NTH_quick_ripple];
}

/* Links the stages of colours and slopes.  `even_columns_only`: only even columns get
 * a colour. */
static void append_layer_stages(chain *c, const tp_frame *frame,
                                const tp_quick_layers *quick, const tp_stage *stage,
                                bool even_columns_only)
{
    const tp_scene_quality *quality = &frame->scene->quality;
    const bool layers = quick->layer[0].level || quick->layer[1].level
                     || quick->layer[2].level;
    const bool thin = even_columns_only || frame->rungs.rate == TP_RATE_LAYERS;
    const bool ripples = has_ripples(frame, quick);
    const bool bends = quick->bend.level && frame->scene->distortion.strength > 0;

    if (layers || ripples)
        append_stage(c, stage[TP_NTH_quick_mip_spans]);
    if (layers)
        append_stage(c, places_stage(stage, bends, thin,
                                     is_linear(frame, quality->distortion)));
    append_stage(c, even_columns_only ? stage[TP_NTH_quick_layers_even]
                    : !layers
                        ? frame->program->stage.plain
                        : layers_stage(stage, thin, is_linear(frame, quality->layers)));
    append_stage(c, ripples_stage(frame, stage, ripples));
    c->light = c->count;
}

static chain make_full_rate_chain(const tp_frame *frame, const tp_quick_layers *layers,
                                  const tp_stage *stage)
{
    static const uint8_t light[3][3] = {
        { TP_NTH_quick_gradient, TP_NTH_quick_gradient_phong,
          TP_NTH_quick_gradient_blinn },
        { 0 /* never */, TP_NTH_quick_dome_phong, TP_NTH_quick_dome_blinn },
        { TP_NTH_quick_cube, TP_NTH_quick_cube_phong, TP_NTH_quick_cube_blinn },
    };
    static const uint8_t half[3][3] = {
        { TP_NTH_quick_gradient_half, TP_NTH_quick_gradient_phong_half,
          TP_NTH_quick_gradient_blinn_half },
        { 0 /* never */, TP_NTH_quick_dome_phong_half, TP_NTH_quick_dome_blinn_half },
        { TP_NTH_quick_cube_half, TP_NTH_quick_cube_phong_half,
          TP_NTH_quick_cube_blinn_half },
    };
    const bool lit = tp_frame_has_module(frame, TP_MODULE_LIGHT);
    const bool diffuse = !lit && frame->scene->light.ambient < TP_FX_ONE;
    const bool halved = (lit || diffuse) && frame->scene->quality.light == TP_RUNG_FAST
                     && !tp_frame_has_module(frame, TP_MODULE_CLEAR);
    chain c = { .count = 0, .halved = halved };

    append_layer_stages(&c, frame, layers, stage, halved);
    if (diffuse)                /* else light changes no colour */
        append_stage(&c, stage[halved ? TP_NTH_quick_diffuse_half : TP_NTH_quick_diffuse]);
    else if (halved)
        append_stage(&c, stage[half[frame->shade.env.kind][select_lobe(frame)]]);
    else if (lit)
        append_stage(&c, stage[light[frame->shade.env.kind][select_lobe(frame)]]);
    return c;
}

/* Returns the stages at half rate: light and reflection of every second column. */
static chain make_half_rate_colour_chain(const tp_frame *frame,
                                         const tp_quick_layers *layers,
                                         const tp_stage *stage)
{
    static const uint8_t light[] = { TP_NTH_quick_gradient_even, TP_NTH_quick_dome_even,
                                     TP_NTH_quick_cube_even };
    static const uint8_t rest[] = { TP_NTH_quick_odd_fill, TP_NTH_quick_glint_phong,
                                    TP_NTH_quick_glint_blinn };
    chain c = { .count = 0 };

    append_layer_stages(&c, frame, layers, stage, true);
    append_stage(&c, stage[light[frame->shade.env.kind]]);
    append_stage(&c, stage[rest[select_lobe(frame)]]);
    return c;
}

/* Adds all stages or none, because each stage reads the results of the stage before.
 * Returns true if added. */
static bool add_chain_if_complete(tp_shaders *list, const chain *c, const void *mine)
{
    for (uint32_t i = 0; i < c->count; i++)
        if (!c->stage[i])
            return false;
    for (uint32_t i = 0; i < c->count; i++)
        tp_shaders_add(list, i < c->light ? TP_AT_COLOUR : TP_AT_LIGHT, c->stage[i], mine);
    return true;
}

static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    const tp_quick_layers *layers = &((const tp_fast_water *)mine)->layers;
    const bool clear = tp_frame_has_module(frame, TP_MODULE_CLEAR);

    if (list->kind != TP_LIST_FAST || (clear && !tp_shaders_has(list, TP_AT_VIEW)))
        return;         /* the program lacks the stage that lights clear water */
    if (tp_frame_has_module(frame, TP_MODULE_MIRROR))
        tp_shaders_add(list, TP_AT_FRESNEL,
                       stage[TP_NTH_quick_over_gradient + (int)frame->shade.env.kind], mine);
    const chain halves = make_half_rate_colour_chain(frame, layers, stage);
    if (frame->rungs.rate == TP_RATE_COLOUR && !clear   /* its stage needs all columns */
        && add_chain_if_complete(list, &halves, mine))
        return;
    const chain columns = make_full_rate_chain(frame, layers, stage);
    if (add_chain_if_complete(list, &columns, mine) && columns.halved)
        list->evens = columns.stage[columns.count - 1];
}

const tp_drawing tp_fast_water_drawing = {
    .layout = layout, .init = init, .begin = begin_fast_water, .stages = add_stages,
};
