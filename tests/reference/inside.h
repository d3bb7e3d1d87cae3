/* SPDX-License-Identifier: MIT */
/* What is seen along a ray in the water: floor, walls and things, through what the water
 * takes (Beer) and gives; and the surface from below, where light is refracted out, or
 * reflected, all of it beyond 48.6 degrees.  Caustics are left out: the sun falls as
 * through level water. */
#ifndef TP_REFERENCE_INSIDE_H
#define TP_REFERENCE_INSIDE_H
#include "scene.h"

typedef struct {
    double     index;
    ref_colour body;            /* what the water itself sends */
    int        bounces;         /* of reflections from below so many are followed */
    double     far;             /* m of depth where the ray begins */
} ref_wet;

ref_colour ref_inside(const ref_scene *s, const ref_ray *ray, const ref_wet *wet);

/* The same for a ray that came in under the surface. */
ref_colour ref_under(const ref_scene *s, const ref_ray *ray, int bounces);

/* What is seen through the surface at `at` by a look along `way`, where the surface
 * itself is lit so; three rays of three indices where light is dispersed. */
ref_colour ref_behind(const ref_scene *s, ref_vec at, ref_vec normal, ref_vec way,
                      ref_colour lit);
#endif
