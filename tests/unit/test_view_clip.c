/* SPDX-License-Identifier: MIT */
/* Clipping: the clipped polygon lies inside, shows the same content, and matches its
 * neighbours. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/clip.h"
#include "tests/lib/measure.h"
#include "tests/lib/camera.h"

#define LSB (1 / 65536.0)

static uint64_t chance;

static tp_view_vertex any_corner(double far, double depth)
{
    tp_view_vertex c = {
        .x = chance_fx(&chance, -far, far), .y = chance_fx(&chance, -far, far),
        .depth = chance_fx(&chance, -depth, depth),
        .s = chance_fx(&chance, -8000, 8000), .t = chance_fx(&chance, -8000, 8000),
    };
    for (int i = 0; i < 3; i++)
        c.n[i] = (int16_t)chance_int(&chance, -32727, 32727);
    return c;
}

static ref_clip_corner ref_of(const tp_view_vertex *c)
{
    return (ref_clip_corner){ c->x * LSB, c->y * LSB, c->depth * LSB };
}

/* Width of the guard band: |x| <= band z is 8192 px in scaled coordinates. */
static double band_of(const test_view *v)
{
    return ldexp(1, TP_GUARD_LOG2 - v->projection.m);
}

static bool is_same(const tp_view_vertex *a, const tp_view_vertex *b)
{
    return a->x == b->x && a->y == b->y && a->depth == b->depth && a->s == b->s
        && a->t == b->t && a->n[0] == b->n[0] && a->n[1] == b->n[1] && a->n[2] == b->n[2];
}

/* -- the clipped polygon ------------------------------------------------------------- */

static void what_is_left_can_be_projected(void **state)
{
    (void)state;
    int counts[TP_CLIP_VERTICES + 1] = { 0 };
    static const double fars[] = { 1, 40, 3000, 32000 },
                        depths[] = { 1, 20, 2000, 32000 };

    for (int n = 0; n < 100000; n++) {
        const test_view v = view_any(&chance);
        const double far = fars[n % 4], depth = depths[n / 4 % 4];
        const tp_view_vertex in[3] = { any_corner(far, depth), any_corner(far, depth),
                                       any_corner(far, depth) };
        tp_view_vertex out[TP_CLIP_VERTICES];
        const int count = tp_clip_triangle(&v.projection, in, out);
        assert_in_range(count, 0, TP_CLIP_VERTICES);
        counts[count]++;
        for (int i = 0; i < count; i++) {
            tp_screen_vertex c;
            assert_true(tp_projection_can_project(&v.projection, &out[i]));
            tp_view_vertex_project(&v.projection, &out[i], &c);
            assert_true(abs(c.u - v.projection.u0) <= 8192 * 16);
            assert_true(abs(c.v - v.projection.v0) <= 8192 * 16);
            assert_true(c.zi < 0x80000000u);
        }
    }
    printf("    corners left:");
    for (int i = 0; i <= TP_CLIP_VERTICES; i++)
        printf(" %d:%d", i, counts[i]);
    printf("\n");
    assert_true(counts[0] && !counts[1] && !counts[2] && counts[3] && counts[4]
                && counts[5] && counts[6]);
}

/* On the screen twice the area of the polygon equals the reference's.  An error e of a
 * corner changes the area by e times the adjacent sides; e is about 1/16 px of rounding,
 * and near the near plane the size of 2^-16 m in pixels. */
static void what_is_left_shows_the_same_area(void **state)
{
    (void)state;
    measure area = { .what = "area", .unit = "px of side" };

    for (int n = 0; n < 40000; n++) {
        const test_view v = view_any(&chance);
        const double far = n % 2 ? 30 : 1000, m = ldexp(1, v.projection.m);
        const tp_view_vertex in[3] = { any_corner(far, far), any_corner(far, far),
                                       any_corner(far, far) };
        const ref_clip_corner corners[3] = { ref_of(&in[0]), ref_of(&in[1]),
                                             ref_of(&in[2]) };
        ref_clip_corner want[8];
        tp_view_vertex got[TP_CLIP_VERTICES];
        const int wanted = ref_clip(corners, want, v.ref.near, band_of(&v));
        const int count = tp_clip_triangle(&v.projection, in, got);
        double sum = 0, side = 0;
        tp_screen_vertex at[TP_CLIP_VERTICES];
        for (int i = 0; i < count; i++)
            tp_view_vertex_project(&v.projection, &got[i], &at[i]);
        for (int i = 0; i < count; i++) {
            const tp_screen_vertex a = at[i], b = at[(i + 1) % count];
            sum -= (double)(a.u - v.projection.u0) * (b.v - v.projection.v0)
                   - (double)(b.u - v.projection.u0) * (a.v - v.projection.v0);
            side += hypot(a.u - b.u, a.v - b.v) / 16;
        }
        const double off = fabs(sum / 256 - ref_clip_area(want, wanted) * m * m);
        /* Size in pixels of 4 LSB of each coordinate at the near plane, where the band is
         * 8192 px wide. */
        const double corner = 0.1 + 4 * LSB / v.ref.near * (m + 8192);
        assert_true(off <= 2 * corner * (side + 4 * corner) + 1);
        measure_add(&area, side > 0 ? off / side : 0, in[0].x, in[0].y, in[0].depth);
    }
    measure_print(&area);
}

