/* SPDX-License-Identifier: MIT */
/* Texture layers of the water compared with a plain sampler: saturation, clamp and colour,
 * added layers, and positions offset by a distortion. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/layers.h"
#include "tests/lib/measure.h"
#include "shade/material.h"

static uint64_t chance;

/* Requested treatment of a layer, in the scene's numbers. */
typedef struct {
    tp_fx    saturation, clamp;
    uint32_t colour;
} grade_wish;

static grade_wish any_wish(void)
{
    return (grade_wish){ chance_int(&chance, 0, 4 * TP_FX_ONE),
                   chance_int(&chance, 0, 3) ? chance_int(&chance, 0, TP_FX(0.95)) : 0,
                   (uint32_t)random_next(&chance) & 0xffffff };
}

static ref_colour sampled(const tp_layer *layer, int level, const test_run *r, int i,
                          int filter)
{
    const double s = repeats(r->s[i], layer->per_metre, layer->drift_s);
    const double t = repeats(r->t[i], layer->per_metre, layer->drift_t);
    return filter ? ref_linear(layer->texture, level, s, t)
                  : ref_colour_unpack(ref_nearest(layer->texture, level, s, t));
}

static ref_colour granted(const grade_wish *w, ref_colour texel)
{
    return ref_grade(texel, w->saturation / 65536.0, w->clamp / 65536.0,
                     ref_colour_unpack(w->colour));
}

/* -- the first layer ----------------------------------------------------------------- */

/* Error bound in levels.  Saturation is truncated to 1/256 of up to 255 levels, then
 * spread; a filtered texel has 4 levels of error, which saturation multiplies by up to
 * three. */
static double slack(const grade_wish *w, int filter)
{
    const double spread = 65536.0 / (65536 - w->clamp), s = w->saturation / 65536.0;
    return 1 + 1.1 * spread + filter * 4 * spread * (1 + 2 * s);
}

static void grades_are_saturation_clamp_and_colour(void **state)
{
    (void)state;
    measure off = { .what = "graded", .unit = "levels of 255" };
    double sum = 0;
    int count = 0;

    for (int n = 0; n < SIDES * 100; n++) {
        tp_texture t = layer_texture(&chance, sides[n % SIDES][0], sides[n % SIDES][1]);
        const int level = chance_int(&chance, 0, t.levels - 1);
        const grade_wish w = any_wish();
        test_run r;
        tp_layer layer = layer_any(&chance, &t);
        run_any(&r, 0, &chance);
        tp_shade s = layer_at_level(&r, &layer, level);
        own.base.layer = layer;
        own.base.grade = tp_grade_make(w.saturation, w.clamp, w.colour);
        run_by(tp_stage_texture_graded, &s, &own.base, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const double e = ref_colour_difference(r.run.colour[i],
                                     granted(&w, sampled(&layer, level, &r, i, 0)));
            assert_true(e <= slack(&w, 0));
            measure_add(&off, e, r.s[i], w.saturation, w.clamp);
            sum += e * e;
            count++;
        }
        layer_free(&t);
    }
    measure_print(&off);
    printf("    graded             rms %.3f\n", sqrt(sum / count));
    assert_true(sqrt(sum / count) <= 1.5);
}

/* Saturation 1, no clamp, white: texels stay unchanged. */
static void a_grade_that_asks_for_nothing_does_nothing(void **state)
{
    (void)state;
    tp_texture t = layer_texture(&chance, 64, 64);

    for (int n = 0; n < 50; n++) {
        static stage *const plain[] = { tp_stage_texture, tp_stage_texture_linear };
        static stage *const graded[] = { tp_stage_texture_graded,
                                         tp_stage_texture_linear_graded };
        test_run r;
        run_any(&r, 0, &chance);
        const tp_shade s = { .zi_log = 29 * 256 };
        own.base.layer = layer_any(&chance, &t);
        own.base.grade = tp_grade_make(TP_FX_ONE, 0, 0xffffff);
        tp_run other = r.run;
        run_by(plain[n % 2], &s, &own.base, &r.run);
        run_by(graded[n % 2], &s, &own.base, &other);
        assert_memory_equal(other.colour, r.run.colour, sizeof r.run.colour);
    }
    layer_free(&t);
}

