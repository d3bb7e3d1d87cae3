/* SPDX-License-Identifier: MIT */
/* The inside of the water in a frame: its data (shade/optics.h) and the shader lists for an
 * eye under water. */
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
    tp_frame_use_fresnel(frame);
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
