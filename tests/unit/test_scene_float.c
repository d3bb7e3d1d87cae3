/* SPDX-License-Identifier: MIT */
/* How a boat lies on the water [E2] [E3], away from any world: heights under four points
 * go in, a lie comes out.  Compared with the same in double precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "scene/boat.h"
#include "scenes.h"

#define Q40 1099511627776.0
#define LSB (1 / 65536.0)

static uint64_t chance;

/* A boat from anywhere in the table's ranges. */
static tp_scene any_boat(tp_boat_mode mode)
{
    tp_scene s;

    tp_scene_default(&s);
    s.boat.mode = mode;
    s.boat.draft = chance_scale(&chance, 0.05, 20);
    s.boat.drag = chance_fx(&chance, 0.05, 2);
    s.water.gravity = chance_scale(&chance, 0.1, 100);
    return s;
}

/* omega dt of [E3]; of as many steps as keep it to an eighth. */
static double omega_tick(const tp_scene *s)
{
    return sqrt((double)s->water.gravity / s->boat.draft) / TP_TICKS_PER_SECOND;
}

static int steps_of(const tp_scene *s)
{
    return (int)fmax(1, ceil(omega_tick(s) * 8));
}

static double omega_step(const tp_scene *s)
{
    return omega_tick(s) / steps_of(s);
}

static void flat(tp_fx water[4], tp_fx height)
{
    for (int i = 0; i < 4; i++)
        water[i] = height;
}

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

/* Columns at four points, each of a quarter of mass and area; speeds are a step's. */
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
    const tp_scene s = any_boat(TP_BOAT_KINEMATIC);

    for (int n = 0; n < 2000; n++) {
        tp_lie a = { .speed = { 5, 6, 7 } };
        tp_hull hull = { .sunk = { 1, 2, 3 } };
        tp_fx water[4];
        double aim[3];
        for (int i = 0; i < 4; i++)
            water[i] = chance_fx(&chance, -2048, 2048);
        tp_boat_float(&a, &s, water);
        tp_boat_sink(&hull, &a, water);
        ref_aims(water, aim);
        for (int k = 0; k < 3; k++) {
            assert_true((double)a.at[k] == aim[k] * Q40);
            assert_int_equal(a.speed[k], 0);
            assert_int_equal(hull.sunk[k], 0);
        }
    }
}

static void smoothing_follows_the_models(void **state)
{
    (void)state;
    measure off = { .what = "smoothed lie", .unit = "m" };

    for (int n = 0; n < 40; n++) {
        tp_scene s = any_boat(TP_BOAT_KINEMATIC);
        tp_lie a = { .at = { 0 } };
        ref_float f = { .lie = { 0 } };
        tp_fx water[4] = { 0 };
        s.boat.smooth = n == 0 ? 1 : n == 1 ? 10 * TP_FX_ONE
                                            : chance_scale(&chance, 0.01, 10);
        for (int t = 0; t < 600; t++) {
            for (int i = 0; i < 4 && t % 40 == 0; i++)
                water[i] = chance_fx(&chance, -8, 8);
            tp_boat_float(&a, &s, water);
            ref_follow(&f, s.boat.smooth * LSB, water);
            for (int k = 0; k < 3; k++)
                measure_add(&off, (double)a.at[k] / Q40 - f.lie[k], s.boat.smooth, t, k);
        }
    }
    measure_print(&off);
    assert_true(off.worst < LSB);
}

