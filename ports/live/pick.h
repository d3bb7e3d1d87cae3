/* SPDX-License-Identifier: MIT */
/* The place on the water under a pixel. */
#ifndef LIVE_PICK_H
#define LIVE_PICK_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/scene.h"

/* Where the ray through the middle of pixel (px, py) of a picture of width x height first
 * meets the surface as the last tick left it: waves, rings and pools, these without
 * heights where they bend the light only.  From below the surface as well.  False: it
 * never does within 8000 m, or meets land first, or a tank's walls end before.  Within
 * 1 px of what is drawn there, but for crests that overhang, what lies at a mesh's far
 * end, where its waves fade, and slow motion, whose pictures lie up to a tick before.
 * A pixel outside of the picture is one of a larger picture. */
bool pick_water(const tp_world *world, const tp_scene *scene, uint32_t width,
                uint32_t height, int32_t px, int32_t py, tp_vec3 *at);
#endif
