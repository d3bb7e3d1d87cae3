/* SPDX-License-Identifier: MIT */
/* Capillary waves compared with the exact matrix [F6] in double precision: rotated into the
 * surface, and added to a gentle surface. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/layers.h"
#include "tests/lib/measure.h"

#define Q12 4096.0
#define MOST (32000 / Q12)

static uint64_t chance;

/* A normal map with slopes up to `steep`; blue is consistent. */
static tp_texture normal_map(uint32_t w, uint32_t h, double steep)
{
    uint32_t *const pixels = malloc((size_t)w * h * sizeof *pixels);
    tp_texture t;

    for (uint32_t i = 0; i < w * h; i++) {
        const ref_dir n = ref_normal(chance_double(&chance, -steep, steep),
                                     chance_double(&chance, -steep, steep));
        pixels[i] = (uint32_t)lround(128 + 127 * n.x) << 16
                  | (uint32_t)lround(128 + 127 * n.z) << 8
                  | (uint32_t)lround(128 + 127 * n.y);
    }
    assert_int_equal(tp_texture_init(&t, pixels, w, h, malloc(tp_texture_bytes(w, h)),
                                     tp_texture_bytes(w, h), NULL),
                     TP_OK);
    free(pixels);
    return t;
}

static void bump_of(const test_run *r, const tp_layer *layer, int level, int i,
                    double n[3])
{
    const ref_colour c =
        ref_linear(layer->texture, level, repeats(r->s[i], layer->per_metre,
                                                  layer->drift_s),
                   repeats(r->t[i], layer->per_metre, layer->drift_t));
    for (int k = 0; k < 3; k++)
        n[k] = (c.c[k] - 128) / 128 * (k < 2 ? own.ripple.gain / 256.0 : 1);
    n[2] = fmax(n[2], 0.125);
}

/* Errors of one stage, for surfaces up to the slope `surface` and ripples up to `ripple`:
 * rms and worst of slopes, and rms of normals in 1/255 of their length.  Light has no finer
 * resolution. */
typedef struct {
    double sum, worst, levels;
    int    count;
} ripple_tally;

static void tally_add(ripple_tally *t, const double want[2], int16_t sx, int16_t sz)
{
    const double wx = ref_clamp(want[0], -MOST, MOST), wz = ref_clamp(want[1], -MOST, MOST);
    const double ex = sx / Q12 - wx, ez = sz / Q12 - wz;
    const ref_dir a = ref_normal(wx, wz), b = ref_normal(sx / Q12, sz / Q12);
    const ref_dir d = { a.x - b.x, a.y - b.y, a.z - b.z };

    t->sum += ex * ex + ez * ez;
    t->worst = fmax(t->worst, fmax(fabs(ex), fabs(ez)));
    t->levels += ref_dir_dot(d, d) * 255 * 255;
    t->count += 2;
}

static ripple_tally compare(stage *ripples, double surface, double ripple)
{
    ripple_tally all = { 0 };

    for (int n = 0; n < 300; n++) {
        tp_texture t = normal_map(32, 16, ripple);
        const int level = chance_int(&chance, 0, 3);
        test_run r;
        tp_layer layer = layer_any(&chance, &t);
        run_any(&r, (int32_t)(surface * Q12), &chance);
        own.ripple.gain = 256;
        tp_shade s = layer_at_level(&r, &layer, level);
        own.ripple.layer = layer;
        run_by(ripples, &s, &own.ripple, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            double bump[3], want[2];
            bump_of(&r, &layer, level, i, bump);
            ref_turned((int16_t)(r.n[i] >> 16) / Q12, (int16_t)(r.n[i] & 0xffff) / Q12,
                       bump, want);
            tally_add(&all, want, r.run.sx[i], r.run.sz[i]);
        }
        layer_free(&t);
    }
    all.sum = sqrt(all.sum / all.count);
    all.levels = sqrt(all.levels / all.count * 2);
    return all;
}

