/* SPDX-License-Identifier: MIT */
/* Breaking waves on a beach: overhang, direction, continuity and bounds. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/measure.h"
#include "tests/lib/coastal_water.h"
#include "waves/coastal_tables.h"

static uint64_t chance;

/* A swell of 24 m length and 0.8 m height: xi0 = 5.5 times the slope, so the swell spills
 * below a slope of 1 in 11 and plunges above. */
static coastal_water beach(double slope, double heading, double steepness,
                           double irregular)
{
    coastal_water o = { .count = 1, .config = coastal_usual() };
    o.wave[0] = coastal_wave(0.4, 24, steepness, heading);
    o.config.floor = shore(4, slope, 90);
    o.config.irregular = (tp_fx)(irregular * 65536);
    coastal_build(&o);
    return o;
}

/* Overhang: largest distance of x behind its preceding maximum, over rest positions from
 * deep to shallow water, m. */
static double overhang(const coastal_water *o, tp_turn phase, bool whole)
{
    const tp_turn phases[TP_WAVES] = { phase };
    double most = -1e9, back = 0;

    for (tp_fx x = TP_FX(-10); x < TP_FX(31); x += 1000) {
        const tp_coastal_point p =
            whole ? tp_coastal_displace_point(o->coastal, phases, x, 0)
                  : tp_coastal_displace_no_overhang(o->coastal, phases, x, 0);
        if (p.depth < TP_FX(0.1))
            break;
        assert_true(hypot((double)p.position.x - x, p.position.z)
                    <= tp_coastal_max_displacement(o->coastal));
        assert_true(abs(p.position.y) <= tp_coastal_max_height(o->coastal));
        most = fmax(most, p.position.x * LSB);
        back = fmax(back, most - p.position.x * LSB);
    }
    return back;
}

static void plunging_crests_overhang_and_smooth_ones_do_not(void **state)
{
    (void)state;
    coastal_water o = beach(0.125, 90, 0.1, 0);
    double most = 0, smooth = 0;

    for (int n = 0; n < 32; n++) {
        most = fmax(most, overhang(&o, (tp_turn)n << 27, true));
        smooth = fmax(smooth, overhang(&o, (tp_turn)n << 27, false));
    }
    coastal_end(&o);
    printf("    x runs back by %.3f m, smooth by %.6f m\n", most, smooth);
    assert_true(most > 0.2);
    assert_true(smooth < 0.001);
}

static void waves_that_leave_the_shore_do_not_break_backwards(void **state)
{
    (void)state;
    coastal_water o = beach(0.125, 270, 0.1, 0);
    const tp_turn now[TP_WAVES] = { 0 };

    /* Crests that move offshore lean, if at all, in their own direction: the orbit is
     * level. */
    for (int i = 0; i < TP_COASTAL_DEPTHS; i++) {
        assert_int_equal(tp_coastal_tables(o.coastal)[0].depth[i].tilt_sin, 0);
        assert_true(tp_coastal_tables(o.coastal)[0].depth[i].way_x < 0);
    }
    for (tp_fx x = TP_FX(-100); x < TP_FX(31); x += 5000) {
        const tp_coastal_point s = tp_coastal_displace_no_overhang(o.coastal, now, x, 0);
        const tp_coastal_point p = tp_coastal_displace_point(o.coastal, now, x, 0);
        assert_true(p.position.x <= s.position.x + 1);
    }
    coastal_end(&o);
}

/* Without steepness only the overhang moves points horizontally: there the bounds are
 * close. */
static void what_overhangs_is_within_the_bounds(void **state)
{
    (void)state;
    measure part = { .what = "overhang", .unit = "of the bound" };

    for (int n = 0; n < 16; n++) {
        coastal_water o = beach(chance_double(&chance, 0.1, 0.3), 90, 0, 0);
        o.config.stretch = 2 * TP_FX_ONE;
        assert_int_equal(tp_coastal_init(o.coastal, &o.config, &o.deep, o.wave, 1, NULL),
                         TP_OK);
        for (int k = 0; k < 4000; k++) {
            const tp_turn phases[TP_WAVES] = { (tp_turn)random_next(&chance) };
            const tp_fx x = chance_fx(&chance, 0, 40);
            const tp_vec3 p = tp_coastal_displace_point(o.coastal, phases, x, 0).position;
            const double way = hypot((double)p.x - x, p.z);
            assert_true(way <= tp_coastal_max_displacement(o.coastal));
            assert_true(abs(p.y) <= tp_coastal_max_height(o.coastal));
            measure_add(&part, way / tp_coastal_max_displacement(o.coastal), n, k, x);
        }
        coastal_end(&o);
    }
    measure_print(&part);
    assert_true(part.worst > 0.5);
}

/* Steps of 2 mm towards the shore, through the gate: no step of the surface is longer than
 * the slopes of the shape allow, 40 lips per turn plus the orbit. */
