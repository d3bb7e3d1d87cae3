/* SPDX-License-Identifier: MIT */
/* The floor compared with double precision: slopes of any heading, height maps of any
 * size. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/deep_water.h"
#include "tests/lib/measure.h"
#include "tests/lib/random.h"
#include "waves/coastal_water.h"

#define LSB (1 / 65536.0)

static uint64_t chance;

static void no_floor_is_deep_everywhere(void **state)
{
    (void)state;
    const tp_floor floor = { .depth = 0, .slope = TP_FX(0.5) };
    const tp_floor_at at = tp_floor_sample(&floor, TP_FX(1000), TP_FX(-1000));
    assert_int_equal(at.depth, TP_FX_MAX);
    assert_int_equal(at.rise_x, 0);
    assert_int_equal(at.rise_z, 0);
}

/* The uphill direction is a unit vector within 7e-9 (rotations, arithmetic.h): the bound is
 * the distance times 7e-9, plus the roundings of position and depth. */
static void slopes_follow_their_plane(void **state)
{
    (void)state;
    measure depth = { .what = "depth", .unit = "mm" },
            rise = { .what = "rise", .unit = "" };

    for (int n = 0; n < 20000; n++) {
        const tp_floor floor = {
            .depth = chance_fx(&chance, 0.01, 8000), .slope = chance_fx(&chance, 0, 1),
            .heading = chance_fx(&chance, -32000, 32000),
        };
        const tp_fx x = chance_fx(&chance, -8000, 8000),
                    z = chance_fx(&chance, -8000, 8000);
        const tp_floor_at got = tp_floor_sample(&floor, x, z);
        const double heading = floor.heading * LSB * PI / 180, slope = floor.slope * LSB;
        const double way = (sin(heading) * x - cos(heading) * z) * LSB;
        const double want = floor.depth * LSB - slope * way;
        measure_add(&depth, 1000 * (got.depth * LSB - want), x, z, floor.heading);
        measure_add(&rise, got.rise_x * LSB - slope * sin(heading), x, z, floor.heading);
        measure_add(&rise, got.rise_z * LSB + slope * cos(heading), x, z, floor.heading);
        assert_true(fabs(got.depth * LSB - want) <= 3 * LSB + 3e-8 * 16000);
    }
    measure_print(&depth);
    measure_print(&rise);
    assert_true(rise.worst <= LSB);
}

/* -- maps -------------------------------------------------------------------------- */

#define SIDE 40

typedef struct {
    uint16_t sample[SIDE * SIDE];
    tp_grey  picture;
    tp_floor floor;
} map;

static void any_map(map *m)
{
    m->picture = (tp_grey){ (uint32_t)chance_int(&chance, 1, SIDE),
                            (uint32_t)chance_int(&chance, 1, SIDE), m->sample };
    for (int i = 0; i < SIDE * SIDE; i++)
        m->sample[i] = (uint16_t)random_next(&chance);
    m->floor = (tp_floor){
        .map = &m->picture,
        .map_x = chance_fx(&chance, -8000, 8000),
        .map_z = chance_fx(&chance, -8000, 8000),
        .map_size = chance_scale(&chance, 1, 8000),
        .map_low = chance_fx(&chance, -8000, 100),
        .map_high = chance_fx(&chance, -8000, 100),
    };
}

typedef struct {
    double height, rise_x, rise_z;
    bool   at_a_joint;          /* here the rise jumps */
} ref_floor;

static double sample_at(const map *m, double col, double row)
{
    const tp_grey *p = &m->picture;
    const int c = (int)fmin(fmax(col, 0), p->cols - 1.0);
    const int r = (int)fmin(fmax(row, 0), p->rows - 1.0);
    return p->sample[(size_t)r * p->cols + (size_t)c] / 65535.0;
}

