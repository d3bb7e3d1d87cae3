/* SPDX-License-Identifier: MIT */
/* Points of deep water: number of Gerstner waves, and form of the normal, [A7]-[A10].
 * `exact` has the cross terms of [A10], `cheap` has no cross terms; the engine uses `cheap`
 * up to a steepness of 0.3 and `exact` beyond. `sharp` is the exact form for crests with
 * power 2 [A3]. Results: place, then slopes dy/dx and dy/dz. */
#include "tests/charts/gerstner.h"
#include "tests/charts/kernels.h"
#include "waves/deep_water.h"

#define WAVE(amplitude, length, heading, phase) \
    { TP_FX(amplitude), TP_FX(length), 0, TP_FX(heading), TP_FX(phase), TP_FX_ONE, 1 }

static const tp_wave waves[GERSTNER_MOST] = {
    WAVE(0.45, 22, 70, 0), WAVE(0.30, 13, 115, 140), WAVE(0.15, 7, 20, 250),
    WAVE(0.35, 17, 95, 60), WAVE(0.20, 9.5, 50, 310), WAVE(0.10, 5.3, 140, 190),
    WAVE(0.50, 31, 85, 20), WAVE(0.07, 4.1, 5, 100),
};

uint32_t gerstner_waves(const char *point, tp_wave wave[GERSTNER_MOST])
{
    const uint32_t count = (uint32_t)(point[0] - '0');
    const tp_fx steepness = point[4] == '3' ? TP_FX(0.3) : TP_FX(0.7);  /* "N;0.3;..." */

    for (uint32_t i = 0; i < count; i++) {
        wave[i] = waves[i];
        wave[i].steepness = steepness / (tp_fx)count;
        wave[i].exponent = gerstner_form(point) == 's' ? 2 : 1;
    }
    return count;
}

static tp_deep_water  deep;
static tp_turn phases[TP_WAVES];

static void fill_places(int32_t *in, const char *point)
{
    tp_wave wave[GERSTNER_MOST];
    const uint32_t count = gerstner_waves(point, wave);

    tp_deep_water_init(&deep, wave, count, GERSTNER_GRAVITY);
    deep.crossed = gerstner_form(point) != 'c';
    tp_deep_water_phases(&deep, GERSTNER_TICK, 0, phases);
    for (uint32_t i = 0; i < KERNEL_UNITS; i++) {
        in[2 * i] = kernel_spread(i, KERNEL_STEP, GERSTNER_HALF);
        in[2 * i + 1] = kernel_spread(i, KERNEL_CROSS, GERSTNER_HALF);
    }
}

static void run_gerstner(const int32_t *in, int32_t *out)
{
    for (uint32_t i = 0; i < KERNEL_UNITS; i++, in += 2, out += 5) {
        const tp_surface_point at =
            tp_deep_water_displace_point(&deep, phases, in[0], in[1]);
        out[0] = at.position.x;
        out[1] = at.position.y;
        out[2] = at.position.z;
        out[3] = at.slope_x;
        out[4] = at.slope_z;
    }
}

#define POINTS(X) \
    X(1, 3, exact) X(2, 3, exact) X(3, 3, exact) X(4, 3, exact) X(8, 3, exact) \
    X(1, 3, cheap) X(2, 3, cheap) X(3, 3, cheap) X(4, 3, cheap) X(8, 3, cheap) \
    X(1, 3, sharp) X(2, 3, sharp) X(3, 3, sharp) X(4, 3, sharp) X(8, 3, sharp) \
    X(1, 7, exact) X(2, 7, exact) X(3, 7, exact) X(4, 7, exact) X(8, 7, exact) \
    X(1, 7, cheap) X(2, 7, cheap) X(3, 7, cheap) X(4, 7, cheap) X(8, 7, cheap) \
    X(1, 7, sharp) X(2, 7, sharp) X(3, 7, sharp) X(4, 7, sharp) X(8, 7, sharp)

#define POINT(n, tenths, form) #n ";0." #tenths ";" #form
#define FILL(n, tenths, form) \
    static void fill_##n##_##tenths##_##form(int32_t *in) \
    { \
        fill_places(in, POINT(n, tenths, form)); \
    }
POINTS(FILL)

#define ROW(n, tenths, form) \
    { "gerstner", POINT(n, tenths, form), fill_##n##_##tenths##_##form, run_gerstner, \
      2, 5, (n) * sizeof(tp_swell) },

const kernel kernels_gerstner[] = {
    POINTS(ROW)
    { NULL, NULL, NULL, NULL, 0, 0, 0 },
};
