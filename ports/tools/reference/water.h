/* SPDX-License-Identifier: MIT */
/* Colour of the water where a ray meets it: each of the engine's stages as a formula.
 *
 *     layers      texels at the rest point, bent by the distortion, added up
 *     ripples     a normal map in the surface's tangent space [F6]
 *     light       ambient and N.L [F5]
 *     refract     colour along the refracted ray [F4], absorbed (inside.h)
 *     mirror      colour along the reflected ray [F3], by Fresnel's share [F1] [F2]
 *     foam        matt foam over the water (foam.h)
 *     glint       specular lobe of the light, R.V or N.H, where no foam hides it
 *
 * The mirror is a ray from the exact surface, so `mirror.distortion` has no meaning here.
 * With mirror.method the ray finds boat, drops and walls, otherwise only the sky. A
 * mirrored ray below the horizon would meet other water and is half as bright. */
#ifndef TP_TOOLS_REFERENCE_WATER_H
#define TP_TOOLS_REFERENCE_WATER_H
#include "solids.h"

/* Normal from the surface's slopes and the ripples. */
ref_vec ref_water_normal(const ref_scene *s, const ref_water *water);

/* Colour of water seen from above; *in_mirror: object in the water's mirror, REF_SKY:
 * none. */
ref_colour ref_water_colour(const ref_scene *s, const ref_water *water, ref_vec way,
                            ref_kind *in_mirror);
#endif
