/* SPDX-License-Identifier: MIT */
/* The surface with all wave models: the sum equals the sum of the parts, the inversion over
 * coastal water finds its point, and the slopes across equal those of the cross product. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "view/surface.h"
#include "tests/lib/measure.h"
#include "tests/lib/coastal_water.h"
#include "tests/lib/pools.h"

enum { RINGS = 5 };

static uint64_t chance;

typedef struct {
    coastal_water deep; /* without coastal water unless built */
    tp_turn     phases[TP_WAVES];
    tp_ring_now ring[RINGS];
    tp_pool    *pool, *field;
} surface_water;

static tp_pool *stirred_pool(tp_cells cells, tp_edges edges)
{
    tp_pool_config c = pool_config(cells, edges, 48, 40);
    c.cell = TP_FX(0.5);
    tp_pool *pool = pool_make(&c);
    for (int n = 0; n < 8; n++)
        tp_pool_add_splash(pool, chance_fx(&chance, -11, 11), chance_fx(&chance, -9, 9),
                           TP_FX_ONE, chance_fx(&chance, -0.6, 0.6));
    pool_steps(pool, 20);
    return pool;
}

/* Waves with a steepness sum of q, rings, pool and field. */
static tp_surface surface_make(surface_water *w, double q)
{
    memset(w, 0, sizeof *w);
    w->deep.count = 4;
    for (int i = 0; i < 4; i++)
        w->deep.wave[i] =
            coastal_wave(chance_double(&chance, 0.1, 0.8), chance_double(&chance, 8, 60),
                         q / 4, chance_double(&chance, -90, 90));
    tp_deep_water_init(&w->deep.deep, w->deep.wave, 4, TP_FX(9.81));
    tp_deep_water_phases(&w->deep.deep, random_below(&chance, 1 << 20), 0, w->phases);
    for (int i = 0; i < RINGS; i++) {
        const tp_ring ring = {
            .x = chance_fx(&chance, -9, 9), .z = chance_fx(&chance, -9, 9),
            .amplitude = chance_fx(&chance, 0.01, 0.5), .length = chance_fx(&chance, 1, 4),
            .speed = TP_FX(1.2), .decay = TP_FX(4), .spread = TP_FX_ONE,
        };
        assert_true(tp_ring_evaluate(&ring, (int64_t)chance_int(&chance, 20, 300) * 65536,
                                     &w->ring[i]));
    }
    w->pool = stirred_pool((tp_cells)random_below(&chance, 3), TP_EDGES_WALL);
    w->field = stirred_pool((tp_cells)random_below(&chance, 3), TP_EDGES_TILE);
    return (tp_surface){ .by = &tp_program_all.water,
                         .deep = &w->deep.deep,
                         .phases = w->phases,
                         .ring = w->ring,
                         .rings = RINGS,
                         .pool = w->pool,
                         .field = w->field,
                         .pool_kind = tp_pool_find_kind(w->pool),
                         .field_kind = tp_pool_find_kind(w->field) };
}

static void water_end(surface_water *w)
{
    free(w->pool);
    free(w->field);
    coastal_end(&w->deep);
}

/* -- relief -------------------------------------------------------------------------- */

static void relief_is_the_sum_of_rings_pool_and_field(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        surface_water w;
        const tp_surface all = surface_make(&w, 0.5);
        for (int k = 0; k < 100; k++) {
            const uint32_t use = random_below(&chance, 8);
            const tp_fx x = chance_fx(&chance, -16, 16), z = chance_fx(&chance, -16, 16);
            const tp_fx back = chance_int(&chance, 0, 65536);
            tp_surface some = all;
            tp_height_slope want = { 0 },
                            part[3] = { tp_ring_height_slope(w.ring, RINGS, x, z),
                                        tp_pool_height_slope(w.pool, x, z, back),
                                        tp_pool_height_slope(w.field, x, z, back) };
            some.lag = back;
            some.rings = use & 1 ? RINGS : 0;
            some.pool = use & 2 ? w.pool : NULL;
            some.field = use & 4 ? w.field : NULL;
            for (int i = 0; i < 3; i++) {
                want.height += use >> i & 1 ? part[i].height : 0;
                want.slope_x += use >> i & 1 ? part[i].slope_x : 0;
                want.slope_z += use >> i & 1 ? part[i].slope_z : 0;
            }
            const tp_height_slope got = tp_rings_pools_sample(&some, x, z);
            assert_int_equal(got.height, want.height);
            assert_int_equal(got.slope_x, want.slope_x);
            assert_int_equal(got.slope_z, want.slope_z);
            assert_int_equal(tp_surface_has_rings_or_pools(&some), use != 0);
        }
        water_end(&w);
    }
}

