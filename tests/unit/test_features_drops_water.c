/* SPDX-License-Identifier: MIT */
/* Drops over moving water, the shape of drops, and the whole ranges of the parameter
 * table. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/drops.h"

#define LSB (1 / 65536.0)
#define G   TP_FX(9.81)
#define HIGH_MOST (16384 << 16)     /* highest drop, 16.16 (drop.c) */

static uint64_t chance;

/* -- moving water -------------------------------------------------------------------- */

/* Waves of up to 3 m and 16 m/s under a drop: the drop never stays under water, bounces up
 * to the permitted number of times and ends. */
static void no_wave_swallows_a_drop(void **state)
{
    (void)state;
    int longest = 0;
    for (int n = 0; n < 1000; n++) {
        const tp_scene_drops c = any_config(&chance);
        const double a = chance_double(&chance, 0.01, 3);
        const double w = chance_double(&chance, 0.1, 5);
        const tp_fx gravity = chance_scale(&chance, 1, 30);
        tp_drop drop = drop_at(&c, chance_double(&chance, -5, 20));
        int struck = 0;
        uint64_t tick = 0;
        while (drop.radius > 0) {
            tp_impact impact;
            tick++;
            const tp_fx level = (tp_fx)lround(a * sin(w * (double)tick / 60) / LSB);
            const tp_fx before = drop.level;
            struck += tp_drop_step(&drop, &c, gravity, level, tick, &impact);
            assert_true(drop.place.y >= level);
            assert_true(before != TP_DROP_NEW || struck == 0 || tick == 1);
            assert_true(tick < 60000);
        }
        longest = (int)tick > longest ? (int)tick : longest;
        assert_int_equal(struck, c.impacts);
    }
    printf("    longest life       %10d ticks\n", longest);
}

/* With a level that moves uniformly, everything is as at rest, the impacts' fractions of
 * ticks too. */
static void evenly_moving_water_is_still_water(void **state)
{
    (void)state;
    tp_scene_drops c = usual;
    c.drag = 0;
    for (int n = 0; n < 500; n++) {
        const int32_t rise = chance_int(&chance, -8000, 8000);  /* LSB per tick: 7.3 m/s */
        tp_drop still = drop_at(&c, 4), lifted = still;
        still.level = lifted.level = 0;
        lifted.fall_q24 = rise * (256 * 60);
        tp_fx level = 0;
        for (uint64_t tick = 1; still.radius > 0; tick++) {
            tp_impact a = { .time = 0 }, b = { .time = 0 };
            level += rise;
            const bool struck = tp_drop_step(&still, &c, G, 0, tick, &a);
            assert_int_equal(tp_drop_step(&lifted, &c, G, level, tick, &b), struck);
            assert_true(llabs(a.time - b.time) <= 2);
            assert_true(tp_abs(a.amplitude - b.amplitude) <= 1);
            assert_true(tp_abs(lifted.place.y - level - still.place.y) <= 2);
            if (level > 20000 * TP_FX_ONE || level < -20000 * TP_FX_ONE)
                break;
        }
    }
}

/* A level set by hand or by a new scene lifts the drop and gives the drop no speed. */
static void a_leap_of_the_level_throws_no_drop(void **state)
{
    (void)state;
    tp_drop drop = drop_at(&usual, 2);
    tp_impact impact;
    for (uint64_t tick = 1; tick <= 10; tick++)
        assert_false(tp_drop_step(&drop, &usual, G, 0, tick, &impact));
    assert_false(tp_drop_step(&drop, &usual, G, TP_FX(50), 11, &impact));
    assert_int_equal(drop.place.y, TP_FX(50));
    assert_int_equal(drop.fall_q24, 0);
    int struck = 0;
    for (uint64_t tick = 12; drop.radius > 0; tick++) {
        struck += tp_drop_step(&drop, &usual, G, TP_FX(50), tick, &impact);
        assert_in_range(drop.place.y, TP_FX(50), TP_FX(50.01));
        assert_true(tick < 100);
    }
    assert_int_equal(struck, usual.impacts);
}

