/* SPDX-License-Identifier: MIT */
/* The governor, driven by scripted frame times: the cost of each step, and the load of each
 * frame. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/random.h"
#include "quality/plan.h"

static uint64_t chance;

static const uint32_t share[] = { 100, 70, 60, 30 };       /* cost of a step, percent */

/* A walk whose estimates are `estimate`, percent. */
static tp_set_walk walk_of(uint32_t count, const uint32_t estimate[])
{
    tp_set_walk walk = { .count = count };

    for (uint32_t i = 0; i < count; i++)
        walk.price[i].cost = (uint64_t)estimate[i] << 24;
    return walk;
}

typedef struct {
    tp_governor governor;
    uint32_t steps, down;       /* steps taken */
    uint32_t last;              /* frame of the last step */
    uint32_t frame;
} drive;

static drive drive_by(uint32_t steps, uint32_t limit, const uint32_t estimate[])
{
    const tp_set_walk walk = walk_of(steps, estimate);
    drive d = { .steps = 0 };

    tp_governor_init(&d.governor, &walk, limit);
    return d;
}

static drive drive_of(uint32_t steps, uint32_t limit)
{
    return drive_by(steps, limit, share);
}

/* Feeds frames.  `load`: time of the first step, us; `noise`: variation in percent, up and
 * down. */
static void run(drive *d, uint32_t frames, uint32_t load, int32_t noise)
{
    for (uint32_t i = 0; i < frames; i++, d->frame++) {
        const int32_t swing = 100 + chance_int(&chance, -noise, noise);
        const int step = tp_governor_add_frame_time(
            &d->governor, load * share[d->governor.at] / 100 * (uint32_t)swing / 100);
        assert_true(d->governor.at < d->governor.steps);
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
    assert_int_equal(d.governor.at, 0);
}

static void one_step_is_never_left(void **state)
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

static void it_goes_at_once_to_the_first_step_that_keeps_the_limit(void **state)
{
    static const struct { uint32_t load, step; } rows[] = {
        { 34000, 1 }, { 41000, 1 }, { 50000, 2 }, { 60000, 3 }, { 100000, 3 },
        { 1000000, 3 },         /* no step holds the limit */
    };

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        drive d = drive_of(4, 33000);
        run(&d, 6000, rows[i].load, 2);
        assert_int_equal(d.governor.at, rows[i].step);
        assert_int_equal(d.steps, 1);
        assert_true(d.last < 10);               /* a window, and frames that settle */
    }
}

/* Holds for any load that stays within its noise, and for any estimates of the costs. */
static void it_does_not_swing(void **state)
{
    (void)state;
    for (int i = 0; i < 500; i++) {
        const uint32_t load = 20000 + random_below(&chance, 130000);
        uint32_t estimate[4] = { 100 };
        for (int k = 1; k < 4; k++)
            estimate[k] = 1 + random_below(&chance, estimate[k - 1]);
        drive d = drive_by(4, 33000, estimate);
        run(&d, 2000, load, 8);
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
    assert_int_equal(d.steps, 4);               /* down at once, up by single steps */
    run(&d, 600, 41000, 4);
    assert_int_equal(d.governor.at, 1);
    assert_int_equal(d.steps, 5);
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
            assert_true(step >= -1 && step <= 3);
            assert_true(d.governor.at < d.governor.steps);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_limit_of_0_changes_nothing),
        cmocka_unit_test(one_step_is_never_left),
        cmocka_unit_test(a_frame_within_the_limit_stays_as_planned),
        cmocka_unit_test(it_goes_at_once_to_the_first_step_that_keeps_the_limit),
        cmocka_unit_test(it_does_not_swing),
        cmocka_unit_test(one_late_frame_changes_nothing),
        cmocka_unit_test(it_comes_back_when_the_load_has_gone),
        cmocka_unit_test(a_step_under_a_falling_load_is_undone),
        cmocka_unit_test(any_times_are_safe),
    };

    chance = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