/* The ends of both parameters: grey, and black except for the whitest texels. */
static void grades_reach_their_ends(void **state)
{
    (void)state;
    uint32_t pixels[4] = { 0xff0000, 0xffffff, 0, 0xf2f2f2 }, mem[16];
    tp_texture t;
    test_run r;
    tp_layer layer = { .per_metre = 1u << 14 };

    assert_int_equal(tp_texture_init(&t, pixels, 4, 1, mem, tp_texture_bytes(4, 1), NULL),
                     TP_OK);
    layer.texture = &t;
    run_any(&r, 0, &chance);
    tp_shade s = layer_at_level(&r, &layer, 0);
    own.base.layer = layer;
    for (uint32_t i = 0; i < TP_RUN; i++)
        r.s[i] = i << 16 | 0x8000;
    own.base.grade = tp_grade_make(0, 0, 0xffffff);
    run_by(tp_stage_texture_graded, &s, &own.base, &r.run);
    assert_int_equal(r.run.colour[0], 0x4d4d4d);        /* 77 / 256 */
    assert_int_equal(r.run.colour[1], 0xffffff);
    assert_int_equal(r.run.colour[2], 0);
    own.base.grade = tp_grade_make(4 * TP_FX_ONE, TP_FX(0.95), 0xffffff);
    run_by(tp_stage_texture_graded, &s, &own.base, &r.run);
    assert_int_equal(r.run.colour[0], 0xff0000);
    assert_int_equal(r.run.colour[1], 0xffffff);
    assert_int_equal(r.run.colour[3], 0);               /* 242 / 255 is below 0.95 */
}

/* -- the other layers ---------------------------------------------------------------- */

/* Both layers are added to the colour; each channel's sum saturates at white. */
static void compare_added(const tp_texture *t, int filter, measure *off)
{
    const int level = chance_int(&chance, 0, t->levels - 1);
    const grade_wish w[2] = { any_wish(), any_wish() };
    test_run r;
    tp_layer layer[2] = { layer_any(&chance, t), layer_any(&chance, t) };
    run_any(&r, 0, &chance);
    tp_shade s = layer_at_level(&r, &layer[0], level);

    layer[1].lod = layer[0].lod;
    for (int k = 0; k < 2; k++) {
        own.layers.added[k] = layer[k];
        own.layers.colour[k] = w[k].colour;
        own.layers.graded[k] = chance_int(&chance, 0, 1);
        own.layers.grade[k] = tp_grade_make(w[k].saturation, w[k].clamp, w[k].colour);
    }
    if (chance_int(&chance, 0, 2) == 0)
        own.layers.added[chance_int(&chance, 0, 1)].texture = NULL;
    const test_run before = r;
    run_by(filter ? tp_stage_layers_linear : tp_stage_layers, &s, &own.layers, &r.run);
    for (int i = 0; i < TP_RUN; i++) {
        ref_colour want = ref_colour_unpack(before.run.colour[i]);
        double allowed = 0;
        for (int k = 0; k < 2; k++) {
            if (!own.layers.added[k].texture)
                continue;
            const ref_colour texel = sampled(&layer[k], level, &before, i, filter);
            want = ref_add(want, own.layers.graded[k]
                                     ? granted(&w[k], texel)
                                     : ref_times(texel, ref_colour_unpack(w[k].colour)));
            allowed += own.layers.graded[k] ? slack(&w[k], filter) : 1 + 4 * filter;
        }
        const double e = ref_colour_difference(r.run.colour[i], want);
        assert_true(e <= allowed);
        measure_add(off, e, before.s[i], filter, level);
    }
}

static void layers_are_added_and_held_at_white(void **state)
{
    (void)state;
    measure off[2] = { { .what = "added", .unit = "levels of 255" },
                       { .what = "added, linear", .unit = "levels of 255" } };

    for (int n = 0; n < SIDES * 100; n++) {
        tp_texture t = layer_texture(&chance, sides[n % SIDES][0], sides[n % SIDES][1]);
        compare_added(&t, n & 1, &off[n & 1]);
        layer_free(&t);
    }
    measure_print(&off[0]);
    measure_print(&off[1]);
}

/* -- distortion ---------------------------------------------------------------------- */

/* Weights are truncated to 1/256 of up to 255 levels in each direction; a level is 1/128 of
 * the strength. */
static void distortions_move_places_by_red_and_green(void **state)
{
    (void)state;
    measure off = { .what = "bent", .unit = "of the strength" };

    for (int n = 0; n < SIDES * 100; n++) {
        tp_texture t = layer_texture(&chance, sides[n % SIDES][0], sides[n % SIDES][1]);
        const int level = chance_int(&chance, 0, t.levels - 1);
        test_run r;
        tp_layer layer = layer_any(&chance, &t);
        run_any(&r, 0, &chance);
        tp_shade s = layer_at_level(&r, &layer, level);
        const tp_fx strength = chance_int(&chance, TP_FX(0.01), 20 * TP_FX_ONE);
        own.layers.bend = layer;
        own.layers.strength = strength;
        run_by(tp_stage_bend, &s, &own.layers, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_colour c = sampled(&layer, level, &r, i, 1);
            const int32_t ds = (int32_t)(r.run.ls[i] - r.s[i]);
            const int32_t dt = (int32_t)(r.run.lt[i] - r.t[i]);
            const double es = (double)ds / strength - (c.c[0] - 128) / 128;
            const double et = (double)dt / strength - (c.c[1] - 128) / 128;
            const double e = fmax(fabs(es), fabs(et));
            assert_true(e <= 2.0 / 128 + 1.5 / strength);
            assert_true(abs(ds) <= strength && abs(dt) <= strength);
            measure_add(&off, e, r.s[i], strength, level);
        }
        layer_free(&t);
    }
    measure_print(&off);
}