static void the_surface_is_continuous_across_the_gate(void **state)
{
    (void)state;
    measure m = { .what = "step of 2 mm", .unit = "mm" };

    for (int n = 0; n < 24; n++) {
        coastal_water o = beach(chance_double(&chance, 0.03, 0.2),
                                chance_double(&chance, 30, 150), 0.1, n % 2);
        tp_turn phases[TP_WAVES];
        any_phases(&chance, phases);
        const tp_fx z = chance_fx(&chance, -50, 50);
        const tp_fx shallow = TP_FX(1),
                    from = (tp_fx)((int64_t)(TP_FX(4) - 2 * shallow) * TP_FX_ONE
                                   / o.config.floor.slope);
        tp_vec3 last = tp_coastal_displace_point(o.coastal, phases, from, z).position;
        for (tp_fx x = from + 131; x < from + TP_FX(12); x += 131) {
            const tp_coastal_point p = tp_coastal_displace_point(o.coastal, phases, x, z);
            if (p.depth < TP_FX(0.2))
                break;
            const tp_vec3 step = tp_vec3_sub(p.position, last);
            measure_add(&m, 1000 * hypot(hypot(step.x, step.y), step.z) * LSB, n, x, z);
            last = p.position;
        }
        coastal_end(&o);
    }
    measure_print(&m);
    assert_true(m.worst < 12);
}

static void crests_break_where_it_is_shallow_and_not_where_it_is_deep(void **state)
{
    (void)state;
    coastal_water o = beach(0.125, 90, 0.1, 0);
    int near = 0, far = 0;

    for (int n = 0; n < 64; n++) {
        const tp_turn phases[TP_WAVES] = { (tp_turn)n << 26 };
        const int a = tp_coastal_displace_point(o.coastal, phases, TP_FX(28), 0).breaking;
        const int b = tp_coastal_displace_point(o.coastal, phases, TP_FX(-40), 0).breaking;
        near = a > near ? a : near;
        far = b > far ? b : far;
    }
    coastal_end(&o);
    assert_true(near > 240);
    assert_int_equal(far, 0);
}

/* Shape of the crests on a beach, the worst over 32 phases. */
typedef struct {
    double back;                /* overhang: x runs back by this, m */
    double lip;                 /* height where the overhang begins, m */
    double steep;               /* steepest front, rise over run, where x runs on */
    int    white;               /* foam of breaking, 0..255 */
} crest_shape;

/* Adds the water from a depth of 2 m to half of the wave's height: from there on the water
 * runs up and down the beach. */
static void add_crest(const coastal_water *o, double slope, tp_turn phase, crest_shape *s)
{
    const tp_turn phases[TP_WAVES] = { phase };
    const double far = 2 / slope, step = far / 4000;
    double most = -1e9, high = 0;
    tp_coastal_point last = { .depth = 0 };

    for (double x = -far; x < 0; x += step) {
        const tp_coastal_point p = tp_coastal_displace_point(
            o->coastal, phases, (tp_fx)((x + 4 / slope) * 65536), 0);
        if (p.depth > 0 && p.depth < TP_FX(0.15))
            break;
        const double run = (p.position.x - last.position.x) * LSB,
                     fall = (last.position.y - p.position.y) * LSB;
        if (p.position.x * LSB >= most) {
            most = p.position.x * LSB;
            high = p.position.y * LSB;
        }
        if (most - p.position.x * LSB > s->back) {
            s->back = most - p.position.x * LSB;
            s->lip = high;
        }
        if (last.depth > 0 && run > step / 4)
            s->steep = fmax(s->steep, fall / run);
        s->white = p.breaking > s->white ? p.breaking : s->white;
        last = p;
    }
}

/* A swell of 0.3 m over 60 m on four beaches: xi0 is 14 times the slope. */
static void breakers_differ_by_the_slope_of_the_beach(void **state)
{
    static const double slope[] = { 0.02, 0.06, 0.13, 0.3 };
    crest_shape shape[4] = { { 0 } };

    (void)state;
    for (int k = 0; k < 4; k++) {
        coastal_water o = { .count = 1, .config = coastal_usual() };
        o.wave[0] = coastal_wave(0.15, 60, 0.015, 90);
        o.config.floor = shore(4, slope[k], 90);
        coastal_build(&o);
        for (int n = 0; n < 32; n++)
            add_crest(&o, slope[k], (tp_turn)n << 27, &shape[k]);
        coastal_end(&o);
        printf("    slope %.2f: xi0 %.2f, overhang %.3f m at %.3f m, steepest front %.3f,"
               " foam %d\n", slope[k], slope[k] / sqrt(0.3 / 60), shape[k].back,
               shape[k].lip, shape[k].steep, shape[k].white);
    }
    assert_true(shape[0].back < 0.001 && shape[0].steep < 0.5 && shape[0].white > 200);
    assert_true(shape[1].back > 0.06 && shape[1].white > 200);
    assert_true(shape[2].back > 0.06 && shape[2].white > 200);
    assert_true(shape[3].back < 0.001 && shape[3].steep < 0.25 && shape[3].white < 80);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(breakers_differ_by_the_slope_of_the_beach),
        cmocka_unit_test(plunging_crests_overhang_and_smooth_ones_do_not),
        cmocka_unit_test(waves_that_leave_the_shore_do_not_break_backwards),
        cmocka_unit_test(what_overhangs_is_within_the_bounds),
        cmocka_unit_test(the_surface_is_continuous_across_the_gate),
        cmocka_unit_test(crests_break_where_it_is_shallow_and_not_where_it_is_deep),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("waves/surf", tests, NULL, NULL);
}
