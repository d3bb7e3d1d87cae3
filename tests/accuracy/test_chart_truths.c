/* SPDX-License-Identifier: MIT */
/* Checks of the references that the charts compare with: the deep water in double precision
 * against the tables of tests/vectors, texture places of triangles against the ray of each
 * pixel, and the steps that the chart "span" compares. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/charts/span.h"
#include "tests/charts/span_true.h"
#include "tools/reference/deep_water.h"
#include "tests/lib/random.h"
#include "tests/lib/vectors.h"

/* -- deep water ---------------------------------------------------------------------- */

static ref_deep_water sea_of(const vector_table *r, double phase[TP_WAVES])
{
    ref_deep_water sea = { .count = r->waves };

    for (int i = 0; i < r->waves; i++) {
        const row_wave *w = &r->wave[i];
        sea.wave[i] = (ref_wave){ .amplitude = w->amplitude, .k = w->k,
                                  .q = w->q * w->k * w->amplitude, .dx = w->dx,
                                  .dz = w->dz, .power = 1 };
        phase[i] = w->phase - w->omega * r->at[2];
    }
    return sea;
}

static void the_sea_has_the_points_of_the_vectors(void **state)
{
    vector_table r = rows_of("gerstner_sum");
    measure place = { .what = "places", .unit = "m" };
    measure normal = { .what = "normals", .unit = "" };

    (void)state;
    while (rows_next(&r)) {
        double phase[TP_WAVES];
        const ref_deep_water   sea = sea_of(&r, phase);
        const ref_point p = ref_at_rest(&sea, phase, r.at[0], r.at[1]);
        const double n = sqrt(p.nx * p.nx + p.ny * p.ny + p.nz * p.nz);
        const double of[6] = { p.x, p.y, p.z, p.nx / n, p.ny / n, p.nz / n };
        for (int i = 0; i < 6; i++)
            measure_add(i < 3 ? &place : &normal, of[i] - r.at[3 + i], r.rows, i, 0);
    }
    measure_print(&place);
    measure_print(&normal);
    assert_true(r.rows > 20);
    assert_true(place.worst < 1e-9);
    assert_true(normal.worst < 1e-9);
}

/* -- triangles ----------------------------------------------------------------------- */

enum { WIDTH = 160, HEIGHT = 120, TRIANGLES = 300 };

static uint64_t   chance;
static uint32_t   plane[2][4][HEIGHT * WIDTH];
static tp_screen_vertex  corner[3];

static tp_gbuffer tile_of(int i)
{
    return (tp_gbuffer){
        .x1 = WIDTH, .y1 = HEIGHT, .stride = WIDTH, .key = plane[i][0], .s = plane[i][1],
        .t = plane[i][2], .n = plane[i][3], .draw_wide = tp_tri_solid_wide,
    };
}

/* Random large triangle, up to four times as deep at one vertex as at another: the
 * perspective is never affine. */
static void any_triangle(void)
{
    for (int i = 0; i < 3; i++) {
        const double turn = (i + chance_double(&chance, 0, 0.6)) * 2 * PI / 3;
        corner[i] = (tp_screen_vertex){
            .u = (int32_t)(16 * (WIDTH / 2 + 70 * cos(turn))),
            .v = (int32_t)(16 * (HEIGHT / 2 + 55 * sin(turn))),
            .zi = (uint32_t)((double)(1u << 28) * (i ? chance_double(&chance, 1.5, 4) : 1)),
            .s = chance_fx(&chance, -100, 100), .t = chance_fx(&chance, -100, 100),
        };
    }
}

static void draw(int i, int32_t step)
{
    const tp_gbuffer tile = tile_of(i);

    tp_gbuffer_clear(&tile);
    span_step = step;
    tp_tri_water(&tile, &corner[0], &corner[1], &corner[2]);
}

static double determinant(const double a[3], const double b[3], const double c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1])
         + c[0] * (a[1] * b[2] - a[2] * b[1]);
}

/* Texture coordinate s (or t) in 16.16, unrounded, at the point where the ray of a pixel
 * meets the plane of the triangle in space; by Cramer's rule. */
static double place_on_ray(int x, int y, bool t)
{
    const double ray[3] = { 16 * x + 8, 16 * y + 8, 1 };
    double at[3][3], sum = 0, place = 0;

    for (int i = 0; i < 3; i++) {
        const double depth = 1e9 / corner[i].zi;
        at[i][0] = corner[i].u * depth;
        at[i][1] = corner[i].v * depth;
        at[i][2] = depth;
    }
    for (int i = 0; i < 3; i++) {
        const double share = determinant(i == 0 ? ray : at[0], i == 1 ? ray : at[1],
                                         i == 2 ? ray : at[2]);
        sum += share;
        place += share * (t ? corner[i].t : corner[i].s);
    }
    return place / sum;
}

static void places_in_double_lie_on_the_pixels_rays(void **state)
{
    measure off = { .what = "places", .unit = "LSB" };

    (void)state;
    for (int n = 0; n < TRIANGLES; n++) {
        any_triangle();
        draw(0, SPAN_TRUE);
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            for (int t = 0; t < 2 && plane[0][0][i]; t++)
                measure_add(&off, (int32_t)plane[0][1 + t][i]
                            - place_on_ray(i % WIDTH, i / WIDTH, t), n, i, t);
    }
    measure_print(&off);
    assert_true(off.inputs > 100000);
    assert_true(off.worst < 0.51);
}

/* The depths are equal to the reference's depths: only the texture coordinates differ, and
 * only between the multiples of the step. */
static void steps_are_true_at_their_multiples(void **state)
{
    static const int32_t steps[] = { 1, 8, 16, 32 };

    (void)state;
    for (size_t k = 0; k < sizeof steps / sizeof *steps; k++) {
        measure at = { .what = "at multiples", .unit = "m" };
        measure between = { .what = "between", .unit = "m" };
        for (int n = 0; n < TRIANGLES; n++) {
            any_triangle();
            draw(0, SPAN_TRUE);
            draw(1, steps[k]);
            for (int i = 0; i < WIDTH * HEIGHT; i++) {
                assert_int_equal(plane[0][0][i], plane[1][0][i]);
                if (plane[0][0][i])
                    measure_add(i % WIDTH % steps[k] ? &between : &at,
                                (int32_t)(plane[1][1][i] - plane[0][1][i]) / 65536.0, n, i,
                                steps[k]);
            }
        }
        measure_print(&at);
        measure_print(&between);
        assert_true(at.worst < 0.001);
        assert_true(steps[k] == 1 || between.worst > 10 * at.worst);
    }
}

/* Along a row the difference between neighbouring pixels is constant. */
static void affine_places_lie_on_a_plane(void **state)
{
    (void)state;
    for (int n = 0; n < TRIANGLES; n++) {
        any_triangle();
        draw(0, 0);
        for (int i = 2; i < WIDTH * HEIGHT; i++) {
            const uint32_t *key = plane[0][0] + i, *s = plane[0][1] + i;
            if (i % WIDTH >= 2 && key[0] && key[-1] && key[-2])
                assert_int_equal(s[0] - s[-1], s[-1] - s[-2]);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_sea_has_the_points_of_the_vectors),
        cmocka_unit_test(places_in_double_lie_on_the_pixels_rays),
        cmocka_unit_test(steps_are_true_at_their_multiples),
        cmocka_unit_test(affine_places_lie_on_a_plane),
    };

    chance = random_seed();
    return cmocka_run_group_tests_name("chart truths", tests, NULL, NULL);
}
