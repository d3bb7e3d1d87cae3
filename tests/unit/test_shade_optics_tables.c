/* SPDX-License-Identifier: MIT */
/* Tables of the shading stages compared with their formulas in double precision, and
 * colours of three channels in one word compared with one channel at a time. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/shading.h"
#include "tests/lib/measure.h"
#include "tests/lib/random.h"
#include "features/sky/sky.h"
#include "shade/shade.h"
#include "shade/optics.h"

#define Q14 16384.0

static uint64_t chance;
static tp_entry16 shine[TP_SHINE + 1];
static tp_shade shade;

static uint32_t any_word(void)
{
    return (uint32_t)random_next(&chance);
}

static uint32_t chance_colour(void)
{
    return any_word() & 0xffffff;
}

/* -- tables ------------------------------------------------------------------------- */

/* Entries are rounded to 1/256 with a maximum of 255: the error is 1/512 in the middle,
 * 1/256 at the grazing end; the formula's own roundings in 16.16 are below 1/10000. */
static void fresnel_is_the_exact_formula_within_a_level(void **state)
{
    (void)state;
    measure m = { .what = "fresnel", .unit = "/256" };

    for (int i = 0; i <= 256; i++) {
        const double want = 256 * ref_fresnel(i / 256.0);
        measure_add(&m, tp_fresnel_table[i] - want, i, 0, 0);
        assert_true(fabs(tp_fresnel_table[i] - want) <= (want > 255.5 ? 1 : 0.51));
        assert_true(i == 0 || tp_fresnel_table[i] <= tp_fresnel_table[i - 1]);
    }
    assert_int_equal(tp_fresnel_table[0], 255);
    assert_int_equal(tp_fresnel_table[256], 5);        /* 2.04 % */
    measure_print(&m);
}

/* Floor of the root of a floor: less than 1 of Q14 too small, never too large. */
static void steep_is_the_root_cut_to_its_format(void **state)
{
    (void)state;
    measure m = { .what = "steep", .unit = "of Q14" };

    for (int i = 0; i <= TP_STEEP; i++) {
        const double want = Q14 / sqrt(1 + i / 128.0);
        measure_add(&m, tp_steep_table[i] - want, i, 0, 0);
        assert_true(tp_steep_table[i] <= want && tp_steep_table[i] > want - 1.001);
    }
    assert_int_equal(tp_steep_table[0], 16384);
    measure_print(&m);
}

static void haze_is_the_rule_cut_to_255ths(void **state)
{
    (void)state;

    for (int i = 0; i <= TP_HAZE; i++) {
        const double want = 255 / (1 + i / 32.0 * (i / 32.0));      /* i = 32 h / z */
        assert_true(tp_haze_table[i] <= want && tp_haze_table[i] > want - 1);
    }
    assert_int_equal(tp_haze_table[32], 127);          /* a half, at h */
    assert_int_equal(tp_haze_table[TP_HAZE], 0);       /* none within h / 16 */
}

/* Converts a Q2.30 share to 256ths. */
static uint8_t share_of(tp_q30 r)
{
    return (uint8_t)tp_clamp((r + (1 << 21)) >> 22, 0, 255);
}

/* Each table follows the rule at its head, to the bit. */
static void constant_tables_are_as_generated(void **state)
{
    (void)state;
    uint8_t gloss[TP_GLOSS];

    for (uint32_t i = 0; i <= TP_STEEP; i++)
        assert_int_equal(tp_steep_table[i],
                         tp_isqrt64(((uint64_t)128 << 32) / (128 + i) << 28) >> 16);
    for (uint32_t i = 0; i <= TP_HAZE; i++)
        assert_int_equal(tp_haze_table[i], 255 * 1024 / (1024 + i * i));
    for (int32_t i = 0; i <= 256; i++) {
        assert_int_equal(tp_fresnel_table[i], share_of(tp_fresnel(i * (1 << 22))));
        assert_int_equal(tp_schlick_table[i], share_of(tp_fresnel_schlick(i * (1 << 22))));
    }
    tp_shade_gloss(gloss, 40 * TP_FX_ONE);
    assert_memory_equal(gloss, tp_drop_gloss, sizeof gloss);
}

