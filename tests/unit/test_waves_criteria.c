/* SPDX-License-Identifier: MIT */
/* Breaking and its type, compared with the models' vectors and formulas. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/finite_depth.h"
#include "tests/lib/random.h"
#include "tests/lib/vectors.h"
#include "waves/coastal_water.h"

#define LSB (1 / 65536.0)

static uint64_t chance;

/* Asserts that `got` is true exactly if x is above `limit`, except within a rounding of the
 * limit. */
static void check_flag(uint32_t got, double want, double x, double limit, uint32_t *close)
{
    if (fabs(x / limit - 1) < 1e-4)
        ++*close;
    else
        assert_int_equal(got != 0, want != 0);
}

/* T, H0, h, slope, k, Ks, H, H/L, H/h, steep, depth, miche, H_miche, xi0, type. */
static void criteria_follow_their_vectors(void **state)
{
    (void)state;
    FILE *const file = fopen("tests/vectors/breaking_criteria.csv", "r");
    measure miche = { .what = "Miche's height", .unit = "%" };
    measure shoaling = { .what = "Ks", .unit = "%" };
    measure xi = { .what = "xi0", .unit = "LSB + 1e-4" };
    const char *const names[] = { "spilling", "plunging", "surging" };
    uint32_t close = 0;
    double v[14];
    char word[16];
    int64_t rows = 0;

    assert_non_null(file);
    while (csv_row_word(file, v, 14, word) == 14) {
        const double k_inf = REF_TWO_PI / v[0] * (REF_TWO_PI / v[0]) / 9.81;
        const tp_fx h = (tp_fx)lround(v[2] * 65536), height = (tp_fx)lround(v[6] * 65536);
        const int64_t deep = ref_to_q32(k_inf), k = tp_depth_wave_number(deep, h);
        const uint32_t flags = tp_breaking_flags(height, k, h);
        const tp_fx xi0 = tp_iribarren((tp_q30)lround(v[3] * 1073741824),
                                       (tp_fx)lround(v[1] * 65536),
                                       (tp_fx)lround(REF_TWO_PI / k_inf * 65536));

        check_flag(flags & TP_BREAKING_STEEP, v[9], v[7], 1 / 7.0, &close);
        check_flag(flags & TP_BREAKING_DEPTH, v[10], v[8], 0.78, &close);
        check_flag(flags & TP_BREAKING_MICHE, v[11], v[6], v[12], &close);
        measure_add(&miche, 100 * (tp_miche_height(k, h) * LSB / v[12] - 1), rows, 0, 0);
        measure_add(&shoaling,
                    100 * (tp_depth_shoaling_factor(deep, k, h) * LSB / v[5] - 1), rows,
                    0, 0);
        measure_add(&xi, (xi0 * LSB - v[13]) / (LSB + 1e-4 * v[13]), rows, 0, 0);
        assert_string_equal(names[tp_breaker_classify(xi0)], word);
        rows++;
    }
    fclose(file);
    measure_print(&miche);
    measure_print(&shoaling);
    measure_print(&xi);
    printf("    %u flags too close to tell\n", close);
    assert_int_equal(rows, 150);
    assert_true(close < 5);
    assert_true(miche.worst < 0.1 && shoaling.worst < 0.1 && xi.worst < 1);
}

