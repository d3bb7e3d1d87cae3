/* SPDX-License-Identifier: MIT */
/* Heights over a depth, and the phase of waves that come in over a straight coast, compared
 * with the models' vectors and with integrals in double precision. */
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

static int64_t chance_k_inf(void)
{
    return tp_depth_wave_number_deep(chance_scale(&chance, 0.25, 2000));
}

static void shoaling_follows_the_models(void **state)
{
    (void)state;
    measure m = { .what = "Ks", .unit = "LSB, 2^-24" };
    measure usual = { .what = "Ks of the usual k", .unit = "%" };
    double least = 1;

    for (int i = 0; i < 20000; i++) {
        const int64_t k_inf = chance_k_inf();
        const tp_fx h = chance_scale(&chance, LSB, 8000);
        const double k = ref_depth_number(ref_q32(k_inf), h * LSB);
        const double want = ref_shoaling(ref_q32(k_inf), k, h * LSB);
        const tp_fx got = tp_depth_shoaling_factor(k_inf, ref_to_q32(k), h);
        const tp_fx quick =
            tp_depth_shoaling_factor(k_inf, tp_depth_wave_number(k_inf, h), h);

        const double may = LSB / 2 + want / 16777216;
        measure_add(&m, fabs(got * LSB - want) / may, k_inf, h, 0);
        measure_add(&usual, (quick * LSB / want - 1) * 100, k_inf, h, 0);
        least = fmin(least, got * LSB);
    }
    measure_print(&m);
    measure_print(&usual);
    printf("    least Ks %.5f\n", least);
    assert_true(m.worst < 1.1 && usual.worst < 0.1);
    assert_true(fabs(least - 0.913) < 0.001);
    assert_int_equal(tp_depth_shoaling_factor(0, 1, 1), TP_FX_ONE);
    assert_int_equal(tp_depth_shoaling_factor(1, 0, 1), TP_FX_ONE);
}

static double cosine(double k, double kz)
{
    return fmax(1 / 16.0, sqrt(fmax(0, 1 - kz / k * (kz / k))));
}

static void refraction_follows_snell_up_to_grazing(void **state)
{
    (void)state;
    measure m = { .what = "Kr", .unit = "LSB" };

    for (int i = 0; i < 20000; i++) {
        const int64_t k_inf = chance_k_inf();
        const tp_fx h = chance_scale(&chance, LSB, 8000);
        const int64_t k = tp_depth_wave_number_exact(k_inf, h);
        const double angle = chance_double(&chance, -1.5707, 1.5707);
        const int64_t kz = (int64_t)(sin(angle) * (double)k_inf);
        const double want = sqrt(cosine((double)k_inf, (double)kz)
                                 / cosine((double)k, (double)kz));
        const tp_fx got = tp_depth_refraction_factor(k_inf, k, kz);

        measure_add(&m, (got * LSB - want) / LSB, k_inf, h, kz);
        assert_true(got >= TP_FX_ONE / 4 && got <= TP_FX_ONE);
    }
    measure_print(&m);
    assert_true(m.worst < 0.6);
}

/* Waves along the shore and beyond, and numbers that no wave has. */
static void refraction_is_bounded_for_any_words(void **state)
{
    (void)state;
    const int64_t k = tp_depth_wave_number_deep(TP_FX(20));

    assert_int_equal(tp_depth_refraction_factor(k, k, k), TP_FX_ONE);
    assert_int_equal(tp_depth_refraction_factor(k, k, -k), TP_FX_ONE);
    assert_int_equal(tp_depth_refraction_factor(k, 1000 * k, k), TP_FX_ONE / 4);
    assert_int_equal(tp_depth_refraction_factor(k, 2 * k, INT64_MIN), TP_FX_ONE);
    assert_int_equal(tp_depth_refraction_factor(k, 2 * k, 0), TP_FX_ONE);
    for (int i = 0; i < 20000; i++) {
        const int64_t a = (int64_t)random_next(&chance) >> (random_next(&chance) & 63);
        const int64_t b = (int64_t)random_next(&chance) >> (random_next(&chance) & 63);
        const int64_t c = (int64_t)random_next(&chance) >> (random_next(&chance) & 63);
        const tp_fx kr = tp_depth_refraction_factor(a, b, c);
        const tp_fx h = random_number(&chance), w = random_number(&chance);

        assert_in_range(kr, TP_FX_ONE / 4 - 1, TP_FX_ONE * 4 + 1);
        assert_true(tp_depth_shoaling_factor(a, b, h) >= 0);
        assert_true(tp_depth_amplitude(random_number(&chance), w, kr, h) >= 0);
        assert_true(tp_depth_amplitude(TP_FX_MAX, TP_FX_MAX, kr, h)
                    <= fmax(0, h) * 0.39 + 0.5);
    }
}