/* Roundings of the squares to 2^-31 add up to less than n / 2^30, 1e-6 at 1000.  The lobe
 * is truncated to 2^-16 and multiplied by up to 1024: 0.016 too small; then truncated to an
 * integer. */
static void shine_is_a_power(void **state)
{
    (void)state;
    measure m = { .what = "shine", .unit = "/256" };

    for (int n = 1; n <= 1000; n = n * 5 / 4 + 1) {
        const double strength = chance_fx(&chance, 0, 4) / 65536.0;
        tp_shade_shine(shine, n * TP_FX_ONE, (tp_fx)lround(strength * 65536));
        for (int i = 0; i <= TP_SHINE; i++) {
            const double want = 256 * strength * pow(i / (double)TP_SHINE, n);
            measure_add(&m, shine[i] - want, n, i, 0);
            assert_true(shine[i] <= want + 0.02 && shine[i] > want - 1.02);
        }
    }
    measure_print(&m);
}

/* A gloss entry is at most 255, so entries lie within 1 below 256 times the power. */
static void gloss_is_a_power(void **state)
{
    (void)state;
    measure m = { .what = "gloss", .unit = "/256" };
    uint8_t gloss[TP_GLOSS];

    for (int n = 1; n <= 1000; n = n * 5 / 4 + 1) {
        tp_shade_gloss(gloss, n * TP_FX_ONE);
        for (int i = 0; i < TP_GLOSS; i++) {
            const double want = 256 * pow(i / 255.0, n);
            measure_add(&m, gloss[i] - want, n, i, 0);
            assert_true(gloss[i] <= want + 0.01 && gloss[i] > want - 1.02);
        }
        assert_int_equal(gloss[TP_GLOSS - 1], 255);
    }
    measure_print(&m);
}

/* Blinn's lobes by c = 2 (N.H)^2 - 1: the cosine of the half angle to the power 4 n.  Twice
 * the exponent doubles the error of the roundings. */
static void lobes_of_blinn_are_powers_of_the_half_angle(void **state)
{
    (void)state;
    measure m = { .what = "gloss_blinn", .unit = "/256" };
    measure s = { .what = "shine_blinn", .unit = "/256" };
    uint8_t gloss[TP_GLOSS];

    for (int n = 1; n <= 1000; n = n * 5 / 4 + 1) {
        tp_shade_gloss_blinn(gloss, n * TP_FX_ONE);
        tp_shade_shine_blinn(shine, n * TP_FX_ONE, TP_FX_ONE);
        for (int i = 0; i < TP_GLOSS; i++) {
            const double want = 256 * pow((1 + i / 255.0) / 2, 2 * n);
            measure_add(&m, gloss[i] - want, n, i, 0);
            assert_true(gloss[i] <= want + 0.01 && gloss[i] > want - 1.04);
        }
        for (int i = 0; i <= TP_SHINE; i++) {
            const double want = 256 * pow((1 + i / (double)TP_SHINE) / 2, 2 * n);
            measure_add(&s, shine[i] - want, n, i, 0);
            assert_true(shine[i] <= want + 0.04 && shine[i] > want - 1.04);
        }
        assert_int_equal(gloss[TP_GLOSS - 1], 255);
        assert_int_equal(shine[TP_SHINE], 256);
    }
    measure_print(&m);
    measure_print(&s);
}

static void an_exponent_outside_its_range_is_held(void **state)
{
    (void)state;
    uint8_t low[TP_GLOSS], one[TP_GLOSS], high[TP_GLOSS], most[TP_GLOSS];

    tp_shade_gloss(low, -5 * TP_FX_ONE);
    tp_shade_gloss(one, TP_FX_ONE);
    tp_shade_gloss(high, 30000 * TP_FX_ONE);
    tp_shade_gloss(most, 1000 * TP_FX_ONE);
    assert_memory_equal(low, one, sizeof one);
    assert_memory_equal(high, most, sizeof most);
}

