/* SPDX-License-Identifier: MIT */
/* A floating boat on still water: energy never grows [C3], the boat comes to exact rest at
 * its draft, and no boat of the table leaves its range. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/measure.h"
#include "tests/lib/boats.h"

static uint64_t chance;

/* -- energy and rest ----------------------------------------------------------------- */

static tp_boat_attitude any_lie(double most, double fastest)
{
    tp_boat_attitude a = { .at = { 0 } };

    for (int k = 0; k < 3; k++) {
        a.at[k] = (int64_t)(chance_double(&chance, -most, most) * Q40);
        a.speed[k] = (int64_t)(chance_double(&chance, -fastest, fastest) * Q40);
    }
    return a;
}

/* Energy [C3] of the three oscillations on water of height 0, in m^2 per squared step. */
static double swing_energy(const tp_boat_attitude *a, const tp_scene *s)
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
        tp_scene s = any_boat(&chance, TP_BOAT_DYNAMIC);
        const double a = omega_tick(&s), draft = s.boat.draft * LSB;
        tp_boat_attitude at = any_lie(draft / 4, a * draft / 8);
        const tp_fx water[4] = { 0 };
        s.boat.drag = n % 4 ? chance_fx(&chance, 0, 2) : 0;
        double before = swing_energy(&at, &s);
        const double first = before;
        for (int t = 0; t < 1000; t++) {
            tp_boat_step_attitude(&at, &s, water);
            const double now = swing_energy(&at, &s);
            measure_add(&grown, fmax(0, (now - before) / first), n, t, 0);
            before = now;
        }
    }
    measure_print(&grown);
    assert_true(grown.worst < 1e-6);
}

static double full_energy(const tp_boat_attitude *a, const tp_scene *s)
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

/* Released from up to eight drafts.  With drag above 0.1 energy never exceeds the initial
 * energy.  Without drag energy varies by (1 + a) / (1 - a), a = omega dt / 2 of a step, as
 * in any single step: 1.133 at most, for a = 1/16. */
static void no_throw_gains_energy_on_still_water(void **state)
{
    (void)state;
    measure none = { .what = "energy, no drag", .unit = "of the first" };
    measure some = { .what = "energy, drag", .unit = "of the first" };

    for (int n = 0; n < 100; n++) {
        tp_scene s = any_boat(&chance, TP_BOAT_DYNAMIC);
        const double a = omega_tick(&s), draft = s.boat.draft * LSB;
        tp_boat_attitude at = any_lie(8 * draft, a * draft);
        const tp_fx water[4] = { 0 };
        s.boat.drag = n % 2 ? chance_scale(&chance, 0.1, 2) : 0;
        const double first = full_energy(&at, &s);
        for (int t = 0; t < 3000; t++) {
            tp_boat_step_attitude(&at, &s, water);
            measure_add(n % 2 ? &some : &none, full_energy(&at, &s) / first, n, t, 0);
        }
    }
    measure_print(&none);
    measure_print(&some);
    assert_true(none.worst <= 1.15);
    assert_true(some.worst <= 1);
}

/* The amplitude falls by zeta omega dt per tick at least, or, if overdamped, by omega dt /
 * (2 zeta).  2^-18 m of 100 m is e^-17. */
static void it_comes_to_exact_rest_at_its_draft(void **state)
{
    (void)state;
    double longest = 0;

    for (int n = 0; n < 60; n++) {
        tp_scene s = any_boat(&chance, TP_BOAT_DYNAMIC);
        s.water.gravity = chance_scale(&chance, 1, 100);
        tp_boat_attitude at = any_lie(n % 2 ? 100 : 1, n % 3 ? 1 : 0.01);
        tp_fx water[4];
        const tp_fx level = chance_fx(&chance, -100, 100);
        const double a = omega_tick(&s), drag = s.boat.drag * LSB;
        const double slow = fmin(drag * a, a / (4 * drag));
        const double fall = 200 * (2 + drag) / (a * a * s.boat.draft * LSB);
        const int most = (int)(30 / slow + fall);
        int t = 0;
        flat(water, level);
        do
            tp_boat_step_attitude(&at, &s, water);
        while ((at.at[0] != (int64_t)level * (1 << 24) || at.at[1] || at.at[2]
                || at.speed[0] || at.speed[1] || at.speed[2]) && t++ < most);
        longest = fmax(longest, (double)t / most);
        assert_true(t < most);
        const tp_boat_attitude rest = at;
        tp_boat_step_attitude(&at, &s, water);
        assert_memory_equal(&rest, &at, sizeof at);
    }
    print_message("# rest after %.2f of the ticks allowed\n", longest);
}

/* Water of any height that jumps each tick, beyond any draft. */
static void no_boat_of_the_table_leaves_its_range(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        tp_scene s = any_boat(&chance, TP_BOAT_DYNAMIC);
        tp_boat_attitude at = any_lie(n % 2 ? 4000 : 1, n % 3 ? 60 : 0);
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
            tp_boat_step_attitude(&at, &s, water);
            tp_boat_set_immersion(&hull, &at, water);
            for (int k = 0; k < 3; k++) {
                assert_true(fabs((double)at.at[k] / Q40) <= 4096);
                assert_true(fabs((double)at.speed[k] / Q40) <= 64);
                assert_true(abs(hull.immersion[k]) <= 256 * TP_FX_ONE);
            }
        }
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(energy_never_grows_on_still_water),
        cmocka_unit_test(no_throw_gains_energy_on_still_water),
        cmocka_unit_test(it_comes_to_exact_rest_at_its_draft),
        cmocka_unit_test(no_boat_of_the_table_leaves_its_range),
    };
    return cmocka_run_group_tests_name("features/boat_buoyancy_rest", tests, NULL, NULL);
}