static void ripples_are_turned_into_the_surface(void **state)
{
    (void)state;
    static const struct {
        double surface, ripple, levels, added;
    } rows[] = {
        { 0, 0.35, 0.3, 0.4 },  { 0.17, 0.35, 0.4, 1.5 },   /* 0.24 in both directions */
        { 0.5, 0.35, 0.4, 5 },  { 1, 0.7, 0.6, 25 },
        { 3, 0.35, 0.5, 25 },   { 7.9, 0.35, 0.8, 45 },
    };

    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const ripple_tally turned =
            compare(tp_stage_ripple, rows[i].surface, rows[i].ripple);
        const ripple_tally added =
            compare(tp_stage_ripple_gentle, rows[i].surface, rows[i].ripple);
        printf("    surface %-4g ripple %-4g turned rms %.4f worst %.4f (%.2f/255)"
               "  added rms %.4f worst %.4f (%.2f/255)\n", rows[i].surface,
               rows[i].ripple, turned.sum, turned.worst, turned.levels, added.sum,
               added.worst, added.levels);
        assert_true(turned.levels <= rows[i].levels);
        assert_true(added.levels <= rows[i].added);
    }
}

/* Any texels at any gain on surfaces of the greatest slope: no slope leaves its range, and
 * slopes that are not clamped are close to the exact slopes. */
static void no_ripple_turns_the_water_upside_down(void **state)
{
    (void)state;
    measure off = { .what = "hostile ripple", .unit = "degrees" };

    for (int n = 0; n < SIDES * 60; n++) {
        tp_texture t = layer_texture(&chance, sides[n % SIDES][0], sides[n % SIDES][1]);
        const int level = chance_int(&chance, 0, t.levels - 1);
        test_run r;
        tp_layer layer = layer_any(&chance, &t);
        own.ripple.gain = chance_int(&chance, 0, 1024);
        run_any(&r, 32767, &chance);
        if (n % 3 == 0)
            r.n[0] = 0x80008000;
        tp_shade s = layer_at_level(&r, &layer, level);
        own.ripple.layer = layer;
        run_by(tp_stage_ripple, &s, &own.ripple, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            double bump[3], want[2];
            bump_of(&r, &layer, level, i, bump);
            ref_turned((int16_t)(r.n[i] >> 16) / Q12, (int16_t)(r.n[i] & 0xffff) / Q12,
                       bump, want);
            assert_in_range(r.run.sx[i] + 32000, 0, 64000);
            assert_in_range(r.run.sz[i] + 32000, 0, 64000);
            const ref_dir a = ref_normal(ref_clamp(want[0], -MOST, MOST),
                                         ref_clamp(want[1], -MOST, MOST));
            const ref_dir b = ref_normal(r.run.sx[i] / Q12, r.run.sz[i] / Q12);
            measure_add(&off, acos(fmin(1, ref_dir_dot(a, b))) * 57.3, r.n[i],
                        own.ripple.gain, level);
        }
        layer_free(&t);
    }
    measure_print(&off);
}

/* Blue straight up means no ripple. */
static void a_flat_map_leaves_the_surface(void **state)
{
    (void)state;
    uint32_t up = 0xff8080ff, mem[1];
    tp_texture t;
    test_run r;

    assert_int_equal(tp_texture_init(&t, &up, 1, 1, mem, tp_texture_bytes(1, 1), NULL),
                     TP_OK);
    run_any(&r, 20000, &chance);
    const tp_shade s = { .zi_log = 29 * 256 };
    own.ripple = (tp_ripple){ .layer.texture = &t, .gain = 1024 };
    run_by(tp_stage_ripple, &s, &own.ripple, &r.run);
    for (int i = 0; i < TP_RUN; i++) {
        assert_in_range(r.run.sx[i] - (int16_t)(r.n[i] >> 16) + 8, 0, 16);
        assert_in_range(r.run.sz[i] - (int16_t)(r.n[i] & 0xffff) + 8, 0, 16);
    }
}

/* -- gentle surfaces ----------------------------------------------------------------- */

/* Slopes of a normal map: -nx along s, +ny along t, 128 is 1, times the gain; tolerance:
 * the sampler's 4 levels and two truncations. */
