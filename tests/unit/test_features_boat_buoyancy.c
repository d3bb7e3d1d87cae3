/* SPDX-License-Identifier: MIT */
/* Motion of a boat on the water [E2] [E3] without a world: input are the heights at four
 * points, output is the boat's attitude.  Compared with the same in double precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/measure.h"
#include "tests/lib/boats.h"

static uint64_t chance;

/* -- in double precision ------------------------------------------------------------- */

typedef struct { double lie[3], speed[3]; } ref_float;

static void ref_aims(const tp_fx water[4], double aim[3])
{
    aim[0] = ((double)water[0] + water[1] + water[2] + water[3]) / 4 * LSB;
    aim[1] = ((double)water[0] - water[1]) * LSB;
    aim[2] = ((double)water[2] - water[3]) * LSB;
}

static void ref_follow(ref_float *f, double tau, const tp_fx water[4])
{
    double aim[3];

    ref_aims(water, aim);
    for (int k = 0; k < 3; k++)
        f->lie[k] += (aim[k] - f->lie[k]) * -expm1(-1 / (60 * tau));
}

static double ref_force(double e, double draft)
{
    return fmax(-draft, fmin(draft, e));
}

/* Water columns at four points, each with a quarter of mass and area; speeds are per
 * step. */
static void ref_step(ref_float *f, const tp_scene *s, const tp_fx water[4])
{
    const double a = omega_step(s), damp = fmin(1, s->boat.drag * LSB * a);
    const double way[4][3] = { { 1, 0.5, 0 }, { 1, -0.5, 0 }, { 1, 0, 0.5 },
                               { 1, 0, -0.5 } };
    const double mass[3] = { 4, 0.5, 0.5 };
    double push[3] = { 0, 0, 0 };

    for (int i = 0; i < 4; i++) {
        double y = 0;
        for (int k = 0; k < 3; k++)
            y += way[i][k] * f->lie[k];
        for (int k = 0; k < 3; k++)
            push[k] += way[i][k] * ref_force(water[i] * LSB - y, s->boat.draft * LSB);
    }
    for (int k = 0; k < 3; k++) {
        f->speed[k] += (a * a * push[k] / mass[k] - 2 * damp * f->speed[k]) / (1 + damp);
        f->lie[k] += f->speed[k];
    }
}

static void ref_swing(ref_float *f, const tp_scene *s, const tp_fx water[4])
{
    for (int n = 0; n < steps_of(s); n++)
        ref_step(f, s, water);
}

/* -- kinematic ----------------------------------------------------------------------- */

static void a_kinematic_boat_takes_the_water_s_lie(void **state)
{
    (void)state;
    const tp_scene s = any_boat(&chance, TP_BOAT_KINEMATIC);

    for (int n = 0; n < 2000; n++) {
        tp_boat_attitude a = { .speed = { 5, 6, 7 } };
        tp_hull hull = { .immersion = { 1, 2, 3 } };
        tp_fx water[4];
        double aim[3];
        for (int i = 0; i < 4; i++)
            water[i] = chance_fx(&chance, -2048, 2048);
        tp_boat_step_attitude(&a, &s, water);
        tp_boat_set_immersion(&hull, &a, water);
        ref_aims(water, aim);
        for (int k = 0; k < 3; k++) {
            assert_true((double)a.at[k] == aim[k] * Q40);
            assert_int_equal(a.speed[k], 0);
            assert_int_equal(hull.immersion[k], 0);
        }
    }
}

