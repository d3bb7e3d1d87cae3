/* SPDX-License-Identifier: MIT */
/* The water's colour where a ray meets it: each of the engine's stages as a formula.
 *
 *     layers      texels at the place at rest, bent by the distortion, added up
 *     ripples     a normal map in the surface's tangent space [F6]
 *     light       ambient and N.L [F5]
 *     behind      what a refracted ray finds [F4], absorbed (inside.h)
 *     mirror      what a reflected ray finds [F3], by Fresnel's share [F1] [F2]
 *     glint       the light's lobe, R.V or N.H
 *
 * The mirror is a ray from the exact surface, so `mirror.bend` has no meaning here; with
 * mirror.objects it finds boat, drops and walls, else and beyond the sky alone.  The
 * sky that a mirrored ray would see below the horizon is other water, half as bright. */
#ifndef TP_REFERENCE_WATER_H
#define TP_REFERENCE_WATER_H
#include "solids.h"

/* The surface's slopes there, with ripples, as a normal. */
ref_vec ref_water_normal(const ref_scene *s, const ref_water *water);

/* Of water that is met from above; *in_mirror: which object is in its mirror, REF_SKY:
 * none. */
ref_colour ref_water_colour(const ref_scene *s, const ref_water *water, ref_vec way,
                            ref_kind *in_mirror);
#endif
