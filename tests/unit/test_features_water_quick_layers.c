/* SPDX-License-Identifier: MIT */
/* The first half of the fast rung: the plain and the packed loops give the same bits; the
 * stages equal the exact stages with nearest texels, for any cuts of spans. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/layers.h"
#include "tests/lib/measure.h"
#include "features/water/fast_layers_linear.h"
#include "features/water/fast_layers_m4.h"
#include "features/water/fast_layers_plain.h"

static uint64_t chance;

/* A layer of the same mapping with a prepared texture. */
static tp_quick_map prepared(const tp_layer *from, const tp_texture *to)
{
    tp_layer layer = *from;
    layer.texture = to;
    return tp_quick_map_make(&layer);
}

static void quick_free(tp_texture *t)
{
    free((void *)(uintptr_t)t->level[0]);
}

static uint32_t any_colour(void)
{
    return (uint32_t)random_next(&chance) & 0xffffff;
}

/* Random words, many of which are at the ends of bytes and halves. */
static uint32_t any_word(void)
{
    static const uint32_t ends[] = { 0, 0xffffffff, 0x7fff8000, 0x80007fff, 0x80008000,
                                     0x7fff7fff, 0x00ff00ff, 0xff00ff00, 0x01017f80 };
    return chance_int(&chance, 0, 2) ? (uint32_t)random_next(&chance)
                                     : ends[chance_int(&chance, 0, 8)];
}

/* -- plain and packed bodies ----------------------------------------------------------- */

enum { TEXELS = 256 * 256 };
static uint32_t texel[TEXELS];

static void any_texels(tp_quick_map *map, const uint32_t *const *levels, uint32_t mask)
{
    const uint32_t log2 = (uint32_t)chance_int(&chance, 1, 8);

    for (uint32_t i = 0; i < 1u << 2 * log2; i++)
        texel[i] = any_word() & mask;
    *map = (tp_quick_map){ any_word(), any_word(), any_word(), 0, 0, log2, levels };
}

/* Positions, samples, then the output of each body. */
typedef struct {
    uint32_t s[TP_RUN], t[TP_RUN], n[TP_RUN], place[2][2 * TP_RUN], to[2][2 * TP_RUN];
} lanes;

static void any_lanes(lanes *l, uint32_t mask)
{
    for (int i = 0; i < TP_RUN; i++) {
        l->s[i] = any_word();
        l->t[i] = any_word();
        l->n[i] = any_word();
    }
    for (int i = 0; i < 2 * TP_RUN; i++) {
        l->place[0][i] = l->place[1][i] = any_word();
        l->to[0][i] = l->to[1][i] = any_word() & mask;
    }
}

/* A part of a span, from any word and of any length. */
static tp_columns any_columns(const lanes *l, int32_t *at)
{
    *at = chance_int(&chance, 0, 7);
    return (tp_columns){ l->s + *at, l->t + *at, l->n + *at,
                         chance_int(&chance, 1, TP_RUN - *at),
                         0, (uint32_t)chance_int(&chance, 0, 1) };
}

static const uint32_t *const levels[] = { texel };

static void both_bodies_add_the_same_layers(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        tp_quick_map map;
        lanes l;
        int32_t at;
        any_texels(&map, levels, 0xffffff);
        any_lanes(&l, 0xffffff);
        const int32_t count = any_columns(&l, &at).count;
        if (n & 1) {
            plain_write_texels(&map, 0, l.place[0] + at, l.to[0] + at, count);
            packed_write_texels(&map, 0, l.place[1] + at, l.to[1] + at, count);
        }
        plain_add_texels(&map, 0, l.place[0] + at, l.to[0] + at, count);
        packed_add_texels(&map, 0, l.place[1] + at, l.to[1] + at, count);
        assert_memory_equal(l.to[0], l.to[1], sizeof l.to[0]);
    }
}

static void both_bodies_bend_places_alike(void **state)
{
    (void)state;
    for (int n = 0; n < 4000; n++) {
        tp_quick_map map;
        lanes l;
        int32_t at;
        any_texels(&map, levels, 0xffffffff);
        any_lanes(&l, 0);
        const tp_columns c = any_columns(&l, &at);
        if (n & 1) {
            plain_distort_places(&map, 0, &c, l.place[0] + at);
            packed_distort_places(&map, 0, &c, l.place[1] + at);
        } else {
            plain_distort_even_places(&map, 0, &c, l.place[0] + at);
            packed_distort_even_places(&map, 0, &c, l.place[1] + at);
        }
        assert_memory_equal(l.place[0], l.place[1], sizeof l.place[0]);
    }
}

