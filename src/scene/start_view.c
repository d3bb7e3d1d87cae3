/* SPDX-License-Identifier: MIT */
/* The start camera of a scene; see the header. */
#include "geom/grid.h"
#include "scene/start_view.h"

int64_t tp_start_view_core_half_width(const tp_scene *s, int32_t lines, int32_t *flank)
{
    *flank = s->grid.reach > 0 ? lines / 8 : 0;
    *flank = *flank < TP_GRID_FLANK ? *flank : TP_GRID_FLANK;
    return (int64_t)s->grid.cell * (lines - 2 * *flank - 1) / 2;
}

int64_t tp_start_view_line_coordinate(const tp_scene *s, int32_t lines, int64_t centre,
                                      int64_t line)
{
    int32_t flank;
    const int64_t half = tp_start_view_core_half_width(s, lines, &flank);
    const int64_t core = (int64_t)(lines - 1 - 2 * flank) * 32768;
    const int64_t out = line < 0 ? -line - core : line - core;      /* lines, Q16 */

    if (out <= 0)
        return centre + (line * s->grid.cell >> 16);
    TP_ASSERT(flank > 0);
    const int64_t share = out / flank;          /* of the skirt, Q16; cubed */
    const int64_t way = half + (s->grid.reach * (share * share * share >> 32) >> 16);
    return centre + (line < 0 ? -way : way);
}

/* Returns the position of the eye. A camera on the boat has a position in deck axes. */
static tp_vec3 start_eye(const tp_scene *s)
{
    tp_vec3 eye = { s->camera.x, s->camera.y, s->camera.z };

    if (s->camera.follow == TP_FOLLOW_BOAT) {
        const tp_turn heading = tp_turn_of_degrees(s->boat.heading);
        const tp_rotation boat = tp_rotation_from_angles(heading, 0, 0);
        eye = tp_rotate_back(&boat, eye);
        eye.x = tp_fx_saturate((int64_t)eye.x + s->boat.x);
        eye.z = tp_fx_saturate((int64_t)eye.z + s->boat.z);
    }
    return eye;
}

static void set_water_extent(tp_start_view *at, const tp_scene *s)
{
    int32_t flank;
    int64_t wide = tp_start_view_core_half_width(s, s->grid.cols, &flank) + s->grid.reach;
    int64_t deep = tp_start_view_core_half_width(s, s->grid.rows, &flank) + s->grid.reach;

    at->x = at->z = 0;
    if (s->grid.follow) {
        at->x = at->eye.x - ((int64_t)s->grid.cell * s->grid.cols * 3 / 10
                             * at->turn.z.x >> 30);
        at->z = at->eye.z - ((int64_t)s->grid.cell * s->grid.rows * 3 / 10
                             * at->turn.z.z >> 30);
    }
    at->water =
        (tp_rectangle){ tp_fx_saturate(at->x - wide), tp_fx_saturate(at->x + wide),
                        tp_fx_saturate(at->z - deep), tp_fx_saturate(at->z + deep) };
    if (tp_has_tank(s))
        at->water = tp_pool_sides(s);
}

tp_start_view tp_start_view_make(const tp_scene *s, uint32_t width, uint32_t height)
{
    TP_ASSERT(width > 0 && height > 0);
    const tp_dir3 half =
        tp_rotation_from_angles(tp_turn_of_degrees(s->camera.fov) / 2, 0, 0).x;
    const tp_turn aboard = s->camera.follow == TP_FOLLOW_BOAT
                         ? tp_turn_of_degrees(s->boat.heading) : 0;
    tp_start_view at = { .eye = start_eye(s) };

    at.turn = tp_rotation_from_angles(aboard + tp_turn_of_degrees(s->camera.heading),
                                      tp_turn_of_degrees(s->camera.pitch), 0);
    at.high = ((int64_t)half.z * 65536) / half.x;
    at.wide = at.high * width / height;
    set_water_extent(&at, s);
    return at;
}

/* -- pixels -------------------------------------------------------------------------- */

tp_vec3 tp_start_view_ray(const tp_start_view *at, int64_t x, int64_t y)
{
    return tp_rotate_back(&at->turn, (tp_vec3){ (tp_fx)x, (tp_fx)y, -TP_FX_ONE });
}

int64_t tp_start_view_water_distance(const tp_start_view *at, int64_t x, int64_t y)
{
    const tp_vec3 ray = tp_start_view_ray(at, x, y);

    if (ray.y == 0 || at->eye.y == 0 || (ray.y < 0) != (at->eye.y > 0))
        return 0;
    const int64_t far = (int64_t)at->eye.y * 65536 / -ray.y;    /* Q16 m, up to 2^47 */
    if (far > (int64_t)1 << 32)
        return 0;
    const int64_t px = at->eye.x + (far * ray.x >> 16);
    const int64_t pz = at->eye.z + (far * ray.z >> 16);
    return px >= at->water.x0 && px <= at->water.x1
        && pz >= at->water.z0 && pz <= at->water.z1 ? far : 0;
}
