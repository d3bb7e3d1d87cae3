/* SPDX-License-Identifier: MIT */
/* Wave numbers over a depth compared with the models' vectors and with bisection in double
 * precision, over the whole range of lengths and of depths. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/finite_depth.h"
#include "tests/lib/random.h"
#include "tests/lib/vectors.h"
#include "waves/coastal_water.h"
#include "waves/softfloat.h"

#define LSB   (1 / 65536.0)
#define LSB32 (1 / 4294967296.0)

static uint64_t chance;

static FILE *vectors(const char *path)
{
    FILE *const file = fopen(path, "r");
    assert_non_null(file);
    return file;
}

static double apart(double got, double want)
{
    return got / want - 1;
}

/* Every column, from k_inf and h in the core's formats: h in 16.16 has a relative error of
 * 7e-5 at the vectors' minimum, 0.11 m; k has half of this error. */
static void dispersion_follows_its_vectors(void **state)
{
    (void)state;
    FILE *const file = vectors("tests/vectors/dispersion.csv");
    measure quick = { .what = "k [B6]", .unit = "%" };
    measure step = { .what = "against k_newton", .unit = "%" };
    measure exact = { .what = "k exact", .unit = "%" };
    measure eckart = { .what = "k [B4]", .unit = "%" };
    measure fenton = { .what = "k [B5]", .unit = "%" };
    measure speed = { .what = "c, cg", .unit = "%" };
    measure shoaling = { .what = "Ks", .unit = "%" };
    double v[12];
    char word[16];
    int64_t rows = 0;

    while (csv_row_word(file, v, 12, word) == 12) {
        const int64_t k_inf = ref_to_q32(v[3]);
        const tp_fx h = (tp_fx)lround(v[1] * 65536), g = TP_FX(9.81);
        const int64_t k = tp_depth_wave_number(k_inf, h);
        const int64_t fine = tp_depth_wave_number_exact(k_inf, h);
        const char *const names[] = { "shallow", "transition", "deep" };

        measure_add(&quick, 100 * apart(ref_q32(k), v[4]), rows, 0, 0);
        measure_add(&step, 100 * apart(ref_q32(k), v[7]), rows, 0, 0);
        measure_add(&exact, 100 * apart(ref_q32(fine), v[4]), rows, 0, 0);
        measure_add(&eckart,
                    100 * apart(ref_q32(tp_depth_wave_number_eckart(k_inf, h)), v[5]),
                    rows, 0, 0);
        measure_add(&fenton,
                    100 * apart(ref_q32(tp_depth_wave_number_fenton(k_inf, h)), v[6]),
                    rows, 0, 0);
        measure_add(&speed, 100 * apart(tp_depth_speed(k_inf, fine, g) * LSB, v[9]), rows,
                    0, 0);
        measure_add(&speed, 100 * apart(tp_depth_group_speed(k_inf, fine, h, g) * LSB,
                                        v[10]), rows, 1, 0);
        measure_add(&shoaling,
                    100 * apart(tp_depth_shoaling_factor(k_inf, k, h) * LSB, v[11]), rows,
                    0, 0);
        assert_string_equal(names[tp_depth_classify(fine, h)], word);
        rows++;
    }
    fclose(file);
    assert_int_equal(rows, 200);
    const measure *const all[] = { &quick, &step, &exact, &eckart, &fenton, &speed,
                                   &shoaling };
    for (int i = 0; i < 7; i++)
        measure_print(all[i]);
    assert_true(quick.worst < 0.06);
    assert_true(step.worst < 0.004);
    assert_true(exact.worst < 0.004 && eckart.worst < 0.004 && fenton.worst < 0.004);
    assert_true(speed.worst < 0.004 && shoaling.worst < 0.1);
}

static int64_t chance_k_inf(void)
{
    return tp_depth_wave_number_deep(chance_scale(&chance, 0.25, 2000));
}

