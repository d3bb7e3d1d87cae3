/* SPDX-License-Identifier: MIT */
/* Conversion of waves to swells: the clock, the phases, the clamps of steepness and
 * amplitude, and the guarantees for the sums. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/deep_water.h"
#include "waves/deep_water.h"

static uint64_t chance;

static void the_clock_is_right_after_ten_years(void **state)
{
    (void)state;
    measure tick = { .what = "clock", .unit = "turn/10 years" };

    for (int n = 0; n < 20000; n++) {
        deep_water o = { .wave[0] = chance_wave(&chance),
                         .count = 1,
                         .gravity = chance_scale(&chance, 0.1, 100) };
        o.wave[0].speed = n % 2 ? TP_FX_ONE : chance_fx(&chance, 0, 8);
        deep_water_settle(&o);
        const long double want = o.ref.wave[0].turns_tick;
        long double off = o.deep.swell[0].turns_tick / 18446744073709551616.0L
                        - (want - floorl(want));
        off -= roundl(off);
        /* The Q60 root and the reference's own 64 bits: 2^-62 at speed 8, 2^-64 at 1. */
        const long double most = o.wave[0].speed > TP_FX_ONE ? 2.2e-19L : 5.5e-20L;
        assert_true(fabsl(off) <= most);
        measure_add(&tick, (double)(off * TEN_YEARS), o.wave[0].length, o.gravity,
                    o.wave[0].speed);
    }
    measure_print(&tick);
}

/* Tick by tick and in one leap the phase is the same: the phase is computed, not
 * accumulated. */
static void phases_are_exact_products(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        deep_water o = deep_water_any(&chance, 4);
        for (int i = 0; i < (int)o.deep.count; i++) {
            const uint64_t turns = o.tick * o.deep.swell[i].turns_tick;
            assert_int_equal(o.phases[i], o.deep.swell[i].phase - (tp_turn)(turns >> 32));
        }
    }
}

/* A fraction of a tick earlier: equal within the truncated bits, 2^-32 turn. */
static void phases_within_a_tick_lie_between_those_of_its_ends(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        deep_water o = deep_water_any(&chance, 4);
        tp_turn now[TP_WAVES], before[TP_WAVES], got[TP_WAVES];
        const tp_fx lag = chance_int(&chance, 0, TP_FX_ONE);
        tp_deep_water_phases(&o.deep, o.tick + 1, 0, now);
        tp_deep_water_phases(&o.deep, o.tick, 0, before);
        tp_deep_water_phases(&o.deep, o.tick + 1, lag, got);
        for (uint32_t i = 0; i < o.deep.count; i++) {
            const double want = (double)o.deep.swell[i].turns_tick * lag * LSB
                              / 18446744073709551616.0;
            const double off = (int32_t)(got[i] - now[i]) / 4294967296.0 - want;
            assert_true(fabs(off - round(off)) < 3 / 4294967296.0);
            assert_int_equal(lag == 0 ? now[i] : got[i], got[i]);
        }
        tp_deep_water_phases(&o.deep, o.tick + 1, TP_FX_ONE, got);
        for (uint32_t i = 0; i < o.deep.count; i++)
            assert_true(abs((int32_t)(got[i] - before[i])) <= 1);
    }
}

static void without_speed_or_gravity_waves_stand_still(void **state)
{
    (void)state;
    const tp_wave wave = { TP_FX_ONE, 10 * TP_FX_ONE, 0, 0, 0, 0, 0 };
    const tp_wave moving = { TP_FX_ONE, 10 * TP_FX_ONE, 0, 0, 0, TP_FX_ONE, 0 };
    tp_deep_water deep;

    tp_deep_water_init(&deep, &wave, 1, TP_FX(9.81));
    assert_int_equal(deep.swell[0].turns_tick, 0);
    tp_deep_water_init(&deep, &moving, 1, 0);
    assert_int_equal(deep.swell[0].turns_tick, 0);
}