static void amplitudes_grow_until_the_depth_holds_them(void **state)
{
    (void)state;
    const tp_fx one = TP_FX_ONE;

    assert_int_equal(tp_depth_amplitude(TP_FX(2), TP_FX(1.5), TP_FX(0.5), TP_FX(20)),
                     TP_FX(1.5));
    assert_int_equal(tp_depth_amplitude(TP_FX(2), one, one, TP_FX(2)), TP_FX(0.78));
    assert_int_equal(tp_depth_amplitude(TP_FX(2), one, one, 0), 0);
    assert_int_equal(tp_depth_amplitude(TP_FX(2), one, one, -1), 0);
    assert_int_equal(tp_depth_amplitude(0, one, one, one), 0);
    assert_int_equal(tp_depth_amplitude(-5, one, one, one), 0);
    for (int i = 0; i < 2000; i++) {
        const tp_fx a = chance_scale(&chance, 0.001, 16);
        const tp_fx h = chance_scale(&chance, 0.01, 90);
        const tp_fx ks = chance_fx(&chance, 0.913, 48), kr = chance_fx(&chance, 0.25, 1);
        const double grown = (double)a * ks * LSB * kr * LSB;
        assert_true(fabs(tp_depth_amplitude(a, ks, kr, h) - fmin(grown, 0.39 * h)) < 1);
    }
}

/* -- the phase over a straight coast ------------------------------------------------- */

static tp_coast *coast_of(const tp_coast_shape *shape)
{
    const size_t bytes = tp_coast_bytes(shape);
    tp_coast *const coast = malloc(bytes);

    assert_non_null(coast);
    assert_int_equal(bytes % 8, 0);
    tp_coast_init(coast, shape);
    assert_true(sizeof *coast + coast->count * sizeof(tp_coast_node) <= bytes);
    return coast;
}

static double phase(const tp_coast *coast, tp_fx x)
{
    return ref_q32(tp_coast_phase(coast, x)) * REF_TWO_PI;
}

static void phase_integral_follows_its_vectors(void **state)
{
    (void)state;
    FILE *const file = fopen("tests/vectors/shoaling_phase.csv", "r");
    measure m = { .what = "phase", .unit = "rad" };
    double v[11];
    int64_t rows = 0;
    size_t longest = 0;

    assert_non_null(file);
    while (csv_row(file, v, 11) == 11) {
        const double omega = REF_TWO_PI / v[0];
        const tp_coast_shape shape = {
            .k_inf_q32 = ref_to_q32(omega * omega / 9.81),
            .kz_q32 = ref_to_q32(v[7]),
            .depth = (tp_fx)lround(v[1] * 65536),
            .slope = (tp_q30)lround(v[2] * 1073741824),
            .least = TP_FX(0.5),
            .x_from = 0, .x_to = TP_FX(400),
        };
        tp_coast *const coast = coast_of(&shape);
        const size_t bytes = tp_coast_bytes(&shape);
        const double most = ref_depth_number(ref_q32(shape.k_inf_q32), 0.5);
        assert_true((1 << coast->bits) * LSB <= REF_TWO_PI / most / 16);
        measure_add(&m, phase(coast, (tp_fx)lround(v[4] * 65536)) - v[9], rows++, 0, 0);
        longest = bytes > longest ? bytes : longest;
        free(coast);
    }
    fclose(file);
    measure_print(&m);
    printf("    the longest table has %zu bytes\n", longest);
    assert_int_equal(rows, 104);
    assert_true(m.worst < 0.002);
}

