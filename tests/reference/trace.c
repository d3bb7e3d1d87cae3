/* SPDX-License-Identifier: MIT */
/* Camera rays. */
#include "trace.h"
#include "inside.h"
#include "water.h"

#define FAR 1e5

/* Glass does not stop a look in air. */
static int in_air(const ref_scene *s)
{
    return REF_THINGS | REF_FLOOR | (s->tank.kind == TP_TANK_STONE ? REF_TANK : 0);
}

ref_seen ref_dry(const ref_scene *s, const ref_ray *ray, double t0, double t1, ref_vec *at)
{
    ref_solid solid;

    if (!ref_solid_meets(s, ray, in_air(s), t0, t1, &solid))
        return (ref_seen){ ref_scene_sky(s, ray->way), REF_SKY, 0 };
    *at = solid.at;
    return (ref_seen){ ref_solid_colour(s, &solid, ray->way, false), solid.kind, 0 };
}

/* The first of a glass tank's outer sides, its outward normal in *n. */
static double glass_at(const ref_scene *s, const ref_ray *ray, ref_vec *n)
{
    const ref_tank *b = &s->tank;
    const double dx = ray->way.x, dz = ray->way.z;
    const double tx = ((dx > 0 ? b->x0 : b->x1) - ray->from.x) / dx;
    const double tz = ((dz > 0 ? b->z0 : b->z1) - ray->from.z) / dz;
    const double t = fmax(tx, tz);              /* a box is entered by its last side */
    const ref_vec at = ref_ray_at(ray, t);

    if (b->kind != TP_TANK_GLASS || !(t > 0) || at.x < b->x0 - 1e-9
        || at.x > b->x1 + 1e-9 || at.z < b->z0 - 1e-9 || at.z > b->z1 + 1e-9
        || at.y < -b->depth || at.y > b->rim)
        return HUGE_VAL;
    *n = tx > tz ? (ref_vec){ dx > 0 ? -1 : 1, 0, 0 }
                 : (ref_vec){ 0, 0, dz > 0 ? -1 : 1 };
    return t;
}

/* Below the level the water stands behind the glass; above it there is air. */
static bool through_glass(const ref_scene *s, const ref_ray *ray, double before,
                          ref_seen *seen, ref_vec *at)
{
    ref_vec n = { 0, 1, 0 };
    const double t = glass_at(s, ray, &n);
    ref_ray on = { ref_ray_at(ray, t), ray->way };

    if (!(t < before))
        return false;
    double rest[2] = { on.from.x, on.from.z };
    if (on.from.y > ref_surface_height(&s->surface, on.from.x, on.from.z, rest, 1e-9))
        return false;
    *at = on.from;
    ref_refracted(ray->way, n, REF_INDEX, &on.way);
    *seen = (ref_seen){ ref_mix(ref_inside(s, &on, REF_INDEX, 1),
                                ref_colour_of((uint32_t)s->scene->tank.glass_colour),
                                s->scene->tank.glass / 65536.0), REF_WALL, 0 };
    return true;
}

static ref_ray ray_at(const ref_camera *c, double u, double v)
{
    const ref_vec right = ref_times_vec(c->right, u - c->u0);
    const ref_vec up = ref_times_vec(c->up, c->v0 - v);

    return (ref_ray){ c->eye, ref_unit_vec(ref_plus(ref_plus(right, up),
                                                    ref_times_vec(c->ahead, c->focal))) };
}

/* As air shows it. */
static ref_seen hazed(const ref_scene *s, ref_colour colour, ref_kind kind, ref_vec at)
{
    const double depth = ref_dot(ref_sub(at, s->camera.eye), s->camera.ahead);
    return (ref_seen){ ref_scene_haze(s, colour, at), kind, 1 / depth };
}

ref_seen ref_look(const ref_scene *s, double u, double v)
{
    const ref_ray ray = ray_at(&s->camera, u, v);
    const double t0 = s->camera.near / ref_dot(ray.way, s->camera.ahead);
    ref_seen seen;
    ref_meeting m;
    ref_solid solid;
    ref_vec at;

    if (s->sunk)
        return (ref_seen){ ref_inside(s, &ray, REF_INDEX, 2), REF_WATER, 0 };
    const bool hit = ref_solid_meets(s, &ray, in_air(s), t0, FAR, &solid);
    const bool wet = ref_ray_meets(&s->surface, &ray, t0, solid.t, false, &m);
    if (through_glass(s, &ray, wet ? m.t : solid.t, &seen, &at))
        return hazed(s, seen.colour, REF_WALL, at);
    if (wet)
        return hazed(s, ref_water_colour(s, &m.water, ray.way), REF_WATER, m.water.at);
    if (hit)
        return hazed(s, ref_solid_colour(s, &solid, ray.way, false), solid.kind, solid.at);
    return (ref_seen){ ref_scene_sky(s, ray.way), REF_SKY, 0 };
}
