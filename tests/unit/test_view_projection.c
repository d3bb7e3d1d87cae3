/* SPDX-License-Identifier: MIT */
/* The projection compared with a pinhole camera in double precision: screen positions
 * of points, the points that tp_projection_can_project() accepts, and the planes of the
 * frustum. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/measure.h"
#include "tests/lib/camera.h"

#define LSB (1 / 65536.0)

static uint64_t chance;

static void the_lens_is_the_pinhole_asked_for(void **state)
{
    (void)state;
    measure focal = { .what = "focal length", .unit = "of itself" };

    for (int n = 0; n < 20000; n++) {
        const test_view v = view_any(&chance);
        const double error = v.projection.focal * LSB / v.ref.focal - 1;
        /* Sine and cosine have 28 bits and the angle 2^-31 turn, for a sine of 0.17. */
        assert_true(fabs(error) <= 1e-7 + LSB / v.ref.focal);
        measure_add(&focal, error, n, v.width, v.height);
        assert_int_equal(v.projection.u0, v.width * 8);
        assert_int_equal(v.projection.v0, v.height * 8);
        assert_true(v.projection.m == TP_GUARD_LOG2
                    || v.projection.focal <= TP_FX_ONE << v.projection.m);
    }
    measure_print(&focal);
}

/* Bound of the error of a projected point, in 1/16 px.  A scaled coordinate is within 1/2
 * of 2^-16 m and its axis within 2^-30 (direction and scale: 7e-9), so the error of x/depth
 * in pixels is 2^m times that over the depth; the depth likewise.  The reciprocal adds
 * 2^-29, the focal length its error as above. */
static double place_error(const test_view *v, ref_vec at, double way)
{
    const double scale = ldexp(1, v->projection.m), far = hypot(at.x, at.y) / at.z;
    const double axis = 1.5e-8 * way, coordinate = LSB / 2 + axis;
    return 0.5 + 16 * scale * coordinate / at.z
         + 16 * v->ref.focal * far * coordinate / at.z
         + 16 * far * (v->ref.focal * (1e-7 + 4e-9) + LSB);
}

static void points_come_out_where_the_pinhole_has_them(void **state)
{
    (void)state;
    measure place[3] = { { .what = "at 1-100 m", .unit = "of 1/16 px" },
                         { .what = "at 100-20000 m", .unit = "of 1/16 px" },
                         { .what = "at near-1 m", .unit = "of 1/16 px" } };
    measure depth = { .what = "depth", .unit = "of 2^31" };
    static const double low[] = { 1, 100, 0.05 }, high[] = { 100, 20000, 1 };

    for (int n = 0; n < 60000; n++) {
        const test_view v = view_any(&chance);
        const double d = chance_double(&chance, low[n % 3], high[n % 3]);
        tp_vec3 p = { 0, 0, 0 };
        if (!view_point(&v, chance_double(&chance, -2000, 6000),
                        chance_double(&chance, -2000, 6000), d, &p))
            continue;
        const ref_vec at = ref_view(&v.ref, ref_vec_make(p));
        tp_view_vertex c;
        tp_projection_view_vertex(&v.projection, p, &c);
        /* Coordinates are scaled by at most 1.42 and clamped beyond 32000 m. */
        if (!tp_projection_can_project(&v.projection, &c) || hypot(at.x, at.y) > 22000)
            continue;
        int32_t u, w;
        uint32_t zi;
        tp_projection_project(&v.projection, &c, &u, &w, &zi);
        const double off = fmax(fabs(u - 16 * ref_u(&v.ref, at)),
                                fabs(w - 16 * ref_v(&v.ref, at)));
        const ref_vec way = ref_sub(ref_vec_make(p), v.ref.eye);
        const double most = place_error(&v, at, sqrt(ref_dot(way, way)));
        assert_true(off <= most);
        measure_add(&place[n % 3], off, p.x, p.y, p.z);
        /* zi is truncated; its inputs are a rounded depth and 255/256 of near, rounded
         * up. */
        const double want = v.projection.zi_near * LSB / at.z;
        const double error =
            ldexp(1, -31)
            + want * (LSB / 2 / at.z + 4e-9 + 1.5e-8 * sqrt(ref_dot(way, way)) / at.z);
        assert_true(fabs(zi / 2147483648.0 - want) <= error);
        assert_true(zi < 0x80000000u);
        measure_add(&depth, (zi / 2147483648.0 - want) * 2147483648.0, p.x, p.y, p.z);
    }
    for (int i = 0; i < 3; i++)
        measure_print(&place[i]);
    measure_print(&depth);
}

