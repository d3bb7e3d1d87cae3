/* SPDX-License-Identifier: MIT */
/* Mean Fresnel share of rough water by the view's elevation, as rows of the chart
 * "rough-fresnel": sums over slopes in double precision, and the errors of flat water, of
 * N.V' = sqrt(N.V^2 + s^2) [V5], of Bruneton's fit [V2] and of the engine's bend.  Waves
 * hide what faces away: a slope counts by its N.V as seen.  Ripples count every slope, by
 * an N.V of 1/10 at least. */
#include <math.h>
#include <stdio.h>
#include "ports/tools/reference/shading.h"
#include "shade/optics.h"
#include "shade/rough_lobe.h"

#define PI 3.14159265358979323846
#define RIPPLED_VIEW 0.1

typedef struct {
    double nv, level;           /* sine and cosine of the elevation */
    double slope;               /* rms of the slopes along and across the view */
    bool   ripples;
} rough_case;

static double share(double nv)
{
    return ref_fresnel(fmin(1, fmax(0, nv)));
}

static double floor_of(const rough_case *c)
{
    return c->ripples ? RIPPLED_VIEW : 0;
}

/* Returns the mean share of slopes up to 5 times their rms. */
static double mean_share(const rough_case *c)
{
    double sum = 0, weights = 0;

    for (double a = -5; a <= 5; a += 0.05)
        for (double b = 0.025; b <= 5; b += 0.05) {
            const double size = sqrt(1 + c->slope * c->slope * (a * a + b * b));
            const double seen = c->nv + c->level * c->slope * a;
            const double weight = exp(-(a * a + b * b) / 2)
                                * (c->ripples ? 1 : fmax(0, seen));
            sum += weight * share(fmax(seen / size, floor_of(c)));
            weights += weight;
        }
    return sum / weights;
}

/* Returns Bruneton's fit [V2]. */
static double fitted_share(const rough_case *c)
{
    const double straight = share(1), nv = fmax(c->nv, floor_of(c));

    return straight + (1 - straight) * pow(1 - nv, 5 * exp(-2.69 * c->slope))
                    / (1 + 22.7 * pow(c->slope, 1.5));
}

/* Returns the share by the engine's bend of N.V: a view from above meets slopes less. */
static double bent_share(const rough_case *c)
{
    const double met = c->slope * c->level;
    const uint32_t variance = (uint32_t)lround(met * met * TP_ROUGH_ONE);
    const tp_rough_view view = tp_rough_view_make(c->ripples ? variance : 0,
                                                  c->ripples ? 0 : variance);
    const int32_t nv = tp_rough_view_cosine((int32_t)lround(c->nv * 16384), &view);

    return tp_fresnel((tp_q30)nv << 16) / (double)TP_Q30_ONE;
}

static void print_rows(const rough_case *c, double elevation)
{
    const double mean = mean_share(c), low = floor_of(c);
    const double value[] = {
        mean, share(fmax(c->nv, low)) - mean,
        share(fmax(hypot(c->nv, c->slope), low)) - mean,
        fitted_share(c) - mean, bent_share(c) - mean,
    };
    static const char *const name[] = { "mean", "flat", "root", "fit", "bend" };

    for (int i = 0; i < 5; i++)
        printf("rough-fresnel,%s;%g;%g,%s,%.2f\n", c->ripples ? "ripples" : "waves",
               c->slope, elevation, name[i], round(1e4 * value[i]) / 100 + 0.0);
}

int main(void)
{
    static const double of[] = { 0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 14, 17, 20, 25, 30, 35,
                                 40, 50, 60, 75, 90 };
    static const double slopes[] = { 0.05, 0.1, 0.2 };

    for (int kind = 0; kind < 2; kind++)
        for (int s = 0; s < 3; s++)
            for (size_t i = 0; i < sizeof of / sizeof of[0]; i++) {
                const double at = of[i] * PI / 180;
                const rough_case c = { sin(at), cos(at), slopes[s], kind == 1 };
                print_rows(&c, of[i]);
            }
    return 0;
}