static void smoothing_follows_the_models(void **state)
{
    (void)state;
    measure off = { .what = "smoothed lie", .unit = "m" };

    for (int n = 0; n < 40; n++) {
        tp_scene s = any_boat(&chance, TP_BOAT_KINEMATIC);
        tp_boat_attitude a = { .at = { 0 } };
        ref_float f = { .lie = { 0 } };
        tp_fx water[4] = { 0 };
        s.boat.smooth = n == 0 ? 1 : n == 1 ? 10 * TP_FX_ONE
                                            : chance_scale(&chance, 0.01, 10);
        for (int t = 0; t < 600; t++) {
            for (int i = 0; i < 4 && t % 40 == 0; i++)
                water[i] = chance_fx(&chance, -8, 8);
            tp_boat_step_attitude(&a, &s, water);
            ref_follow(&f, s.boat.smooth * LSB, water);
            for (int k = 0; k < 3; k++)
                measure_add(&off, (double)a.at[k] / Q40 - f.lie[k], s.boat.smooth, t, k);
        }
    }
    measure_print(&off);
    assert_true(off.worst < LSB);
}

/* Smoothing ends: afterwards the pose stays exactly equal to the pose of the water. */
static void smoothing_ends_exactly_on_flat_water(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        tp_scene s = any_boat(&chance, TP_BOAT_KINEMATIC);
        tp_boat_attitude a = { .at = { 0 } };
        tp_fx water[4];
        const tp_fx level = chance_fx(&chance, -100, 100);
        for (int i = 0; i < 4; i++)
            water[i] = chance_fx(&chance, -100, 100);
        s.boat.smooth = chance_scale(&chance, 0.001, 10);
        tp_boat_snap_attitude(&a, water);
        flat(water, level);
        for (int t = 0; t < 60 * 10 * 30; t++)
            tp_boat_step_attitude(&a, &s, water);
        assert_int_equal(tp_fx_of_q40(a.at[0]), level);
        assert_int_equal(tp_fx_of_q40(a.at[1]), 0);
        assert_int_equal(tp_fx_of_q40(a.at[2]), 0);
        tp_hull hull = { .immersion = { 1, 2, 3 } };
        tp_boat_set_immersion(&hull, &a, water);
        assert_true(hull.immersion[0] == 0 && hull.immersion[1] == 0
                    && hull.immersion[2] == 0);
    }
}

/* -- dynamic ------------------------------------------------------------------------- */

static void compare_swing(int n, measure *off)
{
    tp_scene s = any_boat(&chance, TP_BOAT_DYNAMIC);
    tp_boat_attitude a = { .at = { 0 } };
    ref_float f = { .lie = { 0 } };
    const double high = chance_scale(&chance, 0.01, 40) * LSB;
    const double step = chance_double(&chance, 0, 0.2);
    double phase[4];

    for (int i = 0; i < 4; i++)
        phase[i] = chance_double(&chance, 0, 6);
    for (int t = 0; t < 600; t++) {
        tp_fx water[4];
        for (int i = 0; i < 4; i++)
            water[i] = (tp_fx)lround(high * sin(phase[i] + step * t) * 65536);
        tp_boat_step_attitude(&a, &s, water);
        ref_swing(&f, &s, water);
        for (int k = 0; k < 3; k++)
            measure_add(off, ((double)a.at[k] / Q40 - f.lie[k]) / high, n, t, k);
    }
}

/* Waves of up to 40 m under boats of any kind, so that many points leave the water or
 * submerge.  The error is relative to the waves' height. */
static void floating_follows_the_models(void **state)
{
    (void)state;
    measure off = { .what = "floating lie", .unit = "of the waves" };

    for (int n = 0; n < 200; n++)
        compare_swing(n, &off);
    measure_print(&off);
    assert_true(off.worst < 1e-4);
}

/* Mean time between two upward zero crossings, from eight periods. */
static double period_of(const tp_scene *s)
{
    tp_boat_attitude a = { .at = { -(int64_t)s->boat.draft * (1 << 23), 0, 0 } };
    const tp_fx water[4] = { 0 };
    double first = 0, last = 0;
    int count = 0;

    for (int t = 1; count < 9; t++) {
        const int64_t before = a.at[0];
        tp_boat_step_attitude(&a, s, water);
        if (before < 0 && a.at[0] >= 0) {
            last = t - (double)a.at[0] / (double)(a.at[0] - before);
            first = count++ == 0 ? last : first;
        }
    }
    return (last - first) / 8;
}

