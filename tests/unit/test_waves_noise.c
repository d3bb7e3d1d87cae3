/* SPDX-License-Identifier: MIT */
/* Noise along crests: bounded, continuous, periodic, and not constant. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/random.h"
#include "waves/coastal_tables.h"

static uint64_t chance;

static void noise_stays_within_one(void **state)
{
    (void)state;
    for (int n = 0; n < 100000; n++) {
        const tp_fx x = tp_noise((uint32_t)random_next(&chance),
                                 (uint32_t)random_next(&chance),
                                 (uint32_t)random_next(&chance));
        assert_true(x >= -TP_FX_ONE && x <= TP_FX_ONE);
    }
}

/* A smoothstep's largest slope is 1.5, over height differences of 2: 3 per cell. */
static void noise_is_continuous_and_wraps(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        const uint32_t u = (uint32_t)random_next(&chance),
                       v = (uint32_t)random_next(&chance);
        const uint32_t seed = (uint32_t)random_next(&chance);
        const tp_fx at = tp_noise(u, v, seed);
        assert_true(abs(tp_noise(u + 16, v, seed) - at) <= 3 * 16 + 4);
        assert_true(abs(tp_noise(u, v + 16, seed) - at) <= 3 * 16 + 4);
        assert_int_equal(tp_noise(u, v + (8 << 16), seed), at);
        const uint32_t edge = 0u - random_below(&chance, 16);
        assert_true(abs(tp_noise(edge + 16, v, seed) - tp_noise(edge, v, seed)) <= 52);
    }
}

/* Whole cells: mean 0 within five sigma of 65536 numbers, variance a third. */
static void heights_are_spread_evenly(void **state)
{
    (void)state;
    double sum = 0, square = 0, beside = 0;

    for (uint32_t u = 0; u < 65536; u++) {
        const double a = tp_noise(u << 16, 0, 7) / 65536.0;
        const double b = tp_noise((u + 1) << 16, 0, 7) / 65536.0;
        sum += a;
        square += a * a;
        beside += a * b;
    }
    assert_true(fabs(sum / 65536) < 0.0113);
    assert_true(fabs(square / 65536 - 1 / 3.0) < 0.006);
    assert_true(fabs(beside / 65536) < 0.0066);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noise_stays_within_one),
        cmocka_unit_test(noise_is_continuous_and_wraps),
        cmocka_unit_test(heights_are_spread_evenly),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("waves/noise", tests, NULL, NULL);
}
