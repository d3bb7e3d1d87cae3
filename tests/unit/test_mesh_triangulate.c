/* SPDX-License-Identifier: MIT */
/* Polygons are triangulated: the triangles cover the polygon exactly once and cover nothing
 * outside. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "tests/lib/meshes.h"

enum { MOST = 256 };

static void assert_cut_everywhere(const point *p, int n, bool simple)
{
    point back[MOST];
    for (int i = 0; i < n; i++)
        back[i] = p[n - 1 - i];
    for (int plane = 0; plane < 6; plane++) {
        assert_cut(p, n, plane, simple);
        assert_cut(back, n, plane, simple);
    }
}

/* -- hand-made polygons ------------------------------------------------------------- */

static void convex_polygons_are_cut_as_a_fan(void **state)
{
    (void)state;
    static const point p[] = { {0,0}, {4,0}, {6,3}, {4,6}, {0,6} };
    cutting c = cut_in_plane(p, 5, 0);
    for (uint32_t i = 0; i < 3; i++) {
        assert_int_equal(c.triangle[i][0], 0);
        assert_int_equal(c.triangle[i][1], i + 1);
        assert_int_equal(c.triangle[i][2], i + 2);
    }
    free_cut(&c);
}

static void an_arrow_head_is_cut_at_its_notch(void **state)
{
    (void)state;
    static const point p[] = { {0,0}, {10,5}, {0,10}, {4,5} };
    for (int first = 0; first < 4; first++) {
        point q[4];
        for (int i = 0; i < 4; i++)
            q[i] = p[(i + first) % 4];
        assert_cut_everywhere(q, 4, true);
    }
}

static void straight_corners_get_triangles_of_area(void **state)
{
    (void)state;
    static const point p[] = { {0,0}, {1,0}, {2,0}, {3,0}, {3,1}, {3,3}, {2,3}, {1,3},
                               {0,3}, {0,1} };
    assert_cut_everywhere(p, 10, true);
}

static void a_hole_reached_by_a_cut_stays_open(void **state)
{
    (void)state;
    static const point p[] = { {0,0}, {9,0}, {9,9}, {0,9}, {0,0}, {3,3}, {3,6}, {6,6},
                               {6,3}, {3,3} };
    assert_cut_everywhere(p, 10, false);
}

static void outlines_that_touch_at_a_corner_are_cut(void **state)
{
    (void)state;
    static const point hourglass[] = { {0,0}, {4,4}, {8,0}, {8,8}, {4,4}, {0,8} };
    assert_cut_everywhere(hourglass, 6, false);
    static const point petals[] = { {0,0}, {5,-1}, {5,1}, {0,0}, {1,5}, {-1,5}, {0,0},
                                    {-5,1}, {-5,-1} };
    assert_cut_everywhere(petals, 9, false);
    static const point doubled[] = { {0,0}, {0,0}, {8,0}, {8,8}, {8,8}, {8,8}, {4,2} };
    assert_cut_everywhere(doubled, 7, false);
    static const point spike[] = { {0,0}, {8,0}, {8,4}, {12,4}, {8,4}, {8,8}, {0,8} };
    assert_cut_everywhere(spike, 7, false);
}

static void the_largest_polygons_do_not_overflow(void **state)
{
    (void)state;
    enum { FAR = 16384 * TP_FX_ONE - 1 };
    for (int k = 0; k < 3; k++) {
        cutting c;
        struct tp_obj_cut *const cut = layout_cut(&c, MOST);
        for (int i = 0; i < MOST; i++) {
            cut->at[k][i] = (i & 1) != (i >> 1 & 1) ? FAR : -FAR;
            cut->at[(k + 1) % 3][i] = i & 2 ? FAR : -FAR;
            cut->at[(k + 2) % 3][i] = 0;
        }
        run_cut(&c, cut, MOST);                 /* a square, run around 64 times */
        assert_edges(&c, MOST);
        free_cut(&c);
    }
}

/* -- random polygons ---------------------------------------------------------------- */

static void combs_and_spirals_are_cut(void **state)
{
    (void)state;
    point p[MOST];
    for (int teeth = 1; teeth <= 84; teeth += 9)
        assert_cut_everywhere(p, make_comb(p, teeth), true);
    for (int half = 3; half <= 128; half += 25)
        assert_cut_everywhere(p, make_spiral(p, half), true);
}

