/* SPDX-License-Identifier: MIT */
/* The cheaper stages of foam against the exact stage, on runs of neighbouring places as a
 * camera sees them: the mean difference, the same bits wherever a run is cut, exact foam on
 * packed slopes, and blocks without foam. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/foam/foam_window.h"
#include "tests/lib/shading.h"
#include "tidepool/modules.h"

#define CELLS 40                /* of half a metre */
#define SIDE  (CELLS * 32768)

static uint64_t chance;
static uint8_t  cover[CELLS * CELLS];
static uint32_t texels[2 * 64 * 64];
static tp_texture picture;
static tp_shade_foam foam;

static void make_picture(void)
{
    static uint32_t pixels[64 * 64];

    for (int i = 0; i < 64 * 64; i++) {
        const double x = i % 64 * 0.09817477, y = i / 64 * 0.09817477;
        const double v = sin(3 * x + sin(2 * y)) + cos(4 * y + sin(x));
        pixels[i] = (uint32_t)(127.5 + 63 * v) << 8;
    }
    assert_int_equal(
        tp_texture_init(&picture, pixels, 64, 64, texels, sizeof texels, NULL), TP_OK);
}

/* Patches of foam of some metres, and none between. */
static void fill_cover(void)
{
    const double phase = random_below(&chance, 1000) * 0.01;

    for (int j = 0; j < CELLS; j++)
        for (int i = 0; i < CELLS; i++) {
            const double c = 300 * sin(i * 0.31 + phase) * sin(j * 0.23 - phase) - 60;
            cover[j * CELLS + i] = (uint8_t)(c < 0 ? 0 : c > 255 ? 255 : c);
        }
}

/* A window with foam beyond, or without. */
static void set_foam(bool textured, bool far)
{
    const tp_turn way = (tp_turn)random_next(&chance);

    fill_cover();
    foam = (tp_shade_foam){
        .cover = cover, .cells = CELLS, .col = random_below(&chance, CELLS),
        .row = random_below(&chance, CELLS), .low_s = chance_fx(&chance, -900, 900),
        .low_t = chance_fx(&chance, -900, 900), .side = SIDE,
        .per_metre = ((uint64_t)1 << 48) / 32768,
        .edge = (uint32_t)(((uint64_t)1 << 44) / (7ull * 128 * CELLS * 128 * CELLS)),
        .far_fresh = far ? 9000 : 0, .far_old = far ? 30 : 0, .per_square = 3000,
        .way_x = tp_sin(way) >> 16, .way_z = tp_cos(way) >> 16,
        .colour = 0xf4f8fa, .texture = textured ? &picture : NULL, .repeats = 1 << 15,
        .wide_repeats = 1 << 13,
    };
    if (textured)
        tp_shade_foam_make_ranks(&foam, &picture);
    tp_foam_find_empty_squares(&foam, 1);
}

/* A row of the picture: places go from pixel to pixel by up to 0.1 m, slopes by waves. */
static tp_shade set_run(test_run *r)
{
    const tp_shade s = shade_any(&chance);
    const int32_t ds = chance_int(&chance, -6000, 6000), dt = chance_int(&chance, -6000, 6000);
    const uint32_t at_s = random_below(&chance, SIDE), at_t = random_below(&chance, SIDE);

    run_any(r, 3000, &chance);
    r->run.mine = &foam;
    for (int i = 0; i < TP_RUN; i++) {
        r->key[i] = 0x10000000;
        r->s[i] = (uint32_t)foam.low_s + at_s + (uint32_t)(i * ds);
        r->t[i] = (uint32_t)foam.low_t + at_t + (uint32_t)(i * dt);
        r->n[i] = tp_pair16((int32_t)(600 * sin(i * 0.1)), (int32_t)(400 * cos(i * 0.07)));
        r->run.slope[i] = r->n[i];
    }
    const int32_t depth = tp_log_depth(&s, r->key[0]);
    foam.lod = 64 - depth - (depth > 0 ? depth / 2 : 0);
    return s;
}

/* -- difference ---------------------------------------------------------------------- */

/* Returns the rms difference of a channel, of 255, of two stages on the same runs. */
static double difference(tp_stage cheap, tp_stage exact, bool textured, bool far)
{
    double square = 0;

    for (int n = 0; n < 400; n++) {
        test_run a, b;
        set_foam(textured, far);
        const tp_shade s = set_run(&a);
        b = a;
        b.run.key = b.key, b.run.s = b.s, b.run.t = b.t, b.run.n = b.n;
        cheap(&s, &a.run);
        exact(&s, &b.run);
        for (int i = 0; i < TP_RUN; i++) {
            const double d = (double)(a.run.colour[i] >> 8 & 0xff)
                           - (double)(b.run.colour[i] >> 8 & 0xff);
            square += d * d / (400 * TP_RUN);
        }
    }
    return sqrt(square);
}

/* Measured over six seeds: fast 3.2 to 4.5 with a picture, 2.7 to 3.0 without; plain 14.7
 * to 16.7, and 4.2 to 4.9. */
