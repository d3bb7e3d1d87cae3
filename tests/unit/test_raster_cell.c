/* SPDX-License-Identifier: MIT */
/* Cells of water by planes: the pixels of their two triangles, close to their samples, and
 * the same bits in every tile. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/random.h"
#include "tests/lib/frames.h"

enum { X0 = 64, Y0 = 32, X1 = 256, Y1 = 160 };

static uint64_t chance;

typedef struct {
    tp_screen_vertex left[2], right[2];
} cell;

static tp_screen_vertex vertex(int32_t u, int32_t v)
{
    return (tp_screen_vertex){ .u = u, .v = v, .zi = 1u << 28 };
}

/* A cell of `size` units of 28.4 px at most; every corner strays by up to `stray` of its
 * size, so that cells may fold. */
static cell any_cell(int32_t size, int32_t stray)
{
    const int32_t u = chance_int(&chance, 16 * X0 - size, 16 * X1);
    const int32_t v = chance_int(&chance, 16 * Y0 - size, 16 * Y1);
    const int32_t wide = chance_int(&chance, 0, size), high = chance_int(&chance, 0, size);
    cell c;

    for (int i = 0; i < 2; i++) {
        c.left[i] = vertex(u + chance_int(&chance, 0, wide * stray / 16),
                           v + i * high - chance_int(&chance, 0, high * stray / 16));
        c.right[i] = vertex(u + wide - chance_int(&chance, 0, wide * stray / 16),
                            v + i * high + chance_int(&chance, 0, high * stray / 16));
    }
    return c;
}

/* Gives each corner the values of planes over the screen, and a depth ratio that needs no
 * perspective. */
static void set_planes(cell *c)
{
    const int32_t s = chance_int(&chance, -500, 500), t = chance_int(&chance, -500, 500);
    const int32_t nx = chance_int(&chance, -50, 50), nz = chance_int(&chance, -50, 50);
    tp_screen_vertex *const p[4] = { &c->left[0], &c->left[1], &c->right[0], &c->right[1] };

    for (int i = 0; i < 4; i++) {
        p[i]->s = s * p[i]->u + t * p[i]->v;
        p[i]->t = t * p[i]->u - s * p[i]->v;
        p[i]->n[0] = (int16_t)((nx * (p[i]->u - 16 * X0) + nz * (p[i]->v - 16 * Y0)) / 16);
        p[i]->n[1] = (int16_t)((nz * (p[i]->u - 16 * X0) - nx * (p[i]->v - 16 * Y0)) / 16);
        p[i]->zi += (uint32_t)(10 * p[i]->u + 20 * p[i]->v);
    }
}

static void draw_exact(const tp_gbuffer *tile, const tp_screen_vertex left[2],
                       const tp_screen_vertex right[2])
{
    tp_cell_draw_halves(tp_tri_water, tile, left, right, TP_CELL_WHOLE);
}

static void draw_fast(const tp_gbuffer *tile, const tp_screen_vertex left[2],
                      const tp_screen_vertex right[2])
{
    tp_cell_draw_halves(tp_tri_water, tile, left, right,
                        tp_cell_water_fast(tile, left, right));
}

static test_tile whole(bool front_only)
{
    test_tile tile = tile_of(X0, Y0, X1, Y1, 0);
    tile.samples.front_only = front_only;
    return tile;
}

static void the_pixels_are_those_of_two_triangles(void **state)
{
    static const int32_t sizes[] = { 12, 60, 200, 1000, 2000 };
    uint64_t pixels = 0;

    (void)state;
    for (int n = 0; n < 2000; n++) {
        const bool front_only = n & 1;
        const cell c = any_cell(sizes[n % 5], n % 3 == 0 ? 0 : n % 3 == 1 ? 6 : 20);
        test_tile a = whole(front_only), b = whole(front_only);
        draw_exact(&a.samples, n & 2 ? c.right : c.left, n & 2 ? c.left : c.right);
        draw_fast(&b.samples, n & 2 ? c.right : c.left, n & 2 ? c.left : c.right);
        for (size_t i = 0; i < a.words; i++) {
            if (!a.samples.key[i] != !b.samples.key[i])
                fail_msg("cell %d: pixel %d %d", n, X0 + (int)(i % (X1 - X0)),
                         Y0 + (int)(i / (X1 - X0)));
            pixels += a.samples.key[i] != 0;
        }
        tile_free(&a);
        tile_free(&b);
    }
    assert_in_range(pixels, 300000, 100000000);
}

/* -- samples ------------------------------------------------------------------------- */

/* The distance between two slopes of Q3.12. */
static int32_t slope_error(uint32_t a, uint32_t b, int shift)
{
    const int32_t off = (int16_t)(uint16_t)(a >> shift) - (int16_t)(uint16_t)(b >> shift);
    return off < 0 ? -off : off;
}

