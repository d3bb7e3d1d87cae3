/* SPDX-License-Identifier: MIT */
/* Deep water in double precision, slow and plain: [A1]-[A3] and [A7]-[A11] of the models
 * with the stated clamps, from the numbers of the waves and no intermediate result of the
 * core. */
#ifndef TP_TOOLS_REFERENCE_DEEP_WATER_H
#define TP_TOOLS_REFERENCE_DEEP_WATER_H
#include <math.h>
#include "tidepool/world.h"

#define PI 3.14159265358979323846

typedef struct {
    double amplitude, k, q;     /* m, rad/m, Q k A after the clamp */
    double dx, dz;              /* direction of travel */
    double phase;               /* phase at tick 0, rad */
    long double turns_tick;     /* turns a tick */
    int power;                  /* exponent of [A3]; 1: a sine */
} ref_wave;

typedef struct {
    ref_wave wave[TP_WAVES];
    int count;
} ref_deep_water;

typedef struct {
    double x, y, z;
    double nx, ny, nz;          /* normal, not of unit length: ny is det J */
    double jxx, jxz, jzz, hx, hz;
} ref_point;

static inline double ref_number(int32_t fx)
{
    return fx / 65536.0;
}

static inline ref_wave ref_wave_make(const tp_wave *w, double gravity, double share)
{
    const long double length = w->length / 65536.0L;
    const double heading = ref_number(w->heading) * PI / 180;
    const double cap = 0.3 * (double)length, amplitude = ref_number(w->amplitude);

    return (ref_wave){
        .amplitude = amplitude < cap ? amplitude : cap,
        .k = 2 * PI / (double)length,
        .q = ref_number(w->steepness) * share,
        .dx = sin(heading), .dz = -cos(heading),
        .phase = ref_number(w->phase) * PI / 180,
        .turns_tick = sqrtl((long double)gravity / length / (2 * 3.14159265358979323846L))
                    * (w->speed / 65536.0L) / TP_TICKS_PER_SECOND,
        .power = w->exponent > 1 ? w->exponent : 1,
    };
}

static inline ref_deep_water ref_deep_water_make(const tp_wave *waves, int count,
                                                 tp_fx gravity)
{
    ref_deep_water sea = { .count = 0 };
    double steepness = 0;

    for (int i = 0; i < count; i++)
        steepness += waves[i].amplitude > 0 ? ref_number(waves[i].steepness) : 0;
    for (int i = 0; i < count; i++) {
        if (waves[i].amplitude > 0)
            sea.wave[sea.count++] = ref_wave_make(&waves[i], ref_number(gravity),
                                                steepness > 0.95 ? 0.95 / steepness : 1);
    }
    return sea;
}

/* Phases of a tick, rad. After ten years there are at most 2^35 turns, and a long double
 * with 64 bits keeps a precision of 2^-29 turns. */
static inline void ref_phases(const ref_deep_water *sea, uint64_t tick,
                              double phase[TP_WAVES])
{
    for (int i = 0; i < sea->count; i++) {
        const long double turns = sea->wave[i].turns_tick * tick;
        phase[i] = sea->wave[i].phase - (double)(turns - floorl(turns)) * 2 * PI;
    }
}

/* f - mean of [A3], and f'. The mean of 2 b^n is 2 C(2n, n) / 4^n. */
static inline double ref_profile(int power, double th, double *slope)
{
    const double b = (sin(th) + 1) / 2;
    double mean = 2;

    if (power == 1) {
        *slope = cos(th);
        return sin(th);
    }

    for (int n = 1; n <= power; n++)
        mean *= (2 * n - 1) / (2.0 * n);
    *slope = power * pow(b, power - 1) * cos(th);
    return 2 * pow(b, power) - mean;
}

static inline ref_point ref_at_rest(const ref_deep_water *sea, const double phase[TP_WAVES],
                                    double x0, double z0)
{
    ref_point p = { .x = x0, .z = z0, .jxx = 1, .jzz = 1 };

    for (int i = 0; i < sea->count; i++) {
        const ref_wave *w = &sea->wave[i];
        const double th = w->k * (w->dx * x0 + w->dz * z0) + phase[i];
        const double s = sin(th), c = cos(th), ka = w->k * w->amplitude;
        double rise;
        const double f = ref_profile(w->power, th, &rise);

        p.x += w->q / w->k * w->dx * c;
        p.y += w->amplitude * f;
        p.z += w->q / w->k * w->dz * c;
        p.hx += ka * w->dx * rise;
        p.hz += ka * w->dz * rise;
        p.jxx -= w->q * w->dx * w->dx * s;
        p.jxz -= w->q * w->dx * w->dz * s;
        p.jzz -= w->q * w->dz * w->dz * s;
    }
    p.nx = p.hz * p.jxz - p.hx * p.jzz;
    p.ny = p.jxx * p.jzz - p.jxz * p.jxz;
    p.nz = p.hx * p.jxz - p.hz * p.jxx;
    return p;
}

/* Normal [A10] without the cross terms: N = (-hx, 1 - sum q sin th, -hz). */
static inline ref_point ref_uncrossed(ref_point p)
{
    p.nx = -p.hx;
    p.ny = p.jxx + p.jzz - 1;
    p.nz = -p.hz;
    return p;
}

/* Surface point above or below (x, z) by Newton's method; the step is halved if the full
 * step does not come nearer. */
static inline ref_point ref_sample_deep_water(const ref_deep_water *sea,
                                              const double phase[TP_WAVES], double x,
                                              double z)
{
    double x0 = x, z0 = z, step = 1;
    ref_point p = ref_at_rest(sea, phase, x0, z0);

    for (int n = 0; n < 200; n++) {
        const double ex = x - p.x, ez = z - p.z;
        const double dx = (ex * p.jzz - ez * p.jxz) / p.ny;
        const double dz = (ez * p.jxx - ex * p.jxz) / p.ny;
        const ref_point next = ref_at_rest(sea, phase, x0 + step * dx, z0 + step * dz);
        if (hypot(x - next.x, z - next.z) <= hypot(ex, ez)) {
            x0 += step * dx;
            z0 += step * dz;
            p = next;
            step = 1;
        } else {
            step /= 2;
        }
    }
    return p;
}
#endif
