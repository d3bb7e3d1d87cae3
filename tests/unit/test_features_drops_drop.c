/* SPDX-License-Identifier: MIT */
/* Drops compared with [D1]-[D4] in double precision and with the models' vectors: fall and
 * impacts over still water. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/vectors.h"
#include "tests/lib/drops.h"

#define LSB (1 / 65536.0)
#define Q24 (1 / 16777216.0)
#define TAU 6.283185307179586
#define G   TP_FX(9.81)

static uint64_t chance;

static double speed_of(const tp_drop *drop)
{
    return drop->fall_q24 * Q24;
}

/* -- the models' vectors ------------------------------------------------------------- */

/* Rows: case, y0, e, eff, impact, t, m, rad, v, E, L, A0; six rows for each case, no
 * drag. */
typedef struct {
    measure time, height, energy, radius;
} row_errors;

static void compare_row(const double v[12], const tp_impact *got, row_errors *e)
{
    const int64_t which = (int64_t)v[0], impact = (int64_t)v[4];
    const double seconds = (double)got->time / 65536 / 60;
    const double cap = fmin(v[11], v[10] / 14);
    const double share = got->uncapped_q24 * Q24 / v[11];

    measure_add(&e->time, (seconds - v[5]) * 60, which, impact, 0);
    measure_add(&e->height, (share - 1) * 100, which, impact, 0);
    measure_add(&e->radius, (got->length * LSB / v[10] - 1) * 100, which, impact, 0);
    if (v[9] > 0.01)
        measure_add(&e->energy, (got->lost * LSB / v[9] - 1) * 100, which, impact, 0);
    assert_true(fabs(seconds - v[5]) < 1 / 60.0);
    assert_true(fabs(got->uncapped_q24 * Q24 - v[11]) < 0.01 * v[11]);
    assert_true(fabs(got->amplitude * LSB - cap) < 0.01 * cap + 0.6 * LSB);
    assert_true(fabs(got->lost * LSB - v[9]) < 0.01 * v[9] + LSB);
    assert_true(fabs(got->length * LSB - v[10]) < 0.001 * v[10]);
}

static void rows_of_the_models_agree(void **state)
{
    (void)state;
    FILE *const file = fopen("tests/vectors/drop_bounce.csv", "r");
    assert_non_null(file);
    row_errors e = { { .what = "rows, time", .unit = "ticks" },
                     { .what = "rows, A0", .unit = "%" },
                     { .what = "rows, energy", .unit = "%" },
                     { .what = "rows, length", .unit = "%" } };
    tp_scene_drops c = usual;
    tp_drop drop = { .radius = 0 };
    uint64_t tick = 0;
    double v[12];

    c.drag = 0;
    while (csv_row(file, v, 12) == 12) {
        if (v[4] == 0) {
            c.bounce = (tp_fx)lround(v[2] / LSB);
            c.efficiency = (tp_fx)lround(v[3] / LSB);
            c.radius = (tp_fx)lround(v[7] / LSB);
            drop = drop_at(&c, v[1]);
            tick = 0;
        }
        tp_impact got = { .time = -1 };
        while (!tp_drop_step(&drop, &c, G, 0, ++tick, &got))
            assert_true(tick < 6000);
        compare_row(v, &got, &e);
    }
    fclose(file);
    measure_print(&e.time);
    measure_print(&e.height);
    measure_print(&e.energy);
    measure_print(&e.radius);
    assert_int_equal(e.time.inputs, 60);
}

/* -- fall ---------------------------------------------------------------------------- */

/* Terminal speed vt.  Speed after falling from rest with drag v^2 / vt^2 g is exactly vt
 * tanh(g t / vt). */
static double terminal(const tp_scene_drops *c, double g)
{
    return sqrt(8 * g * (c->density * LSB) * (c->radius * LSB)
                / (3 * 1.2 * c->drag * LSB));
}

