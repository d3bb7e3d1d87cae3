/* SPDX-License-Identifier: MIT */
/* The surface above a point [E1]: Newton's method compared with the models in double
 * precision, from any start and on deep water made to mislead the search; plain steps
 * compared with the table of tests/vectors. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/deep_water.h"
#include "tests/lib/vectors.h"

static uint64_t chance;

typedef struct { measure along, up; } distance;

static distance distance_of(const char *along, const char *up)
{
    return (distance){ { .what = along, .unit = "mm" }, { .what = up, .unit = "mm" } };
}

/* Adds the distance of the found point from the requested point, and from the reference's
 * height there. */
static void look_above(const deep_water *o, tp_fx x, tp_fx z, tp_fx rest[2], distance *d)
{
    const tp_surface_point got = tp_deep_water_sample(&o->deep, o->phases, x, z, rest);
    const ref_point want = ref_sample_deep_water(&o->ref, o->ref_phases, x * LSB, z * LSB);

    assert_true(hypot(want.x - x * LSB, want.z - z * LSB) < 1e-6);
    measure_add(&d->along, hypot(got.position.x - x, got.position.z - z) * LSB * 1000,
                (int64_t)o->tick, x, z);
    measure_add(&d->up, row_error(got.position.y, want.y) * 1000, (int64_t)o->tick, x, z);
}

static void distance_print(const distance *d)
{
    measure_print(&d->along);
    measure_print(&d->up);
}

static void usual_seas(double low, double high, distance *d)
{
    for (int n = 0; n < 1500; n++) {
        const deep_water o =
            deep_water_usual(&chance, TP_WAVES, chance_double(&chance, low, high));
        look_above(&o, chance_fx(&chance, -500, 500), chance_fx(&chance, -500, 500), NULL,
                   d);
    }
    distance_print(d);
}

static void below_a_steepness_of_09_the_surface_is_found_within_1_mm(void **state)
{
    (void)state;
    distance d = distance_of("along, q < 0.9", "up, q < 0.9");
    usual_seas(0, 0.9, &d);
    assert_true(d.along.worst < 1);
    assert_true(d.up.worst < 1);
}

static void in_clamped_seas_it_is_found_within_1_mm_too(void **state)
{
    (void)state;
    distance d = distance_of("along, q = 0.95", "up, q = 0.95");
    usual_seas(0.95, 1.5, &d);
    assert_true(d.along.worst < 1);
    assert_true(d.up.worst < 1);
}

static void along(const deep_water *o, tp_fx rest[2], measure *m)
{
    const tp_fx x = chance_fx(&chance, -29000, 29000);
    const tp_fx z = chance_fx(&chance, -29000, 29000);
    const tp_surface_point got = tp_deep_water_sample(&o->deep, o->phases, x, z, rest);
    measure_add(m, hypot(got.position.x - x, got.position.z - z) * LSB * 1000, x, z,
                o->count);
}

/* Waves of the whole ranges displace up to 300 m sideways, with lengths from 0.25 m to 2000
 * m. */
static void on_any_legal_sea_the_search_ends_at_the_place(void **state)
{
    (void)state;
    measure m = { .what = "any legal sea", .unit = "mm" };

    for (int n = 0; n < 10000; n++) {
        deep_water o = deep_water_any(&chance, TP_WAVES);
        if (n % 4 == 0)
            deep_water_sharpen(&chance, &o);
        along(&o, NULL, &m);
    }
    measure_print(&m);
    assert_true(m.worst < 1);
}

/* Two waves in one direction, or nearly so, with the steepness at the clamp and any two
 * lengths: the short wave's slope misleads the search for the long wave's point. */
static void two_waves_at_the_clamp_do_not_mislead_it(void **state)
{
    (void)state;
    measure m = { .what = "two waves, 0.95", .unit = "mm" };

    for (int n = 0; n < 20000; n++) {
        deep_water o = { .count = chance_int(&chance, 1, 2), .gravity = TP_FX(9.81) };
        const tp_fx heading = chance_fx(&chance, -180, 180);
        for (int i = 0; i < o.count; i++) {
            o.wave[i] = chance_wave(&chance);
            o.wave[i].heading = heading + chance_int(&chance, -TP_FX_ONE, TP_FX_ONE);
            o.wave[i].steepness = i ? chance_scale(&chance, 0.01, 1) : TP_FX_ONE;
        }
        deep_water_settle(&o);
        along(&o, NULL, &m);
    }
    measure_print(&m);
    assert_true(m.worst < 1);
}

/* The start is the last tick's rest position, or any number: the search finds the point in
 * both cases, and the returned point is that of the returned rest position. */
