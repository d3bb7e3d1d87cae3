/* SPDX-License-Identifier: MIT */
/* The foam stage compared with a double-precision version of the file head's formulas:
 * cover interpolated between four cells of a torus, cover beyond the window, the texture's
 * ranks, light, and the remaining glint. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/foam/foam_cover.h"
#include "tools/reference/texture.h"
#include "mesh/mesh.h"
#include "tests/lib/shading.h"
#include "tidepool/modules.h"

#define CELLS 37

static uint64_t chance;
static uint8_t  cover[CELLS * CELLS];
static uint32_t texels[2 * 64 * 64];
static tp_texture picture;

static void make_picture(void)
{
    static uint32_t pixels[64 * 64];

    for (int i = 0; i < 64 * 64; i++) {         /* patches of 8 texels and more */
        const double x = i % 64 * 0.09817477, y = i / 64 * 0.09817477;
        const double v = sin(3 * x + sin(2 * y)) + cos(4 * y + sin(x));
        pixels[i] = (uint32_t)(127.5 + 63 * v) << 8;
    }
    assert_true(sizeof texels >= tp_texture_bytes(64, 64));
    assert_int_equal(
        tp_texture_init(&picture, pixels, 64, 64, texels, tp_texture_bytes(64, 64), NULL),
        TP_OK);
}

static tp_shade_foam foam;              /* foam data of the last span */

/* Cells of 0.5 m at a random position; all samples use the texture's mipmap level
 * `level`. */
static tp_shade shade_foam(test_run *r, bool textured, int level)
{
    tp_shade s = shade_any(&chance);
    tp_shade_foam *f = &foam;
    const tp_turn way = (tp_turn)random_next(&chance);
    const bool shore = random_below(&chance, 3) == 0;

    r->run.mine = f;
    *f = (tp_shade_foam){
        .cover = cover, .cells = CELLS, .col = random_below(&chance, CELLS),
        .row = random_below(&chance, CELLS), .low_s = chance_fx(&chance, -900, 900),
        .low_t = chance_fx(&chance, -900, 900), .side = CELLS * 32768,
        .per_metre = ((uint64_t)1 << 48) / 32768,
        .edge = (uint32_t)(((uint64_t)1 << 44) / (7ull * 128 * CELLS * 128 * CELLS)),
        .far_fresh = shore ? 0 : random_below(&chance, 3) * 9000,
        .far_old = random_below(&chance, 40),
        .per_square = random_below(&chance, 6000) + 100,
        .way_x = tp_sin(way) >> 16,
        .way_z = tp_cos(way) >> 16,
        .floor = shore ? TP_FOAM_BEACH : 0,
        .floor_cover = shore ? tp_foam_shore_cover : NULL,
        .shore_x = shore ? tp_sin(way) >> 16 : 0,
        .shore_z = shore ? -tp_cos(way) >> 16 : 0,
        .stretch = CELLS * 32768 / 16 * 7,
        .colour = (uint32_t)random_next(&chance) & 0xffffff,
        .texture = textured ? &picture : NULL, .repeats = 1 << 15,
        .drift_s = (uint32_t)random_next(&chance),
        .drift_t = (uint32_t)random_next(&chance), .wide_repeats = 1 << 13,
        .wide_drift_s = (uint32_t)random_next(&chance),
        .wide_drift_t = (uint32_t)random_next(&chance),
    };
    if (textured)
        tp_shade_foam_make_ranks(f, &picture);
    for (int i = 0; i < TP_RUN; i++) {
        r->key[i] = 0x10000000;
        const uint32_t out = shore ? 4 * f->side : 10000;
        r->s[i] = (uint32_t)f->low_s + random_below(&chance, f->side + 2 * out) - out;
        r->t[i] = (uint32_t)f->low_t + random_below(&chance, f->side + 2 * out) - out;
        r->run.glint[i] = (uint16_t)chance_int(&chance, 0, 1024);
    }
    const int32_t depth = tp_log_depth(&s, r->key[0]);
    f->lod = level * 256 + 64 - depth - (depth > 0 ? depth / 2 : 0);
    return s;
}

/* -- the same in double precision ---------------------------------------------------- */