/* A new corner lies on an edge of the triangle, and its s, t and normal are those of the
 * point on the edge. */
static void what_corners_carry_is_cut_where_they_are(void **state)
{
    (void)state;
    for (int n = 0; n < 40000; n++) {
        const test_view v = view_any(&chance);
        const tp_view_vertex a = any_corner(20, 20), b = any_corner(20, 20);
        const tp_view_vertex in[3] = { a, b, a };       /* an edge, there and back */
        tp_view_vertex out[TP_CLIP_VERTICES];
        const int count = tp_clip_triangle(&v.projection, in, out);
        const double way[3] = { (double)b.x - a.x, (double)b.y - a.y,
                                (double)b.depth - a.depth };
        const double length2 = way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
        for (int i = 0; i < count; i++) {
            const double share = (way[0] * ((double)out[i].x - a.x)
                                + way[1] * ((double)out[i].y - a.y)
                                + way[2] * ((double)out[i].depth - a.depth)) / length2;
            /* Each of five clips rounds its share to 2^-30 and each number to 1; a position
             * known to 5 LSB on an edge of `length` moves s by the same share of its own
             * difference. */
            const double slack = 8 / sqrt(length2);
            assert_true(share >= -slack && share <= 1 + slack);
            assert_true(fabs(out[i].x - (a.x + share * way[0])) <= 8);
            assert_true(fabs(out[i].y - (a.y + share * way[1])) <= 8);
            assert_true(fabs(out[i].s - (a.s + share * ((double)b.s - a.s)))
                        <= 8 + slack * fabs((double)b.s - a.s));
            assert_true(fabs(out[i].t - (a.t + share * ((double)b.t - a.t)))
                        <= 8 + slack * fabs((double)b.t - a.t));
            for (int k = 0; k < 3; k++)
                assert_true(fabs(out[i].n[k] - (a.n[k] + share * (b.n[k] - a.n[k])))
                            <= 8 + slack * abs(b.n[k] - a.n[k]));
        }
    }
}

/* -- neighbours ---------------------------------------------------------------------- */

static bool has(const tp_view_vertex *corners, int count, const tp_view_vertex *c)
{
    for (int i = 0; i < count; i++) {
        if (is_same(&corners[i], c))
            return true;
    }
    return false;
}

