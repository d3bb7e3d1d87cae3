/* SPDX-License-Identifier: MIT */
/* The view of a fan: its numbers, the direction of the rows, the distances of the water in
 * view and the view's width. */
#include "view/fan.h"
#include "view/wave_models.h"
#include "waves/deep_water.h"

#define MARGIN (TP_FX_ONE / 2)          /* beyond the waves' displacement, m */

/* -- numbers ------------------------------------------------------------------------- */

/* Sets half the longest wave and twice the shortest. */
static void measure_waves(tp_fan_view *to, const tp_deep_water *deep)
{
    uint64_t least = UINT64_MAX, most = 0;              /* turns per metre */

    for (uint32_t i = 0; i < deep->count; i++) {
        const uint64_t turns = deep->swell[i].turns;
        least = turns < least ? turns : least;
        most = turns > most ? turns : most;
    }
    if (most == 0 || least == 0)
        return;
    to->half_longest = (tp_fx)(((uint64_t)1 << 47) / least);
    to->shortest = (tp_fx)(((uint64_t)1 << 49) / most);
}

/* Returns the largest distance of rings and pools from the eye along the heading. */
static int64_t farthest_detail(const tp_grid_view *view)
{
    const tp_rectangle *sides = &view->detail.sides;
    const tp_vec3 eye = view->projection->eye;
    const tp_dir3 right = tp_fan_rows_direction(&view->projection->turn, false);
    const int64_t x = right.z > 0 ? sides->x1 : sides->x0;
    const int64_t z = right.x > 0 ? sides->z0 : sides->z1;

    return ((x - eye.x) * right.z - (z - eye.z) * right.x) >> 30;
}

tp_fan_view tp_fan_view_make(const tp_grid_view *view)
{
    const tp_surface *surface = view->surface;
    tp_fan_view to = { .projection = view->projection, .width = view->width,
                       .height = view->height, .land = TP_FX_MIN,
                       .high = tp_surface_height_bound(surface),
                       .aside = tp_surface_displacement_bound(surface) };

    measure_waves(&to, surface->deep);
    to.detail = view->detail.length;
    to.detail_end = to.detail > 0 ? farthest_detail(view) : 0;
    to.walls = view->detail.walls;
    to.sides = view->detail.sides;
    if (surface->coastal)
        surface->by->coastal->widen_land(&to, surface);
    return to;
}

/* -- directions ---------------------------------------------------------------------- */

/* A direction in the frame of the rows, and in the world, in px, 16.16. */
typedef struct {
    int64_t ahead, side, down;
} fan_ray;

typedef struct {
    int64_t east, south, down;
} world_ray;

/* Returns focal ahead + u right + v up; u and v in px. */
static world_ray make_world_ray(const tp_projection *p, int32_t u, int32_t v)
{
    const int64_t a = p->focal, b = (int64_t)u * TP_FX_ONE, c = (int64_t)v * TP_FX_ONE;
    const tp_dir3 *x = &p->turn.x, *y = &p->turn.y, *z = &p->ahead;

    return (world_ray){ (a * z->x + b * x->x + c * y->x) >> 30,
                        (a * z->z + b * x->z + c * y->z) >> 30,
                        -((a * z->y + b * x->y + c * y->y) >> 30) };
}

/* Returns a corner of the picture in px from the middle, in `axis` 0 or 1. */
static int32_t corner(const tp_fan_view *view, int k, int axis)
{
    const int32_t half = (int32_t)(axis ? view->height : view->width) / 2 + 1;
    return k >> axis & 1 ? half : -half;
}

static fan_ray make_ray(const tp_projection *p, tp_dir3 right, int32_t u, int32_t v)
{
    const world_ray w = make_world_ray(p, u, v);

    return (fan_ray){ (w.east * right.z - w.south * right.x) >> 30,
                      (w.east * right.x + w.south * right.z) >> 30, w.down };
}

#define ROLLED (TP_Q30_ONE / 64)        /* sine of a roll that turns the rows */

/* Returns an axis across the view: the camera's own right as long as that is level.  With a
 * roll, the level direction across the line of sight, since a row is as wide as the view at
 * one depth; a camera that looks down has no such direction and takes the axis of its
 * picture that is more level. */
static tp_dir3 across_view(const tp_rotation *turn)
{
    const tp_dir3 z = turn->z;

    if (tp_abs(turn->x.y) > ROLLED && (int64_t)tp_abs(z.x) + tp_abs(z.z) > TP_Q30_ONE / 4)
        return (tp_dir3){ z.z, 0, -z.x };
    return tp_abs(turn->x.y) > tp_abs(turn->y.y) ? turn->y : turn->x;
}

/* The rows' heading points into the view, upside down, too: the law is for distances
 * ahead. */
tp_dir3 tp_fan_rows_direction(const tp_rotation *turn, bool walled)
{
    const tp_dir3 x = across_view(turn), z = turn->z;
    const bool behind = (int64_t)x.x * z.z < (int64_t)x.z * z.x;

    if (walled && tp_abs(x.x) >= tp_abs(x.z))
        return (tp_dir3){ (x.x < 0) != behind ? -TP_Q30_ONE : TP_Q30_ONE, 0, 0 };
    if (walled)
        return (tp_dir3){ 0, 0, (x.z < 0) != behind ? -TP_Q30_ONE : TP_Q30_ONE };
    return behind ? tp_normalise(-x.x, 0, -x.z) : tp_normalise(x.x, 0, x.z);
}