static double cell_at(const tp_shade_foam *f, int i, int j)
{
    const int col = (i + 1 + 2 * CELLS + (int)f->col) % CELLS;
    const int row = (j + 1 + 2 * CELLS + (int)f->row) % CELLS;
    return cover[row * CELLS + col];
}

static double least(double a, double b) { return a < b ? a : b; }

/* Cover of the window, 0..255, and its weight 0..1: bilinear, from 3/4 of the radius on
 * less by the square of the distance. */
static double cover_of(const tp_shade_foam *f, uint32_t s, uint32_t t, double *weight)
{
    const double u = (int32_t)(s - (uint32_t)f->low_s) / 32768.0;
    const double w = (int32_t)(t - (uint32_t)f->low_t) / 32768.0;
    const double off = hypot(u - CELLS / 2.0, w - CELLS / 2.0) / (CELLS / 2.0);

    *weight = 0;
    if (off >= 1)
        return 0;
    const int i = (int)floor(u - 0.5), j = (int)floor(w - 0.5);
    const double fs = u - 0.5 - i, ft = w - 0.5 - j;
    const double over = cell_at(f, i, j) * (1 - fs) + cell_at(f, i + 1, j) * fs;
    const double under = cell_at(f, i, j + 1) * (1 - fs) + cell_at(f, i + 1, j + 1) * fs;
    *weight = least(1, (1 - off * off) / (7 / 16.0));
    return over * (1 - ft) + under * ft;
}

static double weighed_cover(const tp_shade_foam *f, double s, double t)
{
    double weight;
    const double c = cover_of(f, (uint32_t)(int64_t)floor(s), (uint32_t)(int64_t)floor(t),
                              &weight);
    return c * weight;
}

/* Cover along a straight beach: a stretch around the window's middle repeats, its last
 * eighth mixed with what lies before its beginning. */
static double shore_cover(const tp_shade_foam *f, uint32_t s, uint32_t t)
{
    const double x = f->shore_x / 16384.0, z = f->shore_z / 16384.0, whole = f->stretch;
    const double ds = (int32_t)(s - (uint32_t)f->low_s) - f->side / 2.0;
    const double dt = (int32_t)(t - (uint32_t)f->low_t) - f->side / 2.0;
    const double part = (ds * x + dt * z) / whole + 0.5, turns = floor(part);
    const double here = weighed_cover(f, f->low_s + f->side / 2.0 + ds - turns * whole * x,
                                      f->low_t + f->side / 2.0 + dt - turns * whole * z);
    const double before =
        weighed_cover(f, f->low_s + f->side / 2.0 + ds - (turns + 1) * whole * x,
                      f->low_t + f->side / 2.0 + dt - (turns + 1) * whole * z);
    const double share = least(1, (1 - (part - turns)) * 8);

    return here * share + before * (1 - share);
}

/* Cover after the window's edge: the cover beyond is by the square of the slope. */
static double whole_cover(const tp_shade_foam *f, const test_run *r, int i)
{
    double weight;
    const double c = cover_of(f, r->s[i], r->t[i], &weight);
    const double x = (int16_t)(r->n[i] >> 16) / 4096.0, z = (int16_t)r->n[i] / 4096.0;
    const double q = least((x * x + z * z) * f->per_square / 256, 1700 / 256.0);
    const double up = (x * f->way_x + z * f->way_z) / 16384;
    const double b = up > 0 ? least(up * up * f->per_square / 256, 1700 / 256.0) : 0;
    const double far = f->shore_x || f->shore_z ? shore_cover(f, r->s[i], r->t[i])
                     : up < 0 || !f->far_fresh
                     ? 0 : least(f->far_old + f->far_fresh / 256.0 * q * b, 216);

    return c * weight + far * (1 - weight);
}

static bool is_outer(const tp_shade_foam *f, const test_run *r, int i)
{
    double weight;

    cover_of(f, r->s[i], r->t[i], &weight);
    return weight < 1;
}

