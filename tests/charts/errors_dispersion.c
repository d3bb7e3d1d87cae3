/* SPDX-License-Identifier: MIT */
/* Wave numbers over a depth against x tanh x = y in double precision, for y from 1e-4 to 10
 * in a geometric series: k h from 0.01 to 10. The inputs are computed in integers, so no C
 * library's logarithm changes them. */
#include <stdlib.h>
#include "tests/charts/spread.h"
#include "tests/charts/used.h"

#define TWO_32 4294967296.0

enum { BLOCKS = 32 };

/* Newton's method from Eckart's approximation; the dispersion relation itself tells if the
 * iteration has converged. */
static double depth_of(double y)
{
    double x = y / sqrt(tanh(y));

    for (int i = 0; i < 8; i++) {
        const double t = tanh(x);
        x -= (x * t - y) / (t + x * (1 - t * t));
    }
    if (!(fabs(x * tanh(x) / y - 1) < 1e-14)) {
        fprintf(stderr, "dispersion: x tanh x is not %g at %g\n", y, x);
        exit(EXIT_FAILURE);
    }
    return x;
}

/* Input for y in Q40 over the n-th depth. Returns the exact k h of the rounded input. */
static double wave_of(uint64_t y, uint32_t n, int32_t *in)
{
    const tp_fx h = TP_FX(1.75) + kernel_spread(n, KERNEL_STEP, TP_FX(1.25));
    const uint64_t k = (y >> 8 << 16) / (uint32_t)h;

    in[0] = (int32_t)(uint32_t)k;
    in[1] = (int32_t)(k >> 32);
    in[2] = h;
    return depth_of((double)k / TWO_32 * h / 65536);
}

static double number_of(const int32_t *out)
{
    return ((double)out[1] * TWO_32 + (uint32_t)out[0]) / TWO_32;
}

/* True if the scene has waves over a floor or in wind. */
static bool has_coastal(const tp_scene *s, int32_t unused)
{
    bool waves = false;

    (void)unused;
    for (int i = 0; i < TP_WAVES; i++)
        waves = waves || s->wave[i].amplitude > 0;
    return waves && used_coast(s);
}

static bool never(const tp_scene *s, int32_t unused)
{
    (void)s, (void)unused;
    return false;
}

/* Coastal waves are set up with tp_depth_wave_number_exact; the engine calls no other
 * method. */
static used_test *user_of(const kernel *k)
{
    return strcmp(k->point, "newton-3") == 0 ? has_coastal : never;
}

void judge_dispersion(const kernel *k, const int32_t *counted, const int32_t *counted_out)
{
    static int32_t in[3 * KERNEL_UNITS], out[2 * KERNEL_UNITS];
    static double  x[KERNEL_UNITS];
    uint64_t y = 109951163;             /* 1e-4; the factor is 10^(5/32767) - 1 as Q32 */
    spread s = { 0 };

    (void)counted, (void)counted_out;
    for (uint32_t block = 0; block < BLOCKS; block++) {
        for (uint32_t i = 0; i < KERNEL_UNITS; i++) {
            x[i] = wave_of(y, block * KERNEL_UNITS + i, in + 3 * i);
            y += (y >> 8) * 1509333 >> 24;
        }
        k->run(in, out);
        for (uint32_t i = 0; i < KERNEL_UNITS; i++)
            spread_add(&s, number_of(out + 2 * i) * (in[3 * i + 2] / 65536.0) / x[i] - 1);
    }
    spread_rows(k, &s);
    used_row(k->chart, k->point, user_of(k), 0);
}
