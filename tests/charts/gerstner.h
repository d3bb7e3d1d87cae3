/* SPDX-License-Identifier: MIT */
/* Deep water of the chart "gerstner": a scene's first waves, all with one steepness; shared
 * by kernels and their checks. The first three waves are those of three-swells; the others
 * continue the series with other lengths and directions, each with a lower amplitude for
 * its length. */
#ifndef TP_TESTS_CHARTS_GERSTNER_H
#define TP_TESTS_CHARTS_GERSTNER_H
#include "tidepool/scene.h"

enum { GERSTNER_TICK = 1234, GERSTNER_MOST = 8 };

#define GERSTNER_HALF    TP_FX(200)     /* bound of a rest point's coordinates, m */
#define GERSTNER_GRAVITY TP_FX(9.81)

/* Sets the waves of a point "WAVES;STEEPNESS;FORM": the steepnesses add up to STEEPNESS.
 * The first letter of FORM counts: s sharpened, e exact, c cheap. Returns the number of
 * waves. */
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