static void both_bodies_add_the_same_ripples(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        tp_quick_map map;
        lanes l;
        int32_t at;
        any_texels(&map, levels, 0xffffffff);
        any_lanes(&l, 0xffffffff);
        const tp_columns c = any_columns(&l, &at);
        plain_add_ripple_slopes(&map, 0, &c, l.to[0] + at);
        packed_add_ripple_slopes(&map, 0, &c, l.to[1] + at);
        assert_memory_equal(l.to[0], l.to[1], sizeof l.to[0]);
    }
}

static void both_bodies_fill_the_same_columns(void **state)
{
    (void)state;
    for (int n = 0; n < 1000; n++) {
        lanes l;
        any_lanes(&l, 0xffffff);
        const int32_t pairs = chance_int(&chance, 0, TP_RUN / 2), at = n & 1;
        plain_upsample_colours(l.to[0] + TP_RUN, l.to[0] + at, pairs);
        packed_upsample_colours(l.to[1] + TP_RUN, l.to[1] + at, pairs);
        assert_memory_equal(l.to[0], l.to[1], sizeof l.to[0]);
    }
}

/* -- comparison with the exact stages -------------------------------------------------- */

static const uint32_t small[][2] = { { 1, 1 }, { 2, 1 }, { 1, 64 }, { 256, 256 },
                                     { 16, 128 }, { 256, 2 }, { 64, 64 } };
enum { SMALL = sizeof small / sizeof small[0] };

/* Equal to the bit; only sides over 256 differ. */
static void layers_are_the_exact_ones_of_nearest_texels(void **state)
{
    (void)state;
    for (int n = 0; n < SMALL * 100; n++) {
        tp_texture t = layer_texture(&chance, small[n % SMALL][0], small[n % SMALL][1]);
        tp_texture graded[TP_QUICK_LAYERS];
        tp_quick_layers layers;
        test_run r;
        tp_layer first = layer_any(&chance, &t);
        run_any(&r, 0, &chance);
        tp_shade s = layer_at_level(&r, &first, t.levels > 1
                                                    ? chance_int(&chance, 0, t.levels - 2)
                                                    : 0);
        first.lod += 64;        /* middle of the level */
        own.base.layer = first;
        s.water_colour = any_colour();
        for (int k = 0; k < TP_QUICK_LAYERS; k++) {
            const tp_fx saturation = n & 2 ? TP_FX_ONE : chance_int(&chance, 0, 262144);
            const tp_fx clamp = n & 2 ? 0 : chance_int(&chance, 0, TP_FX(0.95));
            const uint32_t colour = k ? any_colour() : s.water_colour;
            tp_layer layer = own.base.layer;
            layer.drift_s += (uint32_t)k * 77777777u;
            *(k ? &own.layers.grade[k - 1] : &own.base.grade) =
                tp_grade_make(saturation, clamp, colour);
            if (k) {
                own.layers.added[k - 1] = layer;
                own.layers.colour[k - 1] = colour;
                own.layers.graded[k - 1] = !(n & 2);
            }
            tp_quick_graded(&graded[k], &t, saturation, clamp, colour,
                            malloc(tp_quick_bytes(&t)));
            layers.layer[k] = prepared(&layer, &graded[k]);
        }
        tp_run quick = r.run;
        run_by(n & 2 ? tp_stage_texture_tinted : tp_stage_texture_graded, &s, &own.base,
               &r.run);
        run_by(tp_stage_layers, &s, &own.layers, &r.run);
        run_by(tp_stage_quick_mip_spans, &s, &layers, &quick);
        run_by(tp_stage_quick_still, &s, &layers, &quick);
        run_by(tp_stage_quick_layers, &s, &layers, &quick);
        assert_memory_equal(quick.colour, r.run.colour, sizeof quick.colour);
        for (int k = 0; k < TP_QUICK_LAYERS; k++)
            quick_free(&graded[k]);
        layer_free(&t);
    }
}