/* -- land ---------------------------------------------------------------------------- */

void tp_fan_land_places(const tp_fan_view *view, tp_vec3 place[TP_FAN_LAND_PLACES])
{
    const tp_projection *p = view->projection;
    int64_t steepest = 1;

    for (int k = 0; k < 4; k++) {
        const int64_t down = make_world_ray(p, corner(view, k, 0), corner(view, k, 1)).down;
        steepest = down > steepest ? down : steepest;
    }
    for (int k = 0; k < TP_FAN_LAND_PLACES; k++) {
        const world_ray r = make_world_ray(p, corner(view, k, 0), corner(view, k, 1));
        const int64_t level = ((r.east < 0 ? -r.east : r.east)
                               + (r.south < 0 ? -r.south : r.south)) / 4;
        const int64_t down = r.down > level ? r.down : level;
        place[k] = p->eye;
        if (k == 4 || p->eye.y <= 0 || 2 * r.down < steepest)
            continue;
        place[k].x = tp_fx_saturate(p->eye.x + r.east * p->eye.y / down);
        place[k].z = tp_fx_saturate(p->eye.z + r.south * p->eye.y / down);
    }
}

void tp_fan_widen_to_floor(tp_fan_view *view, const tp_surface *surface)
{
    tp_vec3 place[TP_FAN_LAND_PLACES];

    tp_fan_land_places(view, place);
    for (int k = 0; k < TP_FAN_LAND_PLACES; k++)
        tp_fan_widen_land(view, surface->by->coastal->floor(surface->coastal, place[k].x,
                                                            place[k].z).depth);
}

/* -- the water in view --------------------------------------------------------------- */

static void widen(tp_fan_range *r, int64_t d)
{
    r->first = d < r->first ? d : r->first;
    r->last = d > r->last ? d : r->last;
}

/* Widens the range by the water's highest and lowest level on a ray; true if the ray meets
 * one of them. */
static bool widen_by_ray(tp_fan_range *r, const fan_ray *ray, int64_t eye,
                         int64_t height, int64_t high)
{
    bool meets = false;

    for (int k = 0; k < 2; k++) {
        const int64_t drop = eye + (k ? height : -high);
        if (ray->down == 0 || (drop < 0) != (ray->down < 0))
            continue;
        widen(r, tp_clamp_abs(ray->ahead * drop / ray->down, TP_FAN_WIDEST));
        meets = true;
    }
    return meets;
}

/* Returns the level that the nearest rays reach first, m: land, with room for land that
 * rises between the places, or `height`. */
static int64_t highest_level(const tp_fan_view *view, int64_t height)
{
    const int64_t land = view->land, eye = view->projection->eye.y;
    const int64_t under = eye > land ? land + (eye - land) / 4 : eye;

    return land > -height && under > height ? under : height;
}

/* The range lies between the rays of the picture's corners, and leads up to the horizon if
 * that is in the picture. */
tp_fan_range tp_fan_visible_range(const tp_fan_view *view, tp_dir3 right, tp_fx highest,
                                  tp_fx last)
{
    const int64_t eye = view->projection->eye.y;
    const int64_t height = (int64_t)highest + TP_FX_ONE / 4;
    const int64_t room = (int64_t)view->aside + MARGIN;
    const int64_t high = highest_level(view, height);
    const fan_ray middle = make_ray(view->projection, right, 0, 0);
    tp_fan_range r = { INT64_MAX / 2, INT64_MIN / 2 };
    int down = 0, met = 0;

    for (int k = 0; k < 4; k++) {
        const fan_ray ray = make_ray(view->projection, right, corner(view, k, 0),
                                     corner(view, k, 1));
        down += ray.down > 0;
        met += widen_by_ray(&r, &ray, eye, height, high);
    }
    if (met == 0 || (eye <= high && -eye < height))
        widen(&r, 0);
    if (down % 4 != 0)
        widen(&r, middle.ahead < 0 ? -(int64_t)last : last);
    return (tp_fan_range){ tp_clamp_abs(r.first - room, last),
                           tp_clamp_abs(r.last + room, last) };
}

tp_fx tp_fan_half_width_per_depth(const tp_fan_view *view, tp_dir3 right)
{
    const int32_t u = (int32_t)view->width / 2 + 1, v = (int32_t)view->height / 2 + 1;
    const tp_projection *p = view->projection;
    const fan_ray ahead = make_ray(p, right, 0, 0), x = make_ray(p, right, u, 0),
                  y = make_ray(p, right, 0, v);
    const int64_t skew = ahead.side < 0 ? -ahead.side : ahead.side;
    const int64_t wide = x.side - ahead.side, high = y.side - ahead.side;
    const int64_t side = skew + (wide < 0 ? -wide : wide) + (high < 0 ? -high : high);
    const int64_t per_depth = (side << 16) / p->focal;
    const int64_t kept = TP_FX_ONE - per_depth * skew / p->focal;  /* of a skewed row */

    return (tp_fx)((per_depth << 16) / (kept > TP_FX_ONE / 4 ? kept : TP_FX_ONE / 4));
}