/* Layers are sampled at the distorted positions, later stages are not. */
static void bent_places_are_the_layers_alone(void **state)
{
    (void)state;
    tp_texture t = layer_texture(&chance, 32, 16), red = layer_texture(&chance, 1, 1);
    test_run r, moved;
    const tp_shade s = { .zi_log = 29 * 256 };
    own.base.layer = (tp_layer){ .texture = &t, .per_metre = 1 << 13 };

    *(uint32_t *)(uintptr_t)red.level[0] = 0xff4080;        /* + 127/128, - 1/2 */
    own.layers.bend = (tp_layer){ .texture = &red, .per_metre = 5 };
    own.layers.strength = 2 * TP_FX_ONE;
    run_any(&r, 0, &chance);
    moved = r;
    moved.run.key = moved.key;
    moved.run.ls = moved.s;
    moved.run.lt = moved.t;
    for (int i = 0; i < TP_RUN; i++) {
        moved.s[i] += 2 * TP_FX_ONE * 127 / 128;
        moved.t[i] -= TP_FX_ONE;
    }
    const uint32_t *const place = r.run.s;
    run_by(tp_stage_bend, &s, &own.layers, &r.run);
    run_by(tp_stage_texture_linear, &s, &own.base, &r.run);
    run_by(tp_stage_texture_linear, &s, &own.base, &moved.run);
    assert_memory_equal(r.run.colour, moved.run.colour, sizeof r.run.colour);
    assert_ptr_equal(r.run.s, place);
    layer_free(&red);
    layer_free(&t);
}

/* -- cuts ---------------------------------------------------------------------------- */

static void runs_may_be_cut_at_sixteenths(void **state)
{
    (void)state;
    static stage *const stages[] = { tp_stage_texture_graded,
                                     tp_stage_texture_linear_graded, tp_stage_layers,
                                     tp_stage_layers_linear, tp_stage_bend };
    tp_texture t = layer_texture(&chance, 64, 16);

    for (int n = 0; n < 1000; n++) {
        const grade_wish w = any_wish();
        test_run r;
        const tp_shade s = { .zi_log = 29 * 256 };
        own.base.layer = layer_any(&chance, &t);
        run_any(&r, 5000, &chance);
        own.layers.added[0].texture = NULL;
        own.layers.added[1] = own.layers.bend = own.base.layer;
        own.layers.strength = 5 * TP_FX_ONE;
        own.layers.graded[1] = true;
        own.base.grade = own.layers.grade[1] = tp_grade_make(w.saturation, w.clamp,
                                                            w.colour);
        own.base.layer.lod = chance_int(&chance, -2000, 2000);
        const tp_run before = r.run;
        const void *mine = n % 5 < 2 ? (void *)&own.base : &own.layers;
        run_by(stages[n % 5], &s, mine, &r.run);
        if (n % 5 == 4)
            run_by(tp_stage_texture, &s, &own.base, &r.run);
        for (int32_t from = 0; from < TP_RUN; from += 16) {
            tp_run part = run_part(&before, from, from + 16);
            run_by(stages[n % 5], &s, mine, &part);
            if (n % 5 == 4)
                run_by(tp_stage_texture, &s, &own.base, &part);
            assert_memory_equal(part.colour, r.run.colour + from,
                                16 * sizeof *part.colour);
        }
    }
    layer_free(&t);
}

/* The packed bodies of microcontrollers. */
static void packed_texels_are_those_of_single_channels(void **state)
{
    (void)state;
    for (int n = 0; n < 20000; n++) {
        const grade_wish w = any_wish();
        const tp_grade grade = tp_grade_make(w.saturation, w.clamp, w.colour);
        tp_four f = { .fs = random_below(&chance, 256), .ft = random_below(&chance, 256) };
        for (int k = 0; k < 4; k++)
            f.texel[k] = n % 5 ? (uint32_t)random_next(&chance)
                               : random_below(&chance, 2) ? 0xffffffff : 0;
        const tp_split_rgb texel = tp_four_interpolate(&f);
        assert_int_equal(tp_four_interpolate_green(&f), texel.g);
        assert_int_equal(tp_grade_texel_packed(&grade, texel),
                         tp_grade_texel(&grade, texel));
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grades_are_saturation_clamp_and_colour),
        cmocka_unit_test(a_grade_that_asks_for_nothing_does_nothing),
        cmocka_unit_test(grades_reach_their_ends),
        cmocka_unit_test(packed_texels_are_those_of_single_channels),
        cmocka_unit_test(layers_are_added_and_held_at_white),
        cmocka_unit_test(distortions_move_places_by_red_and_green),
        cmocka_unit_test(bent_places_are_the_layers_alone),
        cmocka_unit_test(runs_may_be_cut_at_sixteenths),
    };
    return cmocka_run_group_tests_name("features/water layers", tests, NULL, NULL);
}