static ref_floor ref_shade_water_depth(const map *m, tp_fx x, tp_fx z)
{
    const tp_floor *f = &m->floor;
    const double cell = f->map_size * LSB / m->picture.cols;
    const double low = f->map_low * LSB, range = (f->map_high - (double)f->map_low) * LSB;
    double u = (x - (double)f->map_x) * LSB / cell + m->picture.cols / 2.0 - 0.5;
    double v = (z - (double)f->map_z) * LSB / cell + m->picture.rows / 2.0 - 0.5;
    const bool out_u = u < 0 || u > m->picture.cols - 1.0;
    const bool out_v = v < 0 || v > m->picture.rows - 1.0;
    u = fmin(fmax(u, 0), m->picture.cols - 1.0);
    v = fmin(fmax(v, 0), m->picture.rows - 1.0);
    const double i = floor(u), j = floor(v), s = u - i, t = v - j;
    const double a = sample_at(m, i, j), b = sample_at(m, i + 1, j);
    const double c = sample_at(m, i, j + 1), d = sample_at(m, i + 1, j + 1);
    return (ref_floor){
        low + range * ((a * (1 - s) + b * s) * (1 - t) + (c * (1 - s) + d * s) * t),
        out_u ? 0 : range / cell * ((b - a) * (1 - t) + (d - c) * t),
        out_v ? 0 : range / cell * ((c - a) * (1 - s) + (d - b) * s),
        fmin(s, 1 - s) < 1e-4 || fmin(t, 1 - t) < 1e-4,
    };
}

/* A position is truncated to 2^-16 of a cell, where the full range may change: range /
 * 65536. */
static void maps_are_bilinear_between_the_middles_of_their_pixels(void **state)
{
    (void)state;
    measure height = { .what = "height", .unit = "of the range" };
    measure rise = { .what = "rise", .unit = "" };
    static map m;

    for (int n = 0; n < 2000; n++) {
        any_map(&m);
        const double range = abs(m.floor.map_high - m.floor.map_low) * LSB + 1;
        const double size = m.floor.map_size * LSB, cell = size / m.picture.cols;
        for (int k = 0; k < 20; k++) {
            const tp_fx x = m.floor.map_x + chance_fx(&chance, -size, size);
            const tp_fx z = m.floor.map_z + chance_fx(&chance, -size, size);
            const tp_floor_at got = tp_floor_sample(&m.floor, x, z);
            const ref_floor want = ref_shade_water_depth(&m, x, z);
            measure_add(&height, (-got.depth * LSB - want.height) / range, x, z, n);
            assert_true(fabs(-got.depth * LSB - want.height)
                        <= 3 * range * LSB + 2 * LSB);
            if (want.at_a_joint)
                continue;
            const double most = range / cell * 4 * LSB + 2 * LSB;
            const double wx = fmin(8, fmax(-8, want.rise_x));
            const double wz = fmin(8, fmax(-8, want.rise_z));
            measure_add(&rise, (got.rise_x * LSB - wx) / (1 + range / cell), x, z, n);
            assert_true(fabs(got.rise_x * LSB - wx) <= most);
            assert_true(fabs(got.rise_z * LSB - wz) <= most);
        }
    }
    measure_print(&height);
    measure_print(&rise);
}

static void beyond_a_map_its_edge_goes_on(void **state)
{
    (void)state;
    static map m;

    for (int n = 0; n < 500; n++) {
        any_map(&m);
        const tp_fx far = m.floor.map_size + 2 * TP_FX_ONE;
        const int64_t tall = (int64_t)m.floor.map_size * m.picture.rows / m.picture.cols;
        const tp_fx z = m.floor.map_z;
        const tp_floor_at at = tp_floor_sample(&m.floor, m.floor.map_x + far, z);
        const tp_floor_at on = tp_floor_sample(&m.floor, m.floor.map_x + far + far / 2, z);
        assert_int_equal(at.depth, on.depth);
        assert_int_equal(at.rise_x, 0);
        if (tall < TP_FX(20000))
            assert_int_equal(
                tp_floor_sample(&m.floor, m.floor.map_x, z + (tp_fx)tall).rise_z, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_floor_is_deep_everywhere),
        cmocka_unit_test(slopes_follow_their_plane),
        cmocka_unit_test(maps_are_bilinear_between_the_middles_of_their_pixels),
        cmocka_unit_test(beyond_a_map_its_edge_goes_on),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("waves/floor", tests, NULL, NULL);
}
