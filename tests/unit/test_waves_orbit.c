/* SPDX-License-Identifier: MIT */
/* Elliptic orbits compared with the models' vectors and with [B11]-[B13] in double
 * precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/finite_depth.h"
#include "tools/reference/surf.h"
#include "tests/lib/random.h"
#include "waves/coastal_water.h"
#include "tests/lib/vectors.h"

#define K0 TP_FX(0.1)
#define KX TP_FX(0.11)
#define KY TP_FX(0.09)

static uint64_t chance;

static tp_ellipse row_orbit(const double *v)
{
    return tp_orbit_ellipse(row_fx(v[0]), row_fx(v[1]), row_turn(v[2]), ref_to_q32(v[3]),
                            K0, KX, KY);
}

/* Error of tp_sin, 4.8e-6, and of K0 in 16.16, which is 6.2e-6 more than 0.1, times h. */
static double sine_error(const double *v)
{
    return 4.8e-6 + v[5] * v[1] * 6.2e-6 + 1e-7;
}

static void orbits_follow_their_vectors_to_a_millimetre(void **state)
{
    (void)state;
    vector_table r = rows_of("fr_orbit");
    measure along = { .what = "dx", .unit = "mm" }, up = { .what = "dy", .unit = "mm" };
    measure sine = { .what = "sin alpha", .unit = "" };

    while (rows_next(&r)) {
        const double *v = r.at;
        const tp_ellipse orbit = row_orbit(v);
        const tp_offset o = tp_orbit_evaluate(&orbit, row_turn(v[4]));
        measure_add(&along, 1000 * row_error(o.along, v[10]), r.rows, 0, 0);
        measure_add(&up, 1000 * row_error(o.up, v[11]), r.rows, 0, 0);
        measure_add(&sine, orbit.sin / 1073741824.0 - v[5], r.rows, 0, 0);
        assert_true(fabs(orbit.sin / 1073741824.0 - v[5]) <= sine_error(v));
    }
    assert_int_equal(r.rows, 200);
    measure_print(&along);
    measure_print(&up);
    measure_print(&sine);
    assert_true(along.worst < 1);
    assert_true(up.worst < 1);
}

/* Any wave of the coastal water's ranges; the longest waves have axes of hundreds of
 * metres, so errors are relative to the axes. */
static void any_orbit_follows_the_models(void **state)
{
    (void)state;
    measure off = { .what = "any orbit", .unit = "of its axis" };

    for (int n = 0; n < 20000; n++) {
        const double length = chance_scale(&chance, 0.25, 2000) / 65536.0;
        const double k = 2 * PI / length;
        const tp_fx r = chance_fx(&chance, 0, fmin(16, length / 7));
        const tp_fx h = chance_scale(&chance, 0.001, 4000);
        const tp_turn gamma = (tp_turn)(chance_int(&chance, -0x20000000, 0x20000000));
        const tp_turn phi = (tp_turn)random_next(&chance);
        const tp_ellipse o = tp_orbit_ellipse(r, h, gamma, ref_to_q32(k), K0, KX, KY);
        const ref_ellipse want = ref_orbit_make(r / 65536.0, h / 65536.0,
                                              (int32_t)gamma / 4294967296.0 * 2 * PI, k,
                                              0.1, 0.11, 0.09);
        const ref_offset at = ref_orbit(&want, phi / 4294967296.0 * 2 * PI);
        const tp_offset got = tp_orbit_evaluate(&o, phi);
        const double axis = fmax(want.along, 0.2);
        measure_add(&off, row_error(got.along, at.along) / axis, r, h, (int32_t)gamma);
        measure_add(&off, row_error(got.up, at.up) / axis, r, h, (int32_t)gamma);
    }
    measure_print(&off);
    assert_true(off.worst < 3e-4);
}

static void deep_orbits_are_circles(void **state)
{
    (void)state;
    const tp_ellipse o = tp_orbit_ellipse(TP_FX(2), TP_FX(2000), TP_DEG(10),
                                     ref_to_q32(0.1), K0, KX, KY);
    assert_int_equal(o.along, TP_FX(2));
    assert_int_equal(o.up, TP_FX(2));
    assert_int_equal(o.sin, 0);
}

static void no_axis_is_longer_than_its_wave_allows(void **state)
{
    (void)state;
    for (int n = 0; n < 20000; n++) {
        const double k = 2 * PI / (chance_scale(&chance, 0.25, 2000) / 65536.0);
        const tp_ellipse o = tp_orbit_ellipse(
            chance_fx(&chance, 0, 64), chance_fx(&chance, -1, 20),
            (tp_turn)random_next(&chance), ref_to_q32(k), chance_fx(&chance, 0, 4),
            chance_fx(&chance, 0, 4), chance_fx(&chance, 0, 4));
        assert_true(o.along >= 0 && k * o.along / 65536.0 <= 0.95 + 1e-4);
        assert_true(o.up >= 0 && o.sin >= 0 && o.cos >= 0);
    }
}

/* [B11]: a falling floor does not tilt orbits. */
static void a_falling_floor_does_not_tilt_orbits(void **state)
{
    (void)state;
    for (int n = 0; n < 1000; n++) {
        const tp_turn gamma = (tp_turn)-chance_int(&chance, 0, 0x3fffffff);
        const tp_ellipse o = tp_orbit_ellipse(TP_FX(0.5), chance_fx(&chance, 0, 20), gamma,
                                         ref_to_q32(0.3), K0, KX, KY);
        assert_int_equal(o.sin, 0);
        assert_int_equal(o.cos, TP_Q30_ONE);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orbits_follow_their_vectors_to_a_millimetre),
        cmocka_unit_test(any_orbit_follows_the_models),
        cmocka_unit_test(deep_orbits_are_circles),
        cmocka_unit_test(no_axis_is_longer_than_its_wave_allows),
        cmocka_unit_test(a_falling_floor_does_not_tilt_orbits),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("waves/orbit", tests, NULL, NULL);
}
