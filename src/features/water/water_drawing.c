/* SPDX-License-Identifier: MIT */
/*
 * The exact stages of water in a frame: their data, and the choice of stages, for textures,
 * normals of pools, light, reflectance and glints.
 */
#include "features/water/water.h"
#include "frame/frame.h"
#include "shade/env.h"
#include "shade/rough_lobe.h"
#include "world/pools.h"

/* -- textures: the base layer -------------------------------------------------------- */

static void *layout_base(tp_arena *arena, const tp_module_conditions *conditions)
{
    (void)conditions;
    return tp_arena_alloc(arena, 1, sizeof(tp_base_layer));
}

/* Sets the base layer; its colour and the water's colour are multiplied into one. */
static void begin_base(tp_frame *frame, void *mine)
{
    const tp_scene_layer *layer = &frame->scene->layer[0];
    tp_base_layer *base = mine;
    tp_shade *shade = &frame->shade;

    base->layer = tp_frame_layer(frame, frame->assets.layer[0], &layer->map);
    if (!base->layer.texture)
        return;
    shade->water_colour = tp_colour_times(shade->water_colour, (uint32_t)layer->colour);
    base->grade = tp_grade_make(layer->saturation, layer->clamp, shade->water_colour);
}

/* True if the textures of exact lists are bilinear. */
static bool is_linear(const tp_frame *frame)
{
    return frame->scene->water.filter == TP_FILTER_LINEAR
        && frame->scene->quality.layers <= TP_RUNG_EXACT;
}

static tp_stage select_base_layer_stage(const tp_frame *frame, const tp_stage *stage)
{
    const tp_scene_layer *layer = &frame->scene->layer[0];
    const bool linear = is_linear(frame);

    if (tp_is_graded(layer->saturation, layer->clamp))
        return stage[TP_NTH_texture_graded + linear];
    return stage[2 * linear + (frame->shade.water_colour != 0xffffff)];
}

static void add_base(const tp_frame *frame, const void *mine, const tp_stage *stage,
                     tp_shaders *list)
{
    const tp_base_layer *base = mine;

    if (list->kind != TP_LIST_WATER || !base->layer.texture)
        return;
    tp_shaders_add(list, TP_AT_COLOUR,
                   tp_shaders_pick(list, select_base_layer_stage(frame, stage),
                                   stage[TP_NTH_texture] ? stage[TP_NTH_texture]
                                                         : frame->program->stage.plain),
                   mine);
}

const tp_drawing tp_base_layer_drawing = {
    .layout = layout_base, .begin = begin_base, .stages = add_base,
};

/* -- textures: the added layers and the distortion ----------------------------------- */

static void *layout_layers(tp_arena *arena, const tp_module_conditions *conditions)
{
    (void)conditions;
    return tp_arena_alloc(arena, 1, sizeof(tp_layers));
}

static void begin_layer(const tp_frame *frame, tp_layers *layers, int k)
{
    const tp_scene_layer *layer = &frame->scene->layer[1 + k];
    const uint32_t colour = (uint32_t)layer->colour;

    layers->added[k] = tp_frame_layer(frame, frame->assets.layer[1 + k], &layer->map);
    layers->colour[k] = colour;
    layers->graded[k] = tp_is_graded(layer->saturation, layer->clamp);
    layers->grade[k] = tp_grade_make(layer->saturation, layer->clamp, colour);
}

static void begin_layers(tp_frame *frame, void *mine)
{
    tp_layers *layers = mine;

    for (int k = 0; k < TP_LAYERS_ADDED; k++)
        begin_layer(frame, layers, k);
    layers->bend = tp_frame_layer(frame, frame->assets.distortion,
                                  &frame->scene->distortion.map);
    layers->strength = frame->scene->distortion.strength;
}

/* Adds the stages.  Without a base layer the other layers are added to the water's plain
 * colour. */
static void add_layers(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    const tp_layers *layers = mine;
    const bool added = layers->added[0].texture || layers->added[1].texture;
    const bool base = tp_shaders_has(list, TP_AT_COLOUR);
    const bool linear = is_linear(frame);

    if (list->kind != TP_LIST_WATER)
        return;
    if (layers->bend.texture && layers->strength > 0 && (added || base))
        tp_shaders_add(list, TP_AT_PLACE, stage[TP_NTH_bend], mine);
    if (added && !base)
        tp_shaders_add(list, TP_AT_COLOUR, frame->program->stage.plain, NULL);
    if (added)
        tp_shaders_add(list, TP_AT_COLOUR, stage[TP_NTH_layers + linear], mine);
}

const tp_drawing tp_layers_drawing = {
    .layout = layout_layers, .begin = begin_layers, .stages = add_layers,
};

/* -- pools that bend the normals ----------------------------------------------------- */