/* Any shape in the models' ranges, some of the shapes steep and shallow to the end. */
static tp_coast_shape chance_shape(void)
{
    const int64_t k_inf = tp_depth_wave_number_deep(chance_scale(&chance, 1, 500));
    const tp_q30 slope = (tp_q30)(1073741824 * pow(0.005, chance_double(&chance, 0, 1)));
    const tp_fx depth = chance_scale(&chance, 0.5, 60);
    const double reach = depth * LSB / (slope / 1073741824.0);

    return (tp_coast_shape){
        .k_inf_q32 = k_inf,
        .kz_q32 = (int64_t)(chance_double(&chance, -1, 1) * (double)k_inf),
        .depth = depth, .slope = slope, .least = chance_scale(&chance, 0.0625, 0.5),
        .x_from = -chance_scale(&chance, 0.1, 300),
        .x_to = chance_fx(&chance, reach / 2, reach + 20),
    };
}

/* Phase from x = 0 by the reference, along the three parts of the coast. */
static double ref_phase(const tp_coast_shape *s, double x)
{
    const double k_inf = ref_q32(s->k_inf_q32), kz = ref_q32(s->kz_q32);
    const double h0 = s->depth * LSB, slope = s->slope / 1073741824.0;
    const double least = s->least * LSB, shore = (h0 - least) / slope;
    const double k = ref_depth_number(k_inf, least);
    const double wet = fmin(x, shore);

    return ref_slope_phase(k_inf, kz, h0, slope, 0, wet, 200)
         + (x - wet) * sqrt(k * k - kz * kz);
}

/* Wave numbers have a relative error of 2^-26; a grazing wave leaves 2 e^-12 / slope
 * out. */
static void coasts_of_any_shape_keep_the_budget(void **state)
{
    (void)state;
    measure m = { .what = "phase, any coast", .unit = "rad" };
    measure node = { .what = "bytes", .unit = "" };

    for (int i = 0; i < 25; i++) {
        tp_coast_shape s = chance_shape();
        if (i % 5 == 0)
            s.kz_q32 = i % 10 ? s.k_inf_q32 : 0;            /* grazing, straight in */
        tp_coast *const coast = coast_of(&s);
        measure_add(&node, (double)tp_coast_bytes(&s), i, 0, 0);
        assert_int_equal(tp_coast_phase(coast, 0), 0);
        for (int n = 0; n < 4; n++) {
            const tp_fx x = chance_fx(&chance, s.x_from * LSB, s.x_to * LSB);
            const double want = ref_phase(&s, x * LSB);
            const double error = phase(coast, x) - want;
            measure_add(&m, error, i, x, 0);
            const double left = i % 10 == 5 ? 2 * exp(-12) / s.slope * 1073741824 : 0;
            assert_true(fabs(error) < 0.001 + left + fabs(want) / 67108864);
        }
        free(coast);
    }
    measure_print(&m);
    measure_print(&node);
}

/* Outside the table, behind the beach and in deep water the phase is straight; over a level
 * floor the phase is one line, and zero without a wave. */