/* Offsets are exact to half of 1/1024 m. */
static void offsets_are_red_and_green_of_the_strength(void **state)
{
    (void)state;
    measure off = { .what = "offset", .unit = "of 1/1024 m" };

    for (int n = 0; n < 200; n++) {
        tp_texture t = layer_texture(&chance, 64, 32), offsets;
        const tp_fx strength = chance_int(&chance, TP_FX(0.01), 20 * TP_FX_ONE);
        tp_quick_offsets(&offsets, &t, strength, malloc(tp_quick_bytes(&t)));
        const double m = strength / 64.0;
        for (int i = 0; i < 64 * 64; i++) {
            const uint32_t from = t.level[0][(i / 64 / 2) * 64 + i % 64];
            const uint32_t to = offsets.level[0][i];
            const double s = ((int)(from >> 16 & 255) - 128) / 128.0 * m;
            const double z = ((int)(from >> 8 & 255) - 128) / 128.0 * m;
            const double es = (int16_t)(to >> 16) - s;
            const double ez = (int16_t)(to & 0xffff) - z;
            assert_true(fmax(fabs(es), fabs(ez)) <= 0.5001);
            measure_add(&off, fmax(fabs(es), fabs(ez)), n, i, strength);
        }
        quick_free(&offsets);
        layer_free(&t);
    }
    measure_print(&off);
}

/* Slopes are exact to the last bit of Q3.12; slopes steeper than 7.8 are clamped. */
static void slopes_are_those_of_the_normal_map(void **state)
{
    (void)state;
    measure off = { .what = "slope", .unit = "of 1/4096" };

    for (int n = 0; n < 200; n++) {
        tp_texture t = layer_texture(&chance, 32, 32), slopes;
        const tp_fx bump = chance_int(&chance, 0, 4 * TP_FX_ONE);
        tp_quick_slopes(&slopes, &t, bump, malloc(tp_quick_bytes(&t)));
        for (int i = 0; i < 32 * 32; i++) {
            const uint32_t m = t.level[0][i], to = slopes.level[0][i];
            const double nz = fmax((int)(m & 255) - 128, 16);
            const double gain = (bump >> 8) / 256.0 * 4096 / nz;
            const double x = -((int)(m >> 16 & 255) - 128) * gain;
            const double z = ((int)(m >> 8 & 255) - 128) * gain;
            const double ex = (int16_t)(to >> 16) - fmax(-32000, fmin(32000, x));
            const double ez = (int16_t)(to & 0xffff) - fmax(-32000, fmin(32000, z));
            assert_true(fmax(fabs(ex), fabs(ez)) <= 0.5001);
            measure_add(&off, fmax(fabs(ex), fabs(ez)), n, i, bump);
        }
        quick_free(&slopes);
        layer_free(&t);
    }
    measure_print(&off);
}

/* -- cuts ------------------------------------------------------------------------------ */

typedef struct {
    tp_texture t, graded, offsets, slopes;
    tp_quick_layers layers;
    tp_shade shade;
} busy;

static void busy_make(busy *b)
{
    b->t = layer_texture(&chance, 64, 16);
    tp_quick_graded(&b->graded, &b->t, TP_FX_ONE, 0, any_colour(),
                    malloc(tp_quick_bytes(&b->t)));
    tp_quick_offsets(&b->offsets, &b->t, 3 * TP_FX_ONE, malloc(tp_quick_bytes(&b->t)));
    tp_quick_slopes(&b->slopes, &b->t, TP_FX_ONE, malloc(tp_quick_bytes(&b->t)));
    b->shade = (tp_shade){ .zi_log = 29 * 256 };
    tp_quick_layers *q = &b->layers;
    for (int k = 0; k < TP_QUICK_LAYERS; k++) {
        tp_layer layer = layer_any(&chance, NULL);
        layer.lod = chance_int(&chance, -2000, 2000);
        q->layer[k] = prepared(&layer, &b->graded);
        q->bend = prepared(&layer, &b->offsets);
        q->ripple = prepared(&layer, &b->slopes);
    }
}

static void busy_free(busy *b)
{
    quick_free(&b->graded);
    quick_free(&b->offsets);
    quick_free(&b->slopes);
    layer_free(&b->t);
}

/* Stages [linear][thin]: of distorted places, of layers; of ripples [linear]. */
static const tp_stage bends[2][2] = {
    { tp_stage_quick_bend, tp_stage_quick_bend_thin },
    { tp_stage_quick_bend_linear, tp_stage_quick_bend_linear_thin },
};
static const tp_stage layers[2][2] = {
    { tp_stage_quick_layers, tp_stage_quick_layers_thin },
    { tp_stage_quick_layers_linear, tp_stage_quick_layers_linear_thin },
};
static const tp_stage ripples[2] = { tp_stage_quick_ripple, tp_stage_quick_ripple_linear };