static void falling_with_drag_follows_the_models(void **state)
{
    (void)state;
    measure speed = { .what = "speed", .unit = "m/s" };
    measure height = { .what = "height", .unit = "m" };

    for (int n = 0; n < 2000; n++) {
        tp_scene_drops c = any_config(&chance);
        const tp_fx gravity = chance_scale(&chance, 0.1, 100);
        if (c.drag < TP_FX(0.01))
            c.drag = TP_FX(0.47);
        const double g = gravity * LSB, vt = terminal(&c, g);
        const double kick = g / 120;
        tp_drop drop = drop_at(&c, 16000);
        tp_impact none;
        for (int tick = 1; tick <= 600; tick++) {
            assert_false(tp_drop_step(&drop, &c, gravity, -20000 * TP_FX_ONE,
                                      (uint64_t)tick, &none));
            const double t = tick / 60.0, want = vt * tanh(g * t / vt);
            const double fallen = vt * vt / g * (g * t / vt > 20 ? g * t / vt - log(2)
                                                                 : log(cosh(g * t / vt)));
            if (want > 126)
                break;
            /* The error is of second order: the square of half a tick's speed gain over the
             * terminal speed. */
            const double share = kick * kick / (vt * vt) + 1e-4;
            assert_true(fabs(-speed_of(&drop) - want) <= share * want + 1e-5);
            assert_true(fabs(16000 - drop.place.y * LSB - fallen)
                        <= share * fallen + kick / 60 + 1e-3);
            measure_add(&speed, -speed_of(&drop) - want, c.radius, c.density, gravity);
            measure_add(&height, 16000 - drop.place.y * LSB - fallen, c.radius, c.density,
                        gravity);
        }
    }
    measure_print(&speed);
    measure_print(&height);
}

static void the_terminal_speed_is_approached(void **state)
{
    (void)state;
    tp_scene_drops c = usual;
    tp_impact none;
    c.radius = TP_FX(0.005);
    tp_drop drop = drop_at(&c, 15000);
    for (uint64_t tick = 1; tick <= 1200; tick++)
        tp_drop_step(&drop, &c, G, -20000 * TP_FX_ONE, tick, &none);
    const double want = terminal(&c, 9.81);
    printf("    terminal speed of 5 mm: %.4f m/s, by the formula %.4f\n",
           -speed_of(&drop), want);
    assert_true(fabs(-speed_of(&drop) / want - 1) < 1e-3);
}

/* Ticks until the first impact from 20 m. */
static double fall_time(const tp_scene_drops *c)
{
    tp_drop drop = drop_at(c, 20);
    tp_impact impact = { .time = 0 };
    uint64_t tick = 0;
    while (!tp_drop_step(&drop, c, G, 0, ++tick, &impact))
        assert_true(tick < 6000);
    return (double)impact.time / 65536;
}

static void heavier_drops_fall_faster_through_air_alone(void **state)
{
    (void)state;
    tp_scene_drops light = usual, heavy = usual, small = usual;
    heavy.density = TP_FX(4000);
    small.radius = TP_FX(0.01);
    assert_true(fall_time(&heavy) < fall_time(&light) - 1);
    assert_true(fall_time(&light) < fall_time(&small) - 1);
    light.drag = heavy.drag = small.drag = 0;
    assert_true(fall_time(&heavy) == fall_time(&light));
    assert_true(fall_time(&small) == fall_time(&light));
    /* The reference is sqrt(2 h / g). */
    assert_true(fabs(fall_time(&light) - 60 * sqrt(40 / 9.81)) < 0.001);
}

/* -- impacts ------------------------------------------------------------------------- */

static void each_impact_halves_the_mass_until_the_drop_is_gone(void **state)
{
    (void)state;
    for (int impacts = 5; impacts <= 7; impacts++) {
        tp_scene_drops c = usual;
        c.impacts = impacts;
        tp_drop drop = drop_at(&c, 3);
        int struck = 0;
        for (uint64_t tick = 1; tick < 3000; tick++) {
            tp_impact impact;
            const double before = drop.radius;
            if (!tp_drop_step(&drop, &c, G, 0, tick, &impact))
                continue;
            struck++;
            assert_int_equal(impact.length, 8 * before);
            if (struck < impacts)
                assert_true(fabs(pow(before / drop.radius, 3) - 2) < 0.01);
        }
        assert_int_equal(struck, impacts);
        assert_int_equal(drop.radius, 0);
    }
}

static void speed_comes_back_by_the_bounce(void **state)
{
    (void)state;
    tp_scene_drops c = usual;
    c.drag = 0;
    for (int n = 0; n < 500; n++) {
        c.bounce = chance_fx(&chance, 0.5, 0.8);
        const double y = chance_double(&chance, 0.5, 50);
        tp_drop drop = drop_at(&c, y);
        tp_impact impact;
        double top = 0;
        uint64_t tick = 0;
        while (!tp_drop_step(&drop, &c, G, 0, ++tick, &impact))
            ;
        while (!tp_drop_step(&drop, &c, G, 0, ++tick, &impact))
            top = fmax(top, drop.place.y * LSB);
        const double e = c.bounce * LSB;
        /* Between ticks the top may be up to g (dt / 2)^2 / 2 higher. */
        assert_true(fabs(top - e * e * y) < 0.0004 + 2e-4 * y);
    }
}

