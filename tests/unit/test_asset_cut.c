/* SPDX-License-Identifier: MIT */
/* Polygons are cut into triangles that cover them once and nothing else.
 *
 * That holds exactly if every triangle turns the polygon's way and the triangles' edges,
 * those that run against each other cancelled, are the polygon's: then each point is
 * covered as often as the outline winds around it. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include "asset/obj.h"
#include "test_asset_reader.h"

enum { MOST = TP_OBJ_CORNERS };

typedef struct { int32_t u, v; } point;

/* Twice the area of a, b, c.  Points lie within +-2^29 here. */
static int64_t turn(point a, point b, point c)
{
    return ((int64_t)b.u - a.u) * ((int64_t)c.v - a.v)
         - ((int64_t)b.v - a.v) * ((int64_t)c.u - a.u);
}

static int64_t area_of(const point *p, int n)
{
    int64_t sum = 0;
    for (int i = 2; i < n; i++)
        sum += turn(p[0], p[i - 1], p[i]);
    return sum;
}

/* Lays the polygon into one of six planes: three square to an axis, three aslant, which
 * look largest along another axis than the one it is drawn for.  Then cuts it. */
static void cut_in_plane(tp_obj_cut *cut, const point *p, int n, int plane)
{
    memset(cut, 0xA5, sizeof *cut);
    for (int i = 0; i < n; i++) {
        const int32_t out = plane < 3 ? 77 : p[i].u + 2 * p[i].v;
        cut->at[plane % 3][i] = p[i].u;
        cut->at[(plane + 1) % 3][i] = p[i].v;
        cut->at[(plane + 2) % 3][i] = out;
    }
    tp_obj_cut_polygon(cut, (uint32_t)n);
}

/* Whether the triangles' edges make the outline. */
static void assert_edges(const tp_obj_cut *cut, int n)
{
    static int8_t edge[MOST][MOST];
    memset(edge, 0, sizeof edge);
    for (int i = 0; i < n - 2; i++) {
        for (int k = 0; k < 3; k++) {
            const uint8_t a = cut->triangle[i][k], b = cut->triangle[i][(k + 1) % 3];
            assert_true(a < n && b < n && a != b);
            edge[a][b]++;
            edge[b][a]--;
        }
    }
    for (int a = 0; a < n; a++) {
        for (int b = 0; b < a; b++) {
            int want = a == b + 1 ? -1 : 0;     /* the outline runs b to b + 1 */
            want += a == n - 1 && b == 0 ? 1 : 0;
            assert_int_equal(edge[a][b], want);
        }
    }
}

static void assert_cut(const point *p, int n, int plane, bool simple)
{
    tp_obj_cut cut;
    cut_in_plane(&cut, p, n, plane);
    assert_edges(&cut, n);
    const bool left = area_of(p, n) > 0;
    int64_t sum = 0;
    for (int i = 0; i < n - 2; i++) {
        const uint8_t *const t = cut.triangle[i];
        const int64_t area = turn(p[t[0]], p[t[1]], p[t[2]]);
        assert_true(left ? area >= 0 : area <= 0);
        assert_true(area != 0 || !simple);
        sum += area;
    }
    assert_true(sum == area_of(p, n));
}

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

/* -- by hand ------------------------------------------------------------------------ */

static void convex_polygons_are_cut_as_a_fan(void **state)
{
    (void)state;
    static const point p[] = { {0,0}, {4,0}, {6,3}, {4,6}, {0,6} };
    tp_obj_cut cut;
    cut_in_plane(&cut, p, 5, 0);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(cut.triangle[i][0], 0);
        assert_int_equal(cut.triangle[i][1], i + 1);
        assert_int_equal(cut.triangle[i][2], i + 2);
    }
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
    tp_obj_cut cut;
    for (int k = 0; k < 3; k++) {
        memset(&cut, 0, sizeof cut);
        for (int i = 0; i < MOST; i++) {
            cut.at[k][i] = (i & 1) != (i >> 1 & 1) ? FAR : -FAR;
            cut.at[(k + 1) % 3][i] = i & 2 ? FAR : -FAR;
        }
        tp_obj_cut_polygon(&cut, MOST);         /* a square, gone round 64 times */
        assert_edges(&cut, 4);
    }
}

/* -- at random ---------------------------------------------------------------------- */