/* And then stays there: all of the pose is what the water says. */
static void smoothing_ends_exactly_on_flat_water(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        tp_scene s = any_boat(TP_BOAT_KINEMATIC);
        tp_lie a = { .at = { 0 } };
        tp_fx water[4];
        const tp_fx level = chance_fx(&chance, -100, 100);
        for (int i = 0; i < 4; i++)
            water[i] = chance_fx(&chance, -100, 100);
        s.boat.smooth = chance_scale(&chance, 0.001, 10);
        tp_boat_lay(&a, water);
        flat(water, level);
        for (int t = 0; t < 60 * 10 * 30; t++)
            tp_boat_float(&a, &s, water);
        assert_int_equal(tp_fx_of_q40(a.at[0]), level);
        assert_int_equal(tp_fx_of_q40(a.at[1]), 0);
        assert_int_equal(tp_fx_of_q40(a.at[2]), 0);
        tp_hull hull = { .sunk = { 1, 2, 3 } };
        tp_boat_sink(&hull, &a, water);
        assert_true(hull.sunk[0] == 0 && hull.sunk[1] == 0 && hull.sunk[2] == 0);
    }
}

/* -- dynamic ------------------------------------------------------------------------- */

static void compare_swing(int n, measure *off)
{
    tp_scene s = any_boat(TP_BOAT_DYNAMIC);
    tp_lie a = { .at = { 0 } };
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
        tp_boat_float(&a, &s, water);
        ref_swing(&f, &s, water);
        for (int k = 0; k < 3; k++)
            measure_add(off, ((double)a.at[k] / Q40 - f.lie[k]) / high, n, t, k);
    }
}

/* Waves of up to 40 m under boats of any kind, so that many points leave the water or are
 * drowned; of the waves' height. */
static void floating_follows_the_models(void **state)
{
    (void)state;
    measure off = { .what = "floating lie", .unit = "of the waves" };

    for (int n = 0; n < 200; n++)
        compare_swing(n, &off);
    measure_print(&off);
    assert_true(off.worst < 1e-4);
}

/* The time between two passages upwards, from eight of them. */
static double period_of(const tp_scene *s)
{
    tp_lie a = { .at = { -(int64_t)s->boat.draft * (1 << 23), 0, 0 } };
    const tp_fx water[4] = { 0 };
    double first = 0, last = 0;
    int count = 0;

    for (int t = 1; count < 9; t++) {
        const int64_t before = a.at[0];
        tp_boat_float(&a, s, water);
        if (before < 0 && a.at[0] >= 0) {
            last = t - (double)a.at[0] / (double)(a.at[0] - before);
            first = count++ == 0 ? last : first;
        }
    }
    return (last - first) / 8;
}

/* 2 pi sqrt(draft / g), by (omega dt)^2 / 24 of itself too fast; 1/8 gives 1/1536. */
static void it_swings_at_the_root_of_gravity_over_draft(void **state)
{
    (void)state;
    measure off = { .what = "period", .unit = "of itself" };

    for (int n = 0; n < 50; n++) {
        tp_scene s = any_boat(TP_BOAT_DYNAMIC);
        s.boat.drag = TP_FX(0.001);
        const double a = omega_step(&s), sine = asin(a / 2) * 2 * steps_of(&s);
        measure_add(&off, period_of(&s) * sine / (2 * 3.14159265358979) - 1, n, 0, 0);
        assert_true(sine / omega_tick(&s) - 1 < 1 / 1500.0);
    }
    measure_print(&off);
    assert_true(off.worst < 0.001);
}

/* An amplitude falls by exp(-2 pi zeta / sqrt(1 - zeta^2)) from swing to swing. */
static void drag_is_the_share_of_the_critical(void **state)
{
    (void)state;
    tp_scene s = any_boat(TP_BOAT_DYNAMIC);
    const tp_fx water[4] = { 0 };
    int64_t high[3] = { 0 };
    int tops = 0;

    s.water.gravity = TP_FX(9.81);
    s.boat.draft = 8 * TP_FX_ONE;       /* omega dt = 0.018 */
    s.boat.drag = TP_FX(0.1);
    tp_lie a = { .at = { (int64_t)4 << 40, 0, 0 } };
    int64_t before = a.at[0];
    for (int t = 0; tops < 3; t++) {
        const int64_t now = a.at[0];
        tp_boat_float(&a, &s, water);
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
        tp_scene s = any_boat(TP_BOAT_DYNAMIC);
        const tp_fx water[4] = { 0 };
        s.boat.drag = chance_fx(&chance, 1.001, 2);
        if (n < 4) {
            s.water.gravity = 100 * TP_FX_ONE;
            s.boat.draft = TP_FX(0.05);
        }
        tp_lie a = { .at = { (int64_t)s.boat.draft << 23, (int64_t)s.boat.draft << 24,
                                 (int64_t)s.boat.draft << 21 } };
        for (int t = 0; t < 3000; t++) {
            tp_boat_float(&a, &s, water);
            assert_true(a.at[0] >= 0 && a.at[1] >= 0 && a.at[2] >= 0);
        }
    }
}

