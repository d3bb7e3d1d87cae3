/* SPDX-License-Identifier: MIT */
/* Light of the sky from a direction: the plain gradient, generated skies, cube maps [F7];
 * brightness above white [F8]; haze, and the camera's exposure.  A generated sky is two
 * gradients mixed by the direction to the light, and a glow around the light.
 *
 * Stars are added to a direct view alone (stars.h).  The exposure comes from the world,
 * whose light meter evolves it. */
#ifndef TP_TOOLS_REFERENCE_SKY_LIGHT_H
#define TP_TOOLS_REFERENCE_SKY_LIGHT_H
#include "env.h"
#include "scene.h"

/* Sky that water at `at` mirrors in direction `way`: without the disc where the water has
 * glitter; a cube map is sampled at the water's mipmap level. */
ref_light ref_heaven_mirrored(const ref_scene *s, ref_vec way, ref_vec at);

/* Sky colour from direction `way`, a unit vector, clamped at white. */
ref_colour ref_heaven(const ref_scene *s, ref_vec way);

/* Colour with the scene's share of brightness above white, not clamped. */
ref_colour ref_heaven_whole(const ref_scene *s, ref_light light);

/* Haze: at depth z the share z^2 / (z^2 + h^2) of the colour becomes the horizon's
 * colour. */
ref_colour ref_heaven_haze(const ref_scene *s, ref_colour colour, ref_vec at);

/* The camera's exposure: E t / (1 + (E - 1) t^k), k = 1 for E > 1, else k = 4. */
ref_colour ref_heaven_exposed(const ref_scene *s, ref_colour colour);

/* Sky colour in direction `way`; `disc`: with the disc of the sun or moon. */
ref_light ref_dome(const ref_scene *s, ref_vec way, bool disc);

#endif
