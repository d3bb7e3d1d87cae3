/* SPDX-License-Identifier: MIT */
/* Shares of outlines: near the covered area of each pixel; ropes that do not break; seams
 * without a gap; the same in every tiling. */
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/frames.h"
#include "tests/lib/random.h"

enum { SIDE = 64, MARK = TP_MARK_SOLID };

static uint64_t chance;

static tp_screen_vertex corner(int32_t u, int32_t v)
{
    return (tp_screen_vertex){ .u = u, .v = v, .zi = 1u << 28 };
}

static tp_screen_vertex random_corner(void)
{
    return corner((int32_t)random_below(&chance, 16 * SIDE),
                  (int32_t)random_below(&chance, 16 * SIDE));
}

/* Random depths and light, for the fast rung. */
static tp_screen_vertex lit_corner(void)
{
    tp_screen_vertex c = random_corner();

    c.zi = (1u << 28) + random_below(&chance, 1u << 24);
    c.s = (int32_t)random_below(&chance, 1u << 18);
    c.t = (int32_t)random_below(&chance, 1u << 18);
    for (int k = 0; k < 2; k++)
        c.n[k] = (int16_t)((int32_t)random_below(&chance, 1009) - 504);
    return c;
}

/* A tile with a cleared layer of outlines. */
static test_tile outlined_tile(int32_t x0, int32_t y0, int32_t x1, int32_t y1)
{
    test_tile tile = tile_of(x0, y0, x1, y1, 0);

    tile.samples.outline = calloc(4 * tile.words, sizeof *tile.samples.outline);
    tile.samples.outline_shift = 5;
    tile.samples.front_only = true;
    return tile;
}

static void free_outlined(test_tile *tile)
{
    free(tile->samples.outline);
    tile_free(tile);
}

/* Returns the part of the pixel that shows the mesh, 0..1. */
static double shown_share(const test_tile *tile, int32_t x, int32_t y)
{
    const size_t at = tile_at(tile, x, y);
    const uint32_t *outline = tile->samples.outline + at;

    if (tile->samples.key[at])
        return 1;
    return outline[0] ? tp_outline_share(outline[2 * tile->words], outline[3 * tile->words])
                            / 256.0 : 0;
}

/* Draws triangles with the edges named by the bits of `edges`, in the order of a view. */
static void draw(const test_tile *tile, const tp_screen_vertex (*face)[3],
                 const int *edges, uint32_t count)
{
    for (uint32_t f = 0; f < count; f++)
        for (int k = 0; k < 3; k++)
            if (edges[f] >> k & 1)
                tp_outline_draw_edge(&tile->samples, &face[f][k], &face[f][(k + 1) % 3],
                                     MARK, f);
    for (uint32_t f = 0; f < count; f++)
        tp_tri_solid(&tile->samples, &face[f][0], &face[f][1], &face[f][2], MARK, f, 16);
}

static bool is_inside(const tp_screen_vertex c[3], double u, double v)
{
    for (int k = 0; k < 3; k++) {
        const tp_screen_vertex *a = &c[k], *b = &c[(k + 1) % 3];
        if ((b->u - a->u) * (v - a->v) - (b->v - a->v) * (u - a->u) > 0)
            return false;
    }
    return true;
}

static double covered_area(const tp_screen_vertex c[3], int32_t x, int32_t y)
{
    int inside = 0;

    for (int i = 0; i < 64; i++)
        inside += is_inside(c, 16 * x + 2 * (i % 8) + 1, 16 * y + 2 * (i / 8) + 1);
    return inside / 64.0;
}

static void shares_are_near_the_covered_area(void **state)
{
    double smooth = 0, plain = 0;

    (void)state;
    for (int n = 0; n < 40; ) {
        tp_screen_vertex face[1][3] = { { random_corner(), random_corner(),
                                          random_corner() } };
        if (tp_tri_twice_area(&face[0][0], &face[0][1], &face[0][2]) > -200000)
            continue;
        n++;
        test_tile tile = outlined_tile(0, 0, SIDE, SIDE);
        draw(&tile, (const tp_screen_vertex (*)[3])face, (const int[]){ 7 }, 1);
        for (int32_t i = 0; i < SIDE * SIDE; i++) {
            const int32_t x = i % SIDE, y = i / SIDE;
            const double area = covered_area(face[0], x, y);
            const double centre = is_inside(face[0], 16 * x + 8, 16 * y + 8);
            smooth += pow(shown_share(&tile, x, y) - area, 2);
            plain += pow(centre - area, 2);
        }
        free_outlined(&tile);
    }
    printf("# squares: plain %.1f, outlines %.1f\n", plain, smooth);
    assert_true(plain > 100 && smooth < plain / 8);
}

/* A steep rope of less than half a pixel: each row shows its width. */
static void a_thin_rope_does_not_break(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        const int32_t wide = 3 + (int32_t)random_below(&chance, 5);
        const int32_t top = 320 + (int32_t)random_below(&chance, 64);
        const int32_t low = top + (int32_t)random_below(&chance, 400) - 200;
        const tp_screen_vertex a = corner(top, 0), b = corner(top + wide, 0),
                               c = corner(low + wide, 1024), d = corner(low, 1024);
        const tp_screen_vertex face[2][3] = { { a, d, c }, { a, c, b } };
        test_tile tile = outlined_tile(0, 0, SIDE, SIDE);
        draw(&tile, face, (const int[]){ 1, 2 }, 2);
        for (int32_t y = 0; y < SIDE; y++) {
            double sum = 0;
            for (int32_t x = 0; x < SIDE; x++)
                sum += shown_share(&tile, x, y);
            assert_true(fabs(sum - wide / 16.0) < 0.05);
        }
        free_outlined(&tile);
    }
}

