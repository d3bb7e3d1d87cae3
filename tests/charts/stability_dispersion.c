/* SPDX-License-Identifier: MIT */
/* Wave numbers over a depth, k tanh(kh) = k_inf [B2]: errors of the approximations over kh.
 * Deep: k = k_inf. Shallow: tanh(kh) = kh. Hunt: the sum of 1979 up to the sixth power. */
#include "tests/charts/stability.h"
#include "tests/charts/used.h"
#include "waves/coastal_water.h"

#define CHART "stability-dispersion"

/* Newton's method: x tanh x is convex, so the steps approach the root from above. */
double stability_kh(double y)
{
    double x = y > 1 ? y : sqrt(y);

    for (int i = 0; i < 100; i++) {
        const double t = tanh(x), next = x - (x * t - y) / (t + x * (1 - t * t));
        if (fabs(next - x) <= 1e-16 * x)
            break;
        x = next;
    }
    return x;
}

static double eckart(double y)
{
    return y / sqrt(tanh(y));
}

static double fenton(double y)
{
    return y / pow(tanh(pow(y, 0.75)), 2 / 3.0);
}

static double newton(double y)
{
    const double x = eckart(y), t = tanh(x);
    return x - (x * t - y) / (t + x * (1 - t * t));
}

static double hunt(double y)
{
    static const double d[] = { 0.6666666667, 0.3555555556, 0.1608465608, 0.0632098765,
                                0.0217540484, 0.0065407983 };
    double sum = 0;

    for (int i = 5; i >= 0; i--)
        sum = (sum + d[i]) * y;
    return sqrt(y * (y + 1 / (1 + sum)));
}

static double deep(double y)
{
    return y;
}

static double shallow(double y)
{
    return sqrt(y);
}

const stability_number stability_numbers[STABILITY_NUMBERS] = {
    { "eckart", tp_depth_wave_number_eckart, eckart },
    { "fenton", tp_depth_wave_number_fenton, fenton },
    { "newton", tp_depth_wave_number, newton },
    { "exact", tp_depth_wave_number_exact, NULL },
    { "hunt", NULL, hunt }, { "deep", NULL, deep }, { "shallow", NULL, shallow },
};

/* The reference uses the engine's rounded inputs, not the values before rounding. */
double stability_number_off(const stability_number *n, double kh, double length)
{
    const int64_t k_inf = tp_depth_wave_number_deep(TP_FX(length));
    const double  k = (double)k_inf / 4294967296.0;
    const tp_fx   depth = TP_FX(kh * tanh(kh) / k);
    const double  h = depth * STABILITY_LSB;

    return (double)n->engine(k_inf, depth) / 4294967296.0 * h / stability_kh(k * h) - 1;
}

double stability_formula_off(const stability_number *n, double kh)
{
    const double y = kh * tanh(kh);
    return n->formula(y) / stability_kh(y) - 1;
}

/* -- the map ------------------------------------------------------------------------- */

static const double lengths[] = { 5, 40, 300 };     /* m on deep water */

/* Prints a row. Errors at the level of double precision print as 0, so each machine prints
 * the same. */
static void row(double kh, const char *column, const char *suffix, double off)
{
    printf(CHART ",%.3g,%s%s,%.3g\n", kh, column, suffix,
           fabs(off) < 1e-11 ? 0 : fabs(off));
}

static double engine_off(const stability_number *n, double kh)
{
    double most = 0;

    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++)
        most = fmax(most, fabs(stability_number_off(n, kh, lengths[i])));
    return most;
}

enum { POINTS = 61 };

static double point_of(int i)
{
    return 0.01 * pow(1000, i / (POINTS - 1.0));
}

/* True if the scene has a wave whose kh at the scene's greatest depth is nearest to this
 * point. */
static bool is_of(const tp_scene *scene, int32_t point)
{
    const tp_fx deepest = scene->floor.map[0] ? -scene->floor.map_low
                                              : scene->floor.depth;

    for (int n = 0; deepest > 0 && n < TP_WAVES; n++) {
        if (scene->wave[n].amplitude <= 0)
            continue;
        const double k = 2 * STABILITY_PI / (scene->wave[n].length * STABILITY_LSB);
        const double kh = stability_kh(k * deepest * STABILITY_LSB);
        const double at = log(kh / 0.01) / log(1000) * (POINTS - 1);
        if ((int32_t)floor(at + 0.5) == point)
            return true;
    }
    return false;
}

void stability_dispersion(void)
{
    for (int i = 0; i < POINTS; i++) {
        const double kh = point_of(i);
        for (int n = 0; n < STABILITY_NUMBERS; n++) {
            const stability_number *number = &stability_numbers[n];
            if (number->formula)
                row(kh, number->name, "_theory", stability_formula_off(number, kh));
            if (number->engine)
                row(kh, number->name, "", engine_off(number, kh));
        }
        printf(CHART ",%.3g,used,%s\n", kh, used_by(is_of, i));
    }
}
