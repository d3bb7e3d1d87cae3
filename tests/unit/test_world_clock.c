/* SPDX-License-Identifier: MIT */
/* The clock compared with [D6] in double precision and with the models' vectors. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/random.h"
#include "tests/lib/vectors.h"
#include "world/world.h"

#define LSB   (1 / 65536.0)
#define SLIDE 0.040810542890861656      /* 1 - exp(-1/24) */

static uint64_t chance;

static double scale_of(const tp_clock *clock)
{
    return (double)clock->scale_q40 / 1099511627776.0;
}

static double time_of(const tp_clock *clock)
{
    return (double)clock->ticks + (double)clock->fraction_q40 / 1099511627776.0;
}

/* Rows: frame, target, scale, acc, n, total. */
static void rows_of_the_models_agree(void **state)
{
    (void)state;
    FILE *const file = fopen("tests/vectors/time_scale.csv", "r");
    assert_non_null(file);
    measure scale = { .what = "scale", .unit = "" };
    measure time = { .what = "time", .unit = "ticks" };
    uint64_t apart = 0;
    tp_clock clock;
    double v[6];

    tp_clock_init(&clock, TP_FX_ONE);
    while (csv_row(file, v, 6) == 6) {
        const int64_t total = (int64_t)v[5];
        tp_clock_set_target(&clock, (tp_fx)lround(v[1] * 65536));
        tp_clock_advance(&clock);
        measure_add(&scale, scale_of(&clock) - v[2], (int64_t)v[0], 0, 0);
        measure_add(&time, time_of(&clock) - (v[5] + v[3]), (int64_t)v[0], 0, 0);
        assert_true(llabs((int64_t)tp_clock_ticks(&clock) - total) <= 1);
        apart += (int64_t)tp_clock_ticks(&clock) != total;
    }
    fclose(file);
    measure_print(&scale);
    measure_print(&time);
    printf("    totals that differ %10d of %d\n", (int)apart, (int)scale.inputs);
    assert_int_equal(scale.inputs, 200);
    assert_true(scale.worst < 1e-4);
    assert_true(time.worst < 1e-3);
}

/* An hour of pictures with a target that jumps.  The sum of s stays within the loss by
 * snapping: 2 LSB of s for each change of target, over 24 pictures. */
static void any_targets_follow_the_models(void **state)
{
    (void)state;
    measure time = { .what = "an hour", .unit = "ticks" };
    tp_clock clock;
    double s = 1, sum = 0;
    int changes = 0;

    tp_clock_init(&clock, TP_FX_ONE);
    for (int n = 0; n < 216000; n++) {
        if (random_below(&chance, 200) == 0) {
            tp_clock_set_target(&clock, chance_scale(&chance, 0.1, 5));
            changes++;
        }
        tp_clock_advance(&clock);
        s += (clock.target * LSB - s) * SLIDE;
        sum += s;
        /* 2 LSB by a snap, and at most the same amount left over from the preceding
         * snap. */
        assert_true(fabs(scale_of(&clock) - s) <= 4 * LSB);
        assert_true(fabs(time_of(&clock) - sum) <= (changes + 1) * 50 * LSB);
        measure_add(&time, time_of(&clock) - sum, n, 0, 0);
    }
    measure_print(&time);
}

static void the_target_is_reached_exactly_and_kept(void **state)
{
    (void)state;
    for (int n = 0; n < 1000; n++) {
        const tp_fx from = chance_scale(&chance, 0.125, 4);
        const tp_fx to = chance_scale(&chance, 0.125, 4);
        tp_clock clock;
        int pictures = 0;
        tp_clock_init(&clock, from);
        tp_clock_set_target(&clock, to);
        for (; clock.scale_q40 != (int64_t)to * (1 << 24); pictures++) {
            const double before = fabs(scale_of(&clock) - to * LSB);
            tp_clock_advance(&clock);
            assert_true(fabs(scale_of(&clock) - to * LSB) < before);
        }
        /* ln(4 / 2 LSB) / (1/24) = 283 pictures, 5 s, from one end to the other. */
        assert_in_range(pictures, 0, 285);
        tp_clock_advance(&clock);
        assert_int_equal(tp_clock_scale(&clock), to);
    }
}

