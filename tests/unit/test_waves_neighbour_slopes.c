/* SPDX-License-Identifier: MIT */
/* The normal from four neighbour heights [A6]: exact on planes, equal to the sum of its
 * four triangles' normals, and near a wave's own normal. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/deep_water.h"

static uint64_t chance;

static void a_plane_gives_its_slopes(void **state)
{
    (void)state;
    for (int n = 0; n < 20000; n++) {
        const tp_fx d = chance_scale(&chance, 0.01, 1000);
        const double sx = chance_double(&chance, -3, 3);
        const double sz = chance_double(&chance, -3, 3);
        const double rise = sx * d, run = sz * d;
        const tp_fx neighbours[4] = { (tp_fx)lround(-rise), (tp_fx)lround(rise),
                                      (tp_fx)lround(-run), (tp_fx)lround(run) };
        const tp_height_slope got = tp_neighbour_height_slope(7, neighbours, d);
        /* Each height has a rounding error of half an LSB, over a base of 2 d. */
        assert_int_equal(got.height, 7);
        assert_true(fabs(got.slope_x - sx / LSB) <= 0.5 / (d * LSB) + 0.51);
        assert_true(fabs(got.slope_z - sz / LSB) <= 0.5 / (d * LSB) + 0.51);
        const tp_dir3 normal = tp_neighbour_normal(neighbours, d);
        const double x = -got.slope_x * LSB, z = -got.slope_z * LSB;
        const double length = sqrt(x * x + 1 + z * z);
        assert_true(fabs(normal.x / 1073741824.0 - x / length) < 2 * LSB);
        assert_true(fabs(normal.y / 1073741824.0 - 1 / length) < 2 * LSB);
        assert_true(fabs(normal.z / 1073741824.0 - z / length) < 2 * LSB);
    }
}

/* The normals of the four triangles between the middle and its neighbours, not normalised,
 * add up to 2 d times the vector of the differences: in integers, hence exactly. */
static void it_is_the_sum_of_four_triangles_normals(void **state)
{
    (void)state;
    for (int n = 0; n < 20000; n++) {
        const int64_t d = chance_int(&chance, 1, 1000);
        const int64_t h = chance_int(&chance, -999, 999);
        int64_t x = 0, y = 0, z = 0;
        tp_fx neighbours[4];
        for (int i = 0; i < 4; i++)
            neighbours[i] = chance_int(&chance, -999, 999);
        for (int i = 0; i < 4; i++) {
            const int64_t to_x = i & 1 ? d : -d, to_z = i & 2 ? d : -d;
            const int64_t rise_x = neighbours[i & 1] - h,
                          rise_z = neighbours[2 + (i >> 1)] - h;
            const int64_t up = to_x * to_z < 0 ? -1 : 1;
            x += up * -rise_x * to_z;
            y += up * to_x * to_z;
            z += up * -rise_z * to_x;
        }
        const tp_dir3 want = tp_normalise((int32_t)x, (int32_t)y, (int32_t)z);
        const tp_dir3 got = tp_neighbour_normal(neighbours, (tp_fx)d);
        assert_true(abs(got.x - want.x) <= 16);
        assert_true(abs(got.y - want.y) <= 16);
        assert_true(abs(got.z - want.z) <= 16);
    }
}

/* Second order: the slope's error is d^2/6 of the third derivative, at most A k^3. */
static void it_comes_near_a_waves_own_normal(void **state)
{
    (void)state;
    const tp_wave wave = { .amplitude = TP_FX_ONE, .length = 20 * TP_FX_ONE,
                           .heading = 90 * TP_FX_ONE };
    const double k = 2 * PI / 20, d = 0.5;
    measure slope = { .what = "five heights", .unit = "m/m" };
    const tp_turn phases[TP_WAVES] = { 0 };
    tp_deep_water deep;

    tp_deep_water_init(&deep, &wave, 1, TP_FX(9.81));
    for (int n = 0; n < 1000; n++) {
        const tp_fx x = chance_fx(&chance, -100, 100), step = TP_FX(0.5);
        const tp_surface_point at = tp_deep_water_displace_point(&deep, phases, x, 0);
        const tp_fx neighbours[4] = {
            tp_deep_water_displace_point(&deep, phases, x - step, 0).position.y,
            tp_deep_water_displace_point(&deep, phases, x + step, 0).position.y,
            tp_deep_water_displace_point(&deep, phases, x, -step).position.y,
            tp_deep_water_displace_point(&deep, phases, x, step).position.y,
        };
        const tp_height_slope got =
            tp_neighbour_height_slope(at.position.y, neighbours, step);
        measure_add(&slope, (got.slope_x - at.slope_x) * LSB, x, 0, 0);
        assert_true(abs(got.slope_z - at.slope_z) <= 2);
    }
    measure_print(&slope);
    assert_true(slope.worst < k * k * k * d * d / 6 + 1e-4);
    assert_true(slope.worst > 1e-4);
}

/* At a wall the missing height is the mirrored height: half the slope if the wall lies half
 * a spacing beyond, zero slope if points lie on the wall. */
static void a_wall_mirrors_the_missing_height(void **state)
{
    (void)state;
    const tp_fx middle = 3 * TP_FX_ONE, east = 5 * TP_FX_ONE, d = TP_FX_ONE;
    const tp_fx beyond[4] = { middle, east, 0, 0 }, on[4] = { east, east, 0, 0 };

    assert_int_equal(tp_neighbour_height_slope(middle, beyond, d).slope_x, TP_FX_ONE);
    assert_int_equal(tp_neighbour_height_slope(middle, on, d).slope_x, 0);
    assert_int_equal(tp_neighbour_normal(on, d).y, TP_Q30_ONE);
}

static void slopes_saturate_at_the_ends_of_the_ranges(void **state)
{
    (void)state;
    const tp_fx most = 8192 * TP_FX_ONE - 1;
    const tp_fx cliff[4] = { -most, most, most, -most };

    assert_int_equal(tp_neighbour_height_slope(most, cliff, 1).slope_x, TP_FX_MAX);
    assert_int_equal(tp_neighbour_height_slope(most, cliff, 1).slope_z, TP_FX_MIN);
    assert_int_equal(tp_neighbour_height_slope(most, cliff, most).slope_x, TP_FX_ONE);
    assert_true(tp_neighbour_normal(cliff, most).y > 0);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plane_gives_its_slopes),
        cmocka_unit_test(it_is_the_sum_of_four_triangles_normals),
        cmocka_unit_test(it_comes_near_a_waves_own_normal),
        cmocka_unit_test(a_wall_mirrors_the_missing_height),
        cmocka_unit_test(slopes_saturate_at_the_ends_of_the_ranges),
    };
    return cmocka_run_group_tests_name("waves/neighbour_slopes", tests, NULL, NULL);
}
