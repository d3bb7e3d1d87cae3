/* SPDX-License-Identifier: MIT */
/* Rotations: the signs that the header promises, and every entry compared with double
 * precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "fixed/arithmetic.h"
#include "tests/lib/measure.h"

enum { INPUTS = 1000000 };

static uint64_t seed;

static void assert_dir(tp_dir3 d, tp_q30 x, tp_q30 y, tp_q30 z)
{
    assert_int_equal(d.x, x);
    assert_int_equal(d.y, y);
    assert_int_equal(d.z, z);
}

static void no_turn_is_the_world_itself(void **state)
{
    (void)state;
    const tp_rotation r = tp_rotation_from_angles(0, 0, 0);
    assert_dir(r.x, TP_Q30_ONE, 0, 0);
    assert_dir(r.y, 0, TP_Q30_ONE, 0);
    assert_dir(r.z, 0, 0, TP_Q30_ONE);
}

static void heading_turns_the_look_from_minus_z_to_plus_x(void **state)
{
    (void)state;
    const tp_rotation r = tp_rotation_from_angles(TP_DEG(90), 0, 0);
    assert_dir(r.z, -TP_Q30_ONE, 0, 0);     /* looks along +x, so back is -x */
    assert_dir(r.x, 0, 0, TP_Q30_ONE);
    assert_dir(r.y, 0, TP_Q30_ONE, 0);
    assert_true(tp_rotation_from_angles(TP_DEG(10), 0, 0).z.x < 0);
}

static void pitch_lifts_the_look(void **state)
{
    (void)state;
    const tp_rotation r = tp_rotation_from_angles(0, TP_DEG(90), 0);
    assert_dir(r.z, 0, -TP_Q30_ONE, 0);     /* looks straight up */
    assert_dir(r.y, 0, 0, TP_Q30_ONE);
    assert_dir(r.x, TP_Q30_ONE, 0, 0);
}

static void roll_lowers_the_right_side(void **state)
{
    (void)state;
    const tp_rotation r = tp_rotation_from_angles(0, 0, TP_DEG(90));
    assert_dir(r.x, 0, -TP_Q30_ONE, 0);
    assert_dir(r.y, TP_Q30_ONE, 0, 0);
    assert_dir(r.z, 0, 0, TP_Q30_ONE);
    assert_true(tp_rotation_from_angles(TP_DEG(77), TP_DEG(-20), TP_DEG(1)).x.y < 0);
}

/* Applies roll, pitch and heading to a vector of the local frame, one after the other. */
static void turned(const double v[3], const double angle[3], double out[3])
{
    const double sr = sin(angle[2]), cr = cos(angle[2]);
    const double x = v[0] * cr + v[1] * sr, y = -v[0] * sr + v[1] * cr;
    const double sp = sin(angle[1]), cp = cos(angle[1]);
    const double up = y * cp - v[2] * sp, back = y * sp + v[2] * cp;
    const double sh = sin(angle[0]), ch = cos(angle[0]);
    out[0] = x * ch - back * sh;
    out[1] = up;
    out[2] = x * sh + back * ch;
}

static void every_entry_is_within_2e_8(void **state)
{
    (void)state;
    measure m = { .what = "tp_rotation_from_angles", .unit = "" };
    uint64_t random = seed;
    for (int i = 0; i < INPUTS; i++) {
        const tp_turn t[3] = { (tp_turn)random_next(&random),
                               (tp_turn)random_next(&random),
                               (tp_turn)random_next(&random) };
        const double unit = 6.283185307179586476925 * 0x1p-32;
        const double angle[3] = { t[0] * unit, t[1] * unit, t[2] * unit };
        const tp_rotation r = tp_rotation_from_angles(t[0], t[1], t[2]);
        const tp_dir3 rows[3] = { r.x, r.y, r.z };
        for (int row = 0; row < 3; row++) {
            const double axis[3] = { row == 0, row == 1, row == 2 };
            double want[3];
            turned(axis, angle, want);
            measure_add(&m, rows[row].x * 0x1p-30 - want[0], t[0], t[1], t[2]);
            measure_add(&m, rows[row].y * 0x1p-30 - want[1], t[0], t[1], t[2]);
            measure_add(&m, rows[row].z * 0x1p-30 - want[2], t[0], t[1], t[2]);
        }
    }
    measure_print(&m);
    assert_true(m.worst < 2e-8);
}

static tp_rotation random_rotation(uint64_t *random)
{
    return tp_rotation_from_angles((tp_turn)random_next(random),
                                   (tp_turn)random_next(random),
                                   (tp_turn)random_next(random));
}

static void turning_there_and_back_returns_the_vector(void **state)
{
    (void)state;
    measure m = { .what = "tp_rotate, _back", .unit = "LSB" };
    uint64_t random = seed;
    for (int i = 0; i < INPUTS; i++) {
        const tp_rotation r = random_rotation(&random);
        const tp_vec3 v = { random_number(&random) >> 6, random_number(&random) >> 6,
                            random_number(&random) >> 6 };
        const tp_vec3 w = tp_rotate_back(&r, tp_rotate(&r, v));
        const double off = fabs((double)w.x - v.x) + fabs((double)w.y - v.y)
                         + fabs((double)w.z - v.z);
        measure_add(&m, off, v.x, v.y, v.z);
    }
    measure_print(&m);
    assert_true(m.worst <= 6);              /* 2^25 long and rounded twice */
}

static void a_product_turns_as_its_factors_one_after_the_other(void **state)
{
    (void)state;
    measure m = { .what = "tp_rotation_mul", .unit = "LSB" };
    uint64_t random = seed;
    for (int i = 0; i < INPUTS / 4; i++) {
        const tp_rotation a = random_rotation(&random), b = random_rotation(&random);
        const tp_rotation ab = tp_rotation_mul(&a, &b);
        const tp_vec3 v = { random_number(&random) >> 8, random_number(&random) >> 8,
                            random_number(&random) >> 8 };
        const tp_vec3 one = tp_rotate(&ab, v), two = tp_rotate(&a, tp_rotate(&b, v));
        const double off = fabs((double)one.x - two.x) + fabs((double)one.y - two.y)
                         + fabs((double)one.z - two.z);
        measure_add(&m, off, v.x, v.y, v.z);
    }
    measure_print(&m);
    assert_true(m.worst <= 6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_turn_is_the_world_itself),
        cmocka_unit_test(heading_turns_the_look_from_minus_z_to_plus_x),
        cmocka_unit_test(pitch_lifts_the_look),
        cmocka_unit_test(roll_lowers_the_right_side),
        cmocka_unit_test(every_entry_is_within_2e_8),
        cmocka_unit_test(turning_there_and_back_returns_the_vector),
        cmocka_unit_test(a_product_turns_as_its_factors_one_after_the_other),
    };
    seed = random_seed();
    return cmocka_run_group_tests_name("fixed/rotations", tests, NULL, NULL);
}
