/* SPDX-License-Identifier: MIT */
/* Values that stages compute once for several pixels: exact at multiples of 16 or 32 of the
 * picture, for any begin of a span, and between the multiples by the formulas of their
 * files, bit for bit. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/layers.h"
#include "tests/lib/shading.h"
#include "tests/lib/camera.h"

#define Q14 16384.0

enum { RUNS = 2000 };

static uint64_t chance;

static tp_entry16 shine[TP_SHINE + 1];

static tp_shade shade_of(const test_view *v)
{
    const tp_rotation *turn = &v->projection.turn;
    const tp_rotation light = tp_rotation_from_angles((tp_turn)random_next(&chance),
                                                      (tp_turn)random_next(&chance), 0);
    tp_shade s = {
        .u0 = v->projection.u0, .v0 = v->projection.v0, .focal = v->projection.focal >> 12,
        .world = { turn->x, turn->y, turn->z, light.y.x >> 16, light.y.y >> 16,
                   light.y.z >> 16 },
        .zi_log = tp_log2_q8((uint32_t)v->projection.zi_near) + 15 * 256,
        .fresnel = tp_fresnel_table, .shine = shine,
    };
    return s;
}

/* Makes a span of the samples [from, end) in `r`. */
static void run_of(test_run *r, int32_t x, int32_t from, int32_t end)
{
    r->run.x = x + from;
    r->run.count = end - from;
    r->run.key = r->key + from;
    r->run.s = r->s + from;
    r->run.t = r->t + from;
    r->run.n = r->n + from;
}

static void any_part(test_run *r)
{
    const int32_t from = chance_int(&chance, 0, TP_RUN - 1);
    run_of(r, r->run.x, from, chance_int(&chance, from + 1, TP_RUN));
}

/* -- views and sky --------------------------------------------------------------------- */

/* Both ends in Q1.14, k / 16 of the difference, and a bow by the second differences;
 * truncated. */
static int32_t bowed(int32_t before, int32_t a, int32_t b, int32_t after, int32_t k)
{
    const double bow = a + b - before - after;
    return (int32_t)floor(a + ((b - a) * 64.0 + bow * (16 - k)) * k / 1024.0);
}

static void views_are_bowed_between_multiples_of_16(void **state)
{
    (void)state;

    for (int n = 0; n < RUNS; n++) {
        const test_view v = view_any(&chance);
        const tp_shade s = shade_of(&v);
        test_run r;
        run_any(&r, 0, &chance);
        any_part(&r);
        tp_stage_view(&s, &r.run);
        for (int i = 0; i < r.run.count; i++) {
            const int32_t x = r.run.x + i, k = x % 16;
            tp_ray at[4];
            for (int m = 0; m < 4; m++)
                at[m] = tp_vector_to_eye(&s, &s.world, x - k + 16 * (m - 1), r.run.y);
            assert_int_equal(r.run.vx[i], bowed(at[0].x, at[1].x, at[2].x, at[3].x, k));
            assert_int_equal(r.run.vy[i], bowed(at[0].y, at[1].y, at[2].y, at[3].y, k));
            assert_int_equal(r.run.vz[i], bowed(at[0].z, at[1].z, at[2].z, at[3].z, k));
            assert_int_equal(r.run.lv[i], bowed(at[0].l, at[1].l, at[2].l, at[3].l, k));
        }
    }
}

/* In the usual picture: two truncations of each component and one of the bow, which has up
 * to 15 * 15 / 4 units of 1/1024. */
static void views_are_no_more_than_2_in_10000_short(void **state)
{
    (void)state;
    measure m = { .what = "view's length", .unit = "short of 1" };

    for (int n = 0; n < RUNS; n++) {
        const test_view v = view_of((tp_vec3){ 0, 0, 0 }, (tp_turn)random_next(&chance),
                               tp_turn_of_degrees(chance_fx(&chance, -89, 89)), TP_FX(60),
                               TP_FX(1), 640, 480);
        const tp_shade s = shade_of(&v);
        test_run r;
        run_any(&r, 0, &chance);
        tp_stage_view(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const double x = r.run.vx[i] / Q14, y = r.run.vy[i] / Q14,
                         z = r.run.vz[i] / Q14;
            measure_add(&m, 1 - sqrt(x * x + y * y + z * z), r.run.x, r.run.y, i);
        }
    }
    measure_print(&m);
    assert_true(m.worst <= 0.0002);
}

/* The colour of each entry is the entry's number. */
static void number_the_sky(tp_shade *s)
{
    static uint32_t numbers[TP_SKY + 1];

    for (uint32_t i = 0; i <= TP_SKY; i++)
        numbers[i] = i;
    s->sky = numbers;
}

static void the_sky_is_linear_between_multiples_of_32(void **state)
{
    (void)state;

    for (int n = 0; n < RUNS; n++) {
        const test_view v = view_any(&chance);
        tp_shade s = shade_of(&v);
        test_run r;
        number_the_sky(&s);
        run_any(&r, 0, &chance);
        any_part(&r);
        tp_stage_sky(&s, &r.run);
        for (int i = 0; i < r.run.count; i++) {
            const int32_t x = r.run.x + i, from = x - x % 32;
            const double a = tp_vector_to_eye(&s, &s.world, from, r.run.y).y / Q14;
            const double b = tp_vector_to_eye(&s, &s.world, from + 32, r.run.y).y / Q14;
            const double sine = -(a + (b - a) * (x - from) / 32);
            assert_int_equal(r.run.colour[i], sine < 0 ? 0 : floor(fmin(sine, 1) * 256));
        }
    }
}

