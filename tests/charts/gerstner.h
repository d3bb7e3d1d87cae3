/* SPDX-License-Identifier: MIT */
/* The seas of the chart "gerstner": those of a scene's first waves, all of one steepness,
 * which kernels and judge make alike.  The first three are three-swells'; the others go on
 * as they do, each shorter or longer and lower for its length, in other directions. */
#ifndef CHARTS_GERSTNER_H
#define CHARTS_GERSTNER_H
#include "tidepool/scene.h"

enum { GERSTNER_TICK = 1234, GERSTNER_MOST = 8 };

#define GERSTNER_HALF    TP_FX(200)     /* places at rest lie so far from 0, m */
#define GERSTNER_GRAVITY TP_FX(9.81)

/* The waves of a point "WAVES;STEEPNESS;FORM": their steepnesses add up to STEEPNESS.  Of
 * FORM the first letter counts: s is sharpened, e exact, c cheap.  Their number. */
uint32_t gerstner_waves(const char *point, tp_wave wave[GERSTNER_MOST]);

static inline char gerstner_form(const char *point)
{
    const char *form = point;

    for (; *point; point++)
        if (*point == ';')
            form = point + 1;
    return *form;
}
#endif