static void targets_are_held_between_the_ends(void **state)
{
    (void)state;
    tp_clock clock;
    tp_clock_init(&clock, 0);
    assert_int_equal(clock.target, TP_CLOCK_SLOWEST);
    assert_int_equal(tp_clock_scale(&clock), TP_CLOCK_SLOWEST);
    tp_clock_init(&clock, TP_FX_MAX);
    assert_int_equal(tp_clock_scale(&clock), TP_CLOCK_FASTEST);
    tp_clock_set_target(&clock, TP_FX_MIN);
    assert_int_equal(clock.target, TP_CLOCK_SLOWEST);
    tp_clock_set_target(&clock, TP_FX(5));
    assert_int_equal(clock.target, TP_CLOCK_FASTEST);
}

static void steps_halve_and_double_the_target(void **state)
{
    (void)state;
    tp_clock clock;
    tp_clock_init(&clock, TP_FX_ONE);
    tp_clock_shift_target(&clock, 1);
    assert_int_equal(clock.target, TP_FX_ONE / 2);
    tp_clock_shift_target(&clock, -2);
    assert_int_equal(clock.target, 2 * TP_FX_ONE);
    tp_clock_shift_target(&clock, INT32_MAX);
    assert_int_equal(clock.target, TP_CLOCK_SLOWEST);
    tp_clock_shift_target(&clock, INT32_MIN);
    assert_int_equal(clock.target, TP_CLOCK_FASTEST);
    tp_clock_shift_target(&clock, 0);
    assert_int_equal(clock.target, TP_CLOCK_FASTEST);
}

static void at_scale_one_a_picture_is_a_tick(void **state)
{
    (void)state;
    tp_clock clock;
    tp_clock_init(&clock, TP_FX_ONE);
    for (uint64_t n = 1; n < 1000; n++) {
        tp_clock_advance(&clock);
        assert_int_equal(tp_clock_ticks(&clock), n);
        assert_int_equal(tp_clock_fraction(&clock), 0);
    }
}

/* At scale 1/8 each picture is an eighth of a tick further: slow motion is smooth. */
static void the_fraction_glides_between_ticks(void **state)
{
    (void)state;
    tp_clock clock;
    tp_clock_init(&clock, TP_CLOCK_SLOWEST);
    for (uint32_t n = 1; n < 1000; n++) {
        tp_clock_advance(&clock);
        assert_int_equal(tp_clock_ticks(&clock), n / 8);
        assert_int_equal(tp_clock_fraction(&clock), n % 8 * (TP_FX_ONE / 8));
    }
}

static void ticks_go_on_beyond_years(void **state)
{
    (void)state;
    tp_clock clock;
    tp_clock_init(&clock, TP_CLOCK_FASTEST);
    clock.ticks = (uint64_t)1 << 40;
    tp_clock_advance(&clock);
    assert_true(tp_clock_ticks(&clock) == ((uint64_t)1 << 40) + 4);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_of_the_models_agree),
        cmocka_unit_test(any_targets_follow_the_models),
        cmocka_unit_test(the_target_is_reached_exactly_and_kept),
        cmocka_unit_test(targets_are_held_between_the_ends),
        cmocka_unit_test(steps_halve_and_double_the_target),
        cmocka_unit_test(at_scale_one_a_picture_is_a_tick),
        cmocka_unit_test(the_fraction_glides_between_ticks),
        cmocka_unit_test(ticks_go_on_beyond_years),
    };
    return cmocka_run_group_tests_name("world/clock", tests, NULL, NULL);
}
