/* SPDX-License-Identifier: MIT */
/* The light of the sky from a direction: the plain gradient, generated skies, cubes of
 * six pictures [F7]; its share beyond white [F8]; air, and the camera's exposure.
 *
 * Left out: stars, of which water mirrors none.  The camera's exposure is the world's
 * own, which its meter evolves. */
#ifndef TP_REFERENCE_HEAVEN_H
#define TP_REFERENCE_HEAVEN_H
#include "env.h"
#include "scene.h"

/* What water mirrors from there: not the disc where there is glitter; of a cube a level
 * for water at `at`. */
ref_light ref_heaven_mirrored(const ref_scene *s, ref_vec way, ref_vec at);

/* What comes from `way`, a unit vector, held at white. */
ref_colour ref_heaven(const ref_scene *s, ref_vec way);

/* Light with its share beyond white, not held. */
ref_colour ref_heaven_whole(const ref_scene *s, ref_light light);

/* Air: of a colour at depth z the share z^2 / (z^2 + h^2) goes into the horizon's. */
ref_colour ref_heaven_haze(const ref_scene *s, ref_colour colour, ref_vec at);

/* As the camera is exposed: E t / (1 + (E - 1) t^k), k 1 for E > 1, else 4. */
ref_colour ref_heaven_exposed(const ref_scene *s, ref_colour colour);
#endif