static void it_is_found_from_any_start(void **state)
{
    (void)state;
    distance d = distance_of("along, any start", "up, any start");

    for (int n = 0; n < 1500; n++) {
        deep_water o =
            deep_water_usual(&chance, TP_WAVES, chance_double(&chance, 0, 0.95));
        tp_fx rest[2] = { (tp_fx)random_next(&chance), (tp_fx)random_next(&chance) };
        const tp_fx x = chance_fx(&chance, -500, 500), z = chance_fx(&chance, -500, 500);
        look_above(&o, x, z, rest, &d);
        o.tick++;
        deep_water_settle(&o);
        look_above(&o, x, z, rest, &d);
        const tp_surface_point there =
            tp_deep_water_displace_point(&o.deep, o.phases, rest[0], rest[1]);
        const tp_surface_point again = tp_deep_water_sample(&o.deep, o.phases, x, z, rest);
        assert_memory_equal(&there, &again, sizeof there);
    }
    distance_print(&d);
    assert_true(d.along.worst < 1);
    assert_true(d.up.worst < 1);
}

/* From the rest position of the preceding tick the search has little to do and finds the
 * same point. */
static void a_place_once_found_is_found_again(void **state)
{
    (void)state;
    for (int n = 0; n < 1500; n++) {
        const deep_water o =
            deep_water_usual(&chance, TP_WAVES, chance_double(&chance, 0, 0.95));
        const tp_fx x = chance_fx(&chance, -500, 500), z = chance_fx(&chance, -500, 500);
        tp_fx rest[2] = { x, z };
        tp_deep_water_sample(&o.deep, o.phases, x, z, rest);
        const tp_fx found[2] = { rest[0], rest[1] };
        tp_deep_water_sample(&o.deep, o.phases, x, z, rest);
        assert_memory_equal(rest, found, sizeof found);
    }
}

/* -- far away ------------------------------------------------------------------------ */

static tp_fx held_fx(double metres)
{
    return (tp_fx)fmax(TP_FX_MIN, fmin(TP_FX_MAX, round(metres * 65536)));
}

/* Heights equal the reference at any position of 16.16, the ends included; positions are
 * clamped at the ends. */
static void a_place_at_rest_has_its_height_anywhere(void **state)
{
    (void)state;
    measure height = { .what = "height, anywhere", .unit = "of the bound" };
    measure held = { .what = "held positions", .unit = "m" };

    for (int n = 0; n < 20000; n++) {
        deep_water o = deep_water_any(&chance, 4);
        const tp_fx x = chance_word(&chance), z = chance_word(&chance);
        const double x0 = x * LSB, z0 = z * LSB, off = place_error(&o, x0, z0) + LSB;
        if (n % 4 == 0)
            deep_water_sharpen(&chance, &o);
        const ref_point want = ref_at_rest(&o.ref, o.ref_phases, x0, z0);
        const tp_surface_point got = tp_deep_water_displace_point(&o.deep, o.phases, x, z);
        measure_add(&height, (got.position.y * LSB - want.y) / height_error(&o, x0, z0), x,
                    z, n);
        assert_true(fabs((got.position.x - (double)held_fx(want.x)) * LSB) <= off);
        assert_true(fabs((got.position.z - (double)held_fx(want.z)) * LSB) <= off);
        if (got.position.x == TP_FX_MAX || got.position.x == TP_FX_MIN)
            measure_add(&held, want.x - got.position.x * LSB, x, z, n);
    }
    measure_print(&height);
    measure_print(&held);
    assert_true(height.worst <= 1 && height.worst > 0.5);
    assert_true(held.inputs > 100 && held.worst > 10);
}

static bool has_room(tp_fx x, tp_fx z, int64_t most)
{
    const int64_t end = TP_FX_MAX - most;
    return x <= end && x >= -end && z <= end && z >= -end;
}

/* The search finds the point wherever its box lies within 16.16, which includes 30 km;
 * nearer to the ends the search stays in the box. */
static void above_any_place_there_is_an_answer(void **state)
{
    (void)state;
    measure found = { .what = "far, found", .unit = "mm" };
    measure held = { .what = "far, at the ends", .unit = "mm" };

    for (int n = 0; n < 20000; n++) {
        const deep_water o = deep_water_any(&chance, TP_WAVES);
        const tp_fx x = chance_word(&chance), z = chance_word(&chance);
        const int64_t most = 2 * ((int64_t)o.deep.max_displacement + 2);
        tp_fx rest[2] = { chance_word(&chance), chance_word(&chance) };
        const tp_surface_point got = tp_deep_water_sample(&o.deep, o.phases, x, z, rest);
        const tp_surface_point there =
            tp_deep_water_displace_point(&o.deep, o.phases, rest[0], rest[1]);
        const int64_t dx = (int64_t)got.position.x - x, dz = (int64_t)got.position.z - z;
        const bool room = has_room(x, z, most);
        assert_memory_equal(&got, &there, sizeof got);
        assert_true(llabs(dx) <= most && llabs(dz) <= most);
        assert_true(room || !has_room(x, z, TP_FX_MAX - 30000 * TP_FX_ONE));
        measure_add(room ? &found : &held, hypot((double)dx, (double)dz) * LSB * 1000, x,
                    z, n);
        tp_deep_water_sample_iterated(&o.deep, o.phases, x, z, random_below(&chance, 9));
    }
    measure_print(&found);
    measure_print(&held);
    assert_true(found.worst < 1 && held.inputs > 1000);
}