/* With water.pool_normal_strength the mesh stays flat; the water's normals get the pools'
 * slopes.  The slope maps lie in the frame's block and are made at the start of a frame.  A
 * pool without room for its map stays flat. */

typedef struct {
    tp_pool_bumps  look;        /* data of the stage; first member */
    tp_pool_slope *slope[TP_POOL_BUMPS];
    uint32_t       cells[TP_POOL_BUMPS];    /* capacity of each slope map */
} bumps;

/* Returns the cells of a slope map: the pool and one more cell on each side. */
static uint32_t padded_cell_count(const tp_scene_pool *pool)
{
    return pool->cols <= 0 ? 0 : (uint32_t)(pool->cols + 2) * (uint32_t)(pool->rows + 2);
}

static void *layout_bumps(tp_arena *arena, const tp_module_conditions *conditions)
{
    const tp_scene_pool *pool[] = { &conditions->scene->pool, &conditions->scene->field };
    bumps *b = tp_arena_alloc(arena, 1, sizeof *b), made = { .cells = { 0 } };

    for (int k = 0; k < TP_POOL_BUMPS; k++) {
        made.cells[k] = padded_cell_count(pool[k]);
        made.slope[k] = tp_arena_alloc(arena, made.cells[k], sizeof *made.slope[k]);
    }
    if (b)
        *b = made;
    return b;
}

/* True if a pool is at rest and therefore flat; 32-bit pools never count as flat. */
static bool is_flat(const tp_pool *pool)
{
    return pool->at_rest && pool->cells != TP_CELLS_32;
}

static void begin_bumps(tp_frame *frame, void *mine)
{
    const tp_pool *pools[] = { tp_world_pool(frame->world), tp_world_field(frame->world) };
    bumps *b = mine;

    for (int k = 0; k < TP_POOL_BUMPS; k++) {
        const tp_pool *pool = pools[k];
        tp_pool_bump *bump = &b->look.pool[k];
        bump->slope = NULL;
        if (!pool || is_flat(pool) || (pool->cols + 2) * (pool->rows + 2) > b->cells[k])
            continue;
        *bump = tp_pool_bump_make(pool, b->slope[k]);
        bump->lod = tp_frame_lod(frame, tp_fx_recip(pool->cell), true);
        tp_pool_slopes(pool, frame->world->lag, frame->scene->water.pool_normal_strength,
                       b->slope[k]);
    }
}

static void add_bumps_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                            tp_shaders *list)
{
    const tp_pool_bump *pool = ((const bumps *)mine)->look.pool;

    (void)frame;
    if (!(pool[0].slope || pool[1].slope))
        return;
    if (list->kind == TP_LIST_FAST)
        tp_shaders_add(list, TP_AT_SLOPE, stage[TP_NTH_quick_pool_bump], mine);
    if (!tp_shaders_is_exact_water(list))
        return;
    tp_shaders_add(list, TP_AT_SLOPE, stage[TP_NTH_pool_bump], mine);
    list->rippled |= stage[TP_NTH_pool_bump] != NULL;
}

const tp_drawing tp_bumps_drawing = {
    .layout = layout_bumps, .begin = begin_bumps, .stages = add_bumps_stage,
};

/* -- light --------------------------------------------------------------------------- */

/* View-dependent light, or diffuse light only. */

/* Sets a dark lobe, for water without glitter. */
static void begin_lighting(tp_frame *frame, void *mine)
{
    static const tp_entry16 dark[TP_SHINE + 1];

    (void)mine;
    frame->shade.shine = dark;
    frame->shade.dark = TP_SHINE + 1;
    frame->shade.lobe = tp_lobe_form_make(TP_FX_ONE, 0);
}

/* Adds the view stage and the light stage together: a list with view vectors is always
 * lit. */
static void add_light(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    const bool blinn = frame->scene->light.model == TP_LIGHT_BLINN;
    const bool rough = frame->shade.filtered || frame->shade.ripple;
    const tp_stage smooth = stage[2 * blinn + list->rippled];
    const tp_stage view = frame->program->stage.view;
    tp_stage light = smooth;

    if (list->kind != TP_LIST_WATER)
        return;
    if (rough)
        light = tp_shaders_pick(list, stage[4 + 2 * blinn + list->rippled], smooth);
    tp_shaders_add(list, TP_AT_VIEW, light ? view : NULL, NULL);
    if (view && light)
        tp_shaders_add(list, TP_AT_LIGHT, light, mine);
}

const tp_drawing tp_lighting_drawing = { .begin = begin_lighting, .stages = add_light };

static void add_diffuse(const tp_frame *frame, const void *mine, const tp_stage *stage,
                        tp_shaders *list)
{
    (void)frame;
    if (list->kind == TP_LIST_WATER)
        tp_shaders_add(list, TP_AT_LIGHT, stage[list->rippled], mine);
}