static void cheaper_foam_is_near_the_exact(void **state)
{
    (void)state;
    static const struct { tp_stage stage; const char *name; double lace, plain; } rungs[] = {
        { tp_stage_foam_fast, "fast", 5.5, 4 }, { tp_stage_foam_plain, "plain", 20, 6.5 },
    };
    for (int k = 0; k < 2; k++) {
        const double lace = difference(rungs[k].stage, tp_stage_foam, true, false);
        const double far = difference(rungs[k].stage, tp_stage_foam, true, true);
        const double bare = difference(rungs[k].stage, tp_stage_foam, false, true);
        printf("    %-5s: rms %.2f with a picture, %.2f with foam beyond, %.2f without\n",
               rungs[k].name, lace, far, bare);
        assert_true(lace < rungs[k].lace && far < rungs[k].lace && bare < rungs[k].plain);
    }
}

/* Slopes that no ripple bends are the same packed. */
static void packed_slopes_make_the_same_foam(void **state)
{
    (void)state;
    assert_true(difference(tp_stage_foam_packed, tp_stage_foam, true, true) == 0);
}

/* -- tilings and empty blocks -------------------------------------------------------- */

static void where_a_run_is_cut_never_shows(void **state)
{
    (void)state;
    static const tp_stage stages[] = { tp_stage_foam_fast, tp_stage_foam_plain,
                                       tp_stage_foam_fast_shiny, tp_stage_foam_plain_shiny };
    for (int n = 0; n < 400; n++) {
        test_run r;
        const tp_stage cheap = stages[n % 4];
        set_foam(n % 3, n % 5 < 2);
        const tp_shade s = set_run(&r);
        const int32_t at = 16 * chance_int(&chance, 1, TP_RUN / 16 - 1);
        tp_run a = run_part(&r.run, 0, at), b = run_part(&r.run, at, TP_RUN);
        cheap(&s, &a);
        cheap(&s, &b);
        cheap(&s, &r.run);
        assert_memory_equal(a.colour, r.run.colour, (size_t)at * 4);
        assert_memory_equal(b.colour, r.run.colour + at, (size_t)(TP_RUN - at) * 4);
    }
}

static void without_cover_nothing_changes(void **state)
{
    (void)state;
    static const tp_stage stages[] = { tp_stage_foam_fast_shiny, tp_stage_foam_plain_shiny,
                                       tp_stage_foam_shiny };
    for (int n = 0; n < 90; n++) {
        test_run r;
        set_foam(true, false);
        const tp_shade s = set_run(&r);
        const test_run before = r;
        memset(cover, 0, sizeof cover);
        foam.none = n % 2;
        assert_false(tp_foam_find_empty_squares(&foam, 1));
        stages[n % 3](&s, &r.run);
        assert_memory_equal(&r.run.colour, &before.run.colour, sizeof r.run.colour);
        assert_memory_equal(&r.run.glint, &before.run.glint, sizeof r.run.glint);
    }
}

/* One cell of foam anywhere: the exact stage on known empty squares draws what it draws
 * without knowing any. */
static void no_cell_of_foam_is_passed_over(void **state)
{
    (void)state;
    uint32_t changed = 0;

    for (int n = 0; n < 2000; n++) {
        test_run a, b;
        set_foam(true, n % 4 == 0);
        memset(cover, 0, sizeof cover);
        const tp_shade s = set_run(&a);
        const uint32_t near = random_below(&chance, TP_RUN);
        const uint32_t i = tp_foam_cells(&foam, a.s[near] - (uint32_t)foam.low_s) >> 16,
                       j = tp_foam_cells(&foam, a.t[near] - (uint32_t)foam.low_t) >> 16;
        if (i < CELLS && j < CELLS)
            cover[(j + 1 + foam.row) % CELLS * CELLS + (i + 1 + foam.col) % CELLS] = 255;
        b = a;
        b.run.key = b.key, b.run.s = b.s, b.run.t = b.t, b.run.n = b.n;
        const test_run before = a;
        tp_foam_find_empty_squares(&foam, 1);
        tp_stage_foam(&s, &a.run);
        memset(foam.empty, 0, sizeof foam.empty);
        tp_stage_foam(&s, &b.run);
        assert_memory_equal(&a.run.colour, &b.run.colour, sizeof a.run.colour);
        changed += memcmp(&a.run.colour, &before.run.colour, sizeof a.run.colour) != 0;
    }
    assert_true(changed > 200);
}

int main(void)
{
    chance = random_seed();
    make_picture();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cheaper_foam_is_near_the_exact),
        cmocka_unit_test(packed_slopes_make_the_same_foam),
        cmocka_unit_test(where_a_run_is_cut_never_shows),
        cmocka_unit_test(without_cover_nothing_changes),
        cmocka_unit_test(no_cell_of_foam_is_passed_over),
    };
    return cmocka_run_group_tests_name("features/foam_fast", tests, NULL, NULL);
}
