/* SPDX-License-Identifier: MIT */
/* Directions, lengths and products of vectors compared with double precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "fixed/arithmetic.h"
#include "tests/lib/measure.h"

enum { INPUTS = 10100000 };

static uint64_t seed;

static double length_of(double x, double y, double z)
{
    return sqrt(x * x + y * y + z * z);
}

static void check_direction(measure *m, int32_t x, int32_t y, int32_t z)
{
    const tp_dir3 d = tp_normalise(x, y, z);
    const double length = length_of(x, y, z);
    const double ex = fabs(d.x * 0x1p-30 - x / length),
                 ey = fabs(d.y * 0x1p-30 - y / length),
                 ez = fabs(d.z * 0x1p-30 - z / length);
    measure_add(m, fmax(ex, fmax(ey, ez)) * 0x1p27, x, y, z);
}

static void normalise_errs_by_less_than_2_to_minus_27(void **state)
{
    (void)state;
    measure m = { .what = "tp_normalise", .unit = "of 2^-27" };
    uint64_t random = seed;
    for (int i = 0; i < INPUTS; i++) {
        const int32_t x = random_number(&random), y = random_number(&random),
                      z = random_number(&random);
        if (x != 0 || y != 0 || z != 0)
            check_direction(&m, x, y, z);
    }
    static const int32_t ends[] = { INT32_MIN, INT32_MIN + 1, -1, 0, 1, INT32_MAX };
    for (int i = 0; i < 6 * 6 * 6; i++)
        if (i != 3 * 36 + 3 * 6 + 3)        /* 0, 0, 0 has no direction */
            check_direction(&m, ends[i / 36], ends[i / 6 % 6], ends[i % 6]);
    for (int32_t x = -20; x <= 20; x++)
        for (int32_t y = -20; y <= 20; y++)
            for (int32_t z = 1; z <= 20; z++)
                check_direction(&m, x, y, z);
    measure_print(&m);
    assert_true(m.worst < 1.0);
}

static void the_null_vector_points_up(void **state)
{
    (void)state;
    const tp_dir3 d = tp_normalise(0, 0, 0);
    assert_int_equal(d.x, 0);
    assert_int_equal(d.y, TP_Q30_ONE);
    assert_int_equal(d.z, 0);
}

static void length_is_the_nearest_and_saturates(void **state)
{
    (void)state;
    uint64_t random = seed;
    measure m = { .what = "tp_vec3_length", .unit = "LSB" };
    for (int i = 0; i < INPUTS; i++) {
        const tp_vec3 v = { random_number(&random), random_number(&random),
                            random_number(&random) };
        const double length = length_of(v.x, v.y, v.z);
        const tp_fx r = tp_vec3_length(v);
        if (length >= INT32_MAX)
            assert_int_equal(r, TP_FX_MAX);
        else
            measure_add(&m, r - length, v.x, v.y, v.z);
    }
    measure_print(&m);
    assert_true(m.worst <= 0.5 + 1e-6);     /* rounding of the double itself */
    assert_int_equal(tp_vec3_length((tp_vec3){ INT32_MIN, INT32_MIN, INT32_MIN }),
                     TP_FX_MAX);
    assert_int_equal(tp_vec3_length((tp_vec3){ INT32_MIN, 0, 0 }), TP_FX_MAX);
    assert_int_equal(tp_vec3_length((tp_vec3){ 0, INT32_MAX, 0 }), TP_FX_MAX);
    assert_int_equal(tp_vec3_length((tp_vec3){ TP_FX(3), TP_FX(-4), TP_FX(12) }),
                     TP_FX(13));
    assert_int_equal(tp_vec3_length((tp_vec3){ 0, 0, 0 }), 0);
}

static tp_dir3 random_direction(uint64_t *random)
{
    return tp_normalise((int32_t)random_next(random) / 2,
                        (int32_t)random_next(random) / 2,
                        (int32_t)random_next(random) / 2);
}

static void products_of_directions_round_once(void **state)
{
    (void)state;
    uint64_t random = seed;
    measure dot = { .what = "tp_dir3_dot", .unit = "LSB" };
    measure cross = { .what = "tp_dir3_cross", .unit = "LSB" };
    for (int i = 0; i < INPUTS / 10; i++) {
        const tp_dir3 a = random_direction(&random), b = random_direction(&random);
        const tp_dir3 c = tp_dir3_cross(a, b);
        const double ax = a.x, ay = a.y, az = a.z, bx = b.x, by = b.y, bz = b.z;
        measure_add(&dot, tp_dir3_dot(a, b) - (ax * bx + ay * by + az * bz) * 0x1p-30, i,
                    0, 0);
        measure_add(&cross, c.x - (ay * bz - az * by) * 0x1p-30, i, 0, 0);
        measure_add(&cross, c.y - (az * bx - ax * bz) * 0x1p-30, i, 1, 0);
        measure_add(&cross, c.z - (ax * by - ay * bx) * 0x1p-30, i, 2, 0);
    }
    measure_print(&dot);
    measure_print(&cross);
    assert_true(dot.worst <= 0.5 + 1e-6);
    assert_true(cross.worst <= 0.5 + 1e-6);
}

static void axes_cross_right_handed(void **state)
{
    (void)state;
    const tp_dir3 x = { TP_Q30_ONE, 0, 0 }, y = { 0, TP_Q30_ONE, 0 };
    const tp_dir3 z = tp_dir3_cross(x, y);
    assert_int_equal(z.x, 0);
    assert_int_equal(z.y, 0);
    assert_int_equal(z.z, TP_Q30_ONE);
    assert_int_equal(tp_dot_dir((tp_vec3){ 5, -7, 9 }, y), -7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normalise_errs_by_less_than_2_to_minus_27),
        cmocka_unit_test(the_null_vector_points_up),
        cmocka_unit_test(length_is_the_nearest_and_saturates),
        cmocka_unit_test(products_of_directions_round_once),
        cmocka_unit_test(axes_cross_right_handed),
    };
    seed = random_seed();
    return cmocka_run_group_tests_name("fixed/directions", tests, NULL, NULL);
}