static void a_steepness_sum_above_095_is_scaled_down_and_reported(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        const deep_water o = deep_water_any(&chance, TP_WAVES);
        int64_t asked = 0, got = 0;
        for (int i = 0; i < o.count; i++)
            asked += o.wave[i].amplitude > 0 ? o.wave[i].steepness : 0;
        for (uint32_t i = 0; i < o.deep.count; i++)
            got += (int64_t)o.deep.swell[i].bend_xx + o.deep.swell[i].bend_zz;
        assert_int_equal(o.deep.steepness, asked);
        assert_int_equal(o.deep.clamped, asked > TP_FX(0.95));
        /* Each share and product is rounded by half an LSB; xx + zz is Q k A in Q2.30, with
         * an error of 2^-26 by the direction's 28 bits. */
        const double sum = (double)asked * LSB, most = asked > TP_FX(0.95) ? 0.95 : sum;
        assert_true(fabs((double)got / 1073741824.0 - most) <= o.count * (LSB + 1.5e-8)
                                                               + LSB * sum);
    }
}

static void the_clamp_keeps_heights_and_places_alike(void **state)
{
    (void)state;
    const tp_wave twice[2] = { { TP_FX_ONE, 20 * TP_FX_ONE, TP_FX(0.8), 0, 0, 0, 0 },
                               { TP_FX_ONE, 20 * TP_FX_ONE, TP_FX(0.2), 0, 0, 0, 0 } };
    tp_deep_water deep;

    tp_deep_water_init(&deep, twice, 2, TP_FX(9.81));
    assert_true(deep.clamped);
    assert_false(deep.capped);
    assert_int_equal(deep.steepness, TP_FX(0.8) + TP_FX(0.2));
    assert_int_equal(deep.swell[0].amplitude, TP_FX_ONE);
    assert_int_equal(deep.height, 2 * TP_FX_ONE);
    /* A ratio of 4 to 1 as requested, within the rounding of 16.16. */
    assert_true(labs((long)deep.swell[0].bend_zz - 4L * deep.swell[1].bend_zz) < 5 * 16384);
}

static void an_amplitude_above_three_tenths_of_the_length_is_cut_and_reported(
    void **state)
{
    (void)state;
    const tp_wave tall = { 2 * TP_FX_ONE, TP_FX_ONE, 0, 0, 0, TP_FX_ONE, 0 };
    const tp_wave fair = { TP_FX(0.29), TP_FX_ONE, 0, 0, 0, TP_FX_ONE, 0 };
    tp_deep_water deep;

    tp_deep_water_init(&deep, &tall, 1, TP_FX(9.81));
    assert_true(deep.capped);
    assert_int_equal(deep.swell[0].amplitude, TP_FX(0.3));
    tp_deep_water_init(&deep, &fair, 1, TP_FX(9.81));
    assert_false(deep.capped);
    assert_int_equal(deep.swell[0].amplitude, TP_FX(0.29));
}

static void waves_without_amplitude_are_left_out(void **state)
{
    (void)state;
    const tp_wave waves[3] = { { 0, 10 * TP_FX_ONE, TP_FX_ONE, 0, 0, 0, 0 },
                               { TP_FX_ONE, 10 * TP_FX_ONE, TP_FX(0.5), 0, 0, 0, 0 },
                               { 0, 10 * TP_FX_ONE, TP_FX_ONE, 0, 0, 0, 0 } };
    tp_deep_water deep;

    tp_deep_water_init(&deep, waves, 3, TP_FX(9.81));
    assert_int_equal(deep.count, 1);
    assert_false(deep.clamped);
    tp_deep_water_init(&deep, waves, 0, TP_FX(9.81));
    assert_int_equal(deep.count, 0);
    assert_int_equal(deep.height, 0);
}

/* Waves added one by one give the same limit of steepness. */
static void what_is_added_beyond_a_steepness_of_095_is_taken_from_the_last(void **state)
{
    (void)state;
    const uint64_t metre = (uint64_t)1 << 32;
    tp_wave_exact wave = { .turns = metre / 20, .dx = TP_Q30_ONE, .amplitude = TP_FX_ONE,
                           .steepness = TP_Q30(0.9) };
    tp_deep_water deep = { .count = 0 };

    tp_deep_water_append_wave(&deep, &wave);
    assert_int_equal(deep.swell[0].bend, TP_Q30(0.9));
    assert_false(deep.clamped);
    assert_false(deep.crossed);
    tp_deep_water_append_wave(&deep, &wave);
    assert_int_equal(deep.steepness_sum, TP_Q30(0.95));
    assert_int_equal(deep.swell[0].bend, TP_Q30(0.9));
    assert_true(deep.clamped);
    assert_true(deep.crossed);
    wave.amplitude = 0;
    tp_deep_water_append_wave(&deep, &wave);
    assert_int_equal(deep.count, 2);
    wave.amplitude = TP_FX_ONE;
    for (int i = 0; i < 20; i++)
        tp_deep_water_append_wave(&deep, &wave);
    assert_int_equal(deep.count, TP_WAVES);
    assert_int_equal(deep.steepness_sum, TP_Q30(0.95));
    assert_int_equal(deep.height, TP_WAVES * TP_FX_ONE);
}

