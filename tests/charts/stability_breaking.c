/* SPDX-License-Identifier: MIT */
/* Breaking criteria [B14] [B15] over a wave's height and the depth, both in local
 * wavelengths; and the path of the shipped scenes' waves up to the shore, with shoaling
 * [B7] and without the cap. */
#include "tests/charts/stability.h"
#include "tests/charts/used.h"
#include "waves/coastal_water.h"

#define CHART  "stability-breaking"
#define LENGTH 16.0             /* wavelength of the map's wave, m */

double stability_rise(int i)
{
    return 0.004 * pow(100, i / (STABILITY_RISES - 1.0));
}

double stability_depth(int j)
{
    return 0.01 * pow(100, j / (STABILITY_DEPTHS - 1.0));
}

uint32_t stability_flags(double rise, double depth)
{
    return tp_breaking_flags(TP_FX(LENGTH * rise), tp_depth_wave_number_deep(TP_FX(LENGTH)),
                             TP_FX(LENGTH * depth));
}

double stability_border(int criterion, double h_over_l)
{
    return criterion == STABILITY_STEEP ? 1 / 7.0
         : criterion == STABILITY_DEPTH ? 0.78 * h_over_l
                                        : 0.142 * tanh(2 * STABILITY_PI * h_over_l);
}

/* -- the map ------------------------------------------------------------------------- */

static void row(const char *set, double h, double rise, uint32_t flags, const char *used)
{
    printf(CHART ",%s;%.3g;%.3g,flags,%u\n", set, h, rise, (unsigned)flags);
    printf(CHART ",%s;%.3g;%.3g,used,%s\n", set, h, rise, used);
}

/* Rows of one wave over all depths of the scene that the map shows. */
static void rows_of_wave(const char *name, int n, const tp_wave *wave, double deepest)
{
    const int64_t k_inf = tp_depth_wave_number_deep(wave->length);
    char set[96];

    snprintf(set, sizeof set, "%s-%d", name, n);
    for (double depth = deepest; depth > 0.05; depth /= 1.25) {
        const tp_fx   h = TP_FX(depth);
        const int64_t k = tp_depth_wave_number_exact(k_inf, h);
        const tp_fx   ks = tp_depth_shoaling_factor(k_inf, k, h);
        const double  height = 2.0 * wave->amplitude * ks * STABILITY_LSB;
        const double  length = 2 * STABILITY_PI * 4294967296.0 / (double)k;
        const double  rise = height * STABILITY_LSB / length;
        if (rise > stability_rise(STABILITY_RISES - 1))
            break;
        row(set, depth / length, rise, tp_breaking_flags((tp_fx)height, k, h), name);
    }
}

static void rows_of_scenes(void)
{
    const char *name;

    for (size_t i = 0; used_scene(i, &name); i++) {
        const tp_scene *scene = used_scene(i, &name);
        const tp_fx deepest = scene->floor.map[0] ? -scene->floor.map_low
                                                  : scene->floor.depth;
        for (int n = 0; deepest > 0 && n < TP_WAVES; n++)
            if (scene->wave[n].amplitude > 0)
                rows_of_wave(name, n, &scene->wave[n], deepest * STABILITY_LSB);
    }
}

void stability_breaking(void)
{
    for (int j = 0; j < STABILITY_DEPTHS; j++)
        for (int i = 0; i < STABILITY_RISES; i++)
            row("map", stability_depth(j), stability_rise(i),
                stability_flags(stability_rise(i), stability_depth(j)), "-");
    rows_of_scenes();
}
