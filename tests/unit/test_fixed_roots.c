/* SPDX-License-Identifier: MIT */
/* Roots and normalised reciprocals: exact functions by their definition, others in double
 * precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "fixed/arithmetic.h"
#include "tests/lib/measure.h"

enum { INPUTS = 10000000 };

static uint64_t seed;

/* (r - 1/2)^2 <= n <= (r + 1/2)^2, without fractions. */
static int is_nearest_root(uint64_t n, uint64_t r)
{
    return n <= r * r + r && (r == 0 || n > r * r - r);
}

static void sqrt_is_the_nearest(void **state)
{
    (void)state;
    measure m = { .what = "tp_fx_sqrt", .unit = "LSB" };
    const uint32_t stride = sweep_stride();
    for (uint32_t x = 1; x <= INT32_MAX - stride;
         x += x < 1u << 22 ? 1 : stride / 2 + 1) {
        const uint32_t r = (uint32_t)tp_fx_sqrt((tp_fx)x);
        if (!is_nearest_root((uint64_t)x << 16, r))
            fail_msg("the root of %u is not %u", (unsigned)x, (unsigned)r);
        measure_add(&m, sqrt((double)x * 65536.0) - r, x, r, 0);
    }
    measure_print(&m);
    assert_true(m.worst <= 0.5);
    const uint32_t last = (uint32_t)tp_fx_sqrt(TP_FX_MAX);
    assert_true(is_nearest_root((uint64_t)TP_FX_MAX << 16, last));
    assert_int_equal(tp_fx_sqrt(0), 0);
    assert_int_equal(tp_fx_sqrt(-1), 0);
    assert_int_equal(tp_fx_sqrt(TP_FX_MIN), 0);
    assert_int_equal(tp_fx_sqrt(TP_FX(2.25)), TP_FX(1.5));
}

static void rsqrt_is_within_one_unit(void **state)
{
    (void)state;
    measure m = { .what = "tp_fx_rsqrt", .unit = "LSB" };
    const uint32_t stride = sweep_stride();
    for (uint32_t x = 1; x <= INT32_MAX - stride; x += x < 1u << 22 ? 1 : stride / 2 + 1)
        measure_add(&m, 0x1p24 / sqrt((double)x) - tp_fx_rsqrt((tp_fx)x), x, 0, 0);
    measure_print(&m);
    assert_true(m.worst < 1.0);
    assert_int_equal(tp_fx_rsqrt(1), TP_FX(256));
    assert_int_equal(tp_fx_rsqrt(TP_FX_ONE), TP_FX_ONE);
    assert_int_equal(tp_fx_rsqrt(TP_FX(4)), TP_FX(0.5));
    assert_int_equal(tp_fx_rsqrt(0), TP_FX_MAX);
    assert_int_equal(tp_fx_rsqrt(-1), TP_FX_MAX);
}

static void check_floor_root(uint64_t x)
{
    const uint64_t r = tp_isqrt64(x);
    if (r * r > x || x - r * r > 2 * r)
        fail_msg("the root of %" PRIu64 " is not %" PRIu64, x, r);
}

static void isqrt64_is_the_floor(void **state)
{
    (void)state;
    uint64_t random = seed;
    for (int i = 0; i < INPUTS / 2; i++) {
        const uint64_t x = random_next(&random);
        check_floor_root(x >> (i & 63));
        const uint64_t r = (uint32_t)random_next(&random) >> (i & 31);
        check_floor_root(r * r);            /* here the floor steps */
        check_floor_root(r * r - (r > 0));
        check_floor_root(r * r + 2 * r);
    }
    for (uint32_t x = 0; x < 1u << 20; x++) {
        check_floor_root(x);
        check_floor_root(UINT64_MAX - x);
        check_floor_root(((uint64_t)1 << 62) + x);
        const uint64_t r = UINT32_MAX - x;  /* a step too far would pass 2^32 */
        check_floor_root(r * r);
        check_floor_root(r * r - 1);
    }
    printf("    %-18s %10d inputs, exact\n", "tp_isqrt64", 2 * INPUTS + 5 * (1 << 20));
}

/* Error relative to the true value, in units of 2^-29. */
static void check_recip(measure *m, uint32_t n)
{
    const uint32_t r = tp_recip_norm(n);
    if (r < 0x80000000u)
        fail_msg("the reciprocal of %08x is %08x", (unsigned)n, (unsigned)r);
    measure_add(m, ((double)r * n * 0x1p-63 - 1.0) * 0x1p29, n, r, 0);
}

static void recip_norm_errs_by_less_than_2_to_minus_29(void **state)
{
    (void)state;
    measure m = { .what = "tp_recip_norm", .unit = "of 2^-29" };
    const uint32_t stride = sweep_stride() / 2 + 1;
    for (uint64_t n = (uint64_t)1 << 31; n <= UINT32_MAX; n += stride)
        check_recip(&m, (uint32_t)n);
    for (uint32_t knot = 256; knot < 512; knot++)       /* each step of the table */
        for (uint32_t off = 0; off < 64; off++) {
            check_recip(&m, (knot << 23) + off);
            check_recip(&m, (knot << 23) + 0x7fffff - off);
        }
    measure_print(&m);
    assert_true(m.worst < 1.0);
    assert_int_equal(tp_recip_norm(0x80000000u), UINT32_MAX);
}

/* Relative error in units of 2^-28: half the error of x y^2. */
static void check_rsqrt(measure *m, uint32_t n)
{
    const uint32_t r = tp_rsqrt_norm(n);
    if (r < 0x80000000u)
        fail_msg("the reciprocal root of %08x is %08x", (unsigned)n, (unsigned)r);
    const double y = r * 0x1p-31;
    measure_add(m, (y * y * (n * 0x1p-32) - 1.0) * 0x1p27, n, r, 0);
}

static void rsqrt_norm_errs_by_less_than_2_to_minus_28(void **state)
{
    (void)state;
    measure m = { .what = "tp_rsqrt_norm", .unit = "of 2^-28" };
    const uint32_t stride = sweep_stride() / 2 + 1;
    for (uint64_t n = (uint64_t)1 << 30; n <= UINT32_MAX; n += stride)
        check_rsqrt(&m, (uint32_t)n);
    for (uint32_t knot = 64; knot < 256; knot++)
        for (uint32_t off = 0; off < 64; off++) {
            check_rsqrt(&m, (knot << 24) + off);
            check_rsqrt(&m, (knot << 24) + 0xffffff - off);
        }
    measure_print(&m);
    assert_true(m.worst < 1.0);
    assert_int_equal(tp_rsqrt_norm(0x40000000u), UINT32_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sqrt_is_the_nearest),
        cmocka_unit_test(rsqrt_is_within_one_unit),
        cmocka_unit_test(isqrt64_is_the_floor),
        cmocka_unit_test(recip_norm_errs_by_less_than_2_to_minus_29),
        cmocka_unit_test(rsqrt_norm_errs_by_less_than_2_to_minus_28),
    };
    seed = random_seed();
    return cmocka_run_group_tests_name("fixed/roots", tests, NULL, NULL);
}
