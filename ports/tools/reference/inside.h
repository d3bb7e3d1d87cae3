/* SPDX-License-Identifier: MIT */
/* Colour along a ray in the water: floor, walls and objects through absorption (Beer) and
 * the water's own light; and the surface from below, which refracts the ray out or reflects
 * it, beyond 48.6 degrees totally. Sunlight under water is focused by the waves
 * (caustics.h). */
#ifndef TP_TOOLS_REFERENCE_INSIDE_H
#define TP_TOOLS_REFERENCE_INSIDE_H
#include "scene.h"

typedef struct {
    double     index;
    ref_colour body;            /* light of the water itself */
    int        bounces;         /* number of reflections from below to follow */
    double     far;             /* depth where the ray begins, m */
} ref_wet;

ref_colour ref_shade_underwater(const ref_scene *s, const ref_ray *ray, const ref_wet *wet);

/* Colour along a ray that came in through the surface. */
ref_colour ref_shade_water_depth(const ref_scene *s, const ref_ray *ray, int bounces);

/* Colour `seen` from an eye under water after `way` m of water. */
ref_colour ref_shade_absorbed(const ref_scene *s, ref_colour seen, double way);

/* Colour seen through the surface at `at` along `way`; `lit` is the brightness of the
 * surface itself. Dispersion follows three rays with three indices. */
ref_colour ref_shade_refraction(const ref_scene *s, ref_vec at, ref_vec normal, ref_vec way,
                                ref_colour lit);
#endif
