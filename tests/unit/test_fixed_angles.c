/* SPDX-License-Identifier: MIT */
/* Sines and angles compared with double precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "fixed/arithmetic.h"
#include "tests/lib/measure.h"

enum { INPUTS = 10100000 };

static const double RADIANS = 6.283185307179586476925 / 4294967296.0;   /* per tp_turn */

static uint64_t seed;

static void every_table_entry_is_the_nearest(void **state)
{
    (void)state;
    for (uint32_t knot = 0; knot < 1024; knot++) {
        const tp_turn angle = knot << 22;
        const long long y = llround(fabs(sin(angle * RADIANS)) * 0x1p30);
        assert_int_equal(tp_sin(angle), knot <= 512 ? y : -y);
    }
}

static void the_axes_are_exact(void **state)
{
    (void)state;
    assert_int_equal(tp_sin(0), 0);
    assert_int_equal(tp_sin(0x40000000), TP_Q30_ONE);
    assert_int_equal(tp_sin(0x80000000), 0);
    assert_int_equal(tp_sin(0xc0000000), -TP_Q30_ONE);
    assert_int_equal(tp_cos(0), TP_Q30_ONE);
    assert_int_equal(tp_cos(0x40000000), 0);
    assert_int_equal(tp_cos(0x80000000), -TP_Q30_ONE);
    assert_int_equal(tp_fx_sin(0x40000000), TP_FX_ONE);
    assert_int_equal(tp_fx_cos(0x80000000), -TP_FX_ONE);
    assert_int_equal(tp_fx_sin(TP_DEG(30)), 0x8000);
}

typedef struct { measure sine, cosine, fx; } sine_errors;

static void check_sine(sine_errors *e, tp_turn angle)
{
    const double s = sin(angle * RADIANS), c = cos(angle * RADIANS);
    measure_add(&e->sine, tp_sin(angle) * 0x1p-30 - s, angle, 0, 0);
    measure_add(&e->cosine, tp_cos(angle) * 0x1p-30 - c, angle, 0, 0);
    measure_add(&e->fx, tp_fx_sin(angle) - s * 65536.0, angle, 0, 0);
    measure_add(&e->fx, tp_fx_cos(angle) - c * 65536.0, angle, 0, 0);
}

/* All steps of the table, 33 points in each step and both ends, and the whole turn. */
static void sine_errs_by_less_than_5e_6_and_one_unit_of_16_16(void **state)
{
    (void)state;
    sine_errors e = { { .what = "tp_sin", .unit = "" }, { .what = "tp_cos", .unit = "" },
                      { .what = "tp_fx_sin, _cos", .unit = "LSB" } };
    for (uint32_t knot = 0; knot < 1024; knot++) {
        for (uint32_t part = 0; part <= 32; part++)
            check_sine(&e, (knot << 22) + (part << 17));
        check_sine(&e, (knot << 22) + 1);
        check_sine(&e, (knot << 22) - 1);
    }
    const uint32_t stride = sweep_stride();
    for (uint64_t angle = 0; angle <= UINT32_MAX; angle += stride)
        check_sine(&e, (tp_turn)angle);
    measure_print(&e.sine);
    measure_print(&e.cosine);
    measure_print(&e.fx);
    assert_true(e.sine.worst < 5e-6);
    assert_true(e.cosine.worst < 5e-6);
    assert_true(e.fx.worst < 1.0);
}

static void sine_is_odd_mirrored_and_never_beyond_one(void **state)
{
    (void)state;
    uint64_t random = seed;
    for (int i = 0; i < INPUTS / 10; i++) {
        const tp_turn a = (tp_turn)random_next(&random);
        assert_int_equal(tp_sin(0u - a), -tp_sin(a));
        assert_int_equal(tp_sin(0x80000000u - a), tp_sin(a));
        assert_in_range(tp_sin(a) + TP_Q30_ONE, 0, 2 * (uint32_t)TP_Q30_ONE);
    }
}