static void draw(const busy *b, tp_run *run, bool thin, bool bent, bool linear)
{
    run_by(tp_stage_quick_mip_spans, &b->shade, &b->layers, run);
    run_by(bent ? bends[linear][thin]
                : thin ? tp_stage_quick_still_thin : tp_stage_quick_still,
           &b->shade, &b->layers, run);
    run_by(layers[linear][thin], &b->shade, &b->layers, run);
    run_by(ripples[linear], &b->shade, &b->layers, run);
}

static void runs_may_be_cut_at_sixteenths(void **state)
{
    (void)state;
    for (int n = 0; n < 1000; n++) {
        busy b;
        test_run r;
        busy_make(&b);
        run_any(&r, 30000, &chance);
        const int32_t first = chance_int(&chance, 0, TP_RUN - 1);
        const int32_t end = chance_int(&chance, first + 1, TP_RUN);
        tp_run whole = run_part(&r.run, first, end);
        draw(&b, &whole, n & 1, n & 2, n & 4);
        for (int32_t at = first; at < end; ) {
            const int32_t stop = (at | 15) + 1 < end ? (at | 15) + 1 : end;
            tp_run part = run_part(&r.run, at, stop);
            draw(&b, &part, n & 1, n & 2, n & 4);
            const size_t bytes = (size_t)(stop - at) * sizeof *part.colour;
            assert_memory_equal(part.colour, whole.colour + at - first, bytes);
            assert_memory_equal(part.slope, whole.slope + at - first, bytes);
            at = stop;
        }
        busy_free(&b);
    }
}

/* Half rate keeps the even columns; columns between lie within their neighbours' values. */
static void thin_runs_keep_their_even_columns(void **state)
{
    (void)state;
    for (int n = 0; n < 1000; n++) {
        busy b;
        test_run r;
        busy_make(&b);
        run_any(&r, 0, &chance);
        const int32_t first = chance_int(&chance, 0, TP_RUN - 1);
        tp_run full = run_part(&r.run, first, chance_int(&chance, first + 1, TP_RUN));
        tp_run thin = full;
        draw(&b, &full, false, n & 1, n & 2);
        draw(&b, &thin, true, n & 1, n & 2);
        for (int32_t i = 0; i < full.count; i++) {
            const int32_t left = i > 0 && (full.x + i) % 2 ? i - 1 : i;
            const bool last = (full.x + i) % 16 == 15 || i + 1 == full.count;
            const int32_t right = left < i && !last ? i + 1 : left;
            assert_int_equal(thin.colour[i],
                             tp_uhadd8(full.colour[left], full.colour[right]));
        }
        assert_memory_equal(thin.slope, full.slope,
                            (size_t)full.count * sizeof *full.slope);
        busy_free(&b);
    }
}

/* -- bilinear look-ups ------------------------------------------------------------------ */

/* A place in texels of a map, and the share of the next texel. */
static double place_of(const tp_quick_map *map, uint32_t x, uint32_t drift, int64_t *texel_at)
{
    const double side = 1 << map->log2;
    const double at = (double)(uint32_t)(x * map->per_metre + drift) / 4294967296.0 * side - 0.5;

    *texel_at = (int64_t)floor(at);
    return at - floor(at);
}

/* The mean of a channel of 8 or 16 bits around a place. */
static double mean_of(const tp_quick_map *map, uint32_t s, uint32_t t, int shift, int bits)
{
    const int64_t mask = (1 << map->log2) - 1;
    int64_t i, j;
    const double fu = place_of(map, s, map->drift_s, &i), fv = place_of(map, t, map->drift_t, &j);
    double sum = 0;

    for (int k = 0; k < 4; k++) {
        const uint32_t word = texel[(size_t)((j + k / 2) & mask) * (size_t)(mask + 1)
                                    + (size_t)((i + k % 2) & mask)];
        const double value = bits == 8 ? (word >> shift & 255)
                                       : (double)(int16_t)(word >> shift & 0xffff);
        sum += value * (k % 2 ? fu : 1 - fu) * (k / 2 ? fv : 1 - fv);
    }
    return sum;
}

/* Weights are multiples of 1/32, cut off: the mean is off by at most 1/32 of the texels'
 * range along each axis, and by the rounding of two mixes. */
