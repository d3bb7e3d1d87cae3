/* SPDX-License-Identifier: MIT */
/* Textures on water and meshes against a plain sampler: any sides, all levels, places far
 * beyond the first repeat; and which level is taken. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/texture.h"
#include "asset/mesh.h"
#include "runs.h"

#define Q12 4096.0

static uint64_t chance;

typedef void stage(const tp_shade *shade, tp_run *run);

/* A texture of random texels, alpha too, in memory of its own. */
static tp_texture any_texture(uint32_t w, uint32_t h)
{
    uint32_t *const pixels = malloc((size_t)w * h * sizeof *pixels);
    tp_texture t;

    for (uint32_t i = 0; i < w * h; i++)
        pixels[i] = (uint32_t)random_next(&chance);
    assert_int_equal(
        tp_texture_init(&t, pixels, w, h, malloc(tp_texture_bytes(w, h)), NULL), TP_OK);
    free(pixels);
    return t;
}

static void texture_free(tp_texture *t)
{
    free((void *)(uintptr_t)t->level[0]);
}

/* All samples at one depth, where `layer` is at the texture's level. */
static tp_shade shade_at_level(test_run *r, tp_layer *layer, int level)
{
    const tp_shade s = { .zi_log = 15 * 256 + 14 * 256 };

    for (int i = 0; i < TP_RUN; i++)
        r->key[i] = 0x10000000;
    layer->lod = level * 256 + 64 - tp_log_depth(&s, r->key[0]);
    if (tp_log_depth(&s, r->key[0]) > 0)
        layer->lod -= tp_log_depth(&s, r->key[0]) / 2;
    return s;
}

static tp_layer any_layer(const tp_texture *texture)
{
    return (tp_layer){
        .texture = texture,
        .per_metre = (uint32_t)(random_next(&chance) >> chance_int(&chance, 32, 50)),
        .drift_s = (uint32_t)random_next(&chance),
        .drift_t = (uint32_t)random_next(&chance),
        .slope_gain = chance_int(&chance, 0, 1024),
    };
}

/* The place in repeats as the layer's numbers state it: Q0.32, wrapping. */
static double repeats(uint32_t place, uint32_t per_metre, uint32_t drift)
{
    return (place * per_metre + drift) / 4294967296.0;
}

static const uint32_t sides[][2] = { { 1, 1 },    { 2, 1 },   { 1, 64 },  { 256, 256 },
                                     { 16, 128 }, { 512, 2 }, { 4096, 1 } };
enum { SIDES = sizeof sides / sizeof sides[0] };

/* -- texels -------------------------------------------------------------------------- */

static void compare_nearest(const tp_texture *texture, int level)
{
    test_run r;
    tp_layer layer = any_layer(texture);
    run_any(&r, 0, &chance);
    tp_shade s = shade_at_level(&r, &layer, level);

    s.water = layer;
    s.water_colour = (uint32_t)random_next(&chance) & 0xffffff;
    tp_stage_texture(&s, &r.run);
    test_run tinted = r;
    tinted.run.key = tinted.key;
    tinted.run.s = tinted.s;
    tinted.run.t = tinted.t;
    tp_stage_texture_tinted(&s, &tinted.run);
    for (int i = 0; i < TP_RUN; i++) {
        const uint32_t want =
            ref_nearest(texture, level, repeats(r.s[i], layer.per_metre, layer.drift_s),
                        repeats(r.t[i], layer.per_metre, layer.drift_t));
        assert_int_equal(r.run.colour[i], want & 0xffffff);
        assert_true(ref_off(tinted.run.colour[i],
                            ref_times(ref_colour_of(want), ref_colour_of(s.water_colour)))
                    < 1);
    }
}

static void nearest_takes_the_texel_that_holds_the_place(void **state)
{
    (void)state;
    for (int n = 0; n < SIDES; n++) {
        tp_texture t = any_texture(sides[n][0], sides[n][1]);
        for (int level = 0; level < t.levels; level++) {
            for (int k = 0; k < 20; k++)
                compare_nearest(&t, level);
        }
        texture_free(&t);
    }
}