/* Share of the texels of level 0 below a green value, equal texels counted half, 0..255. */
static double rank_of(double green)
{
    const int v = (int)(green + 0.5);
    double below = 0;

    for (int i = 0; i < 64 * 64; i++) {
        const int at = picture.level[0][i] >> 8 & 0xff;
        below += at < v ? 1 : at == v ? 0.5 : 0;
    }
    return below * 255 / (64 * 64);
}

static double level_mean(double mean, int level)
{
    return 128 + (mean - 128) * least(level, 5) / 5;
}

static double rank_at(const tp_shade_foam *f, const test_run *r, int i, int level, int wide)
{
    const double repeat = 4294967296.0;
    const uint32_t s = wide ? r->s[i] * f->wide_repeats + f->wide_drift_s
                            : r->s[i] * f->repeats + f->drift_s;
    const uint32_t t = wide ? r->t[i] * f->wide_repeats + f->wide_drift_t
                            : r->t[i] * f->repeats + f->drift_t;
    const int at = wide ? (level > 2 ? level - 2 : 0) : level;

    return rank_of(ref_linear(&picture, at, s / repeat, t / repeat).c[1])
         - level_mean(f->mean, at);
}

/* The edge is soft by 80 ranks of 256 in level 0, by all ranks from level 5 on. */
static double white_of(double c, double rank, int level)
{
    const double n = least(level, 5), soft = 80 + n * 176 / 5, span = 168 - 8 * n;
    const double up = rank + soft / 2 - span * (1 - c * 236 / 256 / 128);

    return ref_clamp(least(up / soft, 4 * c / 256), 0, 1) * 240 / 256;
}

/* Opacity of lace over bubbles: patches of the large scale first. A cover below 10 outside of
 * the full weight has the mean opacity of lace. */
static double share_of(const tp_shade_foam *f, const test_run *r, int i, int level)
{
    double c = whole_cover(f, r, i);

    if (c < 1)
        return 0;
    if (is_outer(f, r, i) && c < 10)
        return c / 256 * (236 / 256.0 * 240 / 256 + 0.25);
    if (f->texture)
        c += rank_at(f, r, i, level, 1) * c * (255 - c) / 64 * 103 / 65536;
    const double white = white_of(c, f->texture && level < 5 ? rank_at(f, r, i, level, 0)
                                                             : 0,
                                  f->texture ? level : 5);
    return white + (1 - white) * c / 1024;
}

static double lit_of(const tp_shade *s, const test_run *r, int i)
{
    const double sx = run_sx(r, i), sz = run_sz(r, i), ambient = s->ambient / 256.0;
    const double q = least(sx * sx + sz * sz, 4);
    const double nl = (s->world.ly - sx * s->world.lx - sz * s->world.lz) / Q14;

    return (1 + ambient + (1 - ambient) * ref_clamp(nl / sqrt(1 + q), 0, 1)) / 2;
}

/* -- comparison ---------------------------------------------------------------------- */

typedef struct { measure worst; double square; uint64_t count; } foam_spread;

static void compare(bool textured, int level, foam_spread *off)
{
    test_run r;
    run_any(&r, 6000, &chance);
    const tp_shade s = shade_foam(&r, textured, level);
    const test_run before = r;
    const tp_shade_foam *f = &foam;

    tp_stage_foam_shiny(&s, &r.run);
    for (int i = 0; i < TP_RUN; i++) {
        const double c = whole_cover(f, &r, i), share = share_of(f, &r, i, level);
        if (is_outer(f, &r, i) && fabs(c - 10) < 1.5)
            continue;           /* on the edge of the least cover with lace */
        const ref_colour want = ref_mix(ref_colour_unpack(before.run.colour[i]),
                                        ref_scale(ref_colour_unpack(f->colour),
                                                  lit_of(&s, &r, i)), share);
        const double e = ref_colour_difference(r.run.colour[i], want);
        measure_add(&off->worst, e, (int64_t)(c * 256), level, i);
        off->square += e * e;
        off->count++;
        /* three ranks of the small scale's 80, 1.2 of cover by three of the large, and one
         * of far cover, a cube of numbers of Q8 */
        assert_true(fabs(r.run.glint[i] - before.run.glint[i] * (1 - share))
                    < 2 + before.run.glint[i] * 0.1);
    }
}

