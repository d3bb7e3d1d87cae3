/* SPDX-License-Identifier: MIT */
/* Coastal water as a whole: the limits of deep water and of rest, bounds, and any
 * numbers. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/deep_water.h"
#include "tests/lib/measure.h"
#include "tests/lib/coastal_water.h"

static uint64_t chance;

static tp_wave any_wave(double shortest, double longest, double steepness)
{
    const double length = chance_scale(&chance, shortest, longest) * LSB;
    return coastal_wave(chance_double(&chance, 0.002, 1) * length / 14, length,
                        chance_double(&chance, 0, steepness),
                        chance_double(&chance, 0, 360));
}

/* -- limits ------------------------------------------------------------------------ */

static void compare_with_the_sea(const coastal_water *o, measure *m)
{
    tp_turn phases[TP_WAVES];

    any_phases(&chance, phases);
    for (int n = 0; n < 50; n++) {
        const tp_fx x = chance_fx(&chance, -900, 900), z = chance_fx(&chance, -900, 900);
        const tp_vec3 want = tp_deep_water_displace_point(&o->deep, phases, x, z).position;
        const tp_vec3 got = tp_coastal_displace_point(o->coastal, phases, x, z).position;
        measure_add(m, 1000 * (got.x - want.x) * LSB, x, z, 0);
        measure_add(m, 1000 * (got.y - want.y) * LSB, x, z, 1);
        measure_add(m, 1000 * (got.z - want.z) * LSB, x, z, 2);
    }
}

static void without_a_floor_coastal_water_is_deep_water(void **state)
{
    (void)state;
    measure m = { .what = "no floor", .unit = "mm" };

    for (int n = 0; n < 100; n++) {
        coastal_water o = { .count = (uint32_t)chance_int(&chance, 1, TP_WAVES),
                            .config = coastal_usual() };
        for (uint32_t i = 0; i < o.count; i++) {
            o.wave[i] = chance_wave(&chance);
            o.wave[i].amplitude = ((uint32_t)n + i) % 3 ? o.wave[i].amplitude : 0;
        }
        coastal_build(&o);
        compare_with_the_sea(&o, &m);
        coastal_end(&o);
    }
    measure_print(&m);
    assert_true(m.worst < 1);
}

/* Over 200 m of water e^-Kx h is 2.8e-10, and waves of 60 m do not feel the floor; neither
 * do their tables.  A map keeps phases to 2^-17 turn and its displacements to 2^-14: 1e-4
 * of a wave's amplitude and displacement. */
static void over_a_deep_floor_coastal_water_is_deep_water(void **state)
{
    (void)state;
    const uint16_t grey[4] = { 0, 0, 0, 0 };
    const tp_grey picture = { 2, 2, grey };
    measure level = { .what = "level", .unit = "mm" },
            map = { .what = "map", .unit = "mm" };
    measure slope = { .what = "slope", .unit = "mm" };

    for (int n = 0; n < 24; n++) {
        coastal_water o = { .count = (uint32_t)chance_int(&chance, 1, 3),
                            .config = coastal_usual() };
        for (uint32_t i = 0; i < o.count; i++) {
            o.wave[i] = any_wave(2, 60, 0.5);
            o.wave[i].amplitude = (o.wave[i].amplitude + 1) / 4;
        }
        o.config.floor = (tp_floor){ .depth = TP_FX(200) };
        if (n % 3 == 1)
            o.config.floor = (tp_floor){ .depth = TP_FX(400), .slope = TP_FX(0.1) };
        if (n % 3 == 2)
            o.config.floor = (tp_floor){ .map = &picture, .map_size = TP_FX(400),
                                         .map_low = TP_FX(-200), .map_high = TP_FX(10) };
        coastal_build(&o);
        compare_with_the_sea(&o, n % 3 == 0 ? &level : n % 3 == 1 ? &slope : &map);
        coastal_end(&o);
    }
    measure_print(&level);
    measure_print(&slope);
    measure_print(&map);
    assert_true(level.worst < 1 && slope.worst < 1 && map.worst < 1);
}

