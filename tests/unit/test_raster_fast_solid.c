/* SPDX-License-Identifier: MIT */
/* Triangles of the fast rung cover the pixels of exact ones, have their depth, place and
 * light within a bound, and have the same bits in every tile. */
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/frames.h"
#include "tests/lib/random.h"

enum { SIDE = 96, MARK = TP_MARK_SOLID, MESHED = 12 };

static uint64_t chance;

typedef struct {
    tp_screen_vertex corner[3];
} face;

static int32_t between(int32_t low, int32_t high)
{
    return low + (int32_t)random_below(&chance, (uint32_t)(high - low));
}

/* A vertex near a point; depths differ by up to 1/16. */
static tp_screen_vertex vertex_near(int32_t u, int32_t v, int32_t size, bool level)
{
    tp_screen_vertex c = {
        .u = between(u - size, u + size + 1), .v = between(v - size, v + size + 1),
        .zi = (1u << 26) + random_below(&chance, 1u << 22),
        .s = between(-40000, 40000), .t = between(-40000, 40000),
    };
    c.n[0] = (int16_t)between(-504, 505);
    c.n[1] = (int16_t)between(-504, 505);
    if (level)
        c.v = v + (c.v - v) / 16;
    return c;
}

/* A triangle of any size up to the tile, every third a sliver. */
static face random_face(void)
{
    const int32_t size = 4 << random_below(&chance, 8);
    const int32_t u = between(0, 16 * SIDE), v = between(0, 16 * SIDE);
    const bool level = random_below(&chance, 3) == 0;
    face f;

    for (int k = 0; k < 3; k++)
        f.corner[k] = vertex_near(u, v, size, level);
    return f;
}

static bool draw_fast(const test_tile *tile, const face *f)
{
    return tp_tri_solid_fast(&tile->samples, &f->corner[0], &f->corner[1], &f->corner[2],
                             MARK);
}

static void draw_exact(const test_tile *tile, const face *f)
{
    tp_tri_solid(&tile->samples, &f->corner[0], &f->corner[1], &f->corner[2], MARK, 0, 16);
}

static test_tile front_tile(int32_t x0, int32_t y0, int32_t x1, int32_t y1)
{
    test_tile tile = tile_of(x0, y0, x1, y1, 0);
    tile.samples.front_only = true;
    return tile;
}

static void fast_triangles_cover_the_pixels_of_exact_ones(void **state)
{
    (void)state;
    uint32_t covered = 0, drawn = 0;
    for (int n = 0; n < 4000; n++) {
        const face f = random_face();
        test_tile fast = front_tile(0, 0, SIDE, SIDE), exact = front_tile(0, 0, SIDE, SIDE);
        if (draw_fast(&fast, &f)) {
            draw_exact(&exact, &f);
            for (size_t i = 0; i < fast.words; i++) {
                assert_int_equal(TP_MARK(fast.samples.key[i]), TP_MARK(exact.samples.key[i]));
                covered += fast.samples.key[i] != 0;
            }
            drawn++;
        }
        tile_free(&fast);
        tile_free(&exact);
    }
    print_message("%u pixels of %u triangles\n", covered, drawn);
    assert_true(covered > 20000 && drawn > 3000);
}

/* True if the quantities have a gradient: not tiny, not a sliver. */
static bool has_planes(const face *f)
{
    const tp_screen_vertex *c = f->corner;
    const double area = -(double)tp_tri_twice_area(&c[0], &c[1], &c[2]);
    int32_t low[2] = { c[0].u, c[0].v }, high[2] = { c[0].u, c[0].v };

    for (int k = 1; k < 3; k++) {
        low[0] = c[k].u < low[0] ? c[k].u : low[0];
        low[1] = c[k].v < low[1] ? c[k].v : low[1];
        high[0] = c[k].u > high[0] ? c[k].u : high[0];
        high[1] = c[k].v > high[1] ? c[k].v : high[1];
    }
    return area > 200 * fmax(high[0] - low[0], high[1] - low[1]);
}

static int signed_half(uint32_t word)
{
    return (int16_t)(word & 0xffff);
}

/* The greatest differences measured are 2 of 2^24 in depth, 60 of 65536 repeats and 2 of 511
 * in light: a step is cut by up to 1, at most 64 times in each direction. */
