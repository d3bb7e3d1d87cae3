/* SPDX-License-Identifier: MIT */
/* Slope variance of filtered waves by depth: rows of a grid, from near to far, fill every
 * entry; entries between two rows lie between them. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "view/rough.h"
#include "tests/lib/measure.h"

static tp_filtered_waves waves;
static uint64_t chance;

static void add(double depth, uint32_t along)
{
    tp_filtered_waves_add_row(&waves, TP_FX(depth),
                              (tp_slope_variance){ along, along / 2, along });
}

static void no_rows_and_no_waves_are_smooth(void **state)
{
    (void)state;
    tp_filtered_waves_clear(&waves);
    tp_filtered_waves_finish(&waves);
    assert_int_equal(tp_filtered_waves_lookup(&waves, 1000).along, 0);
    assert_int_equal(tp_filtered_waves_lookup(NULL, 1000).across, 0);
}

static void rows_are_found_at_their_depths(void **state)
{
    (void)state;
    tp_filtered_waves_clear(&waves);
    add(4, 1000);
    add(64, 5000);
    tp_filtered_waves_finish(&waves);
    assert_int_equal(tp_filtered_waves_lookup(&waves, -256).along, 1000);   /* 1/2 m */
    assert_int_equal(tp_filtered_waves_lookup(&waves, 2 * 256).along, 1000);
    assert_int_equal(tp_filtered_waves_lookup(&waves, 4 * 256).along, 3000);
    assert_int_equal(tp_filtered_waves_lookup(&waves, 4 * 256).across, 1500);
    assert_int_equal(tp_filtered_waves_lookup(&waves, 4 * 256 + 32).along, 3125);
    assert_int_equal(tp_filtered_waves_lookup(&waves, 20 * 256).along, 5000);
}

static void random_rows_keep_their_order(void **state)
{
    uint32_t most;

    (void)state;
    for (int n = 0; n < 200; n++) {
        double depth = chance_double(&chance, 0.01, 2), variance = 0;
        tp_filtered_waves_clear(&waves);
        while (depth < 32000) {
            add(depth, (uint32_t)variance);
            depth *= chance_double(&chance, 1.1, 3);
            variance += chance_double(&chance, 0, 100000);
        }
        most = (uint32_t)variance;
        tp_filtered_waves_finish(&waves);
        for (int32_t log = -2000; log < 5000; log++) {
            uint32_t here = tp_filtered_waves_lookup(&waves, log).along;
            assert_true(here <= tp_filtered_waves_lookup(&waves, log + 1).along);
            assert_true(here <= most);
        }
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_rows_and_no_waves_are_smooth),
        cmocka_unit_test(rows_are_found_at_their_depths),
        cmocka_unit_test(random_rows_keep_their_order),
    };
    return cmocka_run_group_tests_name("view/rough", tests, NULL, NULL);
}
