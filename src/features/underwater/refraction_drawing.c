/* SPDX-License-Identifier: MIT */
/* Clear water, through whose surface floor, walls and objects are visible from above, and the
 * refraction map of the objects under the level. */
#include "features/underwater/underwater.h"
#include "frame/drawing.h"
#include "frame/frame.h"
#include "frame/renderers.h"
#include "quality/prices.h"
#include "shade/optics.h"
#include "shade/refracted_ray.h"
#include "world/pools.h"

/* -- clear water --------------------------------------------------------------------- */

bool tp_clear_water_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->water.clarity > 0 && conditions->above & TP_MODULE_UNDERWATER;
}

/* Sets the cost traits.  A ray's cost depends on its target: a box, a map or a plane. */
static void set_cost_traits(const tp_module_conditions *conditions,
                            uint8_t trait[TP_TRAIT_COUNT])
{
    const tp_scene *scene = conditions->scene;
    const bool tank = tp_has_tank(scene) && conditions->above & TP_MODULE_WALLS;
    const bool floor = !tank && tp_has_floor(scene);
    const bool chart = floor && conditions->assets && conditions->assets->floor;

    trait[TP_TRAIT_tank] = tank;
    trait[TP_TRAIT_chart] = chart;
    trait[TP_TRAIT_bed] = floor && !chart;
    trait[TP_TRAIT_dispersion] =
        scene->water.dispersion > 0 && scene->quality.dispersion <= TP_RUNG_EXACT;
}

static void *layout_clear_water(tp_arena *arena, const tp_module_conditions *conditions)
{
    (void)conditions;
    return tp_arena_alloc(arena, 1, sizeof(tp_clear_water));
}

/* Clears the map.  The refraction module, if on, draws its map later. */
static void begin_clear_water(tp_frame *frame, void *mine)
{
    tp_clear_water *clear = mine;

    clear->refraction_map = NULL;
    if (frame->scene->quality.refraction == TP_RUNG_FAST)
        tp_fast_refraction_begin(&frame->shade, &clear->fast);
}

/* The exact stage of each rung of dispersion; the next one is for ripples. */
static const uint8_t exact_view[] = {
    [TP_RUNG_AUTO] = TP_NTH_refract_dispersed, [TP_RUNG_EXACT] = TP_NTH_refract_dispersed,
    [TP_RUNG_FAST] = TP_NTH_refract_shifted, [TP_DISPERSION_OFF] = TP_NTH_refract,
};

/* Adds the stage.  The exact one reads the view vectors and mixes with the lit colour; the
 * fast one comes before light. */
static void add_clear_water_stage(const tp_frame *frame, const void *mine,
                                  const tp_stage *stage, tp_shaders *list)
{
    const uint32_t rung =
        frame->scene->water.dispersion > 0 ? (uint32_t)frame->scene->quality.dispersion
                                           : TP_DISPERSION_OFF;

    if (list->kind == TP_LIST_FAST)
        tp_shaders_add(list, TP_AT_VIEW,
                       stage[rung == TP_RUNG_FAST ? TP_NTH_quick_refract_shifted
                                                  : TP_NTH_quick_refract], mine);
    if (list->kind == TP_LIST_WATER && tp_shaders_has(list, TP_AT_VIEW))
        tp_shaders_add(list, TP_AT_REFRACT, stage[exact_view[rung] + list->rippled], mine);
}

const tp_module tp_clear_water_module = {
    .name = "clear water", .id = TP_CLEAR_WATER_ID,
    .is = TP_MODULE_CLEAR, .trait = TP_TRAIT_behind,
    .enabled = tp_clear_water_enabled, .count = set_cost_traits,
};

const tp_drawing tp_clear_water_drawing = {
    .layout = layout_clear_water,
    .begin = begin_clear_water,
    .stages = add_clear_water_stage,
};

/* -- the refraction map -------------------------------------------------------------- */

/* A planar map of the objects under the level.  Depths are scaled by 3/4, the apparent
 * depth under flat water. */

typedef struct {
    tp_planar_map         map;
    tp_planar_memory store;
} refraction;

#define ETA TP_Q30(TP_WATER_ETA)

/* Returns the projection that scales heights over the level by ETA, by its rows: (S p -
 * eye).r = (p - S^-1 eye).(S r). */
static tp_projection refraction_projection(const tp_projection *projection, tp_fx level)
{
    tp_projection to = *projection;
    int64_t up = (int64_t)(projection->eye.y - level) * TP_Q30_ONE / ETA;

    to.eye.y = tp_fx_saturate(level + up);
    to.right.y = tp_q30_mul(projection->right.y, ETA);
    to.up.y = tp_q30_mul(projection->up.y, ETA);
    to.ahead.y = tp_q30_mul(projection->ahead.y, ETA);
    return to;
}

/* Returns the length of the ray under water per metre of apparent depth, 16.16.  The
 * refracted ray has ETA times the sine, and the true depth is the apparent depth over
 * ETA. */
