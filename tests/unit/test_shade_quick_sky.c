/* SPDX-License-Identifier: MIT */
/* The quick sky of a dome against the exact one, and however runs are cut. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "shade/quick_sky.h"
#include "skies.h"

static uint64_t chance;
static test_sky sky;

/* As cameras look up, near the sun too: a picture of 640 columns at 60 degrees. */
static tp_shade shade_for(int32_t focal)
{
    tp_shade s = shade_any(&chance);

    sky_dome(&sky, &s, &chance);
    s.env.beyond = 0;
    s.focal = focal * 16;
    s.per_focal = (uint32_t)(((uint64_t)1 << 32) / (uint32_t)s.focal);
    return s;
}

static void both_fills_have_the_same_bits(void **state)
{
    (void)state;
    for (int n = 0; n < 100000; n++) {
        const uint32_t a = (uint32_t)random_next(&chance) & 0xffffff;
        const uint32_t b = (uint32_t)random_next(&chance) & 0xffffff;
        const int32_t k = chance_int(&chance, 0, 15);
        const int32_t end = chance_int(&chance, k + 1, 16);
        uint32_t plain[16], packed[16];
        tp_plain_fill(plain, tp_quick_between(a, b), k, end);
        tp_packed_fill(packed, tp_quick_between(a, b), k, end);
        assert_memory_equal(plain, packed, (size_t)(end - k) * 4);
        assert_true(k > 0 || plain[0] == a);
    }
}

static void where_a_run_is_cut_does_not_show(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        const tp_shade s = shade_for(554);
        test_run r;
        run_any(&r, 0, &chance);
        const int32_t cut = chance_int(&chance, 1, TP_RUN - 1);
        tp_run left = run_part(&r.run, 0, cut), right = run_part(&r.run, cut, TP_RUN);
        tp_stage_quick_sky_dome(&s, &r.run);
        tp_stage_quick_sky_dome(&s, &left);
        tp_stage_quick_sky_dome(&s, &right);
        assert_memory_equal(r.run.colour, left.colour, (size_t)cut * 4);
        assert_memory_equal(r.run.colour + cut, right.colour, (size_t)(TP_RUN - cut) * 4);
    }
}

static void compare(const char *what, int32_t focal, double most)
{
    tally off = { .what = what };

    for (int n = 0; n < 4000; n++) {
        const tp_shade s = shade_for(focal);
        test_run r;
        run_any(&r, 0, &chance);
        tp_run quick = r.run;
        tp_stage_sky_dome(&s, &r.run);
        tp_stage_quick_sky_dome(&s, &quick);
        for (int i = 0; i < TP_RUN; i++)
            if (r.run.vy[i] < -100)
                tally_add(&off, quick.colour[i], ref_colour_of(r.run.colour[i]));
    }
    tally_print(&off);
    assert_true(tally_rms(&off) < most);
}

static void it_is_the_sky_that_it_was(void **state)
{
    (void)state;
    compare("640 columns", 554, 1.5);
    compare("320 columns", 277, 1.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_fills_have_the_same_bits),
        cmocka_unit_test(where_a_run_is_cut_does_not_show),
        cmocka_unit_test(it_is_the_sky_that_it_was),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("shade_quick_sky", tests, NULL, NULL);
}