/* A comb, a spiral and stars have many reflex corners in a row, or few ears. */
static int make_comb(point *p, int teeth)
{
    int n = 0;
    for (int i = 0; i < teeth; i++) {
        p[n++] = (point){ 4 * i, 0 };
        p[n++] = (point){ 4 * i + 2, i % 3 };
        p[n++] = (point){ 4 * i + 3, 100 + i % 5 };
    }
    p[n++] = (point){ 4 * teeth, 0 };
    p[n++] = (point){ 4 * teeth, -10 };
    p[n++] = (point){ 0, -10 };
    return n;
}

static int make_spiral(point *p, int half)
{
    static const point step[4] = { {1,0}, {0,1}, {-1,0}, {0,-1} };
    for (int i = 0; i < half; i++) {            /* out along the inner side ... */
        const point *const d = &step[i % 4], *const e = &step[(i + 1) % 4];
        const int32_t r = 4 * (i + 4);
        p[i] = (point){ d->u * r - e->u * (r - 4), d->v * r - e->v * (r - 4) };
        p[2 * half - 1 - i] = (point){ p[i].u + d->u - e->u, p[i].v + d->v - e->v };
    }
    return 2 * half;
}

static void combs_and_spirals_are_cut(void **state)
{
    (void)state;
    point p[MOST];
    for (int teeth = 1; teeth <= 84; teeth += 9)
        assert_cut_everywhere(p, make_comb(p, teeth), true);
    for (int half = 3; half <= 128; half += 25)
        assert_cut_everywhere(p, make_spiral(p, half), true);
}

/* Sorted by angle around the origin, without floating point: directions on a square. */
static int make_star(point *p, int n, uint64_t *random, int32_t reach)
{
    for (int i = 0; i < n; i++) {
        const int32_t along = (int32_t)((int64_t)i * 8 * 4096 / n), side = along / 8192;
        const int32_t a = 4096 - along % 8192;
        const point d = side == 0 ? (point){ 4096, -a } : side == 1 ? (point){ a, 4096 }
                      : side == 2 ? (point){ -4096, a } : (point){ -a, -4096 };
        const int64_t r = 1 + next_random(random) % (uint32_t)reach;
        p[i] = (point){ (int32_t)(d.u * r), (int32_t)(d.v * r) };
    }
    return n;
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

/* May `x` stand between corners i and i + 1 without the outline touching itself? */
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

/* Grows a simple polygon on a grid so coarse that many corners lie on a line. */
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

/* Twists the outline of a random hole into a random simple polygon ten times as big. */
static void random_holes_are_cut(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    for (int i = 0; i < 300; i++) {
        point p[MOST], hole[MOST];
        const int n = make_simple(hole, 20, 12, &random);
        const int32_t far = 30 + (int32_t)(next_random(&random) % 30);
        const point box[] = { {-far, -9}, {40, -far}, {far, far}, {-8, 40} };
        int least = 0;
        for (int k = 1; k < n; k++)             /* nothing of the hole is left of it */
            if (hole[k].u < hole[least].u
                || (hole[k].u == hole[least].u && hole[k].v < hole[least].v))
                least = k;
        const int32_t sense = area_of(hole, n) > 0 ? n - 1 : 1;
        int m = 0;
        for (int k = 0; k <= 4; k++)
            p[m++] = box[k % 4];
        for (int k = 0; k <= n; k++)
            p[m++] = hole[(least + k * sense) % n];
        bool open = true;                       /* the bridge crosses nothing */
        for (int k = 0; k < n; k++) {
            const point c = hole[k], d = hole[(k + 1) % n];
            if (k != least && (k + 1) % n != least && touch(box[0], hole[least], c, d))
                open = false;
        }
        if (open)
            assert_cut(p, m, i % 6, false);
    }
}

/* Do the insides of two triangles, both turning left, have nothing in common?  Then an
 * edge of one of them has the other on its right. */
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

/* Grows a polygon by triangles that lie apart: it may touch itself, at corners and along
 * edges, but nowhere covers a point twice. */
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
        tp_obj_cut cut;
        memset(&cut, 0xA5, sizeof cut);
        for (int k = 0; k < 3 * n; k++)
            cut.at[k % 3][k / 3] = (int32_t)(next_random(&random) & mask & 0x7fffffffu)
                                 - 0x3fffffff;
        tp_obj_cut_polygon(&cut, (uint32_t)n);
        assert_edges(&cut, n);
    }
}

int main(void)
{
    static uint64_t seed;
    seed = random_seed();
    printf("TP_SEED=%llu\n", (unsigned long long)seed);
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
    return cmocka_run_group_tests_name("cut", tests, NULL, NULL);
}