const tp_drawing tp_diffuse_drawing = { .stages = add_diffuse };

/* -- reflectance --------------------------------------------------------------------- */

/* Fresnel's table, and the stages of the reflected sky. */

static void begin_reflectance(tp_frame *frame, void *mine)
{
    (void)mine;
    frame->shade.fresnel = frame->scene->water.fresnel == TP_FRESNEL_SCHLICK
                               ? tp_schlick_table : tp_fresnel_table;
}

/* Adds separate stages for reflection and mixing.  If the program lacks the sky's stage,
 * neither sky nor objects are mixed in. */
static void add_reflect_and_fresnel_stages(const tp_frame *frame, const tp_stage *stage,
                                           tp_shaders *list)
{
    const bool hdr =
        tp_has_hdr_stages(frame->shade.env.beyond, frame->scene) && stage[TP_NTH_fresnel_hdr];

    if (frame->shade.env.kind == TP_ENV_GRADIENT)
        tp_shaders_add(list, TP_AT_REFLECT, stage[TP_NTH_reflect_gradient], NULL);
    if (!list->rippled)
        tp_shaders_add(list, TP_AT_SLOPE, stage[TP_NTH_slopes], NULL);
    if (tp_shaders_has(list, TP_AT_REFLECT) && (list->rippled || stage[TP_NTH_slopes]))
        tp_shaders_add(list, TP_AT_FRESNEL, stage[TP_NTH_fresnel + hdr], NULL);
}

/* Adds the stages.  The plain gradient has no light above white, so one combined stage is
 * enough unless objects are reflected. */
static void add_reflectance_stages(const tp_frame *frame, const void *mine,
                                   const tp_stage *stage, tp_shaders *list)
{
    (void)mine;
    if (!tp_frame_reflects_sky(frame, list))
        return;
    if (frame->shade.env.kind == TP_ENV_GRADIENT
        && frame->scene->mirror.method == TP_MIRROR_NONE)
        tp_shaders_add(list, TP_AT_FRESNEL, stage[TP_NTH_mirror_gradient_sky], NULL);
    else
        add_reflect_and_fresnel_stages(frame, stage, list);
}

const tp_drawing tp_reflectance_drawing = { .begin = begin_reflectance,
                                            .stages = add_reflectance_stages };

/* -- glitter ------------------------------------------------------------------------- */

/* The table of the water's lobe; NULL: baked. */
typedef struct {
    tp_own_table *shine;
} glint;

static void *layout_glint(tp_arena *arena, const tp_module_conditions *conditions)
{
    glint *g = tp_arena_alloc(arena, 1, sizeof *g);
    tp_own_table *shine = tp_table_layout(arena, conditions->assets, TP_TABLE_shine,
                                          (TP_SHINE + 1) * sizeof(tp_entry16));

    if (g)
        g->shine = shine;
    return g;
}

/* Returns the number of entries that are 0; entries do not fall. */
static int32_t count_dark_entries(const tp_entry16 *shine)
{
    int32_t count = 0;

    for (int32_t step = TP_SHINE; step > 0; step >>= 1)
        if (count + step <= TP_SHINE && shine[count + step - 1] == 0)
            count += step;
    return count;
}

static void make_shine(const tp_frame *frame, const void *from, void *entries)
{
    const tp_fx shininess = frame->scene->water.shininess;
    const tp_fx specular = frame->scene->water.specular;

    (void)from;
    if (frame->scene->light.model == TP_LIGHT_BLINN)
        tp_shade_shine_blinn(entries, shininess, specular);
    else
        tp_shade_shine(entries, shininess, specular);
}

const struct tp_draw_shine tp_draw_shine = { { make_shine } };

static void begin_glint(tp_frame *frame, void *mine)
{
    const tp_scene *scene = frame->scene;
    const int32_t numbers[] = { scene->light.model, scene->water.shininess,
                                scene->water.specular };
    const glint *g = mine;

    frame->shade.shine = tp_frame_table(frame, TP_TABLE_shine, g->shine, numbers,
                                        TP_TABLE_MAKER(frame->program->draw.shine), NULL);
    frame->shade.dark = count_dark_entries(frame->shade.shine);
    frame->shade.lobe = tp_lobe_form_make(scene->water.shininess, scene->water.specular);
}

static void add_glint_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                            tp_shaders *list)
{
    (void)frame;
    if (list->kind != TP_LIST_WATER || !tp_shaders_has(list, TP_AT_VIEW))
        return;
    tp_shaders_add(list, TP_AT_GLINT, stage[0], mine);
    list->shines = stage[0] != NULL;
}

const tp_drawing tp_glint_drawing = {
    .layout = layout_glint, .begin = begin_glint, .stages = add_glint_stage,
};