static void sine_rises_through_its_first_quarter(void **state)
{
    (void)state;
    tp_q30 below = 0;
    for (tp_turn a = 0; a <= 0x40000000; a += 1 << 10) {
        assert_true(tp_sin(a) >= below);
        below = tp_sin(a);
    }
}

/* Difference between two angles, in turns. */
static double turns_apart(tp_turn a, double radians)
{
    const double d = a * 0x1p-32 - radians / 6.283185307179586476925;
    return d - nearbyint(d);
}

static void atan2_errs_by_less_than_2_to_minus_18_turn(void **state)
{
    (void)state;
    measure m = { .what = "tp_atan2", .unit = "of 2^-18 turn" };
    uint64_t random = seed;
    for (int i = 0; i < INPUTS; i++) {
        const int32_t y = random_number(&random), x = random_number(&random);
        if (x != 0 || y != 0)
            measure_add(&m, turns_apart(tp_atan2(y, x), atan2(y, x)) * 0x1p18, y, x, 0);
    }
    static const int32_t ends[] = { INT32_MIN, INT32_MIN + 1, -1, 0, 1, INT32_MAX };
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 6; k++)
            if (ends[i] != 0 || ends[k] != 0)
                measure_add(&m, turns_apart(tp_atan2(ends[i], ends[k]),
                                            atan2(ends[i], ends[k])) * 0x1p18,
                            ends[i], ends[k], 0);
    measure_print(&m);
    assert_true(m.worst < 1.0);
}

static void atan2_is_exact_on_the_axes(void **state)
{
    (void)state;
    for (int bit = 0; bit < 31; bit++) {
        const int32_t x = (int32_t)(1u << bit);
        assert_int_equal(tp_atan2(0, x), 0);
        assert_int_equal(tp_atan2(x, 0), 0x40000000);
        assert_int_equal(tp_atan2(0, -x), 0x80000000);
        assert_int_equal(tp_atan2(-x, 0), 0xc0000000);
    }
    assert_int_equal(tp_atan2(0, INT32_MIN), 0x80000000);
    assert_int_equal(tp_atan2(INT32_MIN, 0), 0xc0000000);
    assert_int_equal(tp_atan2(0, 0), 0);
}

/* A degree is 2^32 / 360 units of a turn: 8192 / 45 for each unit of 16.16. */
static void degrees_become_turns(void **state)
{
    (void)state;
    measure m = { .what = "tp_turn_of_degrees", .unit = "2^-32 turn" };
    const uint32_t stride = sweep_stride();
    for (uint64_t word = 0; word <= UINT32_MAX; word += stride) {
        const tp_fx degrees = (tp_fx)(uint32_t)word;
        const double turns = degrees * 8192.0 / 45.0 * 0x1p-32;
        const double d = tp_turn_of_degrees(degrees) * 0x1p-32 - turns;
        measure_add(&m, (d - nearbyint(d)) * 0x1p32, degrees, 0, 0);
    }
    measure_print(&m);
    assert_true(m.worst < 1.0);
    for (int turn = -90; turn <= 90; turn++)
        for (int eighth = 0; eighth < 8; eighth++)
            assert_int_equal(tp_turn_of_degrees((turn * 360 + eighth * 45) * TP_FX_ONE),
                             (uint32_t)eighth << 29);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_table_entry_is_the_nearest),
        cmocka_unit_test(the_axes_are_exact),
        cmocka_unit_test(sine_errs_by_less_than_5e_6_and_one_unit_of_16_16),
        cmocka_unit_test(sine_is_odd_mirrored_and_never_beyond_one),
        cmocka_unit_test(sine_rises_through_its_first_quarter),
        cmocka_unit_test(atan2_errs_by_less_than_2_to_minus_18_turn),
        cmocka_unit_test(atan2_is_exact_on_the_axes),
        cmocka_unit_test(degrees_become_turns),
    };
    seed = random_seed();
    return cmocka_run_group_tests_name("fixed/angles", tests, NULL, NULL);
}
