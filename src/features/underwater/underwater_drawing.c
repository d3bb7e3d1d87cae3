/* SPDX-License-Identifier: MIT */
/*
 * The inside of the water in a frame: its data (shade/optics.h) and the shader lists for
 * an eye under water; clear water, through whose surface floor, walls and objects are
 * visible from above; and the refraction map of the objects under the level.
 */
#include "features/underwater/underwater.h"
#include "frame/drawing.h"
#include "frame/frame.h"
#include "quality/prices.h"
#include "shade/optics.h"
#include "shade/refracted_ray.h"
#include "world/pools.h"

#define CLEAR_UNDERSIDE (4 * TP_FX_ONE)     /* m: visibility in opaque water */

/* Indices in the program's table of stages. */
enum { UNDERSIDE, UNDERSIDE_RIPPLED, DEEP, ABSORB };

/* -- the inside: data of a frame ----------------------------------------------------- */

/* Returns a wall material.  For the ground the mipmap level includes the slant of the
 * view, with the eye's height plus 1 m, because water lies over the ground. */
static tp_wall_material make_wall_material(const tp_frame *frame, const tp_texture *texture,
                                           tp_fx size, int32_t colour, bool ground)
{
    tp_wall_material material = {
        .texture = texture, .colour = tp_frame_lit_colour(frame, (uint32_t)colour),
    };

    if (!texture)
        return material;
    tp_fx texels = tp_fx_div(TP_FX_ONE << texture->log2_w, size);
    material.per_metre = tp_frame_repeats_per_metre(size);
    material.lod = tp_frame_lod(frame, texels, false);
    tp_fx height = tp_abs(tp_clamp(frame->projection.eye.y, -TP_FX_MAX, TP_FX_MAX));
    if (ground)
        material.lod -= (tp_log2_q8((uint32_t)height + TP_FX_ONE) - 16 * 256) / 2;
    return material;
}

/* Sets the refractive index of each channel: water's index, minus or plus half of the
 * spread.  The index is at least 1.15, the range of the table of roots. */
static void set_refractive_indices(tp_underwater *in, tp_fx spread)
{
    TP_ASSERT(spread >= 0);
    for (int k = 0; k < 3; k++) {
        tp_fx index = TP_FX(TP_WATER_INDEX) + (k - 1) * (spread / 2);
        index = index > TP_FX(1.15) ? index : TP_FX(1.15);
        int64_t eta = ((int64_t)1 << 36) / index;           /* Q20 */
        in->eta[k] = (int32_t)((eta + 32) >> 6);
        in->eta2[k] = (int32_t)((eta * eta + ((int64_t)1 << 25)) >> 26);
    }
}

static void set_sun(const tp_shade *shade, tp_underwater *in)
{
    const tp_view_axes *light = &shade->world;
    tp_ray  away = { -light->lx, -light->ly, -light->lz, 0 };
    tp_ray  down = tp_underwater_refract(in, 1, away, (tp_ray){ 0, 16384, 0, 0 });
    int32_t steep = down.y < 0 ? -down.y : 16384;

    in->sun_x = -down.x * light->ly / steep;
    in->sun_y = light->ly;
    in->sun_z = -down.z * light->ly / steep;
}

static void set_walls_and_floor(const tp_frame *frame, tp_underwater *in)
{
    const tp_scene *scene = frame->scene;
    bool tank = tp_frame_has_tank(frame);
    bool floor = tp_has_floor(scene);
    tp_rectangle r = tp_pool_sides(scene);

    in->island = tank && scene->tank.kind == TP_TANK_STONE;
    in->walled = tank && !in->island;
    in->floored = in->walled || (!tank && floor && frame->surface.coastal);
    in->coast_floor = frame->program->draw.coast_floor;
    in->upward_rays = frame->program->draw.upward_rays;
    in->coastal = !tank && floor && in->coast_floor ? frame->surface.coastal : NULL;
    in->sample_floor = in->coastal ? frame->surface.by->coastal->floor : NULL;
    in->x0 = r.x0;
    in->x1 = r.x1;
    in->z0 = r.z0;
    in->z1 = r.z1;
    in->floor_plane = (tp_floor_plane){ .depth = scene->tank.depth, .nl = in->sun_y };
    in->wall = make_wall_material(frame, frame->assets.tank_wall, scene->tank.tile,
                         scene->tank.wall_colour, false);
    in->floor = tank ? make_wall_material(frame, frame->assets.tank_floor, scene->tank.tile,
                                 scene->tank.floor_colour, true)
                     : make_wall_material(frame, frame->assets.floor_texture,
                                 scene->floor.texture_size, scene->floor.colour, true);
}

/* True if the eye is under the surface, and inside the tank if there is a tank.  A program
 * without samples takes swells for level, and counts that. */