static void four_methods_err_as_the_models_say(void **state)
{
    (void)state;
    measure m[] = { { .what = "Eckart", .unit = "%" }, { .what = "Fenton", .unit = "%" },
                    { .what = "usual", .unit = "%" },
                    { .what = "exact, half units off", .unit = "of itself" } };

    for (int i = 0; i < 20000; i++) {
        const int64_t k_inf = chance_k_inf();
        const tp_fx h = chance_scale(&chance, 1 / 65536.0, i % 2 ? 8000 : 200);
        const double want = ref_depth_number(ref_q32(k_inf), h * LSB);
        const double k[] = { ref_q32(tp_depth_wave_number_eckart(k_inf, h)),
                             ref_q32(tp_depth_wave_number_fenton(k_inf, h)),
                             ref_q32(tp_depth_wave_number(k_inf, h)),
                             ref_q32(tp_depth_wave_number_exact(k_inf, h)) };
        for (int n = 0; n < 3; n++)
            measure_add(&m[n], 100 * apart(k[n], want), k_inf, h, 0);
        measure_add(&m[3], fmax(0, fabs(k[3] - want) - LSB32 / 2) / want, k_inf, h, 0);
        assert_true(k[0] < want * (1 + 1e-7));
    }
    for (int n = 0; n < 4; n++)
        measure_print(&m[n]);
    assert_true(m[0].worst < 4.985 && m[0].worst > 4.9);
    assert_true(m[1].worst < 1.635 && m[1].worst > 1.6);
    assert_true(m[2].worst < 0.0515 && m[2].worst > 0.05);
    assert_true(m[3].worst < 1 / 67108864.0);
}

/* At 2^-16 m all waves are shallow: k = sqrt(k_inf / h) (1 + k_inf h / 6).  At depths above
 * 12 / k_inf waves do not feel the floor at all. */
static void both_ends_of_depth_are_exact(void **state)
{
    (void)state;
    for (int i = 0; i < 2000; i++) {
        const int64_t k_inf = chance_k_inf();
        const double y = ref_q32(k_inf) * LSB;
        const double want = sqrt(ref_q32(k_inf) / LSB) * (1 + y / 6);

        assert_true(fabs(apart(ref_q32(tp_depth_wave_number(k_inf, 1)), want)) < 2e-8);
        if (12 / ref_q32(k_inf) < 32000) {
            const tp_fx deep = (tp_fx)(12.00001 / ref_q32(k_inf) * 65536) + 1;
            assert_int_equal(tp_depth_wave_number(k_inf, deep), k_inf);
            assert_int_equal(tp_depth_wave_number_exact(k_inf, deep), k_inf);
            assert_int_equal(tp_depth_wave_number_exact(k_inf, TP_FX_MAX), k_inf);
            assert_true(labs(tp_depth_wave_number_exact(k_inf, deep - 2) - k_inf)
                        <= 1 + (k_inf >> 25));
        }
    }
}

/* Shoaling never lengthens a wave, except for the formats' rounding. */
static void shallower_is_shorter(void **state)
{
    (void)state;
    for (int i = 0; i < 200; i++) {
        const int64_t k_inf = chance_k_inf();
        int64_t quick = INT64_MAX / 2, exact = INT64_MAX / 2;
        for (double h = 1; h < 2e9; h *= 1.01) {
            const tp_fx depth = (tp_fx)h;
            const int64_t q = tp_depth_wave_number(k_inf, depth);
            const int64_t e = tp_depth_wave_number_exact(k_inf, depth);
            assert_true(q <= quick && e <= exact);
            assert_true(e >= k_inf - (k_inf >> 26));
            quick = q + (q >> 25) + 1;
            exact = e + (e >> 26) + 1;
        }
    }
}

static void regimes_change_at_a_half_and_a_twentieth(void **state)
{
    (void)state;
    const int64_t k = 1000 * tp_depth_wave_number_deep(TP_FX(1000));     /* 2 pi / m */

    assert_int_equal(tp_depth_classify(k, TP_FX(0.51)), TP_DEPTH_DEEP);
    assert_int_equal(tp_depth_classify(k, TP_FX(0.49)), TP_DEPTH_TRANSITION);
    assert_int_equal(tp_depth_classify(k, TP_FX(0.051)), TP_DEPTH_TRANSITION);
    assert_int_equal(tp_depth_classify(k, TP_FX(0.049)), TP_DEPTH_SHALLOW);
    assert_int_equal(tp_depth_classify(k, 1), TP_DEPTH_SHALLOW);
    assert_int_equal(tp_depth_classify(k, TP_FX_MAX), TP_DEPTH_DEEP);
    assert_int_equal(tp_depth_classify(0, TP_FX_MAX), TP_DEPTH_SHALLOW);
}