/* At any moment between two ticks: 32-bit cells are not clamped to a range. */
static void no_relief_is_higher_than_the_surface_says(void **state)
{
    (void)state;
    for (int n = 0; n < 30; n++) {
        surface_water w;
        tp_surface s = surface_make(&w, 0.5);
        const tp_fx waves = w.deep.deep.height;
        for (int k = 0; k < 300; k++) {
            s.lag = chance_int(&chance, 0, 65536);
            const tp_height_slope r = tp_rings_pools_sample(
                &s, chance_fx(&chance, -14, 14), chance_fx(&chance, -12, 12));
            assert_true(abs(r.height) <= tp_surface_height_bound(&s) - waves + 3);
        }
        water_end(&w);
    }
}

static void a_falling_pool_of_32_bits_was_higher_a_tick_ago(void **state)
{
    (void)state;
    tp_pool_config c = pool_config(TP_CELLS_32, TP_EDGES_WALL, 32, 32);
    tp_pool *pool = pool_make(&c);
    tp_deep_water deep = { 0 };
    const tp_surface s = {
        .by = &tp_program_all.water, .deep = &deep, .pool = pool, .lag = TP_FX_ONE,
        .pool_kind = tp_pool_find_kind(pool)
    };

    assert_true(tp_pool_add_splash(pool, 0, 0, TP_FX(0.5), TP_FX_ONE));
    tp_pool_step(pool);
    tp_fx most = 0;
    for (int32_t i = -64; i <= 64; i++) {
        const tp_fx h = tp_rings_pools_sample(&s, i * 2048, TP_FX(0.1)).height;
        most = h > most ? h : most;
    }
    assert_true(most > (tp_pool_stats(pool).highest >> 8) + 1);  /* the test has effect */
    assert_true(most <= tp_surface_height_bound(&s));
    free(pool);
}

/* -- points above a position ----------------------------------------------------------- */

static void above_deep_water_is_its_height_plus_rings_and_pools(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        surface_water w;
        const tp_surface s = surface_make(&w, chance_double(&chance, 0, 0.95));
        for (int k = 0; k < 60; k++) {
            const tp_fx x = chance_fx(&chance, -14, 14), z = chance_fx(&chance, -14, 14);
            const tp_height_slope r = tp_rings_pools_sample(&s, x, z);
            tp_fx rest[2] = { x + 99, z - 99 }, same[2] = { x + 99, z - 99 };
            tp_fx *from = k % 2 ? rest : NULL;
            const tp_surface_point got = tp_surface_sample(&s, x, z, from);
            const tp_surface_point deep =
                tp_deep_water_sample(s.deep, s.phases, x, z, from ? same : NULL);
            assert_int_equal(got.position.x, deep.position.x);
            assert_int_equal(got.position.z, deep.position.z);
            assert_int_equal(got.position.y, deep.position.y + r.height);
            assert_int_equal(got.slope_x, deep.slope_x + r.slope_x);
            assert_int_equal(got.slope_z, deep.slope_z + r.slope_z);
            assert_memory_equal(rest, same, sizeof rest);
        }
        water_end(&w);
    }
}

static void coastal_make(surface_water *w, tp_surface *s, double q, bool floor)
{
    *s = surface_make(w, q);
    w->deep.config = coastal_usual();
    if (floor) {
        w->deep.config.floor.depth = chance_fx(&chance, 4, 20);
        w->deep.config.floor.slope = TP_FX(0.02);
    } else {
        w->deep.config.wind = TP_FX(0.02);
    }
    coastal_build(&w->deep);
    s->coastal = w->deep.coastal;
}