/* The ends are the colours themselves; between, the share is truncated to 1/256 (one level
 * of the widest difference) and the mix is rounded. */
static void the_sky_goes_from_horizon_to_zenith(void **state)
{
    (void)state;
    measure m = { .what = "sky", .unit = "levels" };
    static uint32_t sky[TP_SKY + 1];

    for (int n = 0; n < 500; n++) {
        const uint32_t horizon = chance_colour(), zenith = chance_colour();
        tp_shade_sky(sky, horizon, zenith);
        assert_int_equal(sky[0], horizon);
        assert_int_equal(sky[TP_SKY], zenith);
        for (int i = 0; i <= TP_SKY; i++) {
            const double off =
                ref_colour_difference(sky[i], ref_sky(horizon, zenith, i / 256.0));
            measure_add(&m, off, horizon, zenith, i);
            assert_true(off <= 1.5);
            assert_int_equal(sky[i] >> 24, 0);
        }
    }
    measure_print(&m);
}

/* -- colours ------------------------------------------------------------------------ */

/* A colour with the channel's value at `shift`; the other two channels and the top byte are
 * `noise`. */
static uint32_t placed(uint32_t value, int shift, uint32_t noise)
{
    return (noise & ~(0xffu << shift)) | value << shift;
}

typedef struct {
    uint32_t a, b, share;       /* values of the channel; the rest is noise */
    uint32_t scale, mix, times, add;
} channel_errors;

static channel_errors channel_of(uint32_t a, uint32_t b, uint32_t share)
{
    return (channel_errors){ a, b, share,
                      .scale = (a * share + 128) / 256,
                      .mix = (a * (256 - share) + b * share + 128) / 256,
                      .times = (2 * a * b + 255) / 510,
                      .add = a + b > 255 ? 255 : a + b };
}

static void check_channel(const channel_errors *c, int shift)
{
    const uint32_t a = placed(c->a, shift, any_word());
    const uint32_t b = placed(c->b, shift, any_word());
    const uint32_t got[4] = { tp_colour_scale(a, c->share), tp_colour_mix(a, b, c->share),
                              tp_colour_times(a, b), tp_colour_add(a, b) };

    assert_int_equal(got[0] >> shift & 0xff, c->scale);
    assert_int_equal(got[1] >> shift & 0xff, c->mix);
    assert_int_equal(got[2] >> shift & 0xff, c->times);
    assert_int_equal(got[3] >> shift & 0xff, c->add);
    for (int i = 0; i < 4; i++)
        assert_int_equal(got[i] >> 24, 0);
}

/* All pairs of values and, in turn, all shares: the neighbour channels hold noise, and no
 * carry may pass from the noise. */
static void channels_do_not_know_of_each_other(void **state)
{
    (void)state;

    for (uint32_t a = 0; a < 256; a++) {
        for (uint32_t b = 0; b < 256; b++) {
            for (uint32_t k = 0; k < 3; k++) {
                const channel_errors c = channel_of(a, b, (a * 7 + b * 3 + k * 85) % 257);
                for (int shift = 0; shift < 24; shift += 8)
                    check_channel(&c, shift);
            }
        }
    }
}

static void full_and_empty_shares_are_exact(void **state)
{
    (void)state;

    for (int n = 0; n < 100000; n++) {
        const uint32_t a = chance_colour(), b = chance_colour();
        const uint32_t share = random_below(&chance, 257);
        assert_int_equal(tp_colour_scale(a, 256), a);
        assert_int_equal(tp_colour_scale(a, 0), 0);
        assert_int_equal(tp_colour_mix(a, b, 0), a);
        assert_int_equal(tp_colour_mix(a, b, 256), b);
        assert_int_equal(tp_colour_mix(a, a, share), a);
        assert_int_equal(tp_colour_times(a, 0xffffff), a);
        assert_int_equal(tp_colour_times(a, 0), 0);
        assert_int_equal(tp_colour_add(a, 0), a);
        assert_int_equal(tp_colour_add(a, b), tp_colour_add(b, a));
        assert_int_equal(tp_colour_add(a, 0xffffff), 0xffffff);
    }
}