/* Bounces shorter than a tick: no impact is harder than the preceding rise. */
static void no_bounce_gains_speed(void **state)
{
    (void)state;
    for (int n = 0; n < 3000; n++) {
        tp_scene_drops c = any_config(&chance);
        const tp_fx gravity = chance_scale(&chance, 0.1, 100);
        tp_drop drop = drop_at(&c, chance_scale(&chance, 0.0001, 10) * LSB);
        int64_t last = INT32_MAX;
        for (uint64_t tick = 1; drop.radius > 0; tick++) {
            tp_impact impact;
            if (!tp_drop_step(&drop, &c, gravity, 0, tick, &impact))
                continue;
            /* A0 is proportional to the speed and to the radius to the power of 1/2: a
             * factor of 2^(-1/6). */
            assert_true(impact.uncapped_q24 <= 0.8 * 0.9 * (double)last + 3);
            last = impact.uncapped_q24;
        }
    }
}

/* -- shape --------------------------------------------------------------------------- */

static void a_fast_drop_is_long_and_an_impact_flattens_it(void **state)
{
    (void)state;
    tp_drop drop = drop_at(&usual, 10);
    tp_impact impact;
    uint64_t tick = 0;
    int32_t last = 0;

    while (!tp_drop_step(&drop, &usual, G, 0, ++tick, &impact)) {
        assert_true(drop.squash >= last - 100);
        last = drop.squash;
    }
    assert_in_range(last, 4000, 8192);
    assert_true(drop.squash < -4000);
    const int32_t flat = drop.squash;
    int32_t most = flat;
    for (int k = 0; k < 15; k++) {
        tp_drop_step(&drop, &usual, G, 0, ++tick, &impact);
        most = drop.squash > most ? drop.squash : most;
        assert_in_range(drop.squash + 8192, 0, 16384);
    }
    assert_true(most > 0);
}

/* -- all values in range ------------------------------------------------------------- */

/* Levels, gravities and configs that change at every tick, for the sanitizers. */
static void nothing_in_the_ranges_goes_astray(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        tp_scene_drops c = any_config(&chance);
        tp_drop drop = drop_at(&c, c.y * LSB);
        uint64_t tick = random_next(&chance) >> 20;
        tp_fx level = 0;
        for (int k = 0; k < 200; k++) {
            tp_impact impact = { .amplitude = 0 };
            const tp_fx radius = drop.radius;
            if (k % 16 == 0)
                c = any_config(&chance);
            level = k % 7 ? level + random_number(&chance) % 20000
                          : random_number(&chance) / 2;
            level = tp_clamp(level, -HIGH_MOST, HIGH_MOST);
            const tp_fx gravity = chance_scale(&chance, 0.1, 100);
            tp_drop_step(&drop, &c, gravity, level, ++tick, &impact);
            if (radius > 0)
                assert_true(drop.place.y >= level);
            assert_true(drop.radius >= 0 && drop.radius <= radius);
            assert_true(tp_abs(drop.fall_q24) <= 127 << 24);
            assert_in_range(drop.squash + 8192, 0, 16384);
            assert_in_range(impact.amplitude, 0, TP_FX_ONE);
            assert_true(impact.lost >= 0 && impact.uncapped_q24 >= 0);
        }
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_wave_swallows_a_drop),
        cmocka_unit_test(evenly_moving_water_is_still_water),
        cmocka_unit_test(a_leap_of_the_level_throws_no_drop),
        cmocka_unit_test(no_bounce_gains_speed),
        cmocka_unit_test(a_fast_drop_is_long_and_an_impact_flattens_it),
        cmocka_unit_test(nothing_in_the_ranges_goes_astray),
    };
    return cmocka_run_group_tests_name("features/drops water", tests, NULL, NULL);
}
