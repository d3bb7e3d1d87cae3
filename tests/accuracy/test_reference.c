/* SPDX-License-Identifier: MIT */
/* Checks the reference's intersection of rays and water against closed forms and brute
 * force. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/reference_scenes.h"
#include "tests/lib/measure.h"

static ref_ray ray_down(uint64_t *state, ref_vec from, double steepest)
{
    const double round = chance_double(state, 0, 2 * PI);
    const double down = exp(chance_double(state, log(0.02), log(steepest)));
    return (ref_ray){ from, ref_unit_vec((ref_vec){ cos(round), -down, sin(round) }) };
}

static void level_water_is_met_where_the_plane_is(void **state)
{
    uint64_t seed = random_seed();
    measure off = { .what = "level water", .unit = "m" };
    view_of_ref v = { .scene = scene_level() };

    (void)state;
    view_open(&v, 64, 48);
    for (int i = 0; i < 10000; i++) {
        const ref_ray ray = ray_down(&seed, (ref_vec){ 3, chance_double(&seed, 0.1, 40),
                                                       -5 }, 30);
        ref_meeting m;
        assert_true(ref_ray_meets(&v.ref.surface, &ray, 0, 1e5, false, &m));
        const double t = -ray.from.y / ray.way.y;
        measure_add(&off, hypot(m.t - t, hypot(m.water.slope_x, m.water.slope_z)), i, 0,
                    0);
    }
    view_close(&v);
    measure_print(&off);
    assert_true(off.worst < 1e-9);
}

/* -- one Gerstner wave along x ------------------------------------------------------- */

typedef struct {
    double a, q, k, phase;
} trochoid;

static double along(const trochoid *w, double x0)
{
    return x0 + w->q / w->k * cos(w->k * x0 + w->phase);
}

/* x of the first intersection of a ray in the x-y plane with a million chords of the wave,
 * from above. */
static double chord_met(const trochoid *w, const ref_ray *ray, double x_end)
{
    const int    count = 1000000;
    const double from = ray->from.x - 2 * w->q / w->k, step = (x_end - from) / count;
    const double fall = ray->way.y / ray->way.x;
    double last_x = along(w, from), last_f = 1;

    for (int i = 1; i <= count; i++) {
        const double x0 = from + i * step, x = along(w, x0);
        const double f = ray->from.y + fall * (x - ray->from.x)
                       - w->a * sin(w->k * x0 + w->phase);
        if (x > ray->from.x && last_x > ray->from.x && last_f > 0 && f <= 0)
            return last_x + (x - last_x) * last_f / (last_f - f);
        last_x = x;
        last_f = f;
    }
    return HUGE_VAL;
}

static void a_wave_is_met_where_brute_force_finds_it(void **state)
{
    uint64_t seed = random_seed();
    measure off = { .what = "one Gerstner wave", .unit = "m" };
    view_of_ref v = { .scene = scene_level() };

    (void)state;
    v.scene.wave[0] = (tp_wave){ .amplitude = TP_FX(0.8), .length = 11 * TP_FX_ONE,
                                 .steepness = TP_FX(0.42), .heading = 90 * TP_FX_ONE,
                                 .phase = 30 * TP_FX_ONE, .speed = TP_FX_ONE,
                                 .exponent = 1 };
    view_open(&v, 64, 48);
    const trochoid w = { ref_number(TP_FX(0.8)), ref_number(TP_FX(0.42)), 2 * PI / 11,
                         PI / 6 };
    for (int i = 0; i < 40; i++) {
        const double down = exp(chance_double(&seed, log(0.05), log(3)));
        const ref_ray ray = { { chance_double(&seed, -20, 20), 3, 1.5 },
                              ref_unit_vec((ref_vec){ 1, -down, 0 }) };
        ref_meeting m;
        assert_true(ref_ray_meets(&v.ref.surface, &ray, 0, 1e5, false, &m));
        measure_add(&off, m.water.at.x - chord_met(&w, &ray, ray.from.x + 4.2 / down
                                                    + 2 * w.q / w.k), i, 0, 0);
    }
    view_close(&v);
    measure_print(&off);
    assert_true(off.worst < 1e-9 / 0.05);   /* the chords are at most 0.1 mm long */
}

/* -- crossing swells ----------------------------------------------------------------- */

static tp_scene scene_crossing(void)
{
    tp_scene s = scene_plain();

    s.sky.haze = 0;
    s.boat.mesh[0] = 0;
    for (int i = 0; i < 3; i++)
        s.wave[i].steepness = TP_FX(0.25);
    s.wave[1].exponent = 3;
    return s;
}

/* The crossing swells over a beach and in wind. */
static tp_scene scene_beach(void)
{
    tp_scene s = scene_crossing();

    s.wave[1].exponent = 1;
    s.wind.strength = TP_FX(0.2);
    s.wind.heading = 20 * TP_FX_ONE;
    s.floor.depth = 6 * TP_FX_ONE;
    s.floor.slope = TP_FX(0.02);
    s.floor.heading = 50 * TP_FX_ONE;
    return s;
}

static ref_point point_at_rest(const ref_surface *s, double x0, double z0)
{
    return s->coastal ? ref_coastal_rest(s->coastal, s->phase, x0, z0)
                      : ref_at_rest(&s->sea, s->phase, x0, z0);
}

/* dy/dx from the heights 0.1 mm to each side. */
static double slope_by_steps(const ref_surface *s, ref_vec at, double x0, double z0)
{
    double rest[2] = { x0, z0 }, h[2];

    for (int k = 0; k < 2; k++)
        h[k] = ref_surface_height(s, at.x + (k ? 1e-4 : -1e-4), at.z, rest, 1e-13);
    return (h[1] - h[0]) / 2e-4;
}

