/* SPDX-License-Identifier: MIT */
/* Stars over the dome of a night, by the definition at the head of the engine's stars
 * (src/features/sky/sky_stage.c): the sky is a cube of 6 x 64 x 64 cells, a hash of the
 * cell decides whether the cell has a star, its place, brightness and tint. The hash and
 * the tints are copied as data.
 *
 * A star is a disc on the sphere whose radius is the angle of 0.85 pixels at the picture's
 * centre; its light falls from the centre to the edge with the square of the distance.
 * Only a direct view shows stars: water mirrors none. */
#ifndef TP_TOOLS_REFERENCE_STARS_H
#define TP_TOOLS_REFERENCE_STARS_H
#include "scene.h"

/* Light of the stars from direction `way`, a unit vector; black if there is no star. */
ref_colour ref_stars(const ref_scene *s, ref_vec way);
#endif