/* -- plain steps --------------------------------------------------------------------- */

/* [E1]: q^n / (1 - q) of the first distance, plus the rounding of each step. */
static void plain_steps_keep_their_bound(void **state)
{
    (void)state;
    for (int n = 0; n < 3000; n++) {
        const deep_water o =
            deep_water_usual(&chance, 8, chance_double(&chance, 0, 0.95));
        const tp_fx x = chance_fx(&chance, -500, 500), z = chance_fx(&chance, -500, 500);
        const uint32_t steps = (uint32_t)chance_int(&chance, 0, 10);
        const tp_surface_point first =
            tp_deep_water_displace_point(&o.deep, o.phases, x, z);
        const tp_surface_point got =
            tp_deep_water_sample_iterated(&o.deep, o.phases, x, z, steps);
        const double off = hypot(got.position.x - x, got.position.z - z) * LSB;
        const double way = hypot(first.position.x - x, first.position.z - z) * LSB;
        const double q = o.deep.steepness_sum / 1073741824.0;
        assert_true(off <= pow(q, steps) * way + 2 * LSB / (1 - q));
    }
}

/* x, z, t; then x0, z0, y, the heights of the steps 0 to 4, and the normal. */
static void both_searches_follow_the_table(void **state)
{
    (void)state;
    measure step[5] = { { .what = "step 0", .unit = "mm" },
                        { .what = "step 1", .unit = "mm" },
                        { .what = "step 2", .unit = "mm" },
                        { .what = "step 3", .unit = "mm" },
                        { .what = "step 4", .unit = "mm" } };
    errors e = errors_of("table's height", "table's rest", "table's normal");
    vector_table r = rows_of("buoyancy");

    while (rows_next(&r)) {
        const tp_fx x = row_fx(r.at[0]), z = row_fx(r.at[1]);
        tp_fx rest[2] = { x, z };
        tp_deep_water deep;
        tp_turn phases[TP_WAVES];
        rows_sea(&r, 1, &deep);
        rows_phases(&r, r.at[2], phases);
        const tp_surface_point got = tp_deep_water_sample(&deep, phases, x, z, rest);
        measure_add(&e.place, row_error(rest[0], r.at[3]) * 1000, r.rows, 0, 0);
        measure_add(&e.place, row_error(rest[1], r.at[4]) * 1000, r.rows, 0, 0);
        measure_add(&e.height, row_error(got.position.y, r.at[5]) * 1000, r.rows, 0, 0);
        measure_add(&e.normal, row_angle(&got, r.at + 11), r.rows, 0, 0);
        for (uint32_t n = 0; n < 5; n++) {
            const tp_surface_point at =
                tp_deep_water_sample_iterated(&deep, phases, x, z, n);
            measure_add(&step[n], row_error(at.position.y, r.at[6 + n]) * 1000, r.rows, 0,
                        0);
        }
    }
    assert_int_equal(r.rows, 150);
    errors_print(&e);
    assert_true(e.height.worst < 1);
    assert_true(e.place.worst < 1);
    assert_true(e.normal.worst < 0.02);
    for (int n = 0; n < 5; n++) {
        measure_print(&step[n]);
        assert_true(step[n].worst < 1);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(below_a_steepness_of_09_the_surface_is_found_within_1_mm),
        cmocka_unit_test(in_clamped_seas_it_is_found_within_1_mm_too),
        cmocka_unit_test(on_any_legal_sea_the_search_ends_at_the_place),
        cmocka_unit_test(two_waves_at_the_clamp_do_not_mislead_it),
        cmocka_unit_test(it_is_found_from_any_start),
        cmocka_unit_test(a_place_once_found_is_found_again),
        cmocka_unit_test(a_place_at_rest_has_its_height_anywhere),
        cmocka_unit_test(above_any_place_there_is_an_answer),
        cmocka_unit_test(plain_steps_keep_their_bound),
        cmocka_unit_test(both_searches_follow_the_table),
    };
    return cmocka_run_group_tests_name("waves/above", tests, NULL, NULL);
}