static void random_stars_are_cut(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    for (int i = 0; i < 400; i++) {
        point p[MOST];
        const int n = make_star(p, 5 + (int)(next_random(&random) % (MOST - 4)), &random,
                                i % 2 ? 30 : 8000);
        assert_cut(p, n, i % 6, true);
    }
}

static bool on_segment(point a, point b, point p)
{
    return turn(a, b, p) == 0 && (a.u < b.u ? a.u <= p.u && p.u <= b.u
                                            : b.u <= p.u && p.u <= a.u)
        && (a.v < b.v ? a.v <= p.v && p.v <= b.v : b.v <= p.v && p.v <= a.v);
}

static bool touch(point a, point b, point c, point d)
{
    const int64_t c_side = turn(a, b, c), d_side = turn(a, b, d);
    const int64_t a_side = turn(c, d, a), b_side = turn(c, d, b);
    if (((c_side > 0 && d_side < 0) || (c_side < 0 && d_side > 0))
        && ((a_side > 0 && b_side < 0) || (a_side < 0 && b_side > 0)))
        return true;
    return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a)
        || on_segment(c, d, b);
}

/* True if `x` can be inserted between corners i and i + 1 without a self-contact of the
 * outline. */
static bool may_insert(const point *p, int n, int i, point x)
{
    const point a = p[i], b = p[(i + 1) % n];
    if (on_segment(a, x, b) || on_segment(b, x, a))
        return false;
    for (int k = 0; k < n; k++) {
        const point c = p[k], d = p[(k + 1) % n];
        if (k == i)
            continue;
        const bool follows = k == (i + 1) % n, leads = (k + 1) % n == i;
        if (on_segment(c, d, x) || (follows ? on_segment(x, b, d) : touch(x, b, c, d))
            || (leads ? on_segment(a, x, c) : touch(a, x, c, d)))
            return false;
    }
    return true;
}

/* Grows a simple polygon on a coarse grid, where many corners are collinear. */
static int make_simple(point *p, int want, uint32_t grid, uint64_t *random)
{
    int n = 3;
    p[0] = (point){ 0, 0 };
    p[1] = (point){ (int32_t)grid, 1 };
    p[2] = (point){ 2, (int32_t)grid };
    for (int tries = 0; n < want && tries < 3000; tries++) {
        const int i = (int)(next_random(random) % (uint32_t)n);
        const point x = { (int32_t)(next_random(random) % (grid + 1)),
                          (int32_t)(next_random(random) % (grid + 1)) };
        if (!may_insert(p, n, i, x))
            continue;
        memmove(p + i + 2, p + i + 1, (size_t)(n - i - 1) * sizeof *p);
        p[i + 1] = x;
        n++;
    }
    return n;
}

static void random_simple_polygons_are_cut(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    int largest = 0;
    for (int i = 0; i < 300; i++) {
        point p[MOST];
        const uint32_t grid = 4 + next_random(&random) % 30;
        const int n = make_simple(p, 4 + (int)(next_random(&random) % 60), grid, &random);
        assert_cut(p, n, i % 6, true);
        largest = n > largest ? n : largest;
    }
    assert_true(largest > 50);
}

/* Inserts the outline of a random hole into a random simple polygon ten times as large. */
static void random_holes_are_cut(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    for (int i = 0; i < 300; i++) {
        point p[MOST], hole[MOST];
        const int n = make_simple(hole, 20, 12, &random);
        const int32_t far = 30 + (int32_t)(next_random(&random) % 30);
        const point box[] = { {-far, -9}, {40, -far}, {far, far}, {-8, 40} };
        int least = 0;
        for (int k = 1; k < n; k++)             /* no corner left of corner `least` */
            if (hole[k].u < hole[least].u
                || (hole[k].u == hole[least].u && hole[k].v < hole[least].v))
                least = k;
        const int32_t sense = area_of(hole, n) > 0 ? n - 1 : 1;
        int m = 0;
        for (int k = 0; k <= 4; k++)
            p[m++] = box[k % 4];
        for (int k = 0; k <= n; k++)
            p[m++] = hole[(least + k * sense) % n];
        bool open = true;                       /* the bridge crosses no edge */
        for (int k = 0; k < n; k++) {
            const point c = hole[k], d = hole[(k + 1) % n];
            if (k != least && (k + 1) % n != least && touch(box[0], hole[least], c, d))
                open = false;
        }
        if (open)
            assert_cut(p, m, i % 6, false);
    }
}

