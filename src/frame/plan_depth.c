/* SPDX-License-Identifier: MIT */
/* The plan of what is seen through water, and under it: numbers of the water's inside,
 * and the stages that look into it. */
#include "frame/frame.h"
#include "shade/beam.h"
#include "tidepool/light.h"

#define CLEAR_BELOW (4 * TP_FX_ONE)     /* m: of opaque water to those who are in it */

/* -- numbers -------------------------------------------------------------------------- */

/* Of the ground the slant counts, from a metre more than the eye's height: water lies
 * over it. */
static tp_coat coat_of(const tp_frame *frame, const tp_texture *texture, tp_fx size,
                       int32_t colour, bool ground)
{
    tp_coat coat = { .texture = texture, .colour = (uint32_t)colour };

    if (!texture)
        return coat;
    tp_fx texels = tp_fx_div(TP_FX_ONE << texture->log2_w, size);
    coat.per_metre = tp_frame_repeats(size);
    coat.lod = tp_frame_lod(frame, texels, false);
    tp_fx height = tp_abs(tp_clamp(frame->lens.eye.y, -TP_FX_MAX, TP_FX_MAX));
    if (ground)
        coat.lod -= (tp_log2_q8((uint32_t)height + TP_FX_ONE) - 16 * 256) / 2;
    return coat;
}

/* The index of each colour: water's and half of the spread to both sides, held where the
 * table of roots is good. */
static void set_indices(tp_inside *in, tp_fx spread)
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

static void set_sun(const tp_shade *shade, tp_inside *in)
{
    const tp_view_axes *light = &shade->world;
    tp_ray  away = { -light->lx, -light->ly, -light->lz, 0 };
    tp_ray  down = tp_inside_bent(in, 1, away, (tp_ray){ 0, 16384, 0, 0 });
    int32_t steep = down.y < 0 ? -down.y : 16384;

    in->sun_x = -down.x * light->ly / steep;
    in->sun_y = light->ly;
    in->sun_z = -down.z * light->ly / steep;
}

/* The view's axes over the focal length: a 16th of a pixel at 1 m. */
static void view_inside(tp_frame *frame)
{
    tp_inside *in = &frame->shade.inside;
    const tp_view_axes *axes = &frame->shade.world;
    const tp_q30 right[3] = { axes->right.x, axes->right.y, axes->right.z };
    const tp_q30 up[3] = { axes->up.x, axes->up.y, axes->up.z };

    for (int k = 0; k < 3; k++) {
        in->right[k] = (int64_t)right[k] * 4096 / frame->shade.focal;
        in->up[k] = (int64_t)up[k] * 4096 / frame->shade.focal;
    }
    in->zi_near = frame->lens.zi_near;
}

static void set_box(const tp_frame *frame, tp_inside *in)
{
    const tp_scene *scene = frame->scene;
    bool tank = tp_frame_has_tank(frame);
    bool floor = tp_has_floor(scene);
    tp_rectangle r = tp_pool_sides(scene);

    in->walled = tank;
    in->floored = tank || (floor && frame->surface.ocean);
    in->ocean = !tank && floor ? frame->surface.ocean : NULL;
    in->x0 = r.x0;
    in->x1 = r.x1;
    in->z0 = r.z0;
    in->z1 = r.z1;
    in->bed = (tp_bed){ .depth = scene->tank.depth, .nl = in->sun_y };
    in->wall = coat_of(frame, frame->assets.tank_wall, scene->tank.tile,
                       scene->tank.wall_colour, false);
    in->floor = tank ? coat_of(frame, frame->assets.tank_floor, scene->tank.tile,
                               scene->tank.floor_colour, true)
                     : coat_of(frame, frame->assets.floor_texture,
                               scene->floor.texture_size, scene->floor.colour, true);
}

/* -- stages --------------------------------------------------------------------------- */

static tp_stage behind_stage(const tp_frame *frame, bool rippled)
{
    const tp_stages *stages = &frame->kit->stage;
    const tp_stage stage[] = {
#define X(name, bent, dispersed) [2 * (dispersed) + (bent)] = stages->name,
        TP_BEHIND_STAGES(X)
#undef X
    };
    return stage[2 * (frame->scene->water.dispersion > 0) + rippled];
}

static bool can_show_under(const tp_stages *stages)
{
    return stages->deep && stages->view && stages->below && stages->absorb;
}

/* Whether the eye is under the surface at its place; of a tank also within it. */
static bool is_under(const tp_frame *frame)
{
    tp_vec3 eye = frame->lens.eye;
    tp_rectangle r = tp_pool_sides(frame->scene);

    if (!can_show_under(&frame->kit->stage) || eye.y >= tp_surface_height(&frame->surface))
        return false;
    if (tp_frame_has_tank(frame)
        && (eye.x <= r.x0 || eye.x >= r.x1 || eye.z <= r.z0 || eye.z >= r.z1))
        return false;
    return eye.y < tp_surface_above(&frame->surface, eye.x, eye.z, NULL).position.y;
}

static void plan_inside(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    tp_inside *in = &frame->shade.inside;

    if (!frame->under && scene->water.clear == 0 && !tp_frame_has_tank(frame)
        && !frame->parts.block && !frame->assets.floor_texture)
        return;
    tp_absorb_init(&frame->shade.absorb, (uint32_t)scene->water.tint,
                   scene->water.clear > 0 ? scene->water.clear : CLEAR_BELOW);
    in->deep = (uint32_t)scene->water.deep;
    in->glass_colour = (uint32_t)scene->tank.glass_colour;
    in->glass = (uint32_t)scene->tank.glass >> 8;
    set_indices(in, scene->water.dispersion);
    set_sun(&frame->shade, in);
    view_inside(frame);
    set_box(frame, in);
    if (frame->parts.caustic_light)
        frame->kit->draw.caustics->place(frame);
}

const struct tp_draw_inside tp_draw_inside = {
    is_under, plan_inside, view_inside, behind_stage
};
