/* SPDX-License-Identifier: MIT */
/* Normals stay within the bounds of deep_water.h: one trochoid [A8] swept over steepness,
 * length, direction, phase and position, and deep water of any waves [A10]; compared with
 * double precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/deep_water.h"

#define FAR 30000.0             /* m in each direction, as in deep_water.h */

static uint64_t chance;

/* Bound of the phase error by the distance from the origin, rad. */
static double phase_bound(double k, double x0, double z0)
{
    return (fabs(x0) + fabs(z0)) * (1.5e-9 + 1e-8 * k);
}

/* -- single wave ----------------------------------------------------------------------- */

static double trochoid_bound(double s, double k, double x0, double z0)
{
    return (2.5e-6 + s * phase_bound(k, x0, z0)) / (1 - s) + 1.1e-5;
}

/* Q = 1: A = S / k, rounded to 16.16; the wave keeps the remaining Q. */
static deep_water trochoid(double s, double length)
{
    const double k = 2 * PI / length;
    deep_water o = { .count = 1, .gravity = TP_FX(9.81), .tick = 0 };

    o.wave[0] = (tp_wave){
        .amplitude = (tp_fx)lround(s / k / LSB), .length = (tp_fx)lround(length / LSB),
        .steepness = (tp_fx)lround(s / LSB), .heading = chance_fx(&chance, -180, 180),
        .speed = TP_FX_ONE, .phase = chance_fx(&chance, -180, 180),
    };
    deep_water_settle(&o);
    return o;
}

/* Steep waves have the largest errors beside their crests, where the slope changes sign. */
static void look(deep_water *o, double far, double *worst, measure *m)
{
    const ref_wave *w = &o->ref.wave[0];
    const double crest = PI / 2, aside = (1 - w->q) * chance_double(&chance, -3, 3);
    const tp_fx x = chance_fx(&chance, -far, far), z = chance_fx(&chance, -far, far);
    const double x0 = x * LSB, z0 = z * LSB;
    const double here = w->k * (w->dx * x0 + w->dz * z0);
    const double want = random_below(&chance, 2) ? crest + aside
                                                 : chance_double(&chance, -PI, PI);
    const double turns = (want - here) / (2 * PI);

    o->phases[0] = (tp_turn)(int64_t)llround((turns - floor(turns)) * 4294967296.0);
    o->ref_phases[0] = o->phases[0] / 4294967296.0 * 2 * PI;
    const ref_point p = ref_at_rest(&o->ref, o->ref_phases, x0, z0);
    const tp_surface_point got = tp_deep_water_displace_point(&o->deep, o->phases, x, z);
    const double off = normal_angle(&p, &got);
    const double share = off / trochoid_bound(w->q, w->k, x0, z0);
    measure_add(m, off * 180 / PI, (int64_t)(w->q * 1e6), x, z);
    *worst = fmax(*worst, share);
}

static void one_trochoid_keeps_its_bound(void **state)
{
    (void)state;
    static const double steep[] = { 0, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.93, 0.94, 0.95 };
    static const double far[] = { 0, 100, FAR };
    double all = 0;

    printf(
        "#    S   worst, degrees and of the bound: at the origin, within 100 m, 30 km\n");
    for (size_t i = 0; i < sizeof steep / sizeof *steep; i++) {
        printf("# %.2f ", steep[i]);
        for (size_t f = 0; f < 3; f++) {
            measure m = { .worst = 0 };
            double worst = 0;
            for (int n = 0; n < 2000; n++) {
                const double most = fmin(2000, 16 * 2 * PI / fmax(steep[i], 1e-3));
                const double length = chance_scale(&chance, 0.25, most) * LSB;
                deep_water o = trochoid(steep[i], length);
                for (int k = 0; k < 5 && o.deep.count; k++)
                    look(&o, far[f], &worst, &m);
            }
            printf("   %8.5f %.3f", m.worst, worst);
            all = fmax(all, worst);
            assert_true(worst < 1);
        }
        printf("\n");
    }
    assert_true(all > 0.5);
}

/* -- any deep water -------------------------------------------------------------------- */

static double sea_bound(const deep_water *o, double x0, double z0)
{
    double h = 0, b = 0, q = 0;

    for (int i = 0; i < o->ref.count; i++) {
        const ref_wave *w = &o->ref.wave[i];
        const double e = 5e-6 + phase_bound(w->k, x0, z0);
        const bool cut = w->amplitude > 0.3 * 2 * PI / w->k - 1e-9;
        h += w->k * (w->amplitude * turn_most(w) * e + (cut ? LSB / 2 : 0));
        b += w->q * e;
        q += w->q;
    }
    return hypot(h, b) / (1 - q) + 1.1e-5;
}

static void any_sea_keeps_its_bound(void **state)
{
    (void)state;
    measure m = { .what = "any sea", .unit = "of the bound" };

    for (int n = 0; n < 20000; n++) {
        deep_water o =
            n % 2 ? deep_water_any(&chance, 4)
                  : deep_water_usual(&chance, TP_WAVES, chance_double(&chance, 0, 1));
        const double far = n % 3 ? 500 : FAR;
        if (n % 5 == 0)
            deep_water_sharpen(&chance, &o);
        for (int k = 0; k < 5; k++) {
            const tp_fx x = chance_fx(&chance, -far, far),
                        z = chance_fx(&chance, -far, far);
            const tp_surface_point got =
                tp_deep_water_displace_point(&o.deep, o.phases, x, z);
            ref_point want = ref_at_rest(&o.ref, o.ref_phases, x * LSB, z * LSB);
            if (!o.deep.crossed)
                want = ref_uncrossed(want);
            measure_add(&m, normal_angle(&want, &got) / sea_bound(&o, x * LSB, z * LSB), n,
                        x, z);
        }
    }
    measure_print(&m);
    assert_true(m.worst < 1 && m.worst > 0.3);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_trochoid_keeps_its_bound),
        cmocka_unit_test(any_sea_keeps_its_bound),
    };
    return cmocka_run_group_tests_name("waves/normals", tests, NULL, NULL);
}
