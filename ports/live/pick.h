/* SPDX-License-Identifier: MIT */
/* The place on the water under a pixel. */
#ifndef LIVE_PICK_H
#define LIVE_PICK_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/scene.h"

/* Where the ray through the middle of pixel (px, py) of a picture of width x height first
 * meets the surface as it is now: waves, rings and pools.  False: it never does within
 * 8000 m.  From below the surface as well.  Within 1 px of what is drawn there, but for
 * crests that overhang. */
bool pick_water(const tp_world *world, const tp_scene *scene, uint32_t width,
                uint32_t height, int32_t px, int32_t py, tp_vec3 *at);
#endif
