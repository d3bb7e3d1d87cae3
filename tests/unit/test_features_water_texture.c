/* SPDX-License-Identifier: MIT */
/* Textures on water and meshes compared with a plain sampler: any sides, all mipmap levels,
 * positions far beyond the first repeat; and the selection of the level. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/boat/boat.h"
#include "mesh/mesh.h"
#include "tests/lib/layers.h"
#include "tests/lib/measure.h"

static uint64_t chance;

/* -- texels -------------------------------------------------------------------------- */

static void compare_nearest(const tp_texture *texture, int level)
{
    test_run r;
    tp_layer layer = layer_any(&chance, texture);
    run_any(&r, 0, &chance);
    tp_shade s = layer_at_level(&r, &layer, level);

    own.base.layer = layer;
    s.water_colour = (uint32_t)random_next(&chance) & 0xffffff;
    run_by(tp_stage_texture, &s, &own.base, &r.run);
    test_run tinted = r;
    tinted.run.key = tinted.key;
    tinted.run.s = tinted.s;
    tinted.run.t = tinted.t;
    tinted.run.ls = tinted.s;
    tinted.run.lt = tinted.t;
    run_by(tp_stage_texture_tinted, &s, &own.base, &tinted.run);
    for (int i = 0; i < TP_RUN; i++) {
        const uint32_t want =
            ref_nearest(texture, level, repeats(r.s[i], layer.per_metre, layer.drift_s),
                        repeats(r.t[i], layer.per_metre, layer.drift_t));
        assert_int_equal(r.run.colour[i], want & 0xffffff);
        assert_true(ref_colour_difference(tinted.run.colour[i],
                                          ref_times(ref_colour_unpack(want),
                                                    ref_colour_unpack(s.water_colour)))
                    < 1);
    }
}

static void nearest_takes_the_texel_that_holds_the_place(void **state)
{
    (void)state;
    for (int n = 0; n < SIDES; n++) {
        tp_texture t = layer_texture(&chance, sides[n][0], sides[n][1]);
        for (int level = 0; level < t.levels; level++) {
            for (int k = 0; k < 20; k++)
                compare_nearest(&t, level);
        }
        layer_free(&t);
    }
}

/* Weights are truncated to 1/256 of up to 255 levels in each direction; two mixes, the
 * second of the first, are rounded. */
static void compare_linear(const tp_texture *texture, int level, measure *off)
{
    test_run r;
    tp_layer layer = layer_any(&chance, texture);
    run_any(&r, 0, &chance);
    tp_shade s = layer_at_level(&r, &layer, level);

    own.base.layer = layer;
    run_by(tp_stage_texture_linear, &s, &own.base, &r.run);
    for (int i = 0; i < TP_RUN; i++) {
        const double e = ref_colour_difference(
            r.run.colour[i],
            ref_linear(texture, level, repeats(r.s[i], layer.per_metre, layer.drift_s),
                       repeats(r.t[i], layer.per_metre, layer.drift_t)));
        assert_true(e <= 3);
        measure_add(off, e, r.s[i], r.t[i], level);
    }
}

static void linear_mixes_the_four_around_the_place(void **state)
{
    (void)state;
    measure off = { .what = "linear", .unit = "levels of 255" };

    for (int n = 0; n < SIDES; n++) {
        tp_texture t = layer_texture(&chance, sides[n][0], sides[n][1]);
        for (int level = 0; level < t.levels; level++) {
            for (int k = 0; k < 20; k++)
                compare_linear(&t, level, &off);
        }
        layer_free(&t);
    }
    measure_print(&off);
}

/* A texture of a single colour keeps the colour under any filter, a white tint or an
 * offset. */