/* All waves along one axis, each with cos th = 1: the displacement is sum QA.  A wave adds
 * up to one and a half LSB to the bound, the rounding of the point half an LSB. */
static void the_reach_is_the_greatest_displacement(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        deep_water o = deep_water_any(&chance, TP_WAVES);
        const tp_fx heading = chance_int(&chance, -4, 4) * 90 * TP_FX_ONE;
        const tp_turn first[TP_WAVES] = { 0 };
        for (int i = 0; i < o.count; i++)
            o.wave[i].heading = heading;
        deep_water_settle(&o);
        const tp_vec3 p = tp_deep_water_displace_point(&o.deep, first, 0, 0).position;
        const tp_fx away = abs(p.x) > abs(p.z) ? abs(p.x) : abs(p.z);
        assert_true(away <= o.deep.max_displacement);
        assert_true(o.deep.max_displacement - away <= 2 * (int)o.deep.count + 2);
    }
}

/* [A11]: all waves in one direction, all crests at one position, and a sum of Q k A far
 * above the limit.  Then det J is 1 - 0.95, plus 16 roundings of half an LSB. */
static void det_stays_above_zero_where_all_crests_meet(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        deep_water o = deep_water_any(&chance, TP_WAVES);
        const tp_fx heading = chance_fx(&chance, -32400, 32400);
        for (int i = 0; i < o.count; i++) {
            o.wave[i].heading = heading;
            o.wave[i].steepness = TP_FX_ONE;
        }
        deep_water_settle(&o);
        tp_swell_sum sum = { 0 };
        for (uint32_t i = 0; i < o.deep.count; i++)
            tp_swell_sum_add_swell(&sum, &o.deep.swell[i], 0x40000000, 0, 1);
        const double q54 = 18014398509481984.0;
        const double xx = (double)sum.bxx / q54, zz = (double)sum.bzz / q54;
        const double xz = (double)sum.bxz / q54;
        const double det = (1 - xx) * (1 - zz) - xz * xz;
        assert_true(det > 0.0495);
        const tp_turn crest[TP_WAVES] = {
            0x40000000, 0x40000000, 0x40000000, 0x40000000, 0x40000000, 0x40000000,
            0x40000000, 0x40000000, 0x40000000, 0x40000000, 0x40000000, 0x40000000,
            0x40000000, 0x40000000, 0x40000000, 0x40000000 };
        const tp_surface_point p = tp_deep_water_displace_point(&o.deep, crest, 0, 0);
        assert_int_equal(p.slope_x, 0);
        assert_int_equal(p.slope_z, 0);
        assert_int_equal(p.position.x, 0);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_clock_is_right_after_ten_years),
        cmocka_unit_test(phases_are_exact_products),
        cmocka_unit_test(phases_within_a_tick_lie_between_those_of_its_ends),
        cmocka_unit_test(without_speed_or_gravity_waves_stand_still),
        cmocka_unit_test(a_steepness_sum_above_095_is_scaled_down_and_reported),
        cmocka_unit_test(the_clamp_keeps_heights_and_places_alike),
        cmocka_unit_test(
            an_amplitude_above_three_tenths_of_the_length_is_cut_and_reported),
        cmocka_unit_test(waves_without_amplitude_are_left_out),
        cmocka_unit_test(what_is_added_beyond_a_steepness_of_095_is_taken_from_the_last),
        cmocka_unit_test(the_reach_is_the_greatest_displacement),
        cmocka_unit_test(det_stays_above_zero_where_all_crests_meet),
    };
    return cmocka_run_group_tests_name("waves/swell", tests, NULL, NULL);
}