static void bounded(const char *what, bool textured, double most, double rms)
{
    foam_spread off = { .worst = { .what = what, .unit = "of 255" } };

    for (int level = 0; level < (textured ? 6 : 1); level++)
        for (int n = 0; n < 60; n++) {
            for (int i = 0; i < CELLS * CELLS; i++)
                cover[i] = (uint8_t)(chance_int(&chance, 0, 3)
                                     ? chance_int(&chance, 0, 255) : 0);
            compare(textured, level, &off);
        }
    measure_print(&off.worst);
    const double got = sqrt(off.square / (double)off.count);
    printf("    %s: rms %.3f of 255\n", what, got);
    assert_true(off.worst.worst <= most && got <= rms);
}

static void plain_foam_is_as_stated(void **state)
{
    (void)state;
    bounded("plain", false, 6, 1.5);
}

/* Greens are truncated to whole levels before the ranking: up to three of 80 ranks. */
static void foam_of_a_picture_is_as_stated(void **state)
{
    (void)state;
    bounded("picture", true, 20, 1.5);         /* 10 % of 200, as the glint */
}

/* -- further properties -------------------------------------------------------------- */

static void without_cover_nothing_changes(void **state)
{
    (void)state;
    test_run r;

    memset(cover, 0, sizeof cover);
    run_any(&r, 8000, &chance);
    const tp_shade s = shade_foam(&r, true, 0);
    const test_run before = r;
    foam.far_fresh = 0;
    tp_stage_foam_shiny(&s, &r.run);
    assert_memory_equal(&r.run.colour, &before.run.colour, sizeof r.run.colour);
    assert_memory_equal(&r.run.glint, &before.run.glint, sizeof r.run.glint);
}

/* At half cover the mean share of white is the same near and far. */
static void levels_agree_on_the_mean(void **state)
{
    (void)state;
    memset(cover, 110, sizeof cover);
    double mean[6] = { 0 };

    for (int level = 0; level < 6; level++)
        for (int n = 0; n < 200; n++) {
            test_run r;
            run_any(&r, 0, &chance);
            tp_shade s = shade_foam(&r, true, level);
            foam.colour = 0xffffff;
            foam.edge = UINT32_MAX;
            s.ambient = 256;
            memset(r.run.colour, 0, sizeof r.run.colour);
            for (int i = 0; i < TP_RUN; i++) {
                r.s[i] = (uint32_t)foam.low_s + random_below(&chance, foam.side);
                r.t[i] = (uint32_t)foam.low_t + random_below(&chance, foam.side);
            }
            tp_stage_foam(&s, &r.run);
            for (int i = 0; i < TP_RUN; i++)
                mean[level] += (r.run.colour[i] & 0xff) / 255.0 / (200 * TP_RUN);
        }
    for (int level = 0; level < 6; level++) {
        printf("    level %d: %.3f is white\n", level, mean[level]);
        assert_true(fabs(mean[level] - mean[0]) < 0.12);
    }
}

/* Any two parts of a span, cut at a multiple of 16 columns. */
static void where_a_run_is_cut_never_shows(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        test_run r;
        run_any(&r, 3000, &chance);
        const tp_shade s = shade_foam(&r, true, chance_int(&chance, 0, 3));
        const int32_t at = 16 * chance_int(&chance, 1, 3);
        tp_run a = run_part(&r.run, 0, at), b = run_part(&r.run, at, TP_RUN);
        tp_stage_foam(&s, &a);
        tp_stage_foam(&s, &b);
        tp_stage_foam(&s, &r.run);
        assert_memory_equal(a.colour, r.run.colour, (size_t)at * 4);
        assert_memory_equal(b.colour, r.run.colour + at, (size_t)(TP_RUN - at) * 4);
    }
}

int main(void)
{
    chance = random_seed();
    make_picture();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plain_foam_is_as_stated),
        cmocka_unit_test(foam_of_a_picture_is_as_stated),
        cmocka_unit_test(without_cover_nothing_changes),
        cmocka_unit_test(levels_agree_on_the_mean),
        cmocka_unit_test(where_a_run_is_cut_never_shows),
    };
    return cmocka_run_group_tests_name("features/foam_stage", tests, NULL, NULL);
}