/* The last 1/16 m brings everything to rest: heights are capped at 0.39 h; horizontal
 * displacement is limited below 0.95 / k there and shrinks with h. */
static void at_the_waterline_the_sea_is_quiet(void **state)
{
    (void)state;
    measure most = { .what = "at 1 mm", .unit = "mm" };

    for (int n = 0; n < 60; n++) {
        coastal_water o = { .count = 3, .config = coastal_usual() };
        for (uint32_t i = 0; i < o.count; i++)
            o.wave[i] = any_wave(2, 60, 0.5);
        o.config.wind = chance_fx(&chance, 0, 1);
        o.config.irregular = TP_FX_ONE;
        o.config.floor = shore(0.001, chance_double(&chance, 0.01, 0.5), 90);
        coastal_build(&o);
        tp_turn phases[TP_WAVES];
        for (int k = 0; k < 20; k++) {
            any_phases(&chance, phases);
            const tp_coastal_point p = tp_coastal_displace_point(o.coastal, phases, 0, 0);
            assert_in_range(p.depth, 65, 66);
            measure_add(&most, 1000 * p.position.x * LSB, n, k, 0);
            measure_add(&most, 1000 * p.position.y * LSB, n, k, 1);
            measure_add(&most, 1000 * p.position.z * LSB, n, k, 2);
            const tp_coastal_point dry =
                tp_coastal_displace_point(o.coastal, phases, TP_FX_ONE, TP_FX_ONE);
            assert_true(dry.depth <= 0 && dry.breaking == 0);
            assert_memory_equal(&dry.position, (&(tp_vec3){ TP_FX_ONE, 0, TP_FX_ONE }),
                                sizeof dry.position);
        }
        coastal_end(&o);
    }
    measure_print(&most);
    assert_true(most.worst < 60);
}

/* -- any coastal water ------------------------------------------------------------- */

static void any_floor(coastal_water *o, const tp_grey *picture, int kind)
{
    tp_floor *f = &o->config.floor;

    *f = shore(chance_double(&chance, 0.1, 60), chance_double(&chance, 0, 1),
               chance_double(&chance, 0, 360));
    if (kind == 1)
        f->slope = 0;
    if (kind == 2)
        *f = (tp_floor){
            .map = picture, .map_x = chance_fx(&chance, -50, 50),
            .map_size = chance_scale(&chance, 1, 2000),
            .map_low = chance_fx(&chance, -40, 1), .map_high = chance_fx(&chance, -3, 8),
        };
}

static coastal_water any_coastal(const tp_grey *picture, int kind)
{
    coastal_water o = { .count =
                            (uint32_t)chance_int(&chance, 1, kind == 2 ? 2 : TP_WAVES) };

    for (uint32_t i = 0; i < o.count; i++) {
        o.wave[i] = chance_wave(&chance);
        o.wave[i].heading = chance_fx(&chance, 0, 360);
    }
    o.config = (tp_coastal_config){
        .wind = chance_fx(&chance, 0, 1), .wind_heading = chance_fx(&chance, 0, 360),
        .k0 = chance_fx(&chance, 0, 4), .kx = chance_scale(&chance, 0.001, 4),
        .ky = chance_scale(&chance, 0.001, 4), .stretch = chance_fx(&chance, 0, 2),
        .irregular = chance_fx(&chance, 0, 1),
    };
    any_floor(&o, picture, kind);
    coastal_build(&o);
    return o;
}