/* -- energy and rest ----------------------------------------------------------------- */

static tp_lie any_lie(double most, double fastest)
{
    tp_lie a = { .at = { 0 } };

    for (int k = 0; k < 3; k++) {
        a.at[k] = (int64_t)(chance_double(&chance, -most, most) * Q40);
        a.speed[k] = (int64_t)(chance_double(&chance, -fastest, fastest) * Q40);
    }
    return a;
}

/* [C3] of the three swings on water of height 0, in m^2 a square step. */
static double swing_energy(const tp_lie *a, const tp_scene *s)
{
    const double mass[3] = { 4, 0.5, 0.5 }, spring = pow(omega_step(s), 2);
    double sum = 0;

    for (int k = 0; k < 3; k++) {
        const double x = (double)a->at[k] / Q40;
        const double v = (double)a->speed[k] / Q40 / steps_of(s);
        sum += mass[k] * (v * v + spring * x * (x - v)) / 2;
    }
    return sum;
}

/* No point leaves the water: heave and the halves of rise and tilt stay below the draft.
 * Roundings are 2^-40 m. */
static void energy_never_grows_on_still_water(void **state)
{
    (void)state;
    measure grown = { .what = "energy grown", .unit = "of the first" };

    for (int n = 0; n < 200; n++) {
        tp_scene s = any_boat(TP_BOAT_DYNAMIC);
        const double a = omega_tick(&s), draft = s.boat.draft * LSB;
        tp_lie at = any_lie(draft / 4, a * draft / 8);
        const tp_fx water[4] = { 0 };
        s.boat.drag = n % 4 ? chance_fx(&chance, 0, 2) : 0;
        double before = swing_energy(&at, &s);
        const double first = before;
        for (int t = 0; t < 1000; t++) {
            tp_boat_float(&at, &s, water);
            const double now = swing_energy(&at, &s);
            measure_add(&grown, fmax(0, (now - before) / first), n, t, 0);
            before = now;
        }
    }
    measure_print(&grown);
    assert_true(grown.worst < 1e-6);
}

static double full_energy(const tp_lie *a, const tp_scene *s)
{
    const double k = pow(omega_tick(s), 2), draft = s->boat.draft * LSB;
    const double over[4] = { (double)a->at[1] / 2, -(double)a->at[1] / 2,
                             (double)a->at[2] / 2, -(double)a->at[2] / 2 };
    const double mass[3] = { 4, 0.5, 0.5 };
    double sum = 0;

    for (int i = 0; i < 4; i++) {
        const double e = fabs((double)a->at[0] + over[i]) / Q40;
        sum += k * (e < draft ? e * e / 2 : draft * (e - draft / 2));
    }
    for (int i = 0; i < 3; i++)
        sum += mass[i] * pow((double)a->speed[i] / Q40, 2) / 2;
    return sum;
}

/* Thrown from up to eight drafts: with drag above a tenth energy never exceeds the first;
 * without, it wavers by (1 + a) / (1 - a), a = omega dt / 2 of a step, as that of any
 * step does: 1.133 for the most, 1/16. */