static tp_fx path_per_depth(const tp_frame *frame, int32_t x, int32_t y)
{
    tp_ray  ray = tp_vector_to_eye(&frame->shade, &frame->shade.world, x, y);
    int64_t s2 = (1 << 28) - (int64_t)ray.y * ray.y;            /* Q28 */
    int64_t c2 = (1 << 28) - ((s2 * (ETA >> 15) >> 15) * (ETA >> 15) >> 15);
    tp_fx   c = (tp_fx)(tp_isqrt64((uint64_t)c2 << 4));         /* Q16 */
    return tp_fx_div(TP_FX(TP_WATER_INDEX), c);
}

/* Applies absorption to each colour of a row, by the sample's depth under the level. */
static void absorb_row(const tp_frame *frame, const tp_projection *projection,
                       tp_fx eye_height, const tp_gbuffer *band, int32_t y, uint32_t *to)
{
    const uint32_t *key = band->key + (size_t)(uint32_t)(y - band->y0) * band->stride;
    const uint32_t deep = (uint32_t)frame->scene->water.deep_colour;
    const int64_t v = tp_over_focal(&frame->shade, projection->v0 - 16 * y - 8);
    const int64_t middle =
        -((projection->ahead.y >> 14) + (v * (projection->turn.y.y >> 14) >> 16));
    const int64_t aside = -(projection->turn.x.y >> 14) /* per 1/16 px */
                          * (int64_t)frame->shade.per_focal;
    tp_fx way = path_per_depth(frame, band->x0, y);

    for (int32_t x = band->x0; x < band->x1; x++, key++, to++) {
        if (x % 16 == 0)
            way = path_per_depth(frame, x + 8, y);
        if (*to == 0)
            continue;
        int64_t z = tp_depth_from_zi(projection->zi_near, tp_key_zi(*key));
        int64_t fall = middle + ((16 * x + 8 - projection->u0) * aside >> 32);
        tp_fx   depth = tp_fx_saturate((fall * z >> 16) - eye_height);
        *to = tp_absorb_apply(&frame->shade.underwater->absorb, *to & 0xffffff, deep,
                           tp_fx_mul(depth > 0 ? depth : 0, way)) | 0xff000000u;
    }
}

static void draw_refraction_map(tp_frame *frame, const refraction *r, const tp_view *view,
                                const tp_projection *projection, tp_fx eye_height)
{
    const tp_planar_memory *store = &r->store;
    const tp_planar_map *map = &r->map;
    uint32_t wide = (uint32_t)(map->x1 - map->x0);

    for (int32_t y0 = map->y0; y0 < map->y1; y0 += TP_PLANAR_BAND) {
        tp_gbuffer band = tp_planar_gbuffer(store, map, y0);
        tp_gbuffer_clear(&band);
        tp_frame_allow_wide_solids(frame, &band, &frame->stats.dropped);
        tp_view_draw_solids(frame, view, &band);
        for (int32_t y = y0; y < band.y1; y++) {
            uint32_t *to = store->colour + (uint32_t)(y - map->y0) * wide;
            tp_frame_colour_row(frame, &band, y, to);
            absorb_row(frame, projection, eye_height, &band, y, to);
        }
    }
}

static void draw_map(tp_frame *frame, void *mine)
{
    refraction *r = mine;
    tp_clear_water *clear = tp_frame_module_memory(frame, TP_CLEAR_WATER_ID);
    tp_fx    level = tp_view_objects_water_level(frame);
    tp_planar_map *map = &r->map;

    map->colour = NULL;
    if (!clear || !tp_view_is_above_level(frame, level))
        return;
    const tp_projection projection = tp_projection_halve(&frame->projection);
    const tp_projection bent = refraction_projection(&projection, level);
    tp_view view = { .projection = &bent, .clipped = true,
                       .level = tp_projection_level_plane(&projection, level, -1) };
    tp_view_begin(frame, &view);
    tp_grid_box box = tp_view_project_solids(frame, &view);
    if (!tp_planar_set_bounds(&r->store, &box, map))
        return;
    draw_refraction_map(frame, r, &view, &projection, frame->projection.eye.y - level);
    clear->refraction_map = map;
    clear->mix = tp_refraction_map_mix;
}

/* -- the module refraction ----------------------------------------------------------- */

bool tp_refraction_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->water.clarity > 0 && conditions->above & TP_MODULE_SOLID
           && conditions->above & TP_MODULE_UNDERWATER;
}

static void *layout_refraction(tp_arena *arena, const tp_module_conditions *conditions)
{
    refraction *r = tp_arena_alloc(arena, 1, sizeof *r), made = { .map.colour = NULL };

    tp_planar_layout(&made.store, arena, conditions, 1, false);
    if (r)
        *r = made;
    return r;
}

const tp_module tp_refraction_module = {
    .name = "refraction", .id = TP_REFRACTION_ID, .enabled = tp_refraction_enabled,
};

const tp_drawing tp_refraction_drawing = { .layout = layout_refraction,
                                           .draw_map = draw_map };
const tp_stage tp_refraction_stages[] = { NULL };
