/* SPDX-License-Identifier: MIT */
/* Clouds seen from the ground. */
#ifndef CLOUDS_H
#define CLOUDS_H
#include "space.h"

/* What of the sky is left, Q14, and what the clouds add to it. */
typedef struct {
    int32_t through;
    light shine;
    int32_t haze; /* share of the air's colour in that, Q14 */
} cloud_look;

/* Heaps on a level base 900 m up, lit by a sun high in the sky.  dir points up. */
cloud_look cumulus(vec dir, vec sun);

/* How thick a layer of bars along z is in a direction, 0..16384. */
int32_t cloud_bars(vec dir);
#endif
