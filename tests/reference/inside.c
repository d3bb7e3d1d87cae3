/* SPDX-License-Identifier: MIT */
/* Rays in the water; see the header. */
#include "inside.h"
#include "trace.h"
#include "water.h"

#define START 1e-6              /* m: a ray does not meet what it comes from */
#define FAR   1e5

/* What is left of a colour after `way` m. */
static ref_colour through(const ref_scene *s, ref_colour seen, double way)
{
    const tp_scene *scene = s->scene;

    if (scene->water.clear <= 0)
        return ref_colour_of((uint32_t)scene->water.deep);
    return ref_through(seen, ref_colour_of((uint32_t)scene->water.deep),
                       ref_colour_of((uint32_t)scene->water.tint),
                       scene->water.clear / 65536.0, way);
}

static ref_colour from_below(const ref_scene *s, const ref_ray *ray,
                             const ref_meeting *m, double index, int bounces)
{
    const ref_vec up = ref_water_normal(s, &m->water);
    const ref_vec n = ref_times_vec(up, ref_dot(up, ray->way) > 0 ? -1 : 1);
    const double share = ref_fresnel_into(-ref_dot(ray->way, n), 1 / index);
    ref_ray on = { m->water.at, ref_reflected(ray->way, n) };
    ref_colour back = ref_colour_of((uint32_t)s->scene->water.deep);
    ref_vec at;

    if (bounces > 0)
        back = ref_inside(s, &on, index, bounces - 1);
    if (!ref_refracted(ray->way, n, 1 / index, &on.way))
        return back;
    return ref_mix(ref_dry(s, &on, START, FAR, &at).colour, back, share);
}

ref_colour ref_inside(const ref_scene *s, const ref_ray *ray, double index, int bounces)
{
    ref_solid solid;
    ref_meeting m;

    ref_solid_meets(s, ray, REF_THINGS | REF_FLOOR | REF_TANK, START, FAR, &solid);
    if (ref_ray_meets(&s->surface, ray, START, solid.t, true, &m) && m.from_below)
        return through(s, from_below(s, ray, &m, index, bounces), m.t);
    if (solid.kind == REF_SKY)
        return ref_colour_of((uint32_t)s->scene->water.deep);
    return through(s, ref_solid_colour(s, &solid, ray->way, true), solid.t);
}

/* Indices of red, green and blue lie half the spread apart. */
ref_colour ref_behind(const ref_scene *s, ref_vec at, ref_vec normal, ref_vec way)
{
    const double spread = s->scene->water.dispersion / 65536.0;
    ref_colour seen = { { 0, 0, 0 } };

    for (int k = 0; k < 3; k++) {
        const double index = REF_INDEX + spread * (k - 1) / 2;
        ref_ray ray = { at, way };
        ref_refracted(way, normal, index, &ray.way);
        const ref_colour c = ref_inside(s, &ray, index, 1);
        if (spread == 0)
            return c;
        seen.c[k] = c.c[k];
    }
    return seen;
}
