/* SPDX-License-Identifier: MIT */
/* Waves on a fan's grid against cells in a wavelength, as rows of the chart "cells": a wave
 * is sampled at vertices, linear between, unfiltered and by the fan's weight.  Errors are
 * in percent of the wave's rms, over places and phases. */
#include <math.h>
#include <stdio.h>
#include "view/fan.h"

#define PI 3.14159265358979323846

enum { PHASES = 64, PLACES = 64 };

/* Returns the sampled wave at `place`, in cells; `offset` moves all vertices. */
static double sampled_wave(double cells, double place, double offset, double phase)
{
    const double k = 2 * PI / cells, left = floor(place - offset);
    const double share = place - offset - left, at = left + offset;

    return (1 - share) * cos(k * at + phase) + share * cos(k * (at + 1) + phase);
}

/* Returns the rms of the error of a wave with this weight, in percent. */
static double wave_error(double cells, double weight)
{
    double sum = 0;

    for (int i = 0; i < PHASES * PLACES; i++) {
        const double place = (i / PHASES + 0.5) / PLACES, phase = 2 * PI * i / PHASES;
        const double d = weight * sampled_wave(cells, place, 0, phase)
                       - cos(2 * PI / cells * place + phase);
        sum += d * d;
    }
    return 100 * sqrt(2 * sum / (PHASES * PLACES));
}

/* Returns the rms of the change when all vertices move by half a cell, in percent. */
static double slide_error(double cells, double weight)
{
    double sum = 0;

    for (int i = 0; i < PHASES * PLACES; i++) {
        const double place = (i / PHASES + 0.5) / PLACES, phase = 2 * PI * i / PHASES;
        const double d = sampled_wave(cells, place, 0, phase)
                       - sampled_wave(cells, place, 0.5, phase);
        sum += weight * weight * d * d;
    }
    return 100 * sqrt(2 * sum / (PHASES * PLACES));
}

int main(void)
{
    static const double of[] = { 1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3, 3.25, 3.5, 4, 5,
                                 6, 8, 10, 12, 16, 24, 32 };

    for (size_t i = 0; i < sizeof of / sizeof of[0]; i++) {
        const double c = of[i], k = 2 * PI / c;
        const double weight =
            tp_fan_wave_weight(TP_FX_ONE, (int64_t)llround(4294967296.0 / c)) / 65536.0;

        printf("cells,%g,unfiltered,%.3g\n", c, wave_error(c, 1));
        printf("cells,%g,filtered,%.3g\n", c, wave_error(c, weight));
        printf("cells,%g,theory,%.3g\n", c, 100 * k * k / sqrt(120));
        printf("cells,%g,slide,%.3g\n", c, slide_error(c, 1));
        printf("cells,%g,filtered_slide,%.3g\n", c, slide_error(c, weight));
        printf("cells,%g,variance,%.3g\n", c, 100 * (1 - weight * weight));
    }
    return 0;
}