/* -- mipmap levels ------------------------------------------------------------------- */

/* Key of a point `depth` m from an eye with its near plane at `near` m. */
static uint32_t key_at(double near, double depth, uint32_t mark)
{
    return (uint32_t)(near / depth * 2147483648.0) << 1 >> 8 << 8 | mark;
}

/* Texels per pixel grow with the depth, on level ground with its power 3/2; logarithms are
 * up to 1/11 too small, twice, and times 3/2. */
static void levels_follow_the_depth(void **state)
{
    (void)state;
    measure m = { .what = "tp_level_choose", .unit = "levels" };

    for (int n = 0; n < 200000; n++) {
        const tp_fx near = chance_scale(&chance, 0.05, 10);
        const double depth = near * pow(16000, chance_double(&chance, 0, 1)) / 65536.0;
        const uint32_t key = key_at(near / 65536.0, depth, random_below(&chance, 256));
        const int32_t lod = chance_int(&chance, -2560, 2560);
        const bool ground = n & 1;
        const double z = log2(depth);
        const double want = lod / 256.0 + z + (ground && z > 0 ? z / 2 : 0);
        shade.zi_log = tp_log2_q8((uint32_t)near) + 15 * 256;
        const int got = tp_mip_level_choose(lod, tp_log_depth(&shade, key), ground, 13);
        if (want < 0.3 || want > 12.3) {
            assert_in_range(got, want > 12.3 ? 12 : 0, want < 0.3 ? 0 : 12);
            continue;
        }
        measure_add(&m, got + 0.5 - want, lod, key, ground);
        assert_true(fabs(got + 0.5 - want) < 0.5 + 1.5 * 2 / 11.0);
    }
    measure_print(&m);
}

static void levels_never_fall_with_the_depth(void **state)
{
    (void)state;

    for (int n = 0; n < 200; n++) {
        const int32_t lod = chance_int(&chance, -4096, 4096);
        const int levels = chance_int(&chance, 1, 13);
        const uint32_t mark = random_below(&chance, 256);
        int before[2] = { 0, 0 };
        shade.zi_log = tp_log2_q8((uint32_t)chance_scale(&chance, 0.05, 10)) + 15 * 256;
        for (uint32_t key = 0xffffffff; key > 256; key -= key / 97 + 1) {
            for (int ground = 0; ground < 2; ground++) {
                const int32_t depth = tp_log_depth(&shade, (key & ~0xffu) | mark);
                const int l = tp_mip_level_choose(lod, depth, ground, levels);
                assert_in_range(l, before[ground], levels - 1);
                before[ground] = l;
            }
        }
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fresnel_is_the_exact_formula_within_a_level),
        cmocka_unit_test(steep_is_the_root_cut_to_its_format),
        cmocka_unit_test(haze_is_the_rule_cut_to_255ths),
        cmocka_unit_test(constant_tables_are_as_generated),
        cmocka_unit_test(shine_is_a_power),
        cmocka_unit_test(gloss_is_a_power),
        cmocka_unit_test(lobes_of_blinn_are_powers_of_the_half_angle),
        cmocka_unit_test(an_exponent_outside_its_range_is_held),
        cmocka_unit_test(the_sky_goes_from_horizon_to_zenith),
        cmocka_unit_test(channels_do_not_know_of_each_other),
        cmocka_unit_test(full_and_empty_shares_are_exact),
        cmocka_unit_test(levels_follow_the_depth),
        cmocka_unit_test(levels_never_fall_with_the_depth),
    };
    return cmocka_run_group_tests_name("shade/optics_tables", tests, NULL, NULL);
}
