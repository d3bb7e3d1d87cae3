/* SPDX-License-Identifier: MIT */
/* Generated skies: two gradients mixed by the direction to the light, and a glow around the
 * light. */
#ifndef TP_REFERENCE_DOME_H
#define TP_REFERENCE_DOME_H
#include "heaven.h"

/* Sky colour in direction `way`; `disc`: with the disc of the sun or moon. */
ref_light ref_dome(const ref_scene *s, ref_vec way, bool disc);
#endif