/* Scenes show objects from 1 m to 100 m: there 28.4 limits the precision. */
static void a_usual_view_is_right_to_a_sixteenth_of_a_pixel(void **state)
{
    (void)state;
    measure place = { .what = "640x480, 1-100 m", .unit = "of 1/16 px" };

    for (int n = 0; n < 20000; n++) {
        const tp_vec3 eye = { chance_fx(&chance, -500, 500), chance_fx(&chance, 1, 20),
                              chance_fx(&chance, -500, 500) };
        const test_view v = view_of(eye, (tp_turn)random_next(&chance),
                                    tp_turn_of_degrees(chance_fx(&chance, -45, 20)),
                                    60 * TP_FX_ONE, TP_FX(0.25), 640, 480);
        tp_vec3 p = { 0, 0, 0 };
        assert_true(view_point(&v, chance_double(&chance, 0, 640),
                               chance_double(&chance, 0, 480),
                               chance_double(&chance, 1, 100), &p));
        const ref_vec at = ref_view(&v.ref, ref_vec_make(p));
        tp_view_vertex c;
        tp_projection_view_vertex(&v.projection, p, &c);
        assert_true(tp_projection_can_project(&v.projection, &c));
        int32_t u, w;
        uint32_t zi;
        tp_projection_project(&v.projection, &c, &u, &w, &zi);
        measure_add(&place, fmax(fabs(u - 16 * ref_u(&v.ref, at)),
                                 fabs(w - 16 * ref_v(&v.ref, at))), p.x, p.y, p.z);
    }
    measure_print(&place);
    assert_true(place.worst < 1);
}

static void ahead_is_up_the_screen_and_right_is_right(void **state)
{
    (void)state;
    const test_view v = view_of((tp_vec3){ 0, 4 * TP_FX_ONE, 0 }, 0, 0, 60 * TP_FX_ONE,
                                TP_FX(0.25), 320, 240);
    tp_view_vertex near, far, right, up;

    tp_projection_view_vertex(&v.projection, (tp_vec3){ 0, 0, -10 * TP_FX_ONE }, &near);
    tp_projection_view_vertex(&v.projection, (tp_vec3){ 0, 0, -20 * TP_FX_ONE }, &far);
    tp_projection_view_vertex(&v.projection, (tp_vec3){ TP_FX_ONE, 0, -10 * TP_FX_ONE },
                              &right);
    tp_projection_view_vertex(&v.projection, (tp_vec3){ 0, TP_FX_ONE, -10 * TP_FX_ONE },
                              &up);
    assert_int_equal(near.depth, 10 * TP_FX_ONE);
    tp_screen_vertex a, b, c, d;
    tp_view_vertex_project(&v.projection, &near, &a);
    tp_view_vertex_project(&v.projection, &far, &b);
    tp_view_vertex_project(&v.projection, &right, &c);
    tp_view_vertex_project(&v.projection, &up, &d);
    assert_int_equal(a.u, 160 * 16);
    assert_true(b.v < a.v && b.zi < a.zi && d.v < a.v);
    assert_true(c.u > a.u && c.v == a.v);
    /* Seen from above, counter-clockwise: near, right, far.  The area on the screen is <
     * 0. */
    assert_true((int64_t)(c.u - a.u) * (b.v - a.v) - (int64_t)(b.u - a.u) * (c.v - a.v)
                < 0);
}

/* Corners of any object in a scene, in the camera's frame: a point that
 * tp_projection_can_project() accepts is in front of the near plane and inside the guard
 * band. */
