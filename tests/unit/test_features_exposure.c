/* SPDX-License-Identifier: MIT */
/* The exposure curve as a table, compared with its formula in double precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/exposure/exposure.h"
#include "tests/lib/shading.h"

static uint64_t chance;

static double exposed(double e, double t)
{
    return e * t / (1 + (e - 1) * (e > 1 ? t : t * t * t * t));
}

static void tones_follow_their_formula(void **state)
{
    (void)state;
    colour_error off = { .what = "exposure" };

    for (int n = 0; n < 1000; n++) {
        const tp_fx e = chance_scale(&chance, 0.125, 8);
        tp_tones tones;
        const tp_exposure exposure = { .tones = &tones };
        const tp_shade s = { .focal = 16 };
        test_run r;
        tp_exposure_make_tone_curve(tones.tone, e);
        run_any(&r, 0, &chance);
        r.run.mine = &exposure;
        const tp_run before = r.run;
        tp_stage_expose(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            ref_colour c = ref_colour_unpack(before.colour[i]);
            for (int k = 0; k < 3; k++)
                c.c[k] = 255 * exposed(e / 65536.0, c.c[k] / 255);
            colour_error_add(&off, r.run.colour[i], c);
        }
    }
    colour_error_print(&off);
    assert_true(off.largest <= 0.6);
}

static void an_exposure_of_1_is_nothing_and_white_stays_white(void **state)
{
    (void)state;
    tp_entry8 tone[256];

    tp_exposure_make_tone_curve(tone, TP_FX_ONE);
    for (int i = 0; i < 256; i++)
        assert_int_equal(tone[i], i);
    for (tp_fx e = TP_FX_ONE / 8; e <= 8 * TP_FX_ONE; e += 997) {
        tp_exposure_make_tone_curve(tone, e);
        assert_int_equal(tone[0], 0);
        assert_int_equal(tone[255], 255);
        for (int i = 1; i < 256; i++)
            assert_true(tone[i] >= tone[i - 1]);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tones_follow_their_formula),
        cmocka_unit_test(an_exposure_of_1_is_nothing_and_white_stays_white),
    };
    return cmocka_run_group_tests_name("features/exposure", tests, NULL, NULL);
}