static bool is_eye_submerged(tp_frame *frame)
{
    tp_vec3 eye = frame->projection.eye;
    tp_rectangle r = tp_pool_sides(frame->scene);

    if (eye.y >= tp_surface_height_bound(&frame->surface))
        return false;
    if (tp_frame_has_tank(frame)
        && (eye.x <= r.x0 || eye.x >= r.x1 || eye.z <= r.z0 || eye.z >= r.z1))
        return false;
    if (tp_surface_has_swells(&frame->surface) && !frame->surface.by->samples)
        tp_frame_count_lack(frame, TP_LACKING_SAMPLES);
    return eye.y < tp_surface_sample(&frame->surface, eye.x, eye.z, NULL).position.y;
}

/* True if the program has all stages for an eye under water.  Otherwise the view from above
 * is drawn. */
static bool has_stages_for_submerged_eye(const tp_frame *frame)
{
    const tp_stage *stage = tp_frame_module_stages(frame, TP_UNDERWATER_ID);

    return frame->program->stage.view && stage[UNDERSIDE] && stage[DEEP] && stage[ABSORB];
}

/* Rays go up in the water if the eye is below crests. */
static void count_lacking_parts(tp_frame *frame, const tp_underwater *in)
{
    const bool floored = tp_has_floor(frame->scene) && !tp_frame_has_tank(frame);

    frame->stats.dropped += floored && frame->surface.coastal && !in->coast_floor;
    frame->stats.dropped += frame->projection.eye.y < tp_surface_height_bound(&frame->surface)
                            && !in->upward_rays;
}

static void begin_underwater(tp_frame *frame, void *mine)
{
    const tp_scene *scene = frame->scene;
    tp_underwater *in = mine;

    frame->shade.caustic = NULL;
    frame->under = has_stages_for_submerged_eye(frame) && is_eye_submerged(frame);
    if (!frame->under && scene->water.clarity == 0 && !frame->assets.floor_texture
        && !tp_frame_has_module(frame, TP_MODULE_WALLS))
        return;
    tp_absorb_init(&in->absorb, (uint32_t)scene->water.tint,
                   scene->water.clarity > 0 ? scene->water.clarity : CLEAR_UNDERSIDE);
    in->deep = (uint32_t)scene->water.deep_colour;
    set_refractive_indices(in, scene->water.dispersion);
    set_sun(&frame->shade, in);
    tp_underwater_set_view(in, &frame->shade, frame->projection.zi_near);
    set_walls_and_floor(frame, in);
    count_lacking_parts(frame, in);
}

/* Sets the view's axes for the stage of walls: walls are drawn in every render view, and
 * their stage finds places by the axes. */
static void set_wall_stage_axes(tp_frame *frame, void *mine, tp_view *view,
                                tp_grid_box *box)
{
    (void)view, (void)box;
    if (tp_frame_has_module(frame, TP_MODULE_WALLS))
        tp_underwater_set_view(mine, &frame->shade, frame->projection.zi_near);
}

/* -- the inside: shader lists -------------------------------------------------------- */

static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    if (!frame->under)
        return;
    if (list->kind == TP_LIST_SKY)
        tp_shaders_add(list, TP_AT_COLOUR, stage[DEEP], mine);
    else if (list->kind == TP_LIST_UNDERSIDE)
        tp_shaders_add(list, TP_AT_LIGHT,
                       !list->rippled ? stage[UNDERSIDE]
                                      : tp_shaders_pick(list, stage[UNDERSIDE_RIPPLED],
                                                        stage[UNDERSIDE]),
                       mine);
    else
        tp_shaders_add(list, TP_AT_AIR, stage[ABSORB], mine);
}

/* -- the module underwater ----------------------------------------------------------- */

/* True in every scene: any camera may dive. */
bool tp_underwater_enabled(const tp_module_conditions *conditions)
{
    (void)conditions;
    return true;
}

static void *layout_underwater(tp_arena *arena, const tp_module_conditions *conditions)
{
    (void)conditions;
    return tp_arena_alloc(arena, 1, sizeof(tp_underwater));
}

static void init_underwater(tp_frame *frame, void *mine)
{
    memset(mine, 0, sizeof(tp_underwater));
    frame->shade.underwater = mine;
}

const tp_module tp_underwater_module = {
    .name = "underwater", .id = TP_UNDERWATER_ID, .is = TP_MODULE_UNDERWATER,
    .enabled = tp_underwater_enabled,
};

const tp_drawing tp_underwater_drawing = {
    .layout = layout_underwater,
    .init = init_underwater,
    .begin = begin_underwater,
    .project = set_wall_stage_axes,
    .stages = add_stages,
};

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