static void rings_are_no_steeper_than_waves_can_be(void **state)
{
    (void)state;
    int capped = 0;
    for (int n = 0; n < 5000; n++) {
        const tp_scene_drops c = any_config(&chance);
        const tp_fx gravity = chance_scale(&chance, 0.1, 100);
        tp_drop drop = drop_at(&c, chance_double(&chance, 0.01, 100));
        tp_impact impact = { .time = 0 };
        uint64_t tick = 0;
        /* In the lowest gravity the smallest drops fall at 4 cm/s. */
        while (!tp_drop_step(&drop, &c, gravity, 0, ++tick, &impact))
            assert_true(tick < 180000);
        assert_true(impact.amplitude * 14 <= impact.length);
        capped += impact.uncapped_q24 / 256 > impact.amplitude;
        if (impact.uncapped_q24 / 256 < impact.length / 14)
            assert_true(fabs(impact.uncapped_q24 / 256.0 - impact.amplitude) <= 1);
    }
    assert_in_range(capped, 100, 4900);
}

/* A0 by the printed form of [D4], from the impact speed. */
static void ring_heights_follow_the_energy(void **state)
{
    (void)state;
    measure share = { .what = "A0 by [D4]", .unit = "%" };

    for (int n = 0; n < 5000; n++) {
        tp_scene_drops c = any_config(&chance);
        const double g = 9.81, high = chance_double(&chance, 0.2, 100);
        c.drag = 0;
        tp_drop drop = drop_at(&c, high);
        tp_impact impact = { .time = 0 };
        uint64_t tick = 0;
        while (!tp_drop_step(&drop, &c, G, 0, ++tick, &impact))
            ;
        const double r = c.radius * LSB, e = c.bounce * LSB, v = sqrt(2 * g * high);
        const double m = c.density * LSB * 2 / 3 * TAU * r * r * r;
        const double lost = m * v * v / 2 - m / 2 * e * e * v * v / 2, l = 8 * r;
        const double want = sqrt(c.efficiency * LSB * lost
                                 / (1000 * g * TAU * l / 2 * 3 / 8 * l));
        assert_true(fabs(impact.uncapped_q24 * Q24 - want) < 0.002 * want + 2 * Q24);
        if (lost < 32000)
            assert_true(fabs(impact.lost * LSB - lost) < 0.002 * lost + 2 * LSB);
        else
            assert_true(impact.lost * LSB > 0.997 * fmin(lost, 32768));
        if (want > 1e-4)
            measure_add(&share, (impact.uncapped_q24 * Q24 / want - 1) * 100, c.radius,
                        c.density, c.efficiency);
    }
    measure_print(&share);
}

static void an_impact_in_a_tick_is_told_to_its_part(void **state)
{
    (void)state;
    tp_scene_drops c = usual;
    c.drag = 0;
    measure time = { .what = "first impact", .unit = "ticks" };
    for (int n = 0; n < 3000; n++) {
        const double high = (tp_fx)lround(chance_double(&chance, 0.01, 30) / LSB) * LSB;
        tp_drop drop = drop_at(&c, high);
        tp_impact impact;
        uint64_t tick = 0;
        while (!tp_drop_step(&drop, &c, G, 0, ++tick, &impact))
            ;
        const double got = (double)impact.time / 65536;
        assert_true(got >= (double)(tick - 1) && got <= (double)tick);
        measure_add(&time, got - 60 * sqrt(2 * high / (G * LSB)), drop.place.y, 0, 0);
    }
    measure_print(&time);
    assert_true(time.worst < 1e-3);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_of_the_models_agree),
        cmocka_unit_test(falling_with_drag_follows_the_models),
        cmocka_unit_test(the_terminal_speed_is_approached),
        cmocka_unit_test(heavier_drops_fall_faster_through_air_alone),
        cmocka_unit_test(each_impact_halves_the_mass_until_the_drop_is_gone),
        cmocka_unit_test(speed_comes_back_by_the_bounce),
        cmocka_unit_test(rings_are_no_steeper_than_waves_can_be),
        cmocka_unit_test(ring_heights_follow_the_energy),
        cmocka_unit_test(an_impact_in_a_tick_is_told_to_its_part),
    };
    return cmocka_run_group_tests_name("features/drops drop", tests, NULL, NULL);
}
