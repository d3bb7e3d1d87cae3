/* SPDX-License-Identifier: MIT */
/* The governor, driven by scripted frame times: the cost of each rung, and the load of each
 * frame. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/random.h"
#include "quality/plan.h"

static uint64_t chance;

/* Rungs that differ only in their number. */
static tp_ladder ladder_of(uint32_t count)
{
    tp_ladder ladder = { .count = count };

    for (uint32_t i = 0; i < count; i++)
        ladder.rung[i].rate = (tp_rate)i;
    return ladder;
}

typedef struct {
    tp_governor governor;
    uint32_t steps, down;       /* steps taken */
    uint32_t last;              /* frame of the last step */
    uint32_t frame;
} drive;

static drive drive_of(uint32_t rungs, uint32_t limit)
{
    const tp_ladder ladder = ladder_of(rungs);
    drive d = { .steps = 0 };

    tp_governor_init(&d.governor, &ladder, limit);
    return d;
}

static const uint32_t share[] = { 100, 70, 60, 30 };       /* cost of a rung, percent */

/* Feeds frames.  `load`: time of the first rung, us; `noise`: variation in percent, up and
 * down. */
static void run(drive *d, uint32_t frames, uint32_t load, int32_t noise)
{
    for (uint32_t i = 0; i < frames; i++, d->frame++) {
        const int32_t swing = 100 + chance_int(&chance, -noise, noise);
        const int step = tp_governor_add_frame_time(
            &d->governor, load * share[d->governor.at] / 100 * (uint32_t)swing / 100);
        assert_true(d->governor.at < d->governor.ladder.count);
        d->steps += step != 0;
        d->down += step > 0;
        d->last = step ? d->frame : d->last;
    }
}

static void a_limit_of_0_changes_nothing(void **state)
{
    drive d = drive_of(4, 0);

    (void)state;
    run(&d, 5000, 1000000, 50);
    assert_int_equal(d.steps, 0);
    assert_int_equal(tp_governor_rungs(&d.governor).rate, 0);
}

static void one_rung_is_never_left(void **state)
{
    drive d = drive_of(1, 33000);

    (void)state;
    run(&d, 5000, 1000000, 50);
    assert_int_equal(d.steps, 0);
}

static void a_frame_within_the_limit_stays_as_planned(void **state)
{
    drive d = drive_of(4, 33000);

    (void)state;
    run(&d, 5000, 30000, 5);
    assert_int_equal(d.steps, 0);
}

static void it_settles_on_the_first_rung_that_keeps_the_limit(void **state)
{
    static const struct { uint32_t load, rung; } rows[] = {
        { 34000, 1 }, { 41000, 1 }, { 50000, 2 }, { 60000, 3 }, { 100000, 3 },
        { 1000000, 3 },         /* no rung holds the budget */
    };

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        drive d = drive_of(4, 33000);
        run(&d, 6000, rows[i].load, 2);
        assert_int_equal(d.governor.at, rows[i].rung);
        assert_int_equal(d.steps, rows[i].rung);
        assert_true(d.last < 40);               /* two thirds of a second */
    }
}

/* Holds for any load that stays within its noise. */
static void it_does_not_swing(void **state)
{
    (void)state;
    for (int i = 0; i < 500; i++) {
        const uint32_t load = 20000 + random_below(&chance, 130000);
        drive d = drive_of(4, 33000);
        run(&d, 600, load, 8);
        const uint32_t then = d.steps;
        run(&d, 6000, load, 8);
        assert_true(d.steps - then <= 2);       /* the last window may be on the limit */
    }
}

static void one_late_frame_changes_nothing(void **state)
{
    drive d = drive_of(4, 33000);

    (void)state;
    for (int i = 0; i < 100; i++) {
        run(&d, 40, 25000, 2);
        run(&d, 1, 80000, 0);
    }
    assert_int_equal(d.steps, 0);
}

static void it_comes_back_when_the_load_has_gone(void **state)
{
    drive d = drive_of(4, 33000);

    (void)state;
    run(&d, 600, 100000, 4);
    assert_int_equal(d.governor.at, 3);
    run(&d, 400, 20000, 4);
    assert_int_equal(d.governor.at, 0);
    assert_int_equal(d.steps, 6);
    run(&d, 600, 41000, 4);
    assert_int_equal(d.governor.at, 1);
    assert_int_equal(d.steps, 7);
}

/* The step was measured under a falling load, so the measurement must not last forever. */
static void a_step_under_a_falling_load_is_undone(void **state)
{
    drive d = drive_of(2, 33000);

    (void)state;
    run(&d, 8, 1000000, 0);
    assert_int_equal(d.governor.at, 1);
    run(&d, 200, 8000, 0);
    assert_int_equal(d.governor.at, 0);
}

static void any_times_are_safe(void **state)
{
    static const uint32_t ends[] = { 0, 1, 33000, 0x7fffffff, 0xffffffff };

    (void)state;
    for (int i = 0; i < 200; i++) {
        drive d = drive_of(1 + random_below(&chance, 4), ends[random_below(&chance, 5)]);
        for (int k = 0; k < 2000; k++) {
            const int step =
                tp_governor_add_frame_time(&d.governor, ends[random_below(&chance, 5)]);
            assert_true(step >= -1 && step <= 1);
            assert_true(d.governor.at < d.governor.ladder.count);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_limit_of_0_changes_nothing),
        cmocka_unit_test(one_rung_is_never_left),
        cmocka_unit_test(a_frame_within_the_limit_stays_as_planned),
        cmocka_unit_test(it_settles_on_the_first_rung_that_keeps_the_limit),
        cmocka_unit_test(it_does_not_swing),
        cmocka_unit_test(one_late_frame_changes_nothing),
        cmocka_unit_test(it_comes_back_when_the_load_has_gone),
        cmocka_unit_test(a_step_under_a_falling_load_is_undone),
        cmocka_unit_test(any_times_are_safe),
    };

    chance = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
