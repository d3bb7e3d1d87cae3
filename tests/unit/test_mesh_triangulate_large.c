/* SPDX-License-Identifier: MIT */
/* Polygons of very many corners are triangulated as exactly as small polygons, in a few
 * steps per corner, and no outline takes more steps than its bound. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "tests/lib/meshes.h"
#include "tests/lib/random.h"
#include "fixed/arithmetic.h"

enum { MOST = 30000, STEPS = 2048 };   /* step bound of mesh/triangulate.c */

static point p[MOST];

/* Triangulates and checks; returns the mean number of steps per corner. */
static uint32_t cut_and_check(int n, int plane, bool simple)
{
    cutting c = cut_in_plane(p, n, plane);
    assert_covered(&c, p, n, simple);
    const uint64_t taken = (uint64_t)STEPS * (uint64_t)n - c.steps;
    free_cut(&c);
    return (uint32_t)(taken / (uint64_t)n);
}

/* Stores a circle: directions on the border of a square, then scaled to one radius. */
static void put_circle(point *to, int n, int32_t radius)
{
    uint64_t random = 1;
    make_star(to, n, &random, 1);
    for (int i = 0; i < n; i++) {
        const int64_t u = to[i].u, v = to[i].v;
        const int64_t length = tp_isqrt64((uint64_t)(u * u + v * v) << 20);
        to[i] = (point){ (int32_t)(u * radius * 1024 / length),
                         (int32_t)(v * radius * 1024 / length) };
    }
}

static void a_disc_of_30000_corners_is_cut(void **state)
{
    (void)state;
    const int corners = random_rounds(30000, 6000);
    put_circle(p, corners, 1 << 25);
    const uint32_t steps = cut_and_check(corners, 1, true);
    print_message("    disc of %d: %u steps a corner\n", corners, (unsigned)steps);
    assert_true(steps < 1000);
}

static void a_ring_of_20000_corners_keeps_its_hole(void **state)
{
    (void)state;
    const int side = random_rounds(10000, 2500);
    put_circle(p, side, 1 << 24);
    p[side] = p[0];
    put_circle(p + side + 1, side, 1 << 23);
    for (int i = 1; i <= side / 2; i++) {       /* in the opposite direction */
        const point keep = p[side + 1 + i];
        p[side + 1 + i] = p[2 * side + 1 - i];
        p[2 * side + 1 - i] = keep;
    }
    p[2 * side + 1] = p[side + 1];
    const uint32_t steps = cut_and_check(2 * side + 2, 4, false);
    print_message("    ring of %d: %u steps a corner\n", 2 * side, (unsigned)steps);
    assert_true(steps < 1000);
}

static void a_comb_of_6000_corners_is_cut(void **state)
{
    (void)state;
    const uint32_t steps = cut_and_check(make_comb(p, random_rounds(2000, 1000)), 2, true);
    print_message("    comb of 6000: %u steps a corner\n", (unsigned)steps);
    assert_true(steps < 1500);
}

static void a_spiral_of_5000_corners_is_cut(void **state)
{
    (void)state;
    const uint32_t steps = cut_and_check(make_spiral(p, random_rounds(2500, 1200)), 0, true);
    print_message("    spiral of 5000: %u steps a corner\n", (unsigned)steps);
    assert_true(steps < 1500);
}

/* 4096 REACH x 6, the extent of an oblique plane, is below 2^27: wider outlines are
 * rounded, and a rounded star may cross itself. */
static void stars_of_up_to_20000_corners_are_cut(void **state)
{
    enum { REACH = 5400 };
    uint64_t random = *(const uint64_t *)*state;
    static const int corners[] = { 257, 272, 511, 1024, 4097, 20000 };
    for (int i = 0; i < random_rounds(6, 5); i++) {
        const uint32_t steps =
            cut_and_check(make_star(p, corners[i], &random, REACH), i, true);
        print_message("    star of %d: %u steps a corner\n", corners[i], (unsigned)steps);
    }
}

/* A random outline has hardly any ear: without a bound the cut would take 10^9 steps. */
static void an_outline_at_random_ends_within_its_steps(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    const int corners = random_rounds(MOST, 8000);
    for (int i = 0; i < corners; i++)
        p[i] = (point){ (int32_t)(next_random(&random) >> 4) - (1 << 27),
                        (int32_t)(next_random(&random) >> 4) - (1 << 27) };
    cutting c = cut_in_plane(p, corners, 0);
    assert_edges(&c, corners);
    assert_true(c.steps == 0);
    free_cut(&c);
}

/* More than 2^8 corners at the ends of the range: the sum of their areas exceeds 63
 * bits. */
static void the_widest_outlines_turn_the_right_way(void **state)
{
    (void)state;
    enum { FAR = 16384 * TP_FX_ONE - 1, N = 4000 };
    for (int back = 0; back <= 1; back++) {
        cutting c;
        struct tp_obj_cut *const cut = layout_cut(&c, N);
        for (int i = 0; i < N; i++) {           /* a square, run around 1000 times */
            const int k = back ? N - 1 - i : i;
            cut->at[0][i] = (k & 1) != (k >> 1 & 1) ? FAR : -FAR;
            cut->at[1][i] = k & 2 ? FAR : -FAR;
            cut->at[2][i] = 0;
        }
        run_cut(&c, cut, N);
        assert_ptr_equal(cut->u, back ? cut->at[1] : cut->at[0]);
        assert_edges(&c, N);
        free_cut(&c);
    }
}

int main(void)
{
    static uint64_t seed;
    seed = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_disc_of_30000_corners_is_cut),
        cmocka_unit_test(a_ring_of_20000_corners_keeps_its_hole),
        cmocka_unit_test(a_comb_of_6000_corners_is_cut),
        cmocka_unit_test(a_spiral_of_5000_corners_is_cut),
        cmocka_unit_test_prestate(stars_of_up_to_20000_corners_are_cut, &seed),
        cmocka_unit_test_prestate(an_outline_at_random_ends_within_its_steps, &seed),
        cmocka_unit_test(the_widest_outlines_turn_the_right_way),
    };
    return cmocka_run_group_tests_name("mesh/triangulate_large", tests, NULL, NULL);
}
