/* SPDX-License-Identifier: MIT */
/* Generated skies: two gradients mixed by the way to the light, and a glow around it. */
#ifndef TP_REFERENCE_DOME_H
#define TP_REFERENCE_DOME_H
#include "heaven.h"

/* `disc`: with that of the sun or moon. */
ref_light ref_dome(const ref_scene *s, ref_vec way, bool disc);
#endif