static void what_is_held_is_in_front_however_far(void **state)
{
    (void)state;
    static const tp_fx ends[] = {
        TP_FX(-16302), TP_FX(16302), TP_FX(-8000), TP_FX(8000), 0,
        TP_FX(-24302), TP_FX(24302)
    };
    int held = 0, behind = 0;

    for (int n = 0; n < 60000; n++) {
        const test_view v = view_any(&chance);
        const tp_vec3 p = { ends[random_below(&chance, 7)], chance_fx(&chance, -256, 256),
                            ends[random_below(&chance, 7)] };
        if (fabs(p.x * LSB - v.ref.eye.x) > 32700
            || fabs(p.z * LSB - v.ref.eye.z) > 32700)
            continue;
        const ref_vec at = ref_view(&v.ref, ref_vec_make(p));
        tp_view_vertex c;
        tp_projection_view_vertex(&v.projection, p, &c);
        /* Signs are kept even for numbers that are clamped at 32000 m. */
        if (fabs(at.x) > 1)
            assert_int_equal(c.x < 0, at.x < 0);
        if (fabs(at.z) > 1)
            assert_int_equal(c.depth < 0, at.z < 0);
        behind += at.z < 0;
        if (!tp_projection_can_project(&v.projection, &c))
            continue;
        int32_t u, w;
        uint32_t zi;
        tp_projection_project(&v.projection, &c, &u, &w, &zi);
        held++;
        assert_true(at.z >= v.ref.near - 0.01);
        assert_true(abs(u - v.projection.u0) <= 8192 * 16
                    && abs(w - v.projection.v0) <= 8192 * 16);
    }
    printf("    %d held, %d behind\n", held, behind);
    assert_true(held > 0 && behind > 0);
}

/* -- frustum planes ------------------------------------------------------------------ */

static double inside_plane(const tp_plane *plane, tp_vec3 p)
{
    const double q30 = 1073741824.0;
    return (plane->n.x / q30 * p.x + plane->n.y / q30 * p.y + plane->n.z / q30 * p.z
            + plane->d) * LSB;
}

/* Normals have 27 bits, so a plane errs by 2e-4 m at 24 km. */
static void planes_hold_all_that_the_picture_shows_and_little_more(void **state)
{
    (void)state;
    int seen = 0, kept_outside = 0, outside = 0;

    for (int n = 0; n < 40000; n++) {
        const test_view v = view_any(&chance);
        const double over = 0.2;
        const double u = chance_double(&chance, -over, 1 + over) * v.width;
        const double w = chance_double(&chance, -over, 1 + over) * v.height;
        const double d = v.ref.near * chance_double(&chance, 0.5, 1)
                       + chance_scale(&chance, 0.01, 20000) * LSB * (n % 3 > 0);
        tp_plane planes[TP_PROJECTION_PLANES];
        tp_vec3 p = { 0, 0, 0 };
        if (!view_point(&v, u, w, d, &p))
            continue;
        tp_projection_planes(&v.projection, v.width, v.height, planes);
        const bool in = u >= 0 && u <= v.width && w >= 0 && w <= v.height
                     && d > v.ref.near + 2 * LSB;
        /* Outside the margin of a pixel by one more pixel. */
        const bool out = u < -2.5 || u > v.width + 2.5 || w < -2.5 || w > v.height + 2.5
                      || d < v.ref.near - 0.01;
        bool holds = true;
        for (int i = 0; i < TP_PROJECTION_PLANES; i++)
            holds = holds && inside_plane(&planes[i], p) >= 0;
        if (in) {
            assert_true(holds);
            seen++;
        }
        outside += out;
        /* Skips points where a pixel is smaller than the errors of 16.16 and of the
         * normals. */
        const bool fine = d / v.ref.focal > 0.001;
        kept_outside += out && holds && fine;
    }
    printf("    %d points seen, %d outside\n", seen, outside);
    assert_true(seen > 1000 && outside > 1000);
    assert_int_equal(kept_outside, 0);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_lens_is_the_pinhole_asked_for),
        cmocka_unit_test(points_come_out_where_the_pinhole_has_them),
        cmocka_unit_test(a_usual_view_is_right_to_a_sixteenth_of_a_pixel),
        cmocka_unit_test(ahead_is_up_the_screen_and_right_is_right),
        cmocka_unit_test(what_is_held_is_in_front_however_far),
        cmocka_unit_test(planes_hold_all_that_the_picture_shows_and_little_more),
    };
    return cmocka_run_group_tests_name("view/projection", tests, NULL, NULL);
}