static void land_counts_as_a_film_of_a_16th(void **state)
{
    (void)state;
    const int64_t k_inf = tp_depth_wave_number_deep(TP_FX(30));
    const int64_t film = tp_depth_wave_number(k_inf, TP_DEPTH_LEAST);

    assert_int_equal(tp_depth_wave_number(k_inf, 0), film);
    assert_int_equal(tp_depth_wave_number(k_inf, TP_FX_MIN), film);
    assert_int_equal(tp_depth_wave_number_fenton(k_inf, -1),
                     tp_depth_wave_number_fenton(k_inf, TP_DEPTH_LEAST));
    assert_int_equal(tp_depth_classify(film, 0), TP_DEPTH_SHALLOW);
    assert_int_equal(tp_depth_shoaling_factor(k_inf, film, -5),
                     tp_depth_shoaling_factor(k_inf, film, TP_DEPTH_LEAST));
}

static int64_t any_word(void)
{
    const uint64_t word = random_next(&chance);
    return (int64_t)word >> (random_next(&chance) & 63);
}

/* The sanitizer build of the test shows that nothing overflows. */
static void any_words_are_accepted(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; i++) {
        const int64_t k_inf = i % 50 ? any_word() : INT64_MAX - i % 3;
        const int64_t other = i % 51 ? any_word() : INT64_MIN;
        const tp_fx h = (tp_fx)any_word();
        const int64_t k = tp_depth_wave_number_exact(k_inf, h);

        assert_true(k >= 0 && (k_inf > 0 || k == 0));
        assert_true(k_inf <= 0 || k >= k_inf - (k_inf >> 26) - 1);
        assert_true(tp_depth_wave_number_eckart(k_inf, h) >= 0);
        assert_true(tp_depth_wave_number_fenton(k_inf, h) >= 0);
        assert_true(tp_depth_speed(k_inf, other, (tp_fx)any_word()) >= 0);
        assert_true(tp_depth_group_speed(k_inf, other, h, (tp_fx)any_word()) >= 0);
        assert_true(tp_depth_wave_number_deep(h) > 0);
        tp_depth_classify(other, h);
    }
}

static void exponentials_keep_their_errors(void **state)
{
    (void)state;
    measure e = { .what = "e^-x", .unit = "2^-32" };
    measure t = { .what = "tanh x", .unit = "2^-32" };
    measure r = { .what = "tanh x / x", .unit = "of itself" };

    for (uint32_t x = 0; x < 25u << 24; x += x < 1 << 22 ? 61 : 3001) {
        const double v = x / 16777216.0;
        const tp_tanh at = tp_tanh_evaluate(x);
        const double ratio = x == 0 ? 1 : tanh(v) / v;
        measure_add(&e, tp_exp_neg(x) - exp(-v) * 4294967296.0, x, 0, 0);
        measure_add(&t, at.tanh_q32 - tanh(v) * 4294967296.0, x, 0, 0);
        measure_add(&r, apart(at.ratio_q31 / 2147483648.0, ratio), x, 0, 0);
    }
    measure_print(&e);
    measure_print(&t);
    measure_print(&r);
    assert_true(e.worst < 4 && t.worst < 8);
    assert_true(r.worst < 1.2e-8);
    assert_int_equal(tp_exp_neg(UINT32_MAX), 0);
    assert_true(tp_tanh_evaluate(UINT32_MAX).tanh_q32 == UINT32_MAX);
    assert_int_equal(tp_exp_neg_q30(0), TP_Q30_ONE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dispersion_follows_its_vectors),
        cmocka_unit_test(four_methods_err_as_the_models_say),
        cmocka_unit_test(both_ends_of_depth_are_exact),
        cmocka_unit_test(shallower_is_shorter),
        cmocka_unit_test(regimes_change_at_a_half_and_a_twentieth),
        cmocka_unit_test(land_counts_as_a_film_of_a_16th),
        cmocka_unit_test(any_words_are_accepted),
        cmocka_unit_test(exponentials_keep_their_errors),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("waves/water_depth", tests, NULL, NULL);
}