/* Weights are cut to 1/256 of up to 255 levels, one a direction; three mixes are cut. */
static void compare_linear(const tp_texture *texture, int level, measure *off)
{
    test_run r;
    tp_layer layer = any_layer(texture);
    run_any(&r, 0, &chance);
    tp_shade s = shade_at_level(&r, &layer, level);

    s.water = layer;
    tp_stage_texture_linear(&s, &r.run);
    for (int i = 0; i < TP_RUN; i++) {
        const double e = ref_off(
            r.run.colour[i],
            ref_linear(texture, level, repeats(r.s[i], layer.per_metre, layer.drift_s),
                       repeats(r.t[i], layer.per_metre, layer.drift_t)));
        assert_true(e <= 4);
        measure_add(off, e, r.s[i], r.t[i], level);
    }
}

static void linear_mixes_the_four_around_the_place(void **state)
{
    (void)state;
    measure off = { .what = "linear", .unit = "levels of 255" };

    for (int n = 0; n < SIDES; n++) {
        tp_texture t = any_texture(sides[n][0], sides[n][1]);
        for (int level = 0; level < t.levels; level++) {
            for (int k = 0; k < 20; k++)
                compare_linear(&t, level, &off);
        }
        texture_free(&t);
    }
    measure_print(&off);
}

/* A texture of one colour, however filtered, tinted by white or moved, is that colour. */
static void one_colour_stays_one_colour(void **state)
{
    (void)state;
    const uint32_t colour = 0xff8040c0;
    uint32_t pixels[64], mem[128];
    tp_texture t;

    for (int i = 0; i < 64; i++)
        pixels[i] = colour;
    assert_int_equal(tp_texture_init(&t, pixels, 16, 4, mem, NULL), TP_OK);
    for (int n = 0; n < 400; n++) {
        static stage *const stages[] = { tp_stage_texture, tp_stage_texture_tinted,
                                         tp_stage_texture_linear,
                                         tp_stage_texture_linear_tinted };
        test_run r;
        tp_layer layer = any_layer(&t);
        run_any(&r, 0, &chance);
        tp_shade s = shade_at_level(&r, &layer, n % 5);
        s.water = layer;
        s.water_colour = 0xffffff;
        stages[n % 4](&s, &r.run);
        for (int i = 0; i < TP_RUN; i++)
            assert_int_equal(r.run.colour[i], colour & 0xffffff);
    }
}

/* Repeats end where they begin: a place and the same some repeats on are one texel. */
static void repeats_wrap_around(void **state)
{
    (void)state;
    tp_texture t = any_texture(8, 32);
    test_run r;
    tp_layer layer = { .texture = &t, .per_metre = 1u << 13 };      /* 8 m a repeat */
    run_any(&r, 0, &chance);
    tp_shade s = shade_at_level(&r, &layer, 0);
    s.water = layer;

    for (int i = 0; i < TP_RUN; i++) {
        r.s[i] = (uint32_t)(8 * TP_FX_ONE) * (uint32_t)(i * 31 - 900) + 70000;
        r.t[i] = (uint32_t)(8 * TP_FX_ONE) * (uint32_t)(i * 17 - 500) + 444444;
    }
    tp_stage_texture_linear(&s, &r.run);
    for (int i = 1; i < TP_RUN; i++)
        assert_int_equal(r.run.colour[i], r.run.colour[0]);
    texture_free(&t);
}

/* -- levels -------------------------------------------------------------------------- */

/* A texture whose levels tell their number. */
static tp_texture numbered(void)
{
    tp_texture t = any_texture(256, 256);

    for (int level = 0; level < t.levels; level++) {
        uint32_t *const at = (uint32_t *)(uintptr_t)t.level[level];
        for (int i = 0; i < ref_side(8, level) * ref_side(8, level); i++)
            at[i] = (uint32_t)level;
    }
    return t;
}

/* The level by whole numbers, except where the logarithms' twelfths may tip it. */
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
        s.water = layer;
        for (int i = 0; i < TP_RUN; i++)
            r.key[i] = r.key[0];
        tp_stage_texture(&s, &r.run);
        /* Metres, where key is 2^32 near / depth. */
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
    texture_free(&t);
}

/* The first sample of each 16 columns chooses for all of them. */
static void a_level_holds_for_sixteen_columns(void **state)
{
    (void)state;
    tp_texture t = numbered();
    int changes = 0;

    for (int n = 0; n < 500; n++) {
        test_run r;
        tp_shade s = { .zi_log = 29 * 256 };
        run_any(&r, 0, &chance);
        s.water = (tp_layer){ .texture = &t, .lod = 256 };
        tp_stage_texture(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            assert_int_equal(r.run.colour[i], r.run.colour[i & ~15]);
            changes += i % 16 == 0 && r.run.colour[i] != r.run.colour[0];
        }
    }
    assert_true(changes > 100);
    texture_free(&t);
}