static void one_colour_stays_one_colour(void **state)
{
    (void)state;
    const uint32_t colour = 0xff8040c0;
    uint32_t pixels[64], mem[128];
    tp_texture t;

    for (int i = 0; i < 64; i++)
        pixels[i] = colour;
    assert_int_equal(
        tp_texture_init(&t, pixels, 16, 4, mem, tp_texture_bytes(16, 4), NULL), TP_OK);
    for (int n = 0; n < 400; n++) {
        static stage *const stages[] = { tp_stage_texture, tp_stage_texture_tinted,
                                         tp_stage_texture_linear,
                                         tp_stage_texture_linear_tinted };
        test_run r;
        tp_layer layer = layer_any(&chance, &t);
        run_any(&r, 0, &chance);
        tp_shade s = layer_at_level(&r, &layer, n % 5);
        own.base.layer = layer;
        s.water_colour = 0xffffff;
        run_by(stages[n % 4], &s, &own.base, &r.run);
        for (int i = 0; i < TP_RUN; i++)
            assert_int_equal(r.run.colour[i], colour & 0xffffff);
    }
}

/* Repeats are seamless: positions a whole number of repeats apart give the same texel. */
static void repeats_wrap_around(void **state)
{
    (void)state;
    tp_texture t = layer_texture(&chance, 8, 32);
    test_run r;
    tp_layer layer = { .texture = &t, .per_metre = 1u << 13 };      /* 8 m per repeat */
    run_any(&r, 0, &chance);
    tp_shade s = layer_at_level(&r, &layer, 0);
    own.base.layer = layer;

    for (int i = 0; i < TP_RUN; i++) {
        r.s[i] = (uint32_t)(8 * TP_FX_ONE) * (uint32_t)(i * 31 - 900) + 70000;
        r.t[i] = (uint32_t)(8 * TP_FX_ONE) * (uint32_t)(i * 17 - 500) + 444444;
    }
    run_by(tp_stage_texture_linear, &s, &own.base, &r.run);
    for (int i = 1; i < TP_RUN; i++)
        assert_int_equal(r.run.colour[i], r.run.colour[0]);
    layer_free(&t);
}

/* -- mipmap levels ------------------------------------------------------------------- */

/* A texture whose texels hold the number of their level. */
static tp_texture numbered(void)
{
    tp_texture t = layer_texture(&chance, 256, 256);

    for (int level = 0; level < t.levels; level++) {
        uint32_t *const at = (uint32_t *)(uintptr_t)t.level[level];
        for (int i = 0; i < ref_side(8, level) * ref_side(8, level); i++)
            at[i] = (uint32_t)level;
    }
    return t;
}

/* The level is a whole number, except near borders where the logarithms' errors of a
 * twelfth may decide. */
static void levels_go_by_the_depth(void **state)
{
    (void)state;
    tp_texture t = numbered();
    int tried = 0;

    for (int n = 0; n < 3000; n++) {
        test_run r;
        tp_layer layer = { .texture = &t, .lod = chance_int(&chance, -8, 8) * 256 + 128 };
        run_any(&r, 0, &chance);
        const double zi_near = chance_scale(&chance, 0.05, 10) / 65536.0;
        tp_shade s = { .zi_log = tp_log2_q8((uint32_t)(zi_near * 65536)) + 15 * 256 };
        own.base.layer = layer;
        for (int i = 0; i < TP_RUN; i++)
            r.key[i] = r.key[0];
        run_by(tp_stage_texture, &s, &own.base, &r.run);
        /* Depth in metres for key = 2^32 near / depth. */
        const double depth = log2(zi_near * 4294967296.0 / r.key[0]);
        const double level = layer.lod / 256.0 + depth + (depth > 0 ? depth / 2 : 0);
        const double slack = 0.1 * (depth > 0 ? 1.5 : 1) + 0.02;
        const int low = (int)ref_clamp(floor(level - slack), 0, 8);
        const int high = (int)ref_clamp(floor(level + slack), 0, 8);
        for (int i = 0; i < TP_RUN; i++)
            assert_in_range(r.run.colour[i], low, high);
        tried += low == high && low > 0 && low < 8;
    }
    assert_true(tried > 300);
    layer_free(&t);
}

/* The first sample of each 16 columns selects the level for all 16. */
static void a_level_holds_for_sixteen_columns(void **state)
{
    (void)state;
    tp_texture t = numbered();
    int changes = 0;

    for (int n = 0; n < 500; n++) {
        test_run r;
        tp_shade s = { .zi_log = 29 * 256 };
        run_any(&r, 0, &chance);
        own.base.layer = (tp_layer){ .texture = &t, .lod = 256 };
        run_by(tp_stage_texture, &s, &own.base, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            assert_int_equal(r.run.colour[i], r.run.colour[i & ~15]);
            changes += i % 16 == 0 && r.run.colour[i] != r.run.colour[0];
        }
    }
    assert_true(changes > 100);
    layer_free(&t);
}