/* Two surfaces that overlap by less than a pixel leave no gap. */
static void a_seam_shows_no_gap(void **state)
{
    (void)state;
    for (int32_t lap = 1; lap < 6; lap++) {
        const tp_screen_vertex face[2][3] = {
            { corner(0, 0), corner(0, 1024), corner(512 + lap, 1024) },
            { corner(512, 0), corner(512, 1024), corner(1024, 0) },
        };
        test_tile tile = outlined_tile(0, 32, SIDE, SIDE);
        tp_screen_vertex left[3] = { corner(0, 0), corner(512 + lap, 1024),
                                     corner(512 + lap, 0) };
        const tp_screen_vertex all[3][3] = {
            { face[0][0], face[0][1], face[0][2] }, { left[0], left[1], left[2] },
            { face[1][0], face[1][1], face[1][2] },
        };
        draw(&tile, all, (const int[]){ 0, 2, 1 }, 3);
        for (int32_t y = 32; y < 48; y++)
            assert_true(shown_share(&tile, 31, y) > 0.9 && shown_share(&tile, 32, y) > 0.5);
        free_outlined(&tile);
    }
}

static void every_tiling_has_the_same_shares(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        tp_screen_vertex face[6][3];
        const int edges[6] = { 7, 7, 7, 7, 7, 7 };
        for (int i = 0; i < 18; i++)
            face[i / 3][i % 3] = random_corner();
        test_tile whole = outlined_tile(0, 0, SIDE, SIDE);
        draw(&whole, (const tp_screen_vertex (*)[3])face, edges, 6);
        for (int32_t y0 = 0; y0 < SIDE; y0 += 16)
            for (int32_t x0 = 0; x0 < SIDE; x0 += 32) {
                test_tile part = outlined_tile(x0, y0, x0 + 32, y0 + 16);
                draw(&part, (const tp_screen_vertex (*)[3])face, edges, 6);
                for (int32_t i = 0; i < 32 * 16; i++) {
                    const int32_t x = x0 + i % 32, y = y0 + i / 32;
                    const size_t a = tile_at(&whole, x, y), b = tile_at(&part, x, y);
                    assert_int_equal(whole.samples.key[a], part.samples.key[b]);
                    for (size_t p = 0; p < 4; p++)
                        assert_int_equal(whole.samples.outline[a + p * whole.words],
                                         part.samples.outline[b + p * part.words]);
                }
                free_outlined(&part);
            }
        free_outlined(&whole);
    }
}

/* Asserts that part of a picture's outlines has the bits of the whole. */
static void assert_outlines(const test_tile *whole, const test_tile *part)
{
    const tp_gbuffer *s = &part->samples;

    for (int32_t y = s->y0; y < s->y1; y++)
        for (int32_t x = s->x0; x < s->x1; x++) {
            const uint32_t *a = whole->samples.outline + tile_at(whole, x, y),
                           *b = s->outline + tile_at(part, x, y);
            for (size_t p = 0; p < 4; p++)
                assert_int_equal(a[p * whole->words], b[p * part->words]);
        }
}

static void fast_edges_have_the_same_bits_in_every_tiling(void **state)
{
    (void)state;
    for (int n = 0; n < 60; n++) {
        const tp_screen_vertex a = lit_corner(), b = lit_corner();
        test_tile whole = outlined_tile(0, 0, SIDE, SIDE);
        tp_outline_draw_edge_fast(&whole.samples, &a, &b, MARK, 7);
        for (int32_t y0 = 0; y0 < SIDE; y0 += 16)
            for (int32_t x0 = 0; x0 < SIDE; x0 += 32) {
                test_tile part = outlined_tile(x0, y0, x0 + 32, y0 + 16);
                tp_outline_draw_edge_fast(&part.samples, &a, &b, MARK, 7);
                assert_outlines(&whole, &part);
                free_outlined(&part);
            }
        free_outlined(&whole);
    }
}

/* The fast rung has the pixels and shares of the exact one, and its depth within 4 of 2^24:
 * the exact share of an edge is cut to 1 / 65536 of 2^24. */
static void fast_edges_have_the_shares_of_exact_ones(void **state)
{
    (void)state;
    uint32_t pixels = 0;
    for (int n = 0; n < 400; n++) {
        const tp_screen_vertex a = lit_corner(), b = lit_corner();
        test_tile fast = outlined_tile(0, 0, SIDE, SIDE),
                  exact = outlined_tile(0, 0, SIDE, SIDE);
        tp_outline_draw_edge_fast(&fast.samples, &a, &b, MARK, 7);
        tp_outline_draw_edge(&exact.samples, &a, &b, MARK, 7);
        for (size_t i = 0; i < fast.words; i++) {
            const uint32_t *f = fast.samples.outline + i, *e = exact.samples.outline + i;
            assert_int_equal(TP_MARK(f[0]), TP_MARK(e[0]));
            if (f[0] == 0)
                continue;
            assert_true(abs((int)(f[0] >> 8) - (int)(e[0] >> 8)) <= 4);
            assert_int_equal(f[2 * fast.words], e[2 * fast.words]);
            pixels++;
        }
        free_outlined(&fast);
        free_outlined(&exact);
    }
    assert_true(pixels > 4000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shares_are_near_the_covered_area),
        cmocka_unit_test(a_thin_rope_does_not_break),
        cmocka_unit_test(a_seam_shows_no_gap),
        cmocka_unit_test(every_tiling_has_the_same_shares),
        cmocka_unit_test(fast_edges_have_the_same_bits_in_every_tiling),
        cmocka_unit_test(fast_edges_have_the_shares_of_exact_ones),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("raster outline", tests, NULL, NULL);
}