static void check_bounds(const coastal_water *o)
{
    const tp_fx reach = tp_coastal_max_displacement(o->coastal),
                height = tp_coastal_max_height(o->coastal);
    tp_turn phases[TP_WAVES];

    assert_true(reach >= 0 && height >= 0);
    for (int n = 0; n < 100; n++) {
        const double far = n % 2 ? 80 : 3000;
        const tp_fx x = chance_fx(&chance, -far, far), z = chance_fx(&chance, -far, far);
        any_phases(&chance, phases);
        const tp_coastal_point p = tp_coastal_displace_point(o->coastal, phases, x, z);
        const double way = hypot((double)p.position.x - x, (double)p.position.z - z);
        assert_true(way <= (double)reach);
        assert_true(abs(p.position.y) <= height);
        const tp_coastal_point s =
            tp_coastal_displace_no_overhang(o->coastal, phases, x, z);
        assert_true(hypot((double)s.position.x - x, (double)s.position.z - z)
                    <= (double)reach);
        assert_true(abs(s.position.y) <= height);
        assert_int_equal(s.depth, p.depth);
    }
}

static void no_coastal_point_is_beyond_its_bounds(void **state)
{
    (void)state;
    static uint16_t sample[30 * 20];

    for (int n = 0; n < 90; n++) {
        const tp_grey picture = { (uint32_t)chance_int(&chance, 1, 30),
                                  (uint32_t)chance_int(&chance, 1, 20), sample };
        for (int i = 0; i < 600; i++)
            sample[i] = (uint16_t)random_next(&chance);
        coastal_water o = any_coastal(&picture, n % 15 == 2 ? 2 : n % 2);
        check_bounds(&o);
        coastal_end(&o);
    }
}

/* Configs are clamped to their ranges; only the size of a map is checked. */
static void any_numbers_make_coastal_water(void **state)
{
    (void)state;
    const uint16_t sample[6] = { 0, 65535, 0, 65535, 0, 65535 };
    const tp_grey picture = { 3, 2, sample };

    for (int n = 0; n < 60; n++) {
        coastal_water o = { .count = 2,
                            .wave = { chance_wave(&chance), chance_wave(&chance) } };
        tp_coastal_config *c = &o.config;
        int32_t *const field[] = {
            &c->wind,
            &c->wind_heading,
            &c->k0,
            &c->kx,
            &c->ky,
            &c->stretch,
            &c->irregular,
            &c->floor.depth,
            &c->floor.slope,
            &c->floor.heading,
            &c->floor.map_x,
            &c->floor.map_z,
            &c->floor.map_low,
            &c->floor.map_high,
        };
        for (size_t i = 0; i < sizeof field / sizeof field[0]; i++)
            *field[i] = random_number(&chance);
        c->floor.map = n % 12 ? NULL : &picture;
        c->floor.map_size = chance_scale(&chance, 1, 8000);
        coastal_build(&o);
        check_bounds(&o);
        coastal_end(&o);
    }
}

/* The sum of [A11] and [B13] at every node, hence at every position: no loops. */
static void the_smooth_surface_never_folds_over_a_level_floor(void **state)
{
    (void)state;
    for (int n = 0; n < 60; n++) {
        coastal_water o = any_coastal(NULL, 1);
        const double heading = chance_double(&chance, 0, 2 * PI);
        const double dx = sin(heading), dz = cos(heading);
        tp_turn phases[TP_WAVES];
        any_phases(&chance, phases);
        double last = -1e18;
        for (int k = 0; k < 400; k++) {
            const tp_fx x = (tp_fx)lround(dx * k * 2000),
                        z = (tp_fx)lround(dz * k * 2000);
            const tp_vec3 p =
                tp_coastal_displace_no_overhang(o.coastal, phases, x, z).position;
            const double way = p.x * dx + p.z * dz;
            assert_true(way > last - 40);       /* LSB: roundings of sixteen waves */
            last = way;
        }
        coastal_end(&o);
    }
}

static void the_floor_is_the_floor(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        coastal_water o = { .count = 1, .config = coastal_usual() };
        o.wave[0] = any_wave(5, 50, 0.5);
        o.config.floor = shore(chance_double(&chance, 0.1, 60),
                               chance_double(&chance, 0.001, 1),
                               chance_double(&chance, 0, 360));
        coastal_build(&o);
        const tp_fx x = chance_fx(&chance, -500, 500), z = chance_fx(&chance, -500, 500);
        const tp_floor_at a = tp_floor_sample(&o.config.floor, x, z);
        const tp_floor_at b = tp_coastal_floor(o.coastal, x, z);
        assert_memory_equal(&a, &b, sizeof a);
        coastal_end(&o);
    }
}