/* -- meshes -------------------------------------------------------------------------- */

/* Full ambient light alone: the colour is the texel times the diffuse colour. */
static void solids_show_the_texel_that_holds_the_place(void **state)
{
    (void)state;
    static const uint8_t dull[TP_GLOSS];
    const tp_mesh mesh = { 0 };

    for (int n = 0; n < SIDES * 40; n++) {
        tp_texture t = layer_texture(&chance, sides[n % SIDES][0], sides[n % SIDES][1]);
        const int level = chance_int(&chance, 0, t.levels - 1);
        tp_solid solid = { .diffuse = n % 2 ? 0xffffff
                                            : (uint32_t)random_next(&chance) & 0xffffff,
                           .diffuse_map = &t,
                           .gloss = dull };
        tp_shade s = { .zi_log = 29 * 256,
                       .ambient = 256,
                       .focal = 300 * 16 };
        const tp_boat_shading shading = { &mesh, &solid, { { TP_Q30_ONE, 0, 0 },
                                                     { 0, TP_Q30_ONE, 0 },
                                                     { 0, 0, TP_Q30_ONE }, 0, 16384, 0 } };
        test_run r;
        run_any(&r, 0, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            r.key[i] = 0x20000000;
            r.n[i] = tp_dir_pack((tp_dir3){ 0, TP_Q30_ONE, 0 });
        }
        solid.lod = level * 256 + 64 - tp_log_depth(&s, r.key[0]);
        r.run.mine = &shading;
        tp_stage_solid(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const uint32_t want = ref_nearest(&t, level, (r.s[i] >> 16) / 65536.0,
                                              (r.s[i] & 0xffff) / 65536.0);
            assert_true(ref_colour_difference(r.run.colour[i],
                                              ref_times(ref_colour_unpack(want),
                                                        ref_colour_unpack(solid.diffuse)))
                        < 1);
        }
        layer_free(&t);
    }
}

/* -- cuts ---------------------------------------------------------------------------- */

/* Tiles begin at multiples of 16, so spans are cut there. */
static void runs_may_be_cut_at_sixteenths(void **state)
{
    (void)state;
    static stage *const stages[] = { tp_stage_texture, tp_stage_texture_tinted,
                                     tp_stage_texture_linear,
                                     tp_stage_texture_linear_tinted };
    tp_texture t = layer_texture(&chance, 64, 16);

    for (int n = 0; n < 1000; n++) {
        test_run r;
        tp_shade s = { .zi_log = 29 * 256, .water_colour = 0xc08040 };
        run_any(&r, 5000, &chance);
        own.base.layer = layer_any(&chance, &t);
        own.base.layer.lod = chance_int(&chance, -2000, 2000);
        const tp_run before = r.run;
        run_by(stages[n % 4], &s, &own.base, &r.run);
        for (int32_t from = 0; from < TP_RUN; from += 16) {
            tp_run part = run_part(&before, from, from + 16);
            const tp_run want = run_part(&r.run, from, from + 16);
            run_by(stages[n % 4], &s, &own.base, &part);
            assert_memory_equal(part.colour, want.colour, 16 * sizeof *part.colour);
        }
    }
    layer_free(&t);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nearest_takes_the_texel_that_holds_the_place),
        cmocka_unit_test(linear_mixes_the_four_around_the_place),
        cmocka_unit_test(one_colour_stays_one_colour),
        cmocka_unit_test(repeats_wrap_around),
        cmocka_unit_test(levels_go_by_the_depth),
        cmocka_unit_test(a_level_holds_for_sixteen_columns),
        cmocka_unit_test(solids_show_the_texel_that_holds_the_place),
        cmocka_unit_test(runs_may_be_cut_at_sixteenths),
    };
    return cmocka_run_group_tests_name("features/water texture", tests, NULL, NULL);
}
