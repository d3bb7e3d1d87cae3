/* SPDX-License-Identifier: MIT */
/* Auto exposure compared with its rule in double precision [F8]. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/measure.h"
#include "tests/lib/random.h"
#include "features/exposure/exposure.h"

#define LSB (1 / 65536.0)

static uint64_t chance;

static double ref_target(tp_fx mean)
{
    return fmin(8, fmax(0.125, 0.5 / fmax(1 / 16.0, mean * LSB)));
}

/* The target and the product are each rounded by half an LSB; a step below half an LSB
 * becomes one LSB. */
static void a_step_is_the_rule_within_an_lsb(void **state)
{
    (void)state;
    measure m = { .what = "step", .unit = "LSB" };

    for (int i = 0; i < 300000; i++) {
        const tp_fx from = chance_scale(&chance, 0.125, 8);
        const tp_fx mean = chance_scale(&chance, 0.01, 16);
        const tp_fx rate = chance_scale(&chance, 0.001, 1);
        const double e = from * LSB, target = ref_target(mean);
        const double want = e + (target - e) * rate * LSB;
        const tp_fx got = tp_exposure_step(from, mean, rate);
        measure_add(&m, got - want / LSB, from, mean, rate);
    }
    measure_print(&m);
    assert_true(m.worst <= 1.01);
}

/* A long run over a changing scene: roundings do not accumulate, because each tick forgets
 * a share of the past.  The error is at most one LSB per tick divided by the rate. */
static void errors_do_not_add_up(void **state)
{
    (void)state;
    measure m = { .what = "20000 ticks", .unit = "" };
    const tp_fx rate = TP_FX(0.05);
    tp_fx got = TP_FX_ONE, mean = TP_FX_ONE;
    double want = 1;

    for (int tick = 0; tick < 20000; tick++) {
        if (tick % 150 == 0)
            mean = chance_scale(&chance, 0.02, 8);
        got = tp_exposure_step(got, mean, rate);
        want += (ref_target(mean) - want) * rate * LSB;
        measure_add(&m, got * LSB - want, tick, mean, 0);
    }
    measure_print(&m);
    assert_true(m.worst < 20 * LSB);
}

static void the_target_is_reached_and_kept(void **state)
{
    (void)state;

    for (int i = 0; i < 200; i++) {
        const tp_fx mean = chance_scale(&chance, 0.01, 8);
        const tp_fx rate = chance_scale(&chance, 0.005, 1);
        const tp_fx target = (tp_fx)lround(ref_target(mean) / LSB);
        tp_fx exposure = chance_scale(&chance, 0.125, 8);
        for (int tick = 0; tick < 6000; tick++)
            exposure = tp_exposure_step(exposure, mean, rate);
        assert_in_range(exposure, target - 1, target + 1);  /* rounds halves away from 0 */
        assert_int_equal(tp_exposure_step(exposure, mean, rate), exposure);
    }
}

static void any_numbers_give_an_exposure_in_range(void **state)
{
    (void)state;
    const tp_fx ends[] = { TP_FX_MIN, -1, 0, 1, TP_FX_ONE, TP_FX_MAX };

    for (int i = 0; i < 216; i++) {
        const tp_fx e = tp_exposure_step(ends[i % 6], ends[i / 6 % 6], ends[i / 36]);
        assert_in_range(e, TP_FX_ONE / 8, 8 * TP_FX_ONE);
    }
    assert_int_equal(tp_exposure_step(TP_FX_ONE, 0, TP_FX_ONE), 8 * TP_FX_ONE);
    assert_int_equal(tp_exposure_step(TP_FX_ONE, TP_FX(0.1), 0), TP_FX_ONE);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_step_is_the_rule_within_an_lsb),
        cmocka_unit_test(errors_do_not_add_up),
        cmocka_unit_test(the_target_is_reached_and_kept),
        cmocka_unit_test(any_numbers_give_an_exposure_in_range),
    };
    return cmocka_run_group_tests_name("features/exposure_rule", tests, NULL, NULL);
}