static void a_copy_of_the_block_is_the_same_water(void **state)
{
    (void)state;
    const uint16_t sample[6] = { 0, 20000, 65535, 100, 40000, 50000 };
    const tp_grey picture = { 3, 2, sample };
    coastal_water o = any_coastal(&picture, 2), copy = o;
    const size_t bytes = tp_coastal_bytes(&o.config, &o.deep);
    tp_turn phases[TP_WAVES];

    copy.coastal = malloc(bytes);
    memcpy(copy.coastal, o.coastal, bytes);
    memset(o.coastal, 0, bytes);
    coastal_end(&o);
    coastal_water again = copy;
    coastal_build(&again);
    any_phases(&chance, phases);
    for (int n = 0; n < 200; n++) {
        const tp_fx x = chance_fx(&chance, -1000, 1000),
                    z = chance_fx(&chance, -1000, 1000);
        const tp_coastal_point a = tp_coastal_displace_point(copy.coastal, phases, x, z);
        const tp_coastal_point b = tp_coastal_displace_point(again.coastal, phases, x, z);
        assert_memory_equal(&a.position, &b.position, sizeof a.position);
        assert_int_equal(a.breaking, b.breaking);
    }
    coastal_end(&copy);
    coastal_end(&again);
}

static void what_cannot_be_built_says_so(void **state)
{
    (void)state;
    const uint16_t sample[1] = { 0 };
    tp_grey picture = { 1, 1, sample };
    coastal_water o = { .count = 1, .config = coastal_usual() };
    static union { tp_coastal_water coastal; uint8_t bytes[400000]; } block;
    tp_error err;

    o.wave[0] = coastal_wave(0.5, 20, 0.5, 0);
    tp_deep_water_init(&o.deep, o.wave, 1, TP_FX(9.81));
    o.config.floor = (tp_floor){ .map = &picture, .map_size = TP_FX(100) };
    assert_true(tp_coastal_bytes(&o.config, &o.deep) <= sizeof block);
    assert_int_equal(tp_coastal_init(&block.coastal, &o.config, &o.deep, o.wave, 1, &err),
                     TP_OK);
    assert_int_equal(tp_coastal_init(&block.coastal, &o.config, &o.deep, o.wave, 0, &err),
                     TP_E_ARG);
    o.config.floor.map_size = TP_FX(0.5);
    assert_int_equal(tp_coastal_init(&block.coastal, &o.config, &o.deep, o.wave, 1, &err),
                     TP_E_ARG);
    o.config.floor.map_size = TP_FX(100);
    picture.cols = 4097;
    assert_int_equal(tp_coastal_init(&block.coastal, &o.config, &o.deep, o.wave, 1, &err),
                     TP_E_ARG);
    assert_int_equal(tp_coastal_bytes(&o.config, &o.deep), 0);
    o.config.floor = (tp_floor){ .depth = TP_FX(5) };
    assert_int_equal(tp_coastal_bytes(&o.config, &o.deep), TP_COASTAL_STRAIGHT_BYTES(1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_a_floor_coastal_water_is_deep_water),
        cmocka_unit_test(over_a_deep_floor_coastal_water_is_deep_water),
        cmocka_unit_test(at_the_waterline_the_sea_is_quiet),
        cmocka_unit_test(no_coastal_point_is_beyond_its_bounds),
        cmocka_unit_test(any_numbers_make_coastal_water),
        cmocka_unit_test(the_smooth_surface_never_folds_over_a_level_floor),
        cmocka_unit_test(the_floor_is_the_floor),
        cmocka_unit_test(a_copy_of_the_block_is_the_same_water),
        cmocka_unit_test(what_cannot_be_built_says_so),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("waves/coastal", tests, NULL, NULL);
}
