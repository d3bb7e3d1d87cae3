/* SPDX-License-Identifier: MIT */
/* Products and quotients of 16.16 compared with the rounding rule. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "fixed/arithmetic.h"
#include "tests/lib/measure.h"

enum { INPUTS = 12500000 };    /* some quotients saturate */

static uint64_t seed;

static void products_round_half_up(void **state)
{
    (void)state;
    assert_int_equal(tp_fx_mul(1, 0x8000), 1);
    assert_int_equal(tp_fx_mul(-1, 0x8000), 0);
    assert_int_equal(tp_fx_mul(-1, 0x8001), -1);
    assert_int_equal(tp_fx_mul(-3, 0x8000), -1);
    assert_int_equal(tp_fx_mul(TP_FX(-181.5), TP_FX(180.25)), TP_FX(-32715.375));
    assert_int_equal(tp_q30_mul(1, TP_Q30_ONE / 2), 1);
    assert_int_equal(tp_q30_mul(-1, TP_Q30_ONE / 2), 0);
    assert_int_equal(tp_q30_mul(INT32_MIN, TP_Q30_ONE), INT32_MIN);
    assert_int_equal(tp_q30_mul(INT32_MAX, -TP_Q30_ONE), -INT32_MAX);
}

static void constants_are_rounded_to_nearest(void **state)
{
    (void)state;
    assert_int_equal(TP_FX(-0.35), -22938);
    assert_int_equal(TP_FX(0.35), 22938);
    assert_int_equal(TP_Q30(-1), -TP_Q30_ONE);
    assert_int_equal(TP_DEG(90), 0x40000000);
    assert_int_equal(TP_DEG(-90), 0xc0000000);
}

static void small_helpers_do_what_they_say(void **state)
{
    (void)state;
    assert_int_equal(tp_clamp(5, -1, 3), 3);
    assert_int_equal(tp_clamp(-5, -1, 3), -1);
    assert_int_equal(tp_clamp(2, -1, 3), 2);
    assert_int_equal(tp_abs(-INT32_MAX), INT32_MAX);
    for (int bit = 0; bit < 32; bit++) {
        assert_int_equal(tp_clz(1u << bit), 31 - bit);
        assert_int_equal(tp_clz(UINT32_MAX >> (31 - bit)), 31 - bit);
    }
}

/* True if q = floor(n / b + 1/2): exactly when 2 q b <= 2 n + b < 2 (q + 1) b, for b > 0.
 * At an end of the range the quotient may lie beyond. */
static int is_quotient(int64_t n, int64_t b, int64_t q)
{
    if (b < 0) {
        n = -n;
        b = -b;
    }
    const int64_t twice = 2 * n + b;
    const int above = q == TP_FX_MAX || twice < 2 * (q + 1) * b;
    const int below = q == TP_FX_MIN || twice >= 2 * q * b;
    return above && below;
}

static void quotients_round_half_up_and_saturate(void **state)
{
    (void)state;
    measure m = { .what = "tp_fx_div", .unit = "LSB" };
    uint64_t random = seed;
    for (int i = 0; i < INPUTS; i++) {
        const tp_fx a = random_number(&random), b = random_number(&random);
        if (b == 0)
            continue;
        const tp_fx q = tp_fx_div(a, b);
        if (!is_quotient((int64_t)a * TP_FX_ONE, b, q))
            fail_msg("%d / %d is not %d", (int)a, (int)b, (int)q);
        if (q != TP_FX_MAX && q != TP_FX_MIN)
            measure_add(&m, (double)a * 65536.0 / (double)b - (double)q, a, b, q);
    }
    measure_print(&m);
    assert_true(m.worst <= 0.5);
}

static void quotients_of_the_ends_are_safe(void **state)
{
    (void)state;
    static const tp_fx ends[] = { TP_FX_MIN, TP_FX_MIN + 1, -2, -1, 1, 2, TP_FX_MAX };
    enum { ENDS = sizeof ends / sizeof ends[0] };
    for (int i = 0; i < ENDS; i++)
        for (int k = 0; k < ENDS; k++)
            assert_true(is_quotient((int64_t)ends[i] * TP_FX_ONE, ends[k],
                                    tp_fx_div(ends[i], ends[k])));
    assert_int_equal(tp_fx_div(TP_FX_MIN, -1), TP_FX_MAX);
    assert_int_equal(tp_fx_div(1, 0), TP_FX_MAX);
    assert_int_equal(tp_fx_div(-1, 0), TP_FX_MIN);
    assert_int_equal(tp_fx_div(0, 0), 0);
}

static void reciprocals_round_half_up_and_saturate(void **state)
{
    (void)state;
    measure m = { .what = "tp_fx_recip", .unit = "LSB" };
    const uint32_t stride = sweep_stride();
    for (uint64_t word = 0; word <= UINT32_MAX; word += stride) {
        const tp_fx x = (tp_fx)(uint32_t)word;
        const tp_fx r = tp_fx_recip(x);
        if (x == 0)
            continue;
        if (!is_quotient((int64_t)1 << 32, x, r))
            fail_msg("1 / %d is not %d", (int)x, (int)r);
        if (r != TP_FX_MAX && r != TP_FX_MIN)
            measure_add(&m, 0x1p32 / (double)x - (double)r, x, r, 0);
    }
    for (tp_fx x = -(1 << 20); x <= 1 << 20; x++)
        if (x != 0 && !is_quotient((int64_t)1 << 32, x, tp_fx_recip(x)))
            fail_msg("1 / %d is not %d", (int)x, (int)tp_fx_recip(x));
    measure_print(&m);
    assert_true(m.worst <= 0.5);
    assert_int_equal(tp_fx_recip(0), TP_FX_MAX);
    assert_int_equal(tp_fx_recip(-1), TP_FX_MIN);
    assert_int_equal(tp_fx_recip(-2), TP_FX_MIN);
    assert_int_equal(tp_fx_recip(2), TP_FX_MAX);
}

/* Numbers of all lengths, so that quotients have 0 to 63 bits. */
static void quotients_by_shifts_are_those_of_division(void **state)
{
    (void)state;
    const int64_t ends[] = { 0, 1, -1, 2, 3, INT32_MAX, INT32_MIN, INT64_MAX, -INT64_MAX };
    const int count = sizeof ends / sizeof *ends;

    for (int i = 0; i < count; i++)
        for (int k = 1; k < count; k++)
            assert_true(tp_quotient_by_shifts(ends[i], ends[k]) == ends[i] / ends[k]);
    for (int i = 0; i < 1000000; i++) {
        const int64_t n = (int64_t)random_next(&seed) >> random_below(&seed, 64);
        const int64_t d = (int64_t)random_next(&seed) >> random_below(&seed, 64);
        if (n > INT64_MIN && d > INT64_MIN && d != 0)
            assert_true(tp_quotient_by_shifts(n, d) == n / d);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products_round_half_up),
        cmocka_unit_test(constants_are_rounded_to_nearest),
        cmocka_unit_test(small_helpers_do_what_they_say),
        cmocka_unit_test(quotients_round_half_up_and_saturate),
        cmocka_unit_test(quotients_of_the_ends_are_safe),
        cmocka_unit_test(reciprocals_round_half_up_and_saturate),
        cmocka_unit_test(quotients_by_shifts_are_those_of_division),
    };
    seed = random_seed();
    return cmocka_run_group_tests_name("fixed/numbers", tests, NULL, NULL);
}