/* True if the interiors of two triangles, both counter-clockwise, are disjoint.  Then an
 * edge of one triangle has the other triangle on its right side. */
static bool apart(const point a[3], const point b[3])
{
    for (int k = 0; k < 3; k++) {
        const point p = a[k], q = a[(k + 1) % 3], r = b[k], s = b[(k + 1) % 3];
        if ((turn(p, q, b[0]) <= 0 && turn(p, q, b[1]) <= 0 && turn(p, q, b[2]) <= 0)
            || (turn(r, s, a[0]) <= 0 && turn(r, s, a[1]) <= 0 && turn(r, s, a[2]) <= 0))
            return true;
    }
    return false;
}

/* Grows a polygon from disjoint triangles: the polygon may touch itself at corners and
 * along edges, but covers no point twice. */
static int make_touching(point *p, int want, uint32_t grid, uint64_t *random)
{
    point made[MOST][3] = { { {0, 0}, {2, 0}, {0, 2} } };
    int n = 3;
    memcpy(p, made[0], sizeof made[0]);
    for (int tries = 0; n < want && tries < 2000; tries++) {
        const int i = (int)(next_random(random) % (uint32_t)n);
        const point x = { (int32_t)(next_random(random) % (grid + 1)),
                          (int32_t)(next_random(random) % (grid + 1)) };
        const point t[3] = { p[(i + 1) % n], p[i], x };
        bool fits = turn(t[0], t[1], t[2]) > 0;
        for (int k = 0; k < n - 2 && fits; k++)
            fits = apart(made[k], t);
        if (!fits)
            continue;
        memcpy(made[n - 2], t, sizeof t);
        memmove(p + i + 2, p + i + 1, (size_t)(n - i - 1) * sizeof *p);
        p[i + 1] = x;
        n++;
    }
    return n;
}

static void random_outlines_that_touch_themselves_are_cut(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    int largest = 0;
    for (int i = 0; i < 1000; i++) {
        point p[MOST];
        const uint32_t grid = 3 + next_random(&random) % 12;
        const int n = make_touching(p, 4 + (int)(next_random(&random) % 40), grid,
                                    &random);
        assert_cut(p, n, i % 6, false);
        largest = n > largest ? n : largest;
    }
    assert_true(largest > 35);
}

static void any_outline_gives_two_triangles_less_than_corners(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    for (int i = 0; i < 600; i++) {
        const int n = 3 + (int)(next_random(&random) % (MOST - 2));
        const uint32_t mask = 0xffffffffu >> next_random(&random) % 32;
        cutting c;
        struct tp_obj_cut *const cut = layout_cut(&c, n);
        for (int k = 0; k < 3 * n; k++)
            cut->at[k % 3][k / 3] = (int32_t)(next_random(&random) & mask & 0x7fffffffu)
                                 - 0x3fffffff;
        run_cut(&c, cut, n);
        assert_edges(&c, n);
        assert_true(c.steps > 0);               /* no corner was cut without a test */
        free_cut(&c);
    }
}

int main(void)
{
    static uint64_t seed;
    seed = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(convex_polygons_are_cut_as_a_fan),
        cmocka_unit_test(an_arrow_head_is_cut_at_its_notch),
        cmocka_unit_test(straight_corners_get_triangles_of_area),
        cmocka_unit_test(a_hole_reached_by_a_cut_stays_open),
        cmocka_unit_test(outlines_that_touch_at_a_corner_are_cut),
        cmocka_unit_test(the_largest_polygons_do_not_overflow),
        cmocka_unit_test(combs_and_spirals_are_cut),
        cmocka_unit_test_prestate(random_stars_are_cut, &seed),
        cmocka_unit_test_prestate(random_simple_polygons_are_cut, &seed),
        cmocka_unit_test_prestate(random_holes_are_cut, &seed),
        cmocka_unit_test_prestate(random_outlines_that_touch_themselves_are_cut, &seed),
        cmocka_unit_test_prestate(any_outline_gives_two_triangles_less_than_corners,
                                  &seed),
    };
    return cmocka_run_group_tests_name("mesh/triangulate", tests, NULL, NULL);
}
