/* SPDX-License-Identifier: MIT */
/* Rays in the water; see the header. */
#include "inside.h"
#include "trace.h"
#include "water.h"

#define START 1e-6              /* ray start, m: no hit on the surface of origin */
#define FAR   1e5

#define CLEAR 4                 /* m of clear view in opaque water, from within */

static ref_colour own(const ref_scene *s)
{
    return ref_colour_unpack((uint32_t)s->scene->water.deep_colour);
}

static double point_depth(const ref_scene *s, ref_vec at)
{
    return ref_dot(ref_sub(at, s->camera.eye), s->camera.ahead);
}

/* Colour `seen` after `way` m of water whose own light is `body`. */
static ref_colour through(const ref_scene *s, ref_colour seen, ref_colour body,
                          double way)
{
    const double clear = s->scene->water.clarity / 65536.0;

    return ref_shade_absorption(seen, body,
                                ref_colour_unpack((uint32_t)s->scene->water.tint),
                                clear > 0 ? clear : CLEAR, way);
}

static ref_colour shade_from_water(const ref_scene *s, const ref_ray *ray,
                                   const ref_meeting *m, const ref_wet *wet)
{
    const ref_vec up = ref_water_normal(s, &m->water);
    const ref_vec n = ref_times_vec(up, ref_dot(up, ray->way) > 0 ? -1 : 1);
    const double share = ref_fresnel_reflectance(-ref_dot(ray->way, n), 1 / wet->index);
    const ref_wet less = { wet->index, wet->body, wet->bounces - 1, wet->far + m->t };
    ref_ray on = { m->water.at, ref_reflected(ray->way, n) };
    ref_colour back = wet->body;
    ref_vec at;

    if (wet->bounces > 0)
        back = ref_shade_underwater(s, &on, &less);
    if (!ref_refracted(ray->way, n, 1 / wet->index, &on.way))
        return back;
    return ref_mix(ref_dry(s, &on, START, FAR, &at).colour, back, share);
}

ref_colour ref_shade_underwater(const ref_scene *s, const ref_ray *ray, const ref_wet *wet)
{
    ref_solid solid;
    ref_meeting m;

    ref_solid_meets(s, ray, REF_THINGS | REF_FLOOR | REF_BLOCKS | REF_TANK, START, FAR,
                    &solid);
    if (ref_ray_meets(&s->surface, ray, START, solid.t, true, &m) && m.from_below)
        return through(s, shade_from_water(s, ray, &m, wet), wet->body, m.t);
    if (solid.kind == REF_SKY)
        return wet->body;
    solid.far = wet->far + solid.t;
    return through(s, ref_solid_colour(s, &solid, ray->way, true), wet->body, solid.t);
}

ref_colour ref_shade_water_depth(const ref_scene *s, const ref_ray *ray, int bounces)
{
    const ref_wet wet = { REF_INDEX, own(s), bounces, point_depth(s, ray->from) };
    return ref_shade_underwater(s, ray, &wet);
}

ref_colour ref_shade_absorbed(const ref_scene *s, ref_colour seen, double way)
{
    return through(s, seen, own(s), way);
}

/* Colour behind the surface. The water's own light is three parts deep colour, one part lit
 * surface. */
ref_colour ref_shade_refraction(const ref_scene *s, ref_vec at, ref_vec normal, ref_vec way,
                                ref_colour lit)
{
    const double spread = s->scene->water.dispersion / 65536.0;
    ref_colour seen = { { 0, 0, 0 } };

    for (int k = 0; k < 3; k++) {
        const ref_wet wet = { fmax(1.15, REF_INDEX + spread * (k - 1) / 2),
                              ref_mix(own(s), lit, 0.25), 1, point_depth(s, at) };
        ref_ray ray = { at, way };
        ref_refracted(way, normal, wet.index, &ray.way);
        const ref_colour c = ref_shade_underwater(s, &ray, &wet);
        if (spread == 0)
            return c;
        seen.c[k] = c.c[k];
    }
    return seen;
}