static void miche_holds_from_films_to_deep_water(void **state)
{
    (void)state;
    measure m = { .what = "Miche's height", .unit = "LSB, 2^-24" };

    for (int i = 0; i < 20000; i++) {
        const int64_t k = tp_depth_wave_number_deep(chance_scale(&chance, 0.25, 2000));
        const tp_fx h = chance_scale(&chance, LSB, 8000);
        const double n = ref_q32(k), want = 0.142 * REF_TWO_PI / n * tanh(n * h * LSB);
        const double error = fabs(tp_miche_height(k, h) * LSB - want);
        measure_add(&m, error / (LSB / 2 + want / 16777216), k, h, 0);

        const tp_fx height = chance_scale(&chance, 0.001, 300);
        const double steep = height * LSB * n / REF_TWO_PI;
        const uint32_t flags = tp_breaking_flags(height, k, h);
        uint32_t close = 0;
        check_flag(flags & TP_BREAKING_STEEP, steep > 1 / 7.0, steep, 1 / 7.0, &close);
        check_flag(flags & TP_BREAKING_DEPTH, height > 0.78 * h, height, 0.78 * h,
                   &close);
        check_flag(flags & TP_BREAKING_MICHE, height * LSB > want, height * LSB, want,
                   &close);
    }
    measure_print(&m);
    assert_true(m.worst < 1.1);
}

static void thresholds_are_not_above_themselves(void **state)
{
    (void)state;
    assert_int_equal(tp_breaking_flags(TP_FX(78), 0, TP_FX(100)), 0);
    assert_int_equal(tp_breaking_flags(TP_FX(78) + 1, 0, TP_FX(100)), TP_BREAKING_DEPTH);
    assert_int_equal(tp_breaker_classify(TP_FX(0.5) - 1), TP_BREAKER_SPILLING);
    assert_int_equal(tp_breaker_classify(TP_FX(0.5)), TP_BREAKER_PLUNGING);
    assert_int_equal(tp_breaker_classify(TP_FX(3.3)), TP_BREAKER_PLUNGING);
    assert_int_equal(tp_breaker_classify(TP_FX(3.3) + 1), TP_BREAKER_SURGING);
}

static void what_has_no_height_does_not_break_and_what_has_no_depth_does(void **state)
{
    (void)state;
    const int64_t k = tp_depth_wave_number_deep(TP_FX(10));

    assert_int_equal(tp_breaking_flags(0, k, 0), 0);
    assert_int_equal(tp_breaking_flags(TP_FX_MIN, k, TP_FX_MIN), 0);
    assert_int_equal(tp_breaking_flags(1, k, 0), TP_BREAKING_DEPTH | TP_BREAKING_MICHE);
    assert_int_equal(tp_breaking_flags(TP_FX(2), k, TP_FX_MIN),
                     TP_BREAKING_STEEP | TP_BREAKING_DEPTH | TP_BREAKING_MICHE);
    assert_int_equal(tp_miche_height(k, 0), 0);
    assert_int_equal(tp_miche_height(k, TP_FX_MIN), 0);
    assert_int_equal(tp_iribarren(TP_Q30(0.1), 0, TP_FX(10)), TP_FX_MAX);
    assert_int_equal(tp_iribarren(TP_Q30(0.1), -1, TP_FX(10)), TP_FX_MAX);
    assert_int_equal(tp_iribarren(0, TP_FX(1), TP_FX(10)), 0);
    assert_int_equal(tp_iribarren(TP_Q30(0.1), TP_FX(1), 0), 0);
    assert_int_equal(tp_iribarren(INT32_MIN, INT32_MIN, INT32_MIN), 0);
}

static void any_words_are_accepted(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; i++) {
        const int64_t k = (int64_t)random_next(&chance) >> (random_next(&chance) & 63);
        const tp_fx a = random_number(&chance), b = random_number(&chance);

        assert_in_range(tp_breaking_flags(a, k, b), 0, 7);
        assert_true(tp_miche_height(k, a) >= 0);
        assert_true(tp_iribarren(a, b, random_number(&chance)) >= 0);
        assert_in_range(tp_breaker_classify(a), TP_BREAKER_SPILLING, TP_BREAKER_SURGING);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(criteria_follow_their_vectors),
        cmocka_unit_test(miche_holds_from_films_to_deep_water),
        cmocka_unit_test(thresholds_are_not_above_themselves),
        cmocka_unit_test(what_has_no_height_does_not_break_and_what_has_no_depth_does),
        cmocka_unit_test(any_words_are_accepted),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("waves/criteria", tests, NULL, NULL);
}