/* Distance of (x, y, depth) from the line a-b, LSB. */
static double off_line(const tp_view_vertex *c, const tp_view_vertex *a,
                       const tp_view_vertex *b)
{
    const double w[3] = { (double)b->x - a->x, (double)b->y - a->y,
                          (double)b->depth - a->depth };
    const double d[3] = { (double)c->x - a->x, (double)c->y - a->y,
                          (double)c->depth - a->depth };
    const double k = (w[0] * d[0] + w[1] * d[1] + w[2] * d[2])
                   / (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    return sqrt(pow(d[0] - k * w[0], 2) + pow(d[1] - k * w[1], 2)
                + pow(d[2] - k * w[2], 2));
}

/* True where two of the five planes meet, far outside every picture: there a clip by the
 * second plane depends by one LSB on the rounding of the first. */
static bool is_at_two_planes(const test_view *v, const tp_view_vertex *c)
{
    const double band = band_of(v), near = 64;
    const bool x = fabs(abs(c->x) - band * c->depth) < near * (1 + band);
    const bool y = fabs(abs(c->y) - band * c->depth) < near * (1 + band);
    return (abs(c->depth - v->projection.near) < near) + x + y >= 2;
}

/* Two triangles on either side of an edge: every corner that one triangle's clip puts on
 * the edge is equal, bit for bit, in the other. */
static void neighbours_are_cut_to_the_same_corners(void **state)
{
    (void)state;
    int cuts = 0;

    for (int n = 0; n < 40000; n++) {
        const test_view v = view_any(&chance);
        const double far = n % 2 ? 20 : 2000;
        const tp_view_vertex a = any_corner(far, far), b = any_corner(far, far);
        const tp_view_vertex left[3] = { a, b, any_corner(far, far) };
        const tp_view_vertex right[3] = { any_corner(far, far), b, a };
        tp_view_vertex one[TP_CLIP_VERTICES], two[TP_CLIP_VERTICES];
        const int ones = tp_clip_triangle(&v.projection, left, one);
        const int twos = tp_clip_triangle(&v.projection, right, two);
        if (ones == 0 || twos == 0)
            continue;
        for (int i = 0; i < ones; i++) {
            if (off_line(&one[i], &a, &b) > 4 || off_line(&one[i], &b, &left[2]) <= 8
                || off_line(&one[i], &left[2], &a) <= 8
                || is_at_two_planes(&v, &one[i]))
                continue;       /* not of the edge, or also of another edge */
            cuts += !is_same(&one[i], &a) && !is_same(&one[i], &b);
            assert_true(has(two, twos, &one[i]));
        }
    }
    printf("    %d cuts shared\n", cuts);
    assert_true(cuts > 1000);
}

/* -- wholly inside or outside -------------------------------------------------------- */

static void what_lies_inside_stays_as_it_is(void **state)
{
    (void)state;
    int tried = 0;

    for (int n = 0; n < 40000; n++) {
        const test_view v = view_any(&chance);
        tp_view_vertex in[3], out[TP_CLIP_VERTICES];
        bool inside = true;
        for (int i = 0; i < 3; i++) {
            in[i] = any_corner(30, 100);
            const double most = band_of(&v) * ((double)in[i].depth - 5) - 5;
            inside = inside && in[i].depth >= v.projection.near && abs(in[i].x) <= most
                     && abs(in[i].y) <= most;
        }
        if (!inside)
            continue;
        tried++;
        assert_int_equal(tp_clip_triangle(&v.projection, in, out), 3);
        for (int i = 0; i < 3; i++)
            assert_true(is_same(&in[i], &out[i]));
    }
    assert_true(tried > 1000);
}

static void what_lies_outside_is_gone(void **state)
{
    (void)state;
    for (int n = 0; n < 20000; n++) {
        const test_view v = view_any(&chance);
        tp_view_vertex in[3], out[TP_CLIP_VERTICES];
        for (int i = 0; i < 3; i++) {
            in[i] = any_corner(1000, 100);
            const double band = band_of(&v) * fmax(1, (double)in[i].depth) + 8;
            switch (n % 5) {    /* all beyond the same plane */
            case 0: in[i].depth = v.projection.near - 1 - abs(in[i].depth); break;
            case 1: in[i].x = (int32_t)fmin(2e9, band); break;
            case 2: in[i].x = (int32_t)fmax(-2e9, -band); break;
            case 3: in[i].y = (int32_t)fmin(2e9, band); break;
            case 4: in[i].y = (int32_t)fmax(-2e9, -band); break;
            }
            if (n % 5 && band > 2e9)
                in[i].depth = -1;
        }
        assert_int_equal(tp_clip_triangle(&v.projection, in, out), 0);
    }
}

/* Corners as far away as tp_projection_view_vertex allows, with any s and t. */
static void the_ends_of_the_numbers_are_safe(void **state)
{
    (void)state;
    static const int32_t most = 32000 * TP_FX_ONE;
    static const int32_t ends[] = { -most, 1 - most, -65536,   -1,  0,
                                    1,     3277,     most - 1, most };

    for (int n = 0; n < 40000; n++) {
        const test_view v = view_any(&chance);
        tp_view_vertex in[3], out[TP_CLIP_VERTICES];
        for (int i = 0; i < 3; i++) {
            in[i] = any_corner(1000, 1000);
            int32_t *const number[] = { &in[i].x, &in[i].y, &in[i].depth };
            for (int k = 0; k < 3; k++) {
                if (random_below(&chance, 2))
                    *number[k] = ends[random_below(&chance, 9)];
            }
            in[i].s = random_below(&chance, 2) ? INT32_MIN : INT32_MAX;
            in[i].t = (int32_t)(uint32_t)random_next(&chance);
        }
        const int count = tp_clip_triangle(&v.projection, in, out);
        for (int i = 0; i < count; i++) {
            tp_screen_vertex c;
            assert_true(tp_projection_can_project(&v.projection, &out[i]));
            tp_view_vertex_project(&v.projection, &out[i], &c);
        }
    }
}

/* -- a plane given by the caller ------------------------------------------------------- */

/* Height of a view corner above the level, m. */
static double height_of(const test_view *v, const tp_view_vertex *c, double level)
{
    const double k = ldexp(1, v->projection.m) / v->ref.focal;
    return v->ref.eye.y - level + (c->x * LSB * v->ref.right.y + c->y * LSB * v->ref.up.y)
                                * k + c->depth * LSB * v->ref.ahead.y;
}

static void a_level_cuts_off_what_lies_beyond_it(void **state)
{
    (void)state;
    measure height = { .what = "height", .unit = "m" };
    int cut = 0;

    for (int n = 0; n < 40000; n++) {
        const test_view v = view_any(&chance);
        const double level = v.ref.eye.y + chance_double(&chance, -10, 10);
        const int side = n % 2 ? 1 : -1;
        const tp_view_plane plane =
            tp_projection_level_plane(&v.projection, TP_FX(level), side);
        const tp_view_vertex in[3] = { any_corner(30, 30), any_corner(30, 30),
                                       any_corner(30, 30) };
        tp_view_vertex out[TP_CLIP_VERTICES];
        const int count = tp_clip_triangle_view_and_plane(&v.projection, &plane, in, out);
        assert_in_range(count, 0, TP_CLIP_VERTICES);
        for (int i = 0; i < 3; i++)
            measure_add(&height, ldexp((double)tp_view_plane_distance(&plane, &in[i]), -32)
                                 - side * height_of(&v, &in[i], level), n, i, 0);
        for (int i = 0; i < count; i++) {
            assert_true(tp_projection_can_project(&v.projection, &out[i]));
            assert_true(side * height_of(&v, &out[i], level) >= -0.0005);
        }
        cut += count > 3;
    }
    measure_print(&height);
    assert_true(height.worst <= 0.0005 && cut > 5000);
}

/* Two triangles with a common edge get the same corner on the edge, for either direction of
 * the edge. */
static void a_level_cuts_an_edge_once(void **state)
{
    (void)state;
    int shared = 0;

    for (int n = 0; n < 20000; n++) {
        const test_view v = view_any(&chance);
        const tp_view_plane plane = tp_projection_level_plane(
            &v.projection, v.projection.eye.y + chance_fx(&chance, -5, 5), 1);
        tp_view_vertex a = any_corner(3, 30), b = any_corner(3, 30);
        a.depth = b.depth = 20 * TP_FX_ONE;
        const tp_view_vertex one[3] = { a, b, any_corner(3, 30) };
        const tp_view_vertex two[3] = { b, a, any_corner(3, 30) };
        if ((tp_view_plane_distance(&plane, &a) >= 0)
            == (tp_view_plane_distance(&plane, &b) >= 0))
            continue;
        tp_view_vertex p[TP_CLIP_VERTICES], q[TP_CLIP_VERTICES];
        const int np = tp_clip_triangle_view_and_plane(&v.projection, &plane, one, p);
        const int nq = tp_clip_triangle_view_and_plane(&v.projection, &plane, two, q);
        int same = 0;
        for (int i = 0; i < np; i++)
            for (int k = 0; k < nq; k++)
                same += is_same(&p[i], &q[k]);
        assert_true(same >= 2 || !tp_projection_can_project(&v.projection, &a)
                    || !tp_projection_can_project(&v.projection, &b));
        shared += same >= 2;
    }
    printf("    %d edges shared\n", shared);
    assert_true(shared > 500);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_left_can_be_projected),
        cmocka_unit_test(what_is_left_shows_the_same_area),
        cmocka_unit_test(what_corners_carry_is_cut_where_they_are),
        cmocka_unit_test(neighbours_are_cut_to_the_same_corners),
        cmocka_unit_test(what_lies_inside_stays_as_it_is),
        cmocka_unit_test(what_lies_outside_is_gone),
        cmocka_unit_test(the_ends_of_the_numbers_are_safe),
        cmocka_unit_test(a_level_cuts_off_what_lies_beyond_it),
        cmocka_unit_test(a_level_cuts_an_edge_once),
    };
    return cmocka_run_group_tests_name("view/clip", tests, NULL, NULL);
}
