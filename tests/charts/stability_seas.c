/* SPDX-License-Identifier: MIT */
/* Deep water for the maps of the Jacobian and of inversion. */
#include "tests/charts/stability.h"

#define FIRST_HEADING 30.0      /* degrees off the axes */

#define GRAVITY       TP_FX(9.81)

/* Sets the waves. The lengths have no common measure, so all crests come arbitrarily close
 * together. */
static void waves_of(tp_wave wave[STABILITY_WAVES], int waves, double fan, double sum)
{
    double length = 24;

    for (int i = 0; i < waves; i++, length /= 1.6180339887498949) {
        const double turned = waves > 1 ? fan * (i / (waves - 1.0) - 0.5) : 0;
        wave[i] = (tp_wave){
            .amplitude = TP_FX(length / 40), .length = TP_FX(length),
            .steepness = TP_FX(sum / waves), .heading = TP_FX(FIRST_HEADING + turned),
            .speed = TP_FX_ONE,
        };
    }
}

tp_deep_water stability_sea(int waves, double fan, double sum)
{
    tp_wave wave[STABILITY_WAVES];
    tp_deep_water  deep;

    waves_of(wave, waves, fan, sum);
    tp_deep_water_init(&deep, wave, (uint32_t)waves, GRAVITY);
    return deep;
}

tp_deep_water stability_sea_unheld(int waves, double fan, double sum)
{
    tp_wave wave[STABILITY_WAVES];

    waves_of(wave, waves, fan, sum);
    return stability_unheld(wave, (uint32_t)waves, GRAVITY);
}

/* Half the steepnesses, doubled: below a sum of 2 each bend fits its Q2.30. Valid for the
 * sums of J and for plain steps; the fields for a point's slopes are not set. */
tp_deep_water stability_unheld(const tp_wave *wave, uint32_t count, tp_fx gravity)
{
    tp_wave half[TP_WAVES];
    tp_deep_water  deep;

    for (uint32_t i = 0; i < count; i++) {
        half[i] = wave[i];
        half[i].steepness /= 2;
    }
    tp_deep_water_init(&deep, half, count, gravity);
    for (uint32_t i = 0; i < deep.count; i++) {
        tp_swell *w = &deep.swell[i];
        w->bend *= 2;
        w->bend_xx *= 2;
        w->bend_xz *= 2;
        w->bend_zz *= 2;
        w->orbit_x *= 2;
        w->orbit_z *= 2;
    }
    deep.steepness_sum = 0;               /* invalid from here on */
    deep.steepness *= 2;
    deep.max_displacement *= 2;
    return deep;
}

double stability_sum(const tp_deep_water *deep)
{
    double sum = 0;

    for (uint32_t i = 0; i < deep->count; i++)
        sum += deep->swell[i].bend / 1073741824.0;
    return sum;
}

double stability_crests(const tp_deep_water *deep)
{
    double xx = 0, xz = 0, zz = 0;

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        xx += w->bend_xx / 1073741824.0;
        xz += w->bend_xz / 1073741824.0;
        zz += w->bend_zz / 1073741824.0;
    }
    return 1 - (xx + zz) / 2 - sqrt((xx - zz) * (xx - zz) / 4 + xz * xz);
}