static void phases_go_straight_on_beyond_the_table(void **state)
{
    (void)state;
    tp_coast_shape s = { .k_inf_q32 = tp_depth_wave_number_deep(TP_FX(40)),
                         .depth = TP_FX(5),
                         .slope = TP_Q30(0.02),
                         .least = TP_FX(0.5),
                         .x_from = TP_FX(-9000),
                         .x_to = TP_FX(9000) };
    tp_coast *coast = coast_of(&s);
    const double sea = ref_q32(s.k_inf_q32);
    const double shore = ref_depth_number(sea, 0.5);

    const double out = phase(coast, TP_FX(-8000)) - phase(coast, TP_FX(-30000));
    const double in = phase(coast, TP_FX(30000)) - phase(coast, TP_FX(300));
    assert_true(fabs(out - 22000 * sea) < 1e-4);
    assert_true(fabs(in - 29700 * shore) < 1e-4 + in / 67108864);
    assert_true(tp_coast_phase(coast, TP_FX_MIN) < tp_coast_phase(coast, TP_FX_MAX));
    free(coast);

    s.slope = 0;
    coast = coast_of(&s);
    assert_int_equal(coast->count, 0);
    const double level = phase(coast, TP_FX(20000)) - 20000 * ref_depth_number(sea, 5);
    assert_true(fabs(level) < 1e-4);
    free(coast);
    s.k_inf_q32 = 0;
    s.slope = TP_Q30(0.1);
    coast = coast_of(&s);
    assert_int_equal(tp_coast_phase(coast, TP_FX(20000)), 0);
    free(coast);
}

/* Crests never run backwards, not even at the joints of the table. */
static void phases_grow_towards_the_shore(void **state)
{
    (void)state;
    for (int i = 0; i < 20; i++) {
        const tp_coast_shape s = chance_shape();
        tp_coast *const coast = coast_of(&s);
        const tp_fx step = 1 + (s.x_to - s.x_from) / 3000;
        int64_t before = tp_coast_phase(coast, s.x_from - step);

        for (tp_fx x = s.x_from; x < s.x_to + 2 * step; x += step) {
            const int64_t turns = tp_coast_phase(coast, x);
            assert_true(turns > before);
            before = turns;
        }
        for (int n = 0; n < 2; n++) {               /* both ends join */
            const tp_fx end = n ? coast->x_last : coast->x_first;
            const int64_t jump = tp_coast_phase(coast, end + 1)
                               - tp_coast_phase(coast, end - 1);
            assert_true(ref_q32(jump) < 2 * LSB * 5);
        }
        free(coast);
    }
}

/* No table is built for a shape that would not fit here; its size is computed anyway. */
static void shapes_of_any_words_are_accepted(void **state)
{
    (void)state;
    uint32_t built = 0;

    for (int i = 0; i < 3000; i++) {
        const tp_coast_shape s = {
            .k_inf_q32 = (int64_t)random_next(&chance) >> (random_next(&chance) & 63),
            .kz_q32 = (int64_t)random_next(&chance) >> (random_next(&chance) & 63),
            .depth = random_number(&chance), .slope = random_number(&chance),
            .least = random_number(&chance), .x_from = random_number(&chance),
            .x_to = i % 7 ? random_number(&chance) : TP_FX_MAX,
        };
        const size_t bytes = tp_coast_bytes(&s);
        assert_true(bytes >= sizeof(tp_coast) && bytes < (size_t)1 << 32);
        if (bytes > 20000)
            continue;
        tp_coast *const coast = coast_of(&s);
        built += coast->count > 0;
        assert_int_equal(tp_coast_phase(coast, 0), 0);
        assert_true(tp_coast_phase(coast, TP_FX_MIN) <= 0);
        assert_true(tp_coast_phase(coast, TP_FX_MAX) >= 0);
        tp_coast_phase(coast, coast->x_first);
        tp_coast_phase(coast, random_number(&chance));
        free(coast);
    }
    printf("    %u tables\n", built);
    assert_true(built > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shoaling_follows_the_models),
        cmocka_unit_test(refraction_follows_snell_up_to_grazing),
        cmocka_unit_test(refraction_is_bounded_for_any_words),
        cmocka_unit_test(amplitudes_grow_until_the_depth_holds_them),
        cmocka_unit_test(phase_integral_follows_its_vectors),
        cmocka_unit_test(coasts_of_any_shape_keep_the_budget),
        cmocka_unit_test(phases_go_straight_on_beyond_the_table),
        cmocka_unit_test(phases_grow_towards_the_shore),
        cmocka_unit_test(shapes_of_any_words_are_accepted),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("waves/shoal", tests, NULL, NULL);
}
