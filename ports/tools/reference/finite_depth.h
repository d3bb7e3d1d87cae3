/* SPDX-License-Identifier: MIT */
/* Waves over a finite depth in double precision: [B2], [B7] and [B8] of the models as
 * printed, iterated until the result no longer changes. */
#ifndef TP_TOOLS_REFERENCE_FINITE_DEPTH_H
#define TP_TOOLS_REFERENCE_FINITE_DEPTH_H
#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#define REF_TWO_PI 6.28318530717958647693

static inline double ref_q32(int64_t x)
{
    return (double)x / 4294967296.0;
}

static inline int64_t ref_to_q32(double x)
{
    return (int64_t)llround(x * 4294967296.0);
}

/* Solves k tanh(kh) = k_inf by Newton's method from Eckart's 5 %. */
static inline double ref_depth_root(double k_inf, double h)
{
    double k = k_inf / sqrt(tanh(k_inf * h));

    for (int i = 0; i < 5; i++) {
        const double t = tanh(k * h), step = (k * t - k_inf) / (t + k * h * (1 - t * t));
        k -= step;
        if (fabs(step) < 1e-9 * k)
            break;
    }
    return k;
}

/* Solves k tanh(kh) = k_inf by bisection: x tanh x grows with x, so bisection cannot
 * fail. Rounding changes k tanh(kh) by less than 1e-15 of it, so farther than 4e-14 from
 * a root that is known to 1e-14 the root tells the side. */
static inline double ref_depth_number(double k_inf, double h)
{
    const double root = ref_depth_root(k_inf, h);
    const double below = root * (1 - 1e-14), above = root * (1 + 1e-14);
    const bool known = below * tanh(below * h) < k_inf && above * tanh(above * h) >= k_inf;
    const double near = known ? root * 4e-14 : HUGE_VAL;
    double low = k_inf, high = k_inf + 2 * sqrt(k_inf / h);

    while (low < high) {
        const double k = (low + high) / 2, off = k - root;
        const bool is_low = fabs(off) > near ? off < 0 : k * tanh(k * h) < k_inf;
        if (k == (is_low ? low : high))     /* neighbours */
            break;
        if (is_low)
            low = k;
        else
            high = k;
    }
    return (low + high) / 2;
}

/* Group velocity over phase velocity, cg / c [B7]. */
static inline double ref_group_share(double k, double h)
{
    const double x = 2 * k * h;
    return x > 700 ? 0.5 : x < 1e-6 ? 1 : (1 + x / sinh(x)) / 2;
}

static inline double ref_shoaling(double k_inf, double k, double h)
{
    return sqrt(k / k_inf / (2 * ref_group_share(k, h)));
}

/* Phase integral of sqrt(k^2 - kz^2) dx from x0 to x1 on a floor that rises by `slope`;
 * Simpson's rule in even steps of sqrt(h), in which k is almost linear. */
static inline double ref_slope_phase(double k_inf, double kz, double depth, double slope,
                                     double x0, double x1, int steps)
{
    const double s0 = sqrt(depth - slope * x0), s1 = sqrt(depth - slope * x1);
    double sum = 0;

    for (int i = 0; i <= 2 * steps; i++) {
        const double s = s0 + (s1 - s0) * i / (2 * steps);
        const double k = ref_depth_number(k_inf, s * s);
        const double f = sqrt(fmax(0, k * k - kz * kz)) * 2 * s / slope;
        sum += f * (i == 0 || i == 2 * steps ? 1 : i % 2 ? 4 : 2);
    }
    return sum * (s0 - s1) / (6 * steps);
}
#endif