/* The error as stated in skies.c; an entry stands for all sines up to the next entry's
 * sine. */
static void the_skys_height_is_as_near_as_stated(void **state)
{
    (void)state;
    measure m = { .what = "sky's height", .unit = "of a sine" };
    const test_view v = view_of((tp_vec3){ 0, 0, 0 }, 0, 0, TP_FX(60), TP_FX(1), 640, 480);
    tp_shade s = shade_of(&v);
    test_run r;

    number_the_sky(&s);
    run_any(&r, 0, &chance);
    for (r.run.y = 0; r.run.y < 240; r.run.y++) {
        for (r.run.x = 0; r.run.x < 640; r.run.x += TP_RUN) {
            tp_stage_sky(&s, &r.run);
            for (int i = 0; i < TP_RUN; i++) {
                const double x = r.run.x + i + 0.5 - 320, y = 240 - r.run.y - 0.5;
                const double sine = y / sqrt(x * x + y * y + v.ref.focal * v.ref.focal);
                measure_add(&m, (r.run.colour[i] + 0.5) / 256 - sine, r.run.x + i,
                            r.run.y, 0);
            }
        }
    }
    measure_print(&m);
    assert_true(m.worst <= 0.0016 + 0.5 / 256 + 1 / Q14);
}

/* -- mipmap levels --------------------------------------------------------------------- */

/* Level k of 8 texels has red and green of 30 k + 30; as a normal map it has a tilt of the
 * same size. */
static tp_texture numbered(uint32_t texel[4])
{
    tp_texture t = { .log2_w = 3, .log2_h = 0, .levels = 4 };
    static uint32_t rows[4][8];

    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < 8; i++)
            rows[k][i] = texel[k];
        t.level[k] = rows[k];
    }
    return t;
}

/* All samples of 16 columns take the level of the first sample in the span, even if the
 * span begins in the middle of the columns; a depth factor of 2^(2/3) is a level on
 * water. */
static void a_level_is_that_of_the_first_sample_of_16_columns(void **state)
{
    (void)state;
    uint32_t texel[4] = { 0x1e1eff, 0x3c3cff, 0x5a5aff, 0x7878ff };
    const tp_texture t = numbered(texel);
    tp_shade s = { .zi_log = tp_log2_q8(0x4000) + 15 * 256 };

    for (int n = 0; n < RUNS; n++) {
        uint32_t taken[TP_RUN];
        test_run r;
        run_any(&r, 0, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            const int level = chance_int(&chance, 0, 3);
            r.key[i] = (uint32_t)(0.25 / pow(2, (level + 0.5) / 1.5) * 4294967296.0);
            taken[i] = texel[level];
            r.n[i] = 0;
        }
        own.base.layer = own.ripple.layer = (tp_layer){ .texture = &t };
        own.ripple.gain = 256;
        any_part(&r);
        run_by(tp_stage_texture, &s, &own.base, &r.run);
        run_by(tp_stage_ripple, &s, &own.ripple, &r.run);
        const int32_t begin = (int32_t)(r.run.key - r.key);
        uint32_t want = 0;
        for (int i = 0; i < r.run.count; i++) {
            if (i == 0 || (r.run.x + i) % 16 == 0)
                want = taken[begin + i];
            assert_int_equal(r.run.colour[i], want);
            const double slope = (128 - (double)(want >> 16)) / 127 * 4096;
            assert_true(fabs(r.run.sx[i] - slope) <= 2);
            assert_true(fabs(r.run.sz[i] + slope) <= 2);
        }
    }
}

/* -- rippled water --------------------------------------------------------------------- */

/* N.V of rippled water stays at 0.1 or above for any tilt; smooth water may be seen edge
 * on.  Everything else is the same. */
static void rippled_water_stays_turned_to_the_eye(void **state)
{
    (void)state;
    int held = 0;

    for (int n = 0; n < RUNS; n++) {
        const test_view v = view_any(&chance);
        tp_shade s = shade_of(&v);
        test_run r;
        tp_shade_shine(shine, 20 * TP_FX_ONE, TP_FX_ONE);
        run_any(&r, 4096, &chance);
        tp_stage_view(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            r.run.sx[i] = (int16_t)(r.n[i] >> 16);
            r.run.sz[i] = (int16_t)(r.n[i] & 0xffff);
        }
        tp_run rippled = r.run;
        tp_stage_light(&s, &r.run);
        tp_stage_light_rippled(&s, &rippled);
        for (int i = 0; i < TP_RUN; i++) {
            assert_int_equal(rippled.colour[i], r.run.colour[i]);
            assert_int_equal(rippled.nv[i], r.run.nv[i] < 1638 ? 1638 : r.run.nv[i]);
            if (r.run.nv[i] >= 1638) {
                assert_int_equal(rippled.up[i], r.run.up[i]);
                assert_int_equal(rippled.glint[i], r.run.glint[i]);
            }
            held += r.run.nv[i] < 1638;
        }
    }
    assert_true(held > 1000);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(views_are_bowed_between_multiples_of_16),
        cmocka_unit_test(views_are_no_more_than_2_in_10000_short),
        cmocka_unit_test(the_sky_is_linear_between_multiples_of_32),
        cmocka_unit_test(the_skys_height_is_as_near_as_stated),
        cmocka_unit_test(a_level_is_that_of_the_first_sample_of_16_columns),
        cmocka_unit_test(rippled_water_stays_turned_to_the_eye),
    };
    return cmocka_run_group_tests_name("shade/rules", tests, NULL, NULL);
}
