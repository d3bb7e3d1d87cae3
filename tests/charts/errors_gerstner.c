/* SPDX-License-Identifier: MIT */
/* Points of deep water against [A7]-[A10] in double precision, from the numbers of the
 * waves alone. `normal` is the error against the exact normal; `rounding` is the error of
 * fixed point alone, against the same form in double precision. */
#include "tests/charts/errors.h"
#include "tests/charts/gerstner.h"
#include "tests/charts/used.h"
#include "tools/reference/deep_water.h"
#include "waves/deep_water.h"

#define LSB (1 / 65536.0)

static double degrees_between(const ref_point *p, const double n[3])
{
    const double x = p->ny * n[2] - p->nz * n[1], y = p->nz * n[0] - p->nx * n[2];
    const double z = p->nx * n[1] - p->ny * n[0];
    const double dot = p->nx * n[0] + p->ny * n[1] + p->nz * n[2];

    return atan2(sqrt(x * x + y * y + z * z), dot) * 180 / PI;
}

/* True if the scene has that number of waves and uses the form; sums of steepness up to 0.3
 * count with the gentle form. Waves over a floor or in wind are coastal water and do not
 * count. */
static bool takes(const tp_scene *scene, int32_t point)
{
    const char form = (char)(point & 0xff);
    tp_deep_water deep;

    tp_deep_water_init(&deep, scene->wave, used_coast(scene) ? 0 : TP_WAVES,
                       scene->water.gravity);
    return deep.count == (uint32_t)point >> 16
        && (deep.steepness > TP_FX(0.3)) == (point >> 8 & 1)
        && form == (deep.sharpened ? 's' : deep.crossed ? 'e' : 'c');
}

static void say_used(const kernel *k)
{
    const int32_t count = k->point[0] - '0', steep = k->point[4] > '3';
    used_row(k->chart, k->point, takes, count << 16 | steep << 8 | gerstner_form(k->point));
}

void judge_gerstner(const kernel *k, const int32_t *in, const int32_t *out)
{
    tp_wave wave[GERSTNER_MOST];
    const int count = (int)gerstner_waves(k->point, wave);
    const ref_deep_water deep = ref_deep_water_make(wave, count, GERSTNER_GRAVITY);
    double phase[TP_WAVES], place = 0, worst = 0, sum = 0, rounding = 0;

    ref_phases(&deep, GERSTNER_TICK, phase);
    for (uint32_t i = 0; i < KERNEL_UNITS; i++, in += 2, out += 5) {
        const ref_point want = ref_at_rest(&deep, phase, in[0] * LSB, in[1] * LSB);
        const ref_point same = gerstner_form(k->point) == 'c' ? ref_uncrossed(want) : want;
        const double n[3] = { -out[3] * LSB, 1, -out[4] * LSB };
        const double x = out[0] * LSB - want.x, y = out[1] * LSB - want.y;
        const double z = out[2] * LSB - want.z, angle = degrees_between(&want, n);

        place = fmax(place, 1000 * sqrt(x * x + y * y + z * z));
        worst = fmax(worst, angle);
        sum += angle * angle;
        rounding = fmax(rounding, degrees_between(&same, n));
    }
    error_row(k, "place_max", place);
    error_row(k, "normal_max", worst);
    error_row(k, "normal_rms", sqrt(sum / KERNEL_UNITS));
    error_row(k, "rounding_max", rounding);
    say_used(k);
}
