/* SPDX-License-Identifier: MIT */
/* Capillary waves: slopes of a normal map, added to the surface's. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "layers.h"
#include "measure.h"

#define Q12 4096.0

static uint64_t chance;

/* Slopes of a normal map: -nx along s, +ny along t, 128 being 1, times the gain; the
 * sampler's 4 levels and two cuts. */
static void ripples_add_the_slopes_of_a_normal_map(void **state)
{
    (void)state;
    measure off = { .what = "ripple", .unit = "of slope 1" };

    for (int n = 0; n < SIDES * 60; n++) {
        tp_texture t = layer_texture(&chance, sides[n % SIDES][0], sides[n % SIDES][1]);
        test_run r;
        tp_layer layer = layer_any(&chance, &t);
        const int level = chance_int(&chance, 0, t.levels - 1);
        run_any(&r, 20000, &chance);
        tp_shade s = layer_at_level(&r, &layer, level);
        s.ripple = layer;
        tp_stage_ripple(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_colour c =
                ref_linear(&t, level, repeats(r.s[i], layer.per_metre, layer.drift_s),
                           repeats(r.t[i], layer.per_metre, layer.drift_t));
            const double gain = layer.slope_gain / 256.0, most = 32000 / Q12;
            const double sx = (int16_t)(r.n[i] >> 16) / Q12 - (c.c[0] - 128) / 128 * gain;
            const double sz =
                (int16_t)(r.n[i] & 0xffff) / Q12 + (c.c[1] - 128) / 128 * gain;
            const double e = fmax(fabs(r.run.sx[i] / Q12 - ref_clamp(sx, -most, most)),
                                  fabs(r.run.sz[i] / Q12 - ref_clamp(sz, -most, most)));
            assert_true(e <= 4 / 128.0 * gain + 2 / Q12);
            measure_add(&off, e, r.s[i], r.t[i], layer.slope_gain);
        }
        layer_free(&t);
    }
    measure_print(&off);
}

/* -- over pools, and cut ------------------------------------------------------------- */

static void ripples_lie_on_what_pools_have_bent(void **state)
{
    (void)state;
    tp_texture t = layer_texture(&chance, 64, 16);

    for (int n = 0; n < 100; n++) {
        test_run r;
        tp_shade s = { .zi_log = 29 * 256, .ripple = layer_any(&chance, &t) };
        tp_shade_tables(&s);
        run_any(&r, 9000, &chance);
        tp_run over = r.run;
        for (int i = 0; i < TP_RUN; i++) {
            over.sx[i] = (int16_t)(r.n[i] >> 16);
            over.sz[i] = (int16_t)(r.n[i] & 0xffff);
        }
        tp_stage_ripple(&s, &r.run);
        tp_stage_ripple_over(&s, &over);
        assert_memory_equal(over.sx, r.run.sx, sizeof r.run.sx);
        assert_memory_equal(over.sz, r.run.sz, sizeof r.run.sz);
    }
    layer_free(&t);
}

static void runs_may_be_cut_at_sixteenths(void **state)
{
    (void)state;
    static stage *const stages[] = { tp_stage_ripple, tp_stage_ripple_over };
    tp_texture t = layer_texture(&chance, 64, 16);

    for (int n = 0; n < 600; n++) {
        test_run r;
        tp_shade s = { .zi_log = 29 * 256, .ripple = layer_any(&chance, &t) };
        tp_shade_tables(&s);
        run_any(&r, 5000, &chance);
        memset(r.run.sx, 17, sizeof r.run.sx);
        memset(r.run.sz, 3, sizeof r.run.sz);
        s.ripple.lod = chance_int(&chance, -2000, 2000);
        const tp_run before = r.run;
        stages[n % 2](&s, &r.run);
        for (int32_t from = 0; from < TP_RUN; from += 16) {
            tp_run part = run_part(&before, from, from + 16);
            const tp_run want = run_part(&r.run, from, from + 16);
            stages[n % 2](&s, &part);
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
        cmocka_unit_test(ripples_add_the_slopes_of_a_normal_map),
        cmocka_unit_test(ripples_lie_on_what_pools_have_bent),
        cmocka_unit_test(runs_may_be_cut_at_sixteenths),
    };
    return cmocka_run_group_tests_name("ripple", tests, NULL, NULL);
}