/* 2 pi sqrt(draft / g), too fast by the relative error (omega dt)^2 / 24; 1/8 gives
 * 1/1536. */
static void it_swings_at_the_root_of_gravity_over_draft(void **state)
{
    (void)state;
    measure off = { .what = "period", .unit = "of itself" };

    for (int n = 0; n < 50; n++) {
        tp_scene s = any_boat(&chance, TP_BOAT_DYNAMIC);
        s.boat.drag = TP_FX(0.001);
        const double a = omega_step(&s), sine = asin(a / 2) * 2 * steps_of(&s);
        measure_add(&off, period_of(&s) * sine / (2 * 3.14159265358979) - 1, n, 0, 0);
        assert_true(sine / omega_tick(&s) - 1 < 1 / 1500.0);
    }
    measure_print(&off);
    assert_true(off.worst < 0.001);
}

/* The amplitude falls by exp(-2 pi zeta / sqrt(1 - zeta^2)) from swing to swing. */
static void drag_is_the_share_of_the_critical(void **state)
{
    (void)state;
    tp_scene s = any_boat(&chance, TP_BOAT_DYNAMIC);
    const tp_fx water[4] = { 0 };
    int64_t high[3] = { 0 };
    int tops = 0;

    s.water.gravity = TP_FX(9.81);
    s.boat.draft = 8 * TP_FX_ONE;       /* omega dt = 0.018 */
    s.boat.drag = TP_FX(0.1);
    tp_boat_attitude a = { .at = { (int64_t)4 << 40, 0, 0 } };
    int64_t before = a.at[0];
    for (int t = 0; tops < 3; t++) {
        const int64_t now = a.at[0];
        tp_boat_step_attitude(&a, &s, water);
        if (now > before && now > a.at[0])
            high[tops++] = now;
        before = now;
    }
    const double fall = exp(-2 * 3.14159265 * 0.1 / sqrt(1 - 0.01));
    const double first = (double)high[1] / (double)high[0];
    const double second = (double)high[2] / (double)high[1];
    print_message("# fall of amplitude %.5f %.5f, model %.5f\n", first, second, fall);
    assert_true(fabs(first - fall) < 0.002 && fabs(second - fall) < 0.002);
}

static void critical_drag_does_not_overshoot(void **state)
{
    (void)state;
    for (int n = 0; n < 100; n++) {
        tp_scene s = any_boat(&chance, TP_BOAT_DYNAMIC);
        const tp_fx water[4] = { 0 };
        s.boat.drag = chance_fx(&chance, 1.001, 2);
        if (n < 4) {
            s.water.gravity = 100 * TP_FX_ONE;
            s.boat.draft = TP_FX(0.05);
        }
        tp_boat_attitude a = { .at = { (int64_t)s.boat.draft << 23,
                                       (int64_t)s.boat.draft << 24,
                                       (int64_t)s.boat.draft << 21 } };
        for (int t = 0; t < 3000; t++) {
            tp_boat_step_attitude(&a, &s, water);
            assert_true(a.at[0] >= 0 && a.at[1] >= 0 && a.at[2] >= 0);
        }
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_kinematic_boat_takes_the_water_s_lie),
        cmocka_unit_test(smoothing_follows_the_models),
        cmocka_unit_test(smoothing_ends_exactly_on_flat_water),
        cmocka_unit_test(floating_follows_the_models),
        cmocka_unit_test(it_swings_at_the_root_of_gravity_over_draft),
        cmocka_unit_test(drag_is_the_share_of_the_critical),
        cmocka_unit_test(critical_drag_does_not_overshoot),
    };
    return cmocka_run_group_tests_name("features/boat_buoyancy", tests, NULL, NULL);
}
