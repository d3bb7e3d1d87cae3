/* SPDX-License-Identifier: MIT */
#include "check_sea.h"
#include <math.h>

tp_deep_water check_sea_make(const check_wave *waves, unsigned count)
{
    tp_deep_water deep = { .count = 0 };
    for (unsigned i = 0; i < count; i++) {
        const check_wave *w = &waves[i];
        const tp_wave_exact exact = {
            .turns = (uint64_t)llround(w->k / (2 * CHECK_PI) * 4294967296.0),
            .dx = check_q30(w->dx), .dz = check_q30(w->dz),
            .amplitude = check_fx(w->amplitude), .steepness = check_q30(w->q),
            .power = w->power,
        };
        tp_deep_water_append_wave(&deep, &exact);
    }
    return deep;
}

/* Returns the bound of the phase error, rad: the bound of waves/deep_water.h plus the
 * rounding of the point. */
static double phase_error(const check_wave *w, double x, double z)
{
    return (fabs(x) + fabs(z)) * (1.5e-9 + 1e-8 * w->k)
         + w->k * hypot(check_rounding(x), check_rounding(z));
}

/* Error bounds.  f of [A3] is at most 2, and f' at most (n + 1) / 2, n = power of the wave.
 * An error e of sine, cosine and phase changes f by n e, and f' by n (n + 1) / 2 e.
 * Rounded are A, each QA D, the point and the result.  Each step of the fixed-point
 * iteration passes on q times its error. */
check_bound check_sea_bound(const check_wave *waves, unsigned count, double x, double z)
{
    check_bound b = { .up = CHECK_HALF, .along = CHECK_HALF };
    double h = 0, j = 0, q = 0, slope = 0;
    for (unsigned i = 0; i < count; i++) {
        const check_wave *w = &waves[i];
        const double e = 5e-6 + phase_error(w, x, z), n = w->power;
        const double off = check_rounding(w->amplitude);
        b.up += w->amplitude * n * e + 2 * off;
        b.along += w->q / w->k * e + CHECK_HALF;
        h += w->k * (n + 1) / 2 * (w->amplitude * n * e + off);
        slope += w->k * (n + 1) / 2 * w->amplitude;
        j += w->q * e;
        q += w->q;
    }
    b.along += fmax(check_rounding(x), check_rounding(z));
    b.turn = hypot(h, j) / (1 - q) + 1.1e-5;
    b.step = b.up + slope * b.along / (1 - q);
    return b;
}

/* Bound of the normal's error.  A relative error of A turns the normal by at most half of
 * that error. */
double check_trochoid_bound(const check_wave *w, double x, double z)
{
    const double off = check_rounding(w->amplitude);
    const double lost = fmin(check_share(w->amplitude) / 2, w->k * off / (1 - w->q));
    return (2.5e-6 + w->q * phase_error(w, x, z)) / (1 - w->q) + 1.1e-5 + lost;
}
