/* SPDX-License-Identifier: MIT */
/* What is seen along a ray in the water: floor, walls and things, through what the water
 * takes (Beer) and gives; and the surface from below, where light is refracted out, or
 * reflected, all of it beyond 48.6 degrees. */
#ifndef TP_REFERENCE_INSIDE_H
#define TP_REFERENCE_INSIDE_H
#include "scene.h"

/* `index` of the water; of the reflections from below no more than `bounces` are
 * followed. */
ref_colour ref_inside(const ref_scene *s, const ref_ray *ray, double index, int bounces);

/* What is seen through the surface at `at` by a look along `way`; three rays of three
 * indices where light is dispersed. */
ref_colour ref_behind(const ref_scene *s, ref_vec at, ref_vec normal, ref_vec way);
#endif
