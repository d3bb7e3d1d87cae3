/* SPDX-License-Identifier: MIT */
/* Effects of the floor on coastal waves: length and height over a level floor, phases over
 * a slope compared with the integral in double precision, and a map of a slope compared
 * with the slope. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/finite_depth.h"
#include "tools/reference/deep_water.h"
#include "tests/lib/measure.h"
#include "tests/lib/coastal_water.h"

static uint64_t chance;

/* -- level floors ------------------------------------------------------------------ */

/* The three limits of an amplitude.  Tables cut the corner between two limits: with slopes
 * of h^-1/4 and h^1, and nodes h/8 apart, the relative error is 1.25 / 8 / 4, 3.9 %. */
typedef struct {
    double shoaled, depth, miche;
} limits;

static double least_of(const limits *a)
{
    return fmin(fmin(a->shoaled, a->depth), a->miche);
}

static bool at_a_corner(const limits *a)
{
    const double next = 1.17 * least_of(a);
    return (a->shoaled < next) + (a->depth < next) + (a->miche < next) > 1;
}

/* A(h) [B7] capped by [B15] and by Miche's limit, and k(h). */
static void level_floors_shorten_and_raise_waves(void **state)
{
    (void)state;
    measure height = { .what = "height", .unit = "of itself" };
    measure corner = { .what = "height at a corner", .unit = "of itself" };
    measure phase = { .what = "phase, level", .unit = "rad" };

    for (int n = 0; n < 300; n++) {
        const double length = chance_fx(&chance, 5, 200) * LSB;
        const double h = chance_scale(&chance, 0.2, 100) * LSB, k_inf = 2 * PI / length;
        const double k = ref_depth_number(k_inf, h);
        coastal_water o = { .count = 1, .config = coastal_usual() };
        o.wave[0] =
            coastal_wave(chance_double(&chance, 0.002, 0.07) * length, length, 0, 90);
        o.config.floor = shore(h, 0, 0);
        coastal_build(&o);
        const double a = o.wave[0].amplitude * LSB;
        const limits limit = { a * ref_shoaling(k_inf, k, h), 0.39 * h,
                               0.071 * 2 * PI / k * tanh(k * h) };
        const double most = least_of(&limit), low = at_a_corner(&limit) ? 0.039 : 0;
        const double sy = expm1(-0.09 * h) / expm1(-0.11 * h);
        const tp_turn now[TP_WAVES] = { 0 }, later[TP_WAVES] = { 0x40000000u };
        const double c =
            tp_coastal_displace_no_overhang(o.coastal, now, 0, 0).position.y * LSB;
        const double s =
            tp_coastal_displace_no_overhang(o.coastal, later, 0, 0).position.y * LSB;
        const double off = hypot(c, s) / (most * sy) - 1;
        measure_add(low > 0 ? &corner : &height, off, n, o.wave[0].amplitude, 0);
        assert_true(off > -0.004 - low - 4 * LSB / most && off < 0.004 + 4 * LSB / most);
        const tp_fx x = chance_fx(&chance, -10, 10);
        const double turns = coastal_turns_from(
            k * x * LSB / (2 * PI) + coastal_phase(&o, 0, 0), coastal_phase(&o, x, 0));
        measure_add(&phase, 2 * PI * turns * fmin(1, most), n, x, 0);
        coastal_end(&o);
    }
    measure_print(&height);
    measure_print(&corner);
    measure_print(&phase);
    assert_true(phase.worst < 1e-3);
}

/* -- phases over a slope ----------------------------------------------------------- */

typedef struct {
    double length, heading, depth, slope;
} coast;

/* A random coast in 16.16: the last bit of a slope is worth radians after a hundred
 * waves. */
static coast any_coast(void)
{
    return (coast){ chance_scale(&chance, 5, 200) * LSB, chance_fx(&chance, 0, 360) * LSB,
                    chance_fx(&chance, 2, 20) * LSB,
                    chance_fx(&chance, 0.02, 0.2) * LSB };
}

static coastal_water coast_case(const coast *c, double up)
{
    coastal_water o = { .count = 1, .config = coastal_usual() };
    o.wave[0] = coastal_wave(c->length / 40, c->length, 0, c->heading);
    o.config.floor = shore(c->depth, c->slope, up);
    coastal_build(&o);
    return o;
}

/* [B8] [B9]: phase difference towards the shore and along the shore, in water down to 0.3
 * m.  The error is that of the chord between nodes a 32nd of an octave apart. */
static void slopes_have_the_phases_of_the_integral(void **state)
{
    (void)state;
    measure m = { .what = "phase of a slope", .unit = "rad" };

    for (int n = 0; n < 150; n++) {
        const coast c = any_coast();
        coastal_water o = coast_case(&c, 90); /* up is +x */
        const double angle = c.heading * PI / 180, k_inf = 2 * PI / c.length;
        const double kz = -k_inf * cos(angle), sign = sin(angle) < 0 ? -1 : 1;
        const tp_fx to = (tp_fx)((c.depth - 0.3) / c.slope * 65536);
        const double from = coastal_phase(&o, 0, 0);
        for (int k = 0; k < 8; k++) {
            const tp_fx x = (tp_fx)(to * chance_double(&chance, 0, 1));
            const tp_fx z = chance_fx(&chance, -50, 50);
            const double want = sign * ref_slope_phase(k_inf, kz, c.depth, c.slope, 0,
                                                       x * LSB, 60) + kz * z * LSB;
            const double got = coastal_phase(&o, x, z);
            measure_add(&m, 2 * PI * coastal_turns_from(want / (2 * PI), got - from), n,
                        x, z);
        }
        coastal_end(&o);
    }
    measure_print(&m);
    assert_true(m.worst < 0.01);
}