/* Computes the surface point again from the rest point that the root finder returns. */
static void measure_roots(const tp_scene *scene)
{
    uint64_t seed = random_seed();
    measure off = { .what = "roots", .unit = "m" };
    measure slope = { .what = "slopes", .unit = "" };
    view_of_ref v = { .scene = *scene };

    view_open(&v, 64, 48);
    for (int i = 0; i < 2000; i++) {
        const ref_ray ray = ray_down(&seed, (ref_vec){ 1, 5, 2 }, 10);
        ref_meeting m;
        if (!ref_ray_meets(&v.ref.surface, &ray, 0, 1e5, false, &m))
            continue;
        const ref_vec at = ref_ray_point(&ray, m.t);
        const ref_point p = point_at_rest(&v.ref.surface, m.water.x0, m.water.z0);
        measure_add(&off, hypot(at.y - p.y, hypot(at.x - p.x, at.z - p.z)), i, 0, 0);
        measure_add(&slope, slope_by_steps(&v.ref.surface, at, m.water.x0, m.water.z0)
                            - m.water.slope_x, i, 0, 0);
    }
    view_close(&v);
    measure_print(&off);
    measure_print(&slope);
    assert_true(off.inputs > 1000);
    assert_true(off.worst < 1e-9);
    assert_true(slope.worst < 1e-6);
}

static void roots_are_closer_than_a_nanometre(void **state)
{
    const tp_scene crossing = scene_crossing(), beach = scene_beach();

    (void)state;
    measure_roots(&crossing);
    measure_roots(&beach);
}

/* No water stands between the eye and the intersection: F > 0 along the whole ray. */
static void no_crest_is_passed(void **state)
{
    uint64_t seed = random_seed();
    measure deep = { .what = "passed", .unit = "m" };
    view_of_ref v = { .scene = scene_crossing() };

    (void)state;
    view_open(&v, 64, 48);
    for (int i = 0; i < 100; i++) {
        const ref_ray ray = ray_down(&seed, (ref_vec){ 1, 3, 2 }, 1);
        double rest[2] = { 1, 2 };
        ref_meeting m;
        if (!ref_ray_meets(&v.ref.surface, &ray, 0, 1e5, false, &m))
            continue;
        for (double t = 0; t < m.t - 1e-6; t += 0.02) {
            const ref_vec at = ref_ray_point(&ray, t);
            const double f = at.y - ref_surface_height(&v.ref.surface, at.x, at.z, rest,
                                                       1e-9);
            measure_add(&deep, f < 0 ? f : 0, i, (int64_t)(t * 1000), 0);
        }
    }
    view_close(&v);
    measure_print(&deep);
    assert_true(deep.worst < 1e-4);     /* crests thinner than the least step */
}

/* -- pictures ------------------------------------------------------------------------ */

/* The end of the water is seen below the horizontal by the angle of eye height over
 * distance. */
static void the_horizon_lies_in_its_row(void **state)
{
    view_of_ref v = { .scene = scene_level() };
    ref_image image;

    (void)state;
    v.scene.camera.pitch = -7 * TP_FX_ONE;
    view_open(&v, 32, 240);
    ref_image_draw(&image, &v.ref, 32, 240, 1, 1);
    const ref_camera *c = &v.ref.camera;
    const double way = c->eye.z - v.ref.surface.extent.z + v.ref.surface.extent.half_z;
    const double row = c->v0 + c->focal * tan(atan(c->eye.y / way) - 7 * PI / 180);
    for (uint32_t y = 0; y < 240; y++)
        assert_int_equal(image.kind[y * 32 + 16], y + 0.5 < row ? REF_SKY : REF_WATER);
    ref_image_free(&image);
    view_close(&v);
}

static double rms_between(const ref_image *a, const ref_image *b)
{
    double sum = 0;

    for (uint32_t i = 0; i < a->width * a->height; i++)
        for (int c = 0; c < 3; c++)
            sum += pow(a->colour[i].c[c] - b->colour[i].c[c], 2);
    return sqrt(sum / (3.0 * a->width * a->height));
}

/* With four times the samples the error is at most half, as for independent random
 * samples. */
static void more_samples_converge(void **state)
{
    view_of_ref v = { .scene = scene_crossing() };
    const uint32_t samples[4] = { 1, 4, 16, 64 };
    ref_image image[4];
    double rms[3];

    (void)state;
    view_open(&v, 48, 36);
    for (int i = 0; i < 4; i++)
        ref_image_draw(&image[i], &v.ref, 48, 36, samples[i], 1);
    for (int i = 0; i < 3; i++) {
        rms[i] = rms_between(&image[i], &image[3]);
        printf("    %2u samples: rms %.3f of 255 from 64\n", samples[i], rms[i]);
    }
    for (int i = 0; i < 4; i++)
        ref_image_free(&image[i]);
    view_close(&v);
    assert_true(rms[1] < rms[0] / 1.9 && rms[2] < rms[1] / 1.9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(level_water_is_met_where_the_plane_is),
        cmocka_unit_test(a_wave_is_met_where_brute_force_finds_it),
        cmocka_unit_test(roots_are_closer_than_a_nanometre),
        cmocka_unit_test(no_crest_is_passed),
        cmocka_unit_test(the_horizon_lies_in_its_row),
        cmocka_unit_test(more_samples_converge),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