static void large_triangles_have_the_values_of_exact_ones(void **state)
{
    (void)state;
    int depth = 0, place = 0, light = 0;
    uint32_t compared = 0;
    for (int n = 0; n < 4000; n++) {
        face f = random_face();
        for (int k = 0; k < 3; k++)     /* affine in both */
            f.corner[k].zi = (1u << 26) + random_below(&chance, 1u << 18);
        test_tile fast = front_tile(0, 0, SIDE, SIDE), exact = front_tile(0, 0, SIDE, SIDE);
        if (has_planes(&f) && draw_fast(&fast, &f)) {
            draw_exact(&exact, &f);
            for (size_t i = 0; i < fast.words; i++) {
                const tp_gbuffer *a = &fast.samples, *b = &exact.samples;
                if (a->key[i] == 0)
                    continue;
                const int d = abs((int)(a->key[i] >> 8) - (int)(b->key[i] >> 8)),
                          s = abs(signed_half((a->s[i] >> 16) - (b->s[i] >> 16))),
                          t = abs(signed_half(a->s[i] - b->s[i])),
                          l = abs(signed_half(((a->n[i] & 1023) - (b->n[i] & 1023)) << 6) / 64),
                          g = abs(signed_half(((a->n[i] >> 10) - (b->n[i] >> 10)) << 6) / 64);
                depth = d > depth ? d : depth;
                place = s > place ? s : t > place ? t : place;
                light = l > light ? l : g > light ? g : light;
                compared++;
            }
        }
        tile_free(&fast);
        tile_free(&exact);
    }
    print_message("%u pixels: depth %d, place %d, light %d\n", compared, depth, place, light);
    assert_true(compared > 10000);
    assert_true(depth <= 3 && place <= 80 && light <= 2);
}

/* Asserts that part of a picture has the bits of the whole. */
static void assert_part(const test_tile *whole, const test_tile *part)
{
    const tp_gbuffer *s = &part->samples;

    for (int32_t y = s->y0; y < s->y1; y++)
        for (int32_t x = s->x0; x < s->x1; x++) {
            const size_t a = tile_at(whole, x, y), b = tile_at(part, x, y);
            assert_int_equal(whole->samples.key[a], s->key[b]);
            if (s->key[b] == 0)
                continue;
            assert_int_equal(whole->samples.s[a], s->s[b]);
            assert_int_equal(whole->samples.n[a], s->n[b]);
        }
}

static void every_tile_has_the_same_bits(void **state)
{
    (void)state;
    for (int n = 0; n < 300; n++) {
        face mesh[MESHED];
        test_tile whole = front_tile(0, 0, SIDE, SIDE);
        const int32_t x0 = 16 * between(0, 5), y0 = between(0, SIDE - 1),
                      x1 = x0 + 16, y1 = y0 + 1 + between(0, SIDE - y0);
        test_tile part = front_tile(x0, y0, x1, y1);
        for (int k = 0; k < MESHED; k++) {
            mesh[k] = random_face();
            if (draw_fast(&whole, &mesh[k]))
                assert_true(draw_fast(&part, &mesh[k]));
        }
        assert_part(&whole, &part);
        tile_free(&whole);
        tile_free(&part);
    }
}

static void back_sides_and_triangles_outside_draw_nothing(void **state)
{
    (void)state;
    for (int n = 0; n < 500; n++) {
        face f = random_face();
        test_tile tile = front_tile(0, 0, SIDE, SIDE);
        const tp_screen_vertex *c = f.corner;
        if (tp_tri_twice_area(&c[0], &c[1], &c[2]) < 0) {
            const tp_screen_vertex swap = f.corner[1];
            f.corner[1] = f.corner[2];
            f.corner[2] = swap;
        }
        assert_true(draw_fast(&tile, &f));
        for (int k = 0; k < 3; k++)
            f.corner[k].u += 16 * 1000;
        assert_true(draw_fast(&tile, &f));
        for (size_t i = 0; i < tile.words; i++)
            assert_int_equal(tile.samples.key[i], 0);
        tile_free(&tile);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fast_triangles_cover_the_pixels_of_exact_ones),
        cmocka_unit_test(large_triangles_have_the_values_of_exact_ones),
        cmocka_unit_test(every_tile_has_the_same_bits),
        cmocka_unit_test(back_sides_and_triangles_outside_draw_nothing),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("raster/fast_solid", tests, NULL, NULL);
}