/* Distance between (x, z) and the final point of the search over coastal water. */
static void coastal_errors(double q, bool floor, measure *m, uint32_t *coarse)
{
    for (int n = 0; n < 8; n++) {
        surface_water w;
        tp_surface s;
        coastal_make(&w, &s, q, floor);
        for (int k = 0; k < 60; k++) {
            const tp_fx x = chance_fx(&chance, -50, 50), z = chance_fx(&chance, -50, 50);
            tp_fx rest[2] = { x, z };
            const tp_surface_point got = tp_surface_sample(&s, x, z, rest);
            const tp_coastal_point at =
                tp_coastal_displace_no_overhang(s.coastal, s.phases, rest[0], rest[1]);
            const double off = hypot(at.position.x - x, at.position.z - z) * LSB;
            const tp_height_slope r = tp_rings_pools_sample(&s, x, z);
            assert_int_equal(got.position.y, at.position.y + r.height);
            measure_add(m, off * 1000, x, z, n);
            *coarse += off > 0.001;
        }
        water_end(&w);
    }
}

static void over_coastal_water_the_place_is_found_by_inversion(void **state)
{
    (void)state;
    static const double sums[] = { 0, 0.3, 0.5, 0.7, 0.9 };

    for (int n = 0; n < 10; n++) {
        char name[32];
        uint32_t coarse = 0;
        measure m = { .what = name, .unit = "mm" };
        snprintf(name, sizeof name, "%s, sum %.1f", n % 2 ? "floor" : "deep", sums[n / 2]);
        coastal_errors(sums[n / 2], n % 2, &m, &coarse);
        measure_print(&m);
        assert_int_equal(coarse, 0);
    }
}

/* Slopes compared with heights 2 cm to either side. */
static void slopes_over_coastal_water_are_those_of_its_heights(void **state)
{
    (void)state;
    measure m = { .what = "slopes", .unit = "" };

    for (int n = 0; n < 8; n++) {
        surface_water w;
        tp_surface s;
        coastal_make(&w, &s, 0.3, false);
        s.rings = 0;
        s.pool = s.field = NULL;
        for (int k = 0; k < 40; k++) {
            const tp_fx x = chance_fx(&chance, -50, 50), z = chance_fx(&chance, -50, 50);
            const tp_fx d = TP_FX(0.02);
            const tp_surface_point at = tp_surface_sample(&s, x, z, NULL);
            const double sx = (tp_surface_sample(&s, x + d, z, NULL).position.y
                               - tp_surface_sample(&s, x - d, z, NULL).position.y)
                              / (2.0 * d);
            const double sz = (tp_surface_sample(&s, x, z + d, NULL).position.y
                               - tp_surface_sample(&s, x, z - d, NULL).position.y)
                              / (2.0 * d);
            measure_add(&m, at.slope_x * LSB - sx, x, z, 0);
            measure_add(&m, at.slope_z * LSB - sz, x, z, 1);
        }
        water_end(&w);
    }
    measure_print(&m);
    assert_true(m.worst < 0.02);
}

/* -- slopes across --------------------------------------------------------------------- */

/* Slopes -N over N.y, clamped as the header states. */
static bool slopes_of(tp_vec3 a, tp_vec3 b, double *sx, double *sz,
                      double *size)
{
    const double nx = (double)b.y * a.z - (double)b.z * a.y;
    const double ny = (double)b.z * a.x - (double)b.x * a.z;
    const double nz = (double)b.x * a.y - (double)b.y * a.x;
    const double most = fabs(nx) + fabs(nz);
    const bool   held = ny * 8 <= most;
    const double over = held ? most / 8 : ny;

    *sx = over > 0 ? -nx / over : 0;
    *sz = over > 0 ? -nz / over : 0;
    *size = held ? most : most + ny;
    return held;
}

static tp_vec3 way_any(double most)
{
    return (tp_vec3){ chance_fx(&chance, -most, most), chance_fx(&chance, -most, most),
                      chance_fx(&chance, -most, most) };
}

static void slopes_across_are_those_of_the_cross_product(void **state)
{
    (void)state;
    measure m = { .what = "slopes across", .unit = "LSB" };
    uint32_t held = 0;

    for (int n = 0; n < 100000; n++) {
        const double most = chance_scale(&chance, 0.01, 2000) * LSB;
        const tp_vec3 a = way_any(most), b = way_any(most);
        double sx, sz, size;
        tp_fx gx, gz;
        held += slopes_of(a, b, &sx, &sz, &size);
        tp_slopes_from_tangents(a, b, &gx, &gz);
        assert_true(abs(gx) <= 8 * TP_FX_ONE && abs(gz) <= 8 * TP_FX_ONE);
        if (size < 8388608)             /* small vectors have few digits */
            continue;
        measure_add(&m, gx - sx * 65536, a.x, a.y, a.z);
        measure_add(&m, gz - sz * 65536, b.x, b.y, b.z);
    }
    measure_print(&m);
    assert_in_range(held, 40000, 90000);
    assert_true(m.worst < 2);
}