/* Along the direction of deep water, at any angle, the phase grows with every step. */
static void crests_never_run_backwards(void **state)
{
    (void)state;
    for (int n = 0; n < 60; n++) {
        const coast c = any_coast();
        coastal_water o = coast_case(&c, chance_double(&chance, 0, 360));
        const double angle = c.heading * PI / 180, dx = sin(angle), dz = -cos(angle);
        const double step = c.length / 400, from = chance_double(&chance, -200, 0);
        double last = 0, most = 0, walked = 0;
        bool wet = false;
        for (int k = 0; k < 2000; k++) {
            const double way = from + k * step;
            const tp_fx x = (tp_fx)lround(dx * way * 65536);
            const tp_fx z = (tp_fx)lround(dz * way * 65536);
            if (tp_coastal_floor(o.coastal, x, z).depth < TP_FX(0.3)) {
                wet = false;
                continue;
            }
            const double phase = coastal_phase(&o, x, z);
            const double on = coastal_turns_from(last, phase);
            if (wet)
                assert_true(on > -2e-4);    /* limit of the phase from 16.16 heights */
            walked += wet ? on : 0;
            most = fmax(most, walked);
            assert_true(walked > most - 5e-4);
            last = phase;
            wet = true;
        }
        coastal_end(&o);
    }
}

static void a_map_of_a_slope_has_the_phases_of_the_slope(void **state)
{
    (void)state;
    measure far = { .what = "map's phase", .unit = "rad" };

    for (int n = 0; n < 12; n++) {
        const double up = chance_double(&chance, 0, 360);
        const coast c = { chance_fx(&chance, 12, 40) * LSB,
                          up + chance_double(&chance, -60, 60), 6,
                          chance_fx(&chance, 0.02, 0.05) * LSB };
        coastal_water straight = coast_case(&c, up), mapped = straight;
        const coastal_picture p =
            coastal_slope_picture(&straight.config.floor, 129, 200, &mapped.config.floor);
        mapped.config.floor.map = &p.picture;
        coastal_build(&mapped);
        const double apart = coastal_turns_from(coastal_phase(&straight, 0, 0),
                                                coastal_phase(&mapped, 0, 0));
        for (int k = 0; k < 300; k++) {
            const tp_fx x = chance_fx(&chance, -95, 95), z = chance_fx(&chance, -95, 95);
            if (tp_coastal_floor(straight.coastal, x, z).depth < TP_FX(1))
                continue;
            const double a = coastal_phase(&straight, x, z),
                         b = coastal_phase(&mapped, x, z);
            measure_add(&far, 2 * PI * coastal_turns_from(a + apart, b), n, x, z);
        }
        coastal_end(&straight);
        coastal_end(&mapped);
        free(p.sample);
    }
    measure_print(&far);
    assert_true(far.worst < 0.15);
}

/* Waves straight onto the shore, so that no refraction changes the heights: the slope's
 * tables of displacements and tilts compared with the values computed over a map. */
static void a_map_of_a_slope_moves_as_the_slope(void **state)
{
    (void)state;
    measure m = { .what = "map's point", .unit = "mm" };

    for (int n = 0; n < 4; n++) {
        const double up = 90 * n;
        coastal_water straight = { .count = 1, .config = coastal_usual() };
        straight.wave[0] = coastal_wave(0.4, 24, 0.1, up);
        straight.config.floor = shore(6, 0.06, up);
        coastal_water mapped = straight;
        const coastal_picture p =
            coastal_slope_picture(&straight.config.floor, 129, 200, &mapped.config.floor);
        coastal_build(&straight);
        mapped.config.floor.map = &p.picture;
        coastal_build(&mapped);
        /* Subtracts the phase difference in the middle, because the phase of the map begins
         * at its edge. */
        straight.wave[0].steepness = mapped.wave[0].steepness = 0;
        coastal_water a = straight, b = mapped;
        coastal_build(&a);
        coastal_build(&b);
        const double apart =
            coastal_turns_from(coastal_phase(&b, 0, 0), coastal_phase(&a, 0, 0));
        coastal_end(&a);
        coastal_end(&b);
        for (int k = 0; k < 500; k++) {
            const tp_fx x = chance_fx(&chance, -95, 95), z = chance_fx(&chance, -95, 95);
            const tp_turn at = (tp_turn)random_next(&chance);
            const tp_turn first[TP_WAVES] = { at };
            const tp_turn second[TP_WAVES] = {
                at + (tp_turn)(int32_t)lround(apart * 4294967295.0)
            };
            const tp_coastal_point s =
                tp_coastal_displace_point(straight.coastal, first, x, z);
            const tp_coastal_point t =
                tp_coastal_displace_point(mapped.coastal, second, x, z);
            if (s.depth < TP_FX(1))
                continue;
            measure_add(&m, 1000 * (s.position.x - t.position.x) * LSB, n, x, z);
            measure_add(&m, 1000 * (s.position.y - t.position.y) * LSB, n, x, z);
            measure_add(&m, 1000 * (s.position.z - t.position.z) * LSB, n, x, z);
        }
        coastal_end(&straight);
        coastal_end(&mapped);
        free(p.sample);
    }
    measure_print(&m);
    assert_true(m.worst < 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(level_floors_shorten_and_raise_waves),
        cmocka_unit_test(slopes_have_the_phases_of_the_integral),
        cmocka_unit_test(crests_never_run_backwards),
        cmocka_unit_test(a_map_of_a_slope_has_the_phases_of_the_slope),
        cmocka_unit_test(a_map_of_a_slope_moves_as_the_slope),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("waves/refraction", tests, NULL, NULL);
}
