/* SPDX-License-Identifier: MIT */
/* Sharpened sines, [A3]: compared with the models in double precision and with the table of
 * tests/vectors; sharpened sines keep the mean level and the bounds. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/deep_water.h"
#include "tests/lib/vectors.h"

static uint64_t chance;

/* k, A, theta; then f, mean, y and dy/dtheta.  For a wave of 1 rad/m the last column is its
 * slope. */
static void sharpened_sines_follow_the_table(void **state)
{
    (void)state;
    measure height = { .what = "table's height", .unit = "mm" };
    measure slope = { .what = "table's slope", .unit = "m/rad" };
    vector_table r = rows_of("sharp_sine");

    while (rows_next(&r)) {
        const row_wave w = { .k = 1, .dx = 1, .amplitude = r.at[1] };
        tp_wave_exact exact = row_exact(&w);
        exact.power = (int32_t)r.at[0];
        tp_deep_water deep = { .count = 0 };
        tp_deep_water_append_wave(&deep, &exact);
        assert_false(deep.capped);
        assert_int_equal(deep.sharpened, exact.power > 1);
        const tp_turn phases[TP_WAVES] = { row_turn(r.at[2]) };
        const tp_surface_point got = tp_deep_water_displace_point(&deep, phases, 0, 0);
        measure_add(&height, row_error(got.position.y, r.at[5]) * 1000, r.rows, 0, 0);
        measure_add(&slope, row_error(got.slope_x, r.at[6]), r.rows, 0, 0);
    }
    assert_int_equal(r.rows, 120);
    measure_print(&height);
    measure_print(&slope);
    assert_true(height.worst < 0.5);
    assert_true(slope.worst < 2e-4);
}

static void any_legal_sharpened_sea_follows_the_models(void **state)
{
    (void)state;
    errors e = errors_of("sharp height", "sharp place", "sharp normal");

    for (int n = 0; n < 2000; n++) {
        deep_water o = deep_water_any(&chance, TP_WAVES);
        deep_water_sharpen(&chance, &o);
        for (int k = 0; k < 20; k++)
            deep_water_compare(&o, chance_fx(&chance, -24000, 24000),
                               chance_fx(&chance, -24000, 24000), &e);
    }
    errors_print(&e);
}

/* Slopes of all waves at their maximum add up beyond 31 bits of Q.23 before the clamp;
 * UBSan checks. */
static void the_steepest_sharpened_sea_stays_in_its_formats(void **state)
{
    (void)state;
    errors e = errors_of("steep height", "steep place", "steep normal");

    for (int n = 0; n < 500; n++) {
        deep_water o = { .count = TP_WAVES, .gravity = TP_FX(9.81) };
        const tp_fx heading = chance_fx(&chance, -180, 180);
        for (int i = 0; i < o.count; i++)
            o.wave[i] = (tp_wave){ .amplitude = 16 * TP_FX_ONE,
                                   .length = chance_scale(&chance, 0.25, 53),
                                   .steepness = TP_FX_ONE, .heading = heading,
                                   .phase = chance_fx(&chance, 50, 70), .exponent = 8 };
        deep_water_settle(&o);
        for (int k = 0; k < 10; k++)
            deep_water_compare(&o, chance_int(&chance, -2000, 2000),
                               chance_int(&chance, -2000, 2000), &e);
    }
    errors_print(&e);
}

static tp_deep_water one_wave(int32_t power)
{
    const tp_wave wave = { .amplitude = TP_FX_ONE, .length = 20 * TP_FX_ONE,
                           .exponent = power };
    tp_deep_water deep;
    tp_deep_water_init(&deep, &wave, 1, TP_FX(9.81));
    return deep;
}

/* The mean of f is subtracted; from trough to crest the height is 2 A; the crest is the
 * stated height. */
static void the_level_stays_whatever_the_power(void **state)
{
    (void)state;
    for (int32_t power = 1; power <= 8; power++) {
        const tp_deep_water deep = one_wave(power);
        int64_t sum = 0;
        tp_fx low = 0, high = 0;
        for (uint32_t n = 0; n < 4096; n++) {
            const tp_turn phases[TP_WAVES] = { n << 20 };
            const tp_fx y = tp_deep_water_displace_point(&deep, phases, 0, 0).position.y;
            sum += y;
            low = y < low ? y : low;
            high = y > high ? y : high;
        }
        assert_true(fabs((double)sum / 4096) < 1);
        assert_true(abs(high - low - 2 * TP_FX_ONE) <= 1);
        assert_true(high <= deep.height && deep.height <= high + 1);
    }
}

static void powers_beyond_the_range_count_as_its_ends(void **state)
{
    (void)state;
    assert_int_equal(one_wave(0).swell[0].power, 1);
    assert_int_equal(one_wave(-3).swell[0].power, 1);
    assert_int_equal(one_wave(9).swell[0].power, 8);
    assert_false(one_wave(0).sharpened);
    assert_false(one_wave(1).sharpened);
    assert_true(one_wave(2).sharpened);
    assert_int_equal(one_wave(0).height, TP_FX_ONE);
    assert_int_equal(one_wave(1).swell[0].mean_q24, 1 << 24);
}

/* A sine is the same beside a sharpened wave without effect, within an LSB. */
static void a_sine_is_a_sine_in_a_sharpened_sea(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        deep_water o = deep_water_usual(&chance, 4, chance_double(&chance, 0, 0.9));
        tp_deep_water mixed = o.deep;
        mixed.sharpened = true;
        const tp_fx x = chance_fx(&chance, -500, 500), z = chance_fx(&chance, -500, 500);
        const tp_surface_point want = tp_deep_water_displace_point(&o.deep, o.phases, x, z);
        const tp_surface_point got = tp_deep_water_displace_point(&mixed, o.phases, x, z);
        assert_true(abs(got.position.y - want.position.y) <= 1);
        assert_int_equal(got.position.x, want.position.x);
        assert_int_equal(got.position.z, want.position.z);
        assert_true(abs(got.slope_x - want.slope_x) <= 2);
        assert_true(abs(got.slope_z - want.slope_z) <= 2);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sharpened_sines_follow_the_table),
        cmocka_unit_test(any_legal_sharpened_sea_follows_the_models),
        cmocka_unit_test(the_steepest_sharpened_sea_stays_in_its_formats),
        cmocka_unit_test(the_level_stays_whatever_the_power),
        cmocka_unit_test(powers_beyond_the_range_count_as_its_ends),
        cmocka_unit_test(a_sine_is_a_sine_in_a_sharpened_sea),
    };
    return cmocka_run_group_tests_name("waves/sharp_crests", tests, NULL, NULL);
}
