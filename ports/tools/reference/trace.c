/* SPDX-License-Identifier: MIT */
/* Camera rays. */
#include "trace.h"
#include "inside.h"
#include "sky_light.h"
#include "spray.h"
#include "stars.h"
#include "water.h"

#define FAR 1e5

#define IN_AIR (REF_THINGS | REF_FLOOR | REF_BLOCKS)

ref_seen ref_dry(const ref_scene *s, const ref_ray *ray, double t0, double t1,
                 ref_vec *at)
{
    ref_solid solid;

    if (!ref_solid_meets(s, ray, IN_AIR, t0, t1, &solid))
        return (ref_seen){ .colour = ref_heaven(s, ray->way), .kind = REF_SKY };
    *at = solid.at;
    return (ref_seen){ .colour = ref_solid_colour(s, &solid, ray->way, false),
                       .kind = solid.kind };
}

/* Distance to the first outer side of a glass tank; outward normal in *n. */
static double find_glass(const ref_scene *s, const ref_ray *ray, ref_vec *n)
{
    const ref_tank *b = &s->tank;
    const double dx = ray->way.x, dz = ray->way.z;
    double tx = -HUGE_VAL, tz = -HUGE_VAL, out = HUGE_VAL;

    if (b->kind != TP_TANK_GLASS
        || !ref_ray_clip_slab(ray->from.x, dx, b->x0, b->x1, &tx, &out)
        || !ref_ray_clip_slab(ray->from.z, dz, b->z0, b->z1, &tz, &out))
        return HUGE_VAL;
    const double t = fmax(tx, tz);              /* a ray enters a box at the last side */
    const double y = ray->from.y + t * ray->way.y;
    if (!(t > 0 && t <= out && y >= -b->depth && y <= b->rim))
        return HUGE_VAL;
    *n = tx > tz ? (ref_vec){ dx > 0 ? -1 : 1, 0, 0 }
                 : (ref_vec){ 0, 0, dz > 0 ? -1 : 1 };
    return t;
}

/* Colour of the water behind the glass, below its surface. Returns false if there is
 * air. */
static bool visible_side(const ref_scene *s, const ref_ray *ray, double t, ref_vec n,
                         ref_colour *colour)
{
    ref_ray on = { ref_ray_point(ray, t), ray->way };
    double rest[2] = { on.from.x, on.from.z };

    if (on.from.y > ref_surface_height(&s->surface, on.from.x, on.from.z, rest, 1e-9))
        return false;
    ref_refracted(ray->way, n, REF_INDEX, &on.way);
    *colour = ref_shade_water_depth(s, &on, 1);
    return true;
}

/* Adds the glass before the colour: the glass's own colour, and the sky by the Fresnel
 * share. */
static ref_colour glazed(const ref_scene *s, ref_colour c, ref_vec way, ref_vec n)
{
    const ref_colour sky = ref_heaven(s, ref_reflected(way, n));

    c = ref_mix(c, ref_colour_unpack((uint32_t)s->scene->tank.glass_colour),
                s->scene->tank.glass / 65536.0);
    return ref_mix(c, sky, ref_fresnel_reflectance(-ref_dot(way, n), REF_INDEX));
}

static ref_ray camera_ray(const ref_camera *c, double u, double v)
{
    const ref_vec right = ref_times_vec(c->right, u - c->u0);
    const ref_vec up = ref_times_vec(c->up, c->v0 - v);

    return (ref_ray){ c->eye, ref_unit_vec(ref_plus(ref_plus(right, up),
                                                    ref_times_vec(c->ahead, c->focal))) };
}

/* Colour seen through haze. */
static ref_seen hazed(const ref_scene *s, ref_colour colour, ref_kind kind, ref_vec at)
{
    const double depth = ref_dot(ref_sub(at, s->camera.eye), s->camera.ahead);
    return (ref_seen){ .colour = ref_heaven_haze(s, colour, at), .kind = kind,
                       .near = 1 / depth };
}

static ref_seen wet(const ref_scene *s, const ref_water *water, ref_vec way)
{
    ref_kind in_mirror;
    const ref_colour colour = ref_water_colour(s, water, way, &in_mirror);
    ref_seen seen = hazed(s, colour, REF_WATER, water->at);

    seen.in_mirror = in_mirror;
    return seen;
}

/* Traces a ray without the tank's glass. */
static ref_seen bare(const ref_scene *s, const ref_ray *ray, double t0, double *far)
{
    ref_meeting m;
    ref_solid solid;
    const bool hit = ref_solid_meets(s, ray, IN_AIR, t0, FAR, &solid);
    const double wet_to = solid.kind == REF_BOAT ? ref_find_lid(s, ray, t0, solid.t)
                                                 : solid.t;
    const bool water = ref_ray_meets(&s->surface, ray, t0, wet_to, false, &m);

    *far = water ? m.t : wet_to;
    if (water)
        return wet(s, &m.water, ray->way);
    if (hit)
        return hazed(s, ref_solid_colour(s, &solid, ray->way, false), solid.kind,
                     solid.at);
    return (ref_seen){ .colour = ref_add(ref_heaven(s, ray->way), ref_stars(s, ray->way)),
                       .kind = REF_SKY };
}

/* Distance at which a solid or the surface ends the view of an eye under water. */
static double find_end_of_water(const ref_scene *s, const ref_ray *ray)
{
    ref_meeting m;
    ref_solid solid;

    ref_solid_meets(s, ray, IN_AIR | REF_TANK, 0, FAR, &solid);
    return ref_ray_meets(&s->surface, ray, 0, solid.t, true, &m) ? m.t : solid.t;
}

/* Traces a ray of an eye under water. */
static ref_seen sunk(const ref_scene *s, const ref_ray *ray)
{
    ref_seen seen = { .colour = ref_shade_water_depth(s, ray, 2), .kind = REF_WATER };

    if (s->specks > 0)
        seen.spray = ref_spray_blend(s, ray, find_end_of_water(s, ray), false,
                                     &seen.colour);
    return seen;
}

static ref_seen look(const ref_scene *s, double u, double v)
{
    const ref_ray ray = camera_ray(&s->camera, u, v);
    const double t0 = s->camera.near / ref_dot(ray.way, s->camera.ahead);
    ref_vec n = { 0, 1, 0 };
    double far;

    if (s->immersion)
        return sunk(s, &ray);
    const double glass = find_glass(s, &ray, &n);
    ref_seen seen = bare(s, &ray, t0, &far);
    const bool pane = glass > t0 && glass < far;
    if (pane && visible_side(s, &ray, glass, n, &seen.colour)) {
        seen = hazed(s, seen.colour, REF_SIDE, ref_ray_point(&ray, glass));
        far = glass;
    }
    if (s->specks > 0)
        seen.spray = ref_spray_blend(s, &ray, far, seen.kind == REF_WATER, &seen.colour);
    if (pane)
        seen.colour = glazed(s, seen.colour, ray.way, n);
    return seen;
}

ref_seen ref_look(const ref_scene *s, double u, double v)
{
    ref_seen seen = look(s, u, v);
    seen.colour = ref_heaven_exposed(s, seen.colour);
    return seen;
}