static void gentle_ripples_add_the_slopes_of_a_normal_map(void **state)
{
    (void)state;
    measure off = { .what = "gentle ripple", .unit = "of slope 1" };

    for (int n = 0; n < SIDES * 60; n++) {
        tp_texture t = layer_texture(&chance, sides[n % SIDES][0], sides[n % SIDES][1]);
        test_run r;
        tp_layer layer = layer_any(&chance, &t);
        const int level = chance_int(&chance, 0, t.levels - 1);
        own.ripple.gain = chance_int(&chance, 0, 1024);
        run_any(&r, 20000, &chance);
        tp_shade s = layer_at_level(&r, &layer, level);
        own.ripple.layer = layer;
        run_by(tp_stage_ripple_gentle, &s, &own.ripple, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            double bump[3];
            bump_of(&r, &layer, level, i, bump);
            const double sx = (int16_t)(r.n[i] >> 16) / Q12 - bump[0] * (2 - bump[2]);
            const double sz = (int16_t)(r.n[i] & 0xffff) / Q12 + bump[1] * (2 - bump[2]);
            const double e = fmax(fabs(r.run.sx[i] / Q12 - ref_clamp(sx, -MOST, MOST)),
                                  fabs(r.run.sz[i] / Q12 - ref_clamp(sz, -MOST, MOST)));
            assert_true(e <= 4 * 4 / 128.0 * own.ripple.gain / 256.0 + 2 / Q12);
            measure_add(&off, e, r.s[i], r.t[i], own.ripple.gain);
        }
        layer_free(&t);
    }
    measure_print(&off);
}

/* -- over pools, and cuts ------------------------------------------------------------ */

static void ripples_lie_on_what_pools_have_bent(void **state)
{
    (void)state;
    tp_texture t = normal_map(64, 16, 0.5);

    for (int n = 0; n < 100; n++) {
        test_run r;
        const tp_shade s = { .zi_log = 29 * 256 };
        own.ripple = (tp_ripple){ layer_any(&chance, &t), chance_int(&chance, 0, 1024) };
        run_any(&r, 9000, &chance);
        tp_run over = r.run;
        for (int i = 0; i < TP_RUN; i++) {
            over.sx[i] = (int16_t)(r.n[i] >> 16);
            over.sz[i] = (int16_t)(r.n[i] & 0xffff);
        }
        run_by(tp_stage_ripple, &s, &own.ripple, &r.run);
        run_by(tp_stage_ripple_pool_slopes, &s, &own.ripple, &over);
        assert_memory_equal(over.sx, r.run.sx, sizeof r.run.sx);
        assert_memory_equal(over.sz, r.run.sz, sizeof r.run.sz);
    }
    layer_free(&t);
}

static void runs_may_be_cut_at_sixteenths(void **state)
{
    (void)state;
    static stage *const stages[] = { tp_stage_ripple, tp_stage_ripple_gentle,
                                     tp_stage_ripple_pool_slopes };
    tp_texture t = layer_texture(&chance, 64, 16);

    for (int n = 0; n < 600; n++) {
        test_run r;
        const tp_shade s = { .zi_log = 29 * 256 };
        own.ripple = (tp_ripple){ layer_any(&chance, &t), chance_int(&chance, 0, 1024) };
        run_any(&r, 5000, &chance);
        memset(r.run.sx, 17, sizeof r.run.sx);
        memset(r.run.sz, 3, sizeof r.run.sz);
        own.ripple.layer.lod = chance_int(&chance, -2000, 2000);
        const tp_run before = r.run;
        run_by(stages[n % 3], &s, &own.ripple, &r.run);
        for (int32_t from = 0; from < TP_RUN; from += 16) {
            tp_run part = run_part(&before, from, from + 16);
            const tp_run want = run_part(&r.run, from, from + 16);
            run_by(stages[n % 3], &s, &own.ripple, &part);
            assert_memory_equal(part.sx, want.sx, 16 * sizeof *part.sx);
            assert_memory_equal(part.sz, want.sz, 16 * sizeof *part.sz);
        }
    }
    layer_free(&t);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ripples_are_turned_into_the_surface),
        cmocka_unit_test(no_ripple_turns_the_water_upside_down),
        cmocka_unit_test(a_flat_map_leaves_the_surface),
        cmocka_unit_test(gentle_ripples_add_the_slopes_of_a_normal_map),
        cmocka_unit_test(ripples_lie_on_what_pools_have_bent),
        cmocka_unit_test(runs_may_be_cut_at_sixteenths),
    };
    return cmocka_run_group_tests_name("features/water ripple", tests, NULL, NULL);
}