/* The quotient of a division in 64 bits, of the same numbers. */
static void slopes_are_quotients_rounded_towards_0(void **state)
{
    (void)state;
    for (int n = 0; n < 200000; n++) {
        const double most = chance_scale(&chance, 0.0001, 2000) * LSB;
        const tp_vec3 a = way_any(most), b = way_any(n % 3 ? most : 100 * LSB);
        int64_t nx = (int64_t)b.y * a.z - (int64_t)b.z * a.y;
        int64_t ny = (int64_t)b.z * a.x - (int64_t)b.x * a.z;
        int64_t nz = (int64_t)b.x * a.y - (int64_t)b.y * a.x;
        int64_t sum = llabs(nx) + llabs(nz);
        tp_fx sx, sz;
        for (; sum > (int64_t)1 << 40; sum >>= 1) {
            nx /= 2;
            ny /= 2;
            nz /= 2;
        }
        if (ny * 8 <= sum)
            ny = sum / 8 + 1;
        tp_slopes_from_tangents(a, b, &sx, &sz);
        assert_int_equal(sx, -nx * 65536 / ny);
        assert_int_equal(sz, -nz * 65536 / ny);
    }
}

static void sheets_without_a_size_are_level(void **state)
{
    (void)state;
    const tp_vec3 none = { 0, 0, 0 }, x = { 8192, 0, 0 }, back = { -8192, 0, 0 };
    const tp_vec3 z = { 0, 0, 8192 };
    const tp_vec3 pair[][2] = { { none, none }, { x, none }, { none, z }, { x, x },
                                { x, back }, { back, z } };

    for (size_t i = 0; i < sizeof pair / sizeof pair[0]; i++) {
        tp_fx sx = 1, sz = 1;
        tp_slopes_from_tangents(pair[i][0], pair[i][1], &sx, &sz);
        assert_int_equal(sx, 0);
        assert_int_equal(sz, 0);
    }
}

static void what_overhangs_is_as_steep_as_can_be(void **state)
{
    (void)state;
    const tp_vec3 over = { -TP_FX(0.2), TP_FX_ONE, 0 }, along = { 0, 0, TP_FX_ONE };
    const tp_vec3 huge = { -2047 * TP_FX_ONE, 2047 * TP_FX_ONE, 2047 * TP_FX_ONE };
    const tp_vec3 wide = { 2047 * TP_FX_ONE, -2047 * TP_FX_ONE, 2047 * TP_FX_ONE };
    tp_fx sx, sz;

    tp_slopes_from_tangents(over, along, &sx, &sz);
    assert_true(sx > TP_FX(7.9) && sx <= 8 * TP_FX_ONE);
    assert_int_equal(sz, 0);
    tp_slopes_from_tangents(huge, wide, &sx, &sz);
    assert_true(abs(sx) <= 8 * TP_FX_ONE && abs(sz) <= 8 * TP_FX_ONE);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(relief_is_the_sum_of_rings_pool_and_field),
        cmocka_unit_test(no_relief_is_higher_than_the_surface_says),
        cmocka_unit_test(a_falling_pool_of_32_bits_was_higher_a_tick_ago),
        cmocka_unit_test(above_deep_water_is_its_height_plus_rings_and_pools),
        cmocka_unit_test(over_coastal_water_the_place_is_found_by_inversion),
        cmocka_unit_test(slopes_over_coastal_water_are_those_of_its_heights),
        cmocka_unit_test(slopes_across_are_those_of_the_cross_product),
        cmocka_unit_test(slopes_are_quotients_rounded_towards_0),
        cmocka_unit_test(sheets_without_a_size_are_level),
        cmocka_unit_test(what_overhangs_is_as_steep_as_can_be),
    };
    return cmocka_run_group_tests_name("view/surface", tests, NULL, NULL);
}