static void raise(int32_t *most, int32_t by)
{
    *most = by > *most ? by : *most;
}

/* s and t are within 1/64 px of the exact triangles' where these need no perspective: each
 * difference is below 2^15 a pixel.  Slopes step by whole units over a row of up to 24 px:
 * half a unit each; the divisor has 12 bits. */
static void planes_are_drawn_as_by_two_triangles(void **state)
{
    int32_t place = 0, slope = 0, depth = 0;

    (void)state;
    for (int n = 0; n < 2000; n++) {
        cell c = any_cell(24 * 16, 5);
        set_planes(&c);
        test_tile a = whole(false), b = whole(false);
        draw_exact(&a.samples, c.left, c.right);
        draw_fast(&b.samples, c.left, c.right);
        for (size_t i = 0; i < a.words; i++) {
            if (!a.samples.key[i])
                continue;
            const int32_t z = (int32_t)(a.samples.key[i] >> 8) - (int32_t)(b.samples.key[i] >> 8);
            raise(&depth, tp_abs(z));
            raise(&place, tp_abs((int32_t)(a.samples.s[i] - b.samples.s[i])));
            raise(&place, tp_abs((int32_t)(a.samples.t[i] - b.samples.t[i])));
            raise(&slope, slope_error(a.samples.n[i], b.samples.n[i], 0));
            raise(&slope, slope_error(a.samples.n[i], b.samples.n[i], 16));
        }
        tile_free(&a);
        tile_free(&b);
    }
    printf("largest errors: s, t %d of 65536 m, slopes %d of 4096, depth %d\n", place, slope,
           depth);
    assert_in_range(place, 0, 256);
    assert_in_range(slope, 1, 13);
    assert_in_range(depth, 0, 8);
}

/* -- tiles --------------------------------------------------------------------------- */

static void compare_part(const test_tile *all, const test_tile *part)
{
    const tp_gbuffer *s = &part->samples;

    for (int32_t y = s->y0; y < s->y1; y++)
        for (int32_t x = s->x0; x < s->x1; x++) {
            const size_t i = tile_at(all, x, y), k = tile_at(part, x, y);
            assert_int_equal(all->samples.key[i], s->key[k]);
            if (!s->key[k])
                continue;
            assert_int_equal(all->samples.s[i], s->s[k]);
            assert_int_equal(all->samples.t[i], s->t[k]);
            assert_int_equal(all->samples.n[i], s->n[k]);
        }
}

static void tiles_cut_anywhere_give_the_same_samples(void **state)
{
    (void)state;
    for (int n = 0; n < 800; n++) {
        const int32_t x = chance_int(&chance, X0, X1 - 1), y = chance_int(&chance, Y0, Y1 - 1);
        test_tile all = whole(n & 1);
        test_tile part = tile_of(x, y, chance_int(&chance, x + 1, X1),
                                 chance_int(&chance, y + 1, Y1), (uint32_t)n % 5);
        part.samples.front_only = n & 1;
        for (int k = 0; k < 6; k++) {
            cell c = any_cell(k < 3 ? 300 : 1000, k % 2 ? 3 : 12);
            set_planes(&c);
            draw_fast(&all.samples, c.left, c.right);
            draw_fast(&part.samples, c.left, c.right);
        }
        compare_part(&all, &part);
        tile_free(&all);
        tile_free(&part);
    }
}

static void a_cell_beside_the_tile_or_without_area_draws_nothing(void **state)
{
    test_tile tile = whole(false);

    (void)state;
    for (int n = 0; n < 1000; n++) {
        const int32_t u = 16 * (n % 2 ? X1 : X0 - 40), v = 16 * (n % 4 < 2 ? Y1 : Y0 - 40);
        cell c = { { vertex(u, v), vertex(u, v + 500) },
                   { vertex(u + 500, v), vertex(u + 500, v + 500) } };
        if (n % 4 == 3)
            c = (cell){ { vertex(2000, 1000), vertex(2000, 1400) },
                        { vertex(2000, 1000), vertex(2000, 1400) } };
        draw_fast(&tile.samples, c.left, c.right);
    }
    for (size_t i = 0; i < tile.words; i++)
        assert_int_equal(tile.samples.key[i], 0);
    tile_free(&tile);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_pixels_are_those_of_two_triangles),
        cmocka_unit_test(planes_are_drawn_as_by_two_triangles),
        cmocka_unit_test(tiles_cut_anywhere_give_the_same_samples),
        cmocka_unit_test(a_cell_beside_the_tile_or_without_area_draws_nothing),
    };
    return cmocka_run_group_tests_name("raster/cell", tests, NULL, NULL);
}