static void no_throw_gains_energy_on_still_water(void **state)
{
    (void)state;
    measure none = { .what = "energy, no drag", .unit = "of the first" };
    measure some = { .what = "energy, drag", .unit = "of the first" };

    for (int n = 0; n < 100; n++) {
        tp_scene s = any_boat(TP_BOAT_DYNAMIC);
        const double a = omega_tick(&s), draft = s.boat.draft * LSB;
        tp_lie at = any_lie(8 * draft, a * draft);
        const tp_fx water[4] = { 0 };
        s.boat.drag = n % 2 ? chance_scale(&chance, 0.1, 2) : 0;
        const double first = full_energy(&at, &s);
        for (int t = 0; t < 3000; t++) {
            tp_boat_float(&at, &s, water);
            measure_add(n % 2 ? &some : &none, full_energy(&at, &s) / first, n, t, 0);
        }
    }
    measure_print(&none);
    measure_print(&some);
    assert_true(none.worst <= 1.15);
    assert_true(some.worst <= 1);
}

/* Amplitude falls by zeta omega dt a tick at the least, or slower where it creeps:
 * omega dt / (2 zeta).  2^-18 m of 100 m is e^-17. */
static void it_comes_to_exact_rest_at_its_draft(void **state)
{
    (void)state;
    double longest = 0;

    for (int n = 0; n < 60; n++) {
        tp_scene s = any_boat(TP_BOAT_DYNAMIC);
        s.water.gravity = chance_scale(&chance, 1, 100);
        tp_lie at = any_lie(n % 2 ? 100 : 1, n % 3 ? 1 : 0.01);
        tp_fx water[4];
        const tp_fx level = chance_fx(&chance, -100, 100);
        const double a = omega_tick(&s), drag = s.boat.drag * LSB;
        const double slow = fmin(drag * a, a / (4 * drag));
        const double fall = 200 * (2 + drag) / (a * a * s.boat.draft * LSB);
        const int most = (int)(30 / slow + fall);
        int t = 0;
        flat(water, level);
        do
            tp_boat_float(&at, &s, water);
        while ((at.at[0] != (int64_t)level * (1 << 24) || at.at[1] || at.at[2]
                || at.speed[0] || at.speed[1] || at.speed[2]) && t++ < most);
        longest = fmax(longest, (double)t / most);
        assert_true(t < most);
        const tp_lie rest = at;
        tp_boat_float(&at, &s, water);
        assert_memory_equal(&rest, &at, sizeof at);
    }
    print_message("# rest after %.2f of the ticks allowed\n", longest);
}

/* Water of any height that jumps each tick, out of every draft's reach. */
static void no_boat_of_the_table_leaves_its_range(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        tp_scene s = any_boat(TP_BOAT_DYNAMIC);
        tp_lie at = any_lie(n % 2 ? 4000 : 1, n % 3 ? 60 : 0);
        s.boat.drag = n % 4 ? chance_fx(&chance, 0, 2) : 0;
        if (n % 5 == 0) {
            s.water.gravity = n % 2 ? 100 * TP_FX_ONE : TP_FX(0.1);
            s.boat.draft = n % 3 ? TP_FX(0.05) : 20 * TP_FX_ONE;
        }
        for (int t = 0; t < 500; t++) {
            tp_fx water[4];
            tp_hull hull = { .x = 0 };
            for (int i = 0; i < 4; i++)
                water[i] = chance_fx(&chance, -2048, 2048);
            tp_boat_float(&at, &s, water);
            tp_boat_sink(&hull, &at, water);
            for (int k = 0; k < 3; k++) {
                assert_true(fabs((double)at.at[k] / Q40) <= 4096);
                assert_true(fabs((double)at.speed[k] / Q40) <= 64);
                assert_true(abs(hull.sunk[k]) <= 256 * TP_FX_ONE);
            }
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
        cmocka_unit_test(energy_never_grows_on_still_water),
        cmocka_unit_test(no_throw_gains_energy_on_still_water),
        cmocka_unit_test(it_comes_to_exact_rest_at_its_draft),
        cmocka_unit_test(no_boat_of_the_table_leaves_its_range),
    };
    return cmocka_run_group_tests_name("float", tests, NULL, NULL);
}
