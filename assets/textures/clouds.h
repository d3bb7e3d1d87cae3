/* SPDX-License-Identifier: MIT */
/* Clouds seen from the ground. */
#ifndef CLOUDS_H
#define CLOUDS_H
#include "space.h"

/* Share of the sky that is still visible, Q14, and light that the clouds add. */
typedef struct {
    int32_t through;
    light shine;
    int32_t haze; /* share of the air's colour in `shine`, Q14 */
} cloud_look;

/* Heaps over a level base 900 m up, lit by a sun high in the sky; dir points up. */
cloud_look cumulus(vec dir, vec sun);

/* Thickness of a layer of bars along z in a direction, 0..16384. */
int32_t cloud_bars(vec dir);
#endif