/* -- ripples ------------------------------------------------------------------------- */

/* Slopes of a normal map: -nx along s, +ny along t, 128 being 1, times the gain; the
 * sampler's 4 levels and two cuts. */
static void ripples_add_the_slopes_of_a_normal_map(void **state)
{
    (void)state;
    measure off = { .what = "ripple", .unit = "of slope 1" };

    for (int n = 0; n < SIDES * 60; n++) {
        tp_texture t = any_texture(sides[n % SIDES][0], sides[n % SIDES][1]);
        test_run r;
        tp_layer layer = any_layer(&t);
        const int level = chance_int(&chance, 0, t.levels - 1);
        run_any(&r, 20000, &chance);
        tp_shade s = shade_at_level(&r, &layer, level);
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
        texture_free(&t);
    }
    measure_print(&off);
}

/* -- meshes -------------------------------------------------------------------------- */

/* Full ambient light and nothing else: the texel times the diffuse colour. */
static void solids_show_the_texel_that_holds_the_place(void **state)
{
    (void)state;
    static const uint8_t dull[TP_GLOSS];
    const tp_mesh mesh = { 0 };

    for (int n = 0; n < SIDES * 40; n++) {
        tp_texture t = any_texture(sides[n % SIDES][0], sides[n % SIDES][1]);
        const int level = chance_int(&chance, 0, t.levels - 1);
        tp_solid solid = { .diffuse = n % 2 ? 0xffffff
                                            : (uint32_t)random_next(&chance) & 0xffffff,
                           .diffuse_map = &t,
                           .gloss = dull };
        tp_shade s = { .zi_log = 29 * 256,
                       .ambient = 256,
                       .focal = 300 * 16,
                       .boat = &mesh,
                       .solid = &solid,
                       .mesh = { { TP_Q30_ONE, 0, 0 },
                                 { 0, TP_Q30_ONE, 0 },
                                 { 0, 0, TP_Q30_ONE },
                                 0,
                                 16384,
                                 0 } };
        test_run r;
        run_any(&r, 0, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            r.key[i] = 0x20000000;
            r.n[i] = tp_dir_pack((tp_dir3){ 0, TP_Q30_ONE, 0 });
        }
        solid.lod = level * 256 + 64 - tp_log_depth(&s, r.key[0]);
        tp_stage_solid(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const uint32_t want = ref_nearest(&t, level, (r.s[i] >> 16) / 65536.0,
                                              (r.s[i] & 0xffff) / 65536.0);
            assert_true(ref_off(r.run.colour[i], ref_times(ref_colour_of(want),
                                                           ref_colour_of(solid.diffuse)))
                        < 1);
        }
        texture_free(&t);
    }
}

/* -- cuts ---------------------------------------------------------------------------- */

/* Tiles begin at multiples of 16, so runs are cut there. */
static void runs_may_be_cut_at_sixteenths(void **state)
{
    (void)state;
    static stage *const stages[] = { tp_stage_texture, tp_stage_texture_tinted,
                                     tp_stage_texture_linear,
                                     tp_stage_texture_linear_tinted, tp_stage_ripple };
    tp_texture t = any_texture(64, 16);

    for (int n = 0; n < 1000; n++) {
        test_run r;
        tp_shade s = { .zi_log = 29 * 256, .water_colour = 0xc08040 };
        run_any(&r, 5000, &chance);
        s.water = s.ripple = any_layer(&t);
        s.water.lod = s.ripple.lod = chance_int(&chance, -2000, 2000);
        const tp_run before = r.run;
        stages[n % 5](&s, &r.run);
        for (int32_t from = 0; from < TP_RUN; from += 16) {
            tp_run part = run_part(&before, from, from + 16);
            const tp_run want = run_part(&r.run, from, from + 16);
            stages[n % 5](&s, &part);
            assert_memory_equal(part.colour, want.colour, 16 * sizeof *part.colour);
            assert_memory_equal(part.sx, want.sx, 16 * sizeof *part.sx);
            assert_memory_equal(part.sz, want.sz, 16 * sizeof *part.sz);
        }
    }
    texture_free(&t);
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
        cmocka_unit_test(ripples_add_the_slopes_of_a_normal_map),
        cmocka_unit_test(solids_show_the_texel_that_holds_the_place),
        cmocka_unit_test(runs_may_be_cut_at_sixteenths),
    };
    return cmocka_run_group_tests_name("texture", tests, NULL, NULL);
}