static void bilinear_texels_are_the_mean_of_four(void **state)
{
    (void)state;
    for (int n = 0; n < 3000; n++) {
        tp_quick_map map;
        any_texels(&map, levels, 0xffffff);
        const tp_lookup l = linear_lookup_make(&map, 0);
        const uint32_t s = any_word(), t = any_word(), seen = linear_texel(&l, s, t);
        for (int shift = 0; shift < 24; shift += 8)
            assert_true(fabs((seen >> shift & 255) - mean_of(&map, s, t, shift, 8)) <= 18);
        any_texels(&map, levels, 0xffffffff);
        const tp_lookup wide = linear_lookup_make(&map, 0);
        const linear_pair p = linear_find_pair(&wide, s, t);
        assert_true(fabs(p.high / 1024.0 - mean_of(&map, s, t, 16, 16)) <= 4098);
        assert_true(fabs(p.low / 1024.0 - mean_of(&map, s, t, 0, 16)) <= 4098);
    }
}

/* At the middle of a texel the bilinear look-ups are the nearest ones. */
static void bilinear_texels_are_texels_in_their_middle(void **state)
{
    (void)state;
    for (int n = 0; n < 3000; n++) {
        tp_quick_map map;
        any_texels(&map, levels, 0xffffffff);
        map.per_metre = 1;
        map.drift_s = map.drift_t = 0;
        const tp_lookup near = tp_lookup_make(&map, 0), l = linear_lookup_make(&map, 0);
        const uint32_t half = 1u << (near.down - 1);
        const uint32_t s = (any_word() >> near.down << near.down) + half;
        const uint32_t t = (any_word() >> near.down << near.down) + half;
        const uint32_t word = plain_texel(&near, s, t);
        const linear_pair p = linear_find_pair(&l, s, t);
        assert_int_equal(linear_texel(&l, s, t) & 0xffffff, word & 0xffffff);
        assert_int_equal(p.high, (int16_t)(word >> 16) * 1024);
        assert_int_equal(p.low, (int16_t)word * 1024);
    }
}

/* The loops write the look-ups; a distortion is exact at a block's first column. */
static void loops_write_the_bilinear_texels(void **state)
{
    (void)state;
    for (int n = 0; n < 1000; n++) {
        tp_quick_map map;
        lanes a;
        int32_t at;
        any_texels(&map, levels, 0xffffff);
        any_lanes(&a, 0xffffff);
        const tp_lookup l = linear_lookup_make(&map, 0);
        const tp_columns c = any_columns(&a, &at);
        linear_write_texels(&map, 0, a.place[0] + at, a.to[0] + at, c.count);
        linear_add_texels(&map, 0, a.place[0] + at, a.to[1] + at, c.count);
        const uint32_t seen = linear_texel(&l, a.place[0][at], a.place[0][at + TP_RUN]);
        assert_int_equal(a.to[0][at], seen);
        assert_true((a.to[1][at] & 0xff) >= (seen & 0xff));
        linear_add_ripple_slopes(&map, 0, &c, a.to[0] + at);
        linear_distort_places(&map, 0, &c, a.place[0] + at);
        linear_distort_even_places(&map, 0, &c, a.place[1] + at);
        const linear_pair p = linear_find_pair(&l, c.s[0], c.t[0]);
        assert_int_equal(a.to[0][at],
                         tp_qadd16(tp_pair16(p.high >> 10, p.low >> 10), c.n[0]));
        assert_int_equal(a.place[0][at], c.s[0] + (uint32_t)(p.high >> 4));
        assert_int_equal(a.place[1][at + TP_RUN], c.t[0] + (uint32_t)(p.low >> 4));
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_bodies_add_the_same_layers),
        cmocka_unit_test(both_bodies_bend_places_alike),
        cmocka_unit_test(both_bodies_add_the_same_ripples),
        cmocka_unit_test(both_bodies_fill_the_same_columns),
        cmocka_unit_test(layers_are_the_exact_ones_of_nearest_texels),
        cmocka_unit_test(offsets_are_red_and_green_of_the_strength),
        cmocka_unit_test(slopes_are_those_of_the_normal_map),
        cmocka_unit_test(runs_may_be_cut_at_sixteenths),
        cmocka_unit_test(thin_runs_keep_their_even_columns),
        cmocka_unit_test(bilinear_texels_are_the_mean_of_four),
        cmocka_unit_test(loops_write_the_bilinear_texels),
        cmocka_unit_test(bilinear_texels_are_texels_in_their_middle),
    };
    return cmocka_run_group_tests_name("features/water quick layers", tests, NULL, NULL);
}
