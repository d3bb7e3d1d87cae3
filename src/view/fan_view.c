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
    const tp_vec3 eye = view->projection->eye;
    tp_fan_view to = { .projection = view->projection, .width = view->width,
                       .height = view->height, .land = TP_FX_MIN,
                       .high = tp_surface_height_bound(surface),
                       .aside = tp_surface_displacement_bound(surface) };

    measure_waves(&to, surface->deep);
    to.detail = view->detail.length;
    to.detail_end = to.detail > 0 ? farthest_detail(view) : 0;
    to.walled = view->detail.walled;
    to.sides = view->detail.sides;
    if (surface->coastal)
        to.land = tp_fx_saturate(-(int64_t)surface->by->coastal->floor(
            surface->coastal, eye.x, eye.z).depth);
    return to;
}

/* -- directions ---------------------------------------------------------------------- */

/* A direction in the frame of the rows, in px, 16.16. */
typedef struct {
    int64_t ahead, side, down;
} fan_ray;

/* Returns focal ahead + u right + v up; u and v in px. */
static fan_ray make_ray(const tp_projection *p, tp_dir3 right, int32_t u, int32_t v)
{
    const int64_t a = p->focal, b = (int64_t)u * TP_FX_ONE, c = (int64_t)v * TP_FX_ONE;
    const tp_dir3 *x = &p->turn.x, *y = &p->turn.y, *z = &p->ahead;
    const int64_t east = (a * z->x + b * x->x + c * y->x) >> 30;
    const int64_t south = (a * z->z + b * x->z + c * y->z) >> 30;

    return (fan_ray){ (east * right.z - south * right.x) >> 30,
                      (east * right.x + south * right.z) >> 30,
                      -((a * z->y + b * x->y + c * y->y) >> 30) };
}

/* A camera that lies on its side has its own right upright.  The rows' heading points into
 * the view, upside down, too: the law is for distances ahead. */
tp_dir3 tp_fan_rows_direction(const tp_rotation *turn, bool walled)
{
    const tp_dir3 x = tp_abs(turn->x.y) > TP_Q30(0.9) ? turn->y : turn->x, z = turn->z;
    const bool behind = (int64_t)x.x * z.z < (int64_t)x.z * z.x;

    if (walled && tp_abs(x.x) >= tp_abs(x.z))
        return (tp_dir3){ (x.x < 0) != behind ? -TP_Q30_ONE : TP_Q30_ONE, 0, 0 };
    if (walled)
        return (tp_dir3){ 0, 0, (x.z < 0) != behind ? -TP_Q30_ONE : TP_Q30_ONE };
    return behind ? tp_normalise(-x.x, 0, -x.z) : tp_normalise(x.x, 0, x.z);
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

/* Returns the level that the nearest rays reach first, m: land under the eye, with room for
 * land that rises ahead, or `height`. */
static int64_t highest_level(const tp_fan_view *view, int64_t height)
{
    const int64_t land = view->land, eye = view->projection->eye.y;
    const int64_t under = eye > land ? land + (eye - land) / 4 : eye;

    return land > -height && under > height ? under : height;
}

/* The range lies between the rays of the picture's corners, and leads up to the horizon if
 * that is in the picture. */
tp_fan_range tp_fan_visible_range(const tp_fan_view *view, tp_dir3 right, tp_fx last)
{
    const int32_t u = (int32_t)view->width / 2 + 1, v = (int32_t)view->height / 2 + 1;
    const int64_t eye = view->projection->eye.y;
    const int64_t height = view->high + TP_FX_ONE / 4;
    const int64_t room = (int64_t)view->aside + MARGIN;
    const int64_t high = highest_level(view, height);
    const fan_ray middle = make_ray(view->projection, right, 0, 0);
    tp_fan_range r = { INT64_MAX / 2, INT64_MIN / 2 };
    int down = 0, met = 0;

    for (int k = 0; k < 4; k++) {
        const fan_ray ray = make_ray(view->projection, right, k & 1 ? u : -u,
                                     k & 2 ? v : -v);
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
