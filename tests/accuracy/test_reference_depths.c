/* SPDX-License-Identifier: MIT */
/* Checks the view through the water against closed forms: Snell's angles and Beer's law on
 * tilted water, dispersion by colour, wet and dry floors, and the surface from below with
 * Snell's window and total internal reflection. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/reference_scenes.h"

static uint64_t seed;

static tp_scene scene_clear(void)
{
    tp_scene s = scene_clear_any(&seed);

    s.camera.pitch = -45 * TP_FX_ONE;
    s.camera.heading = 0;
    s.water.reflection = 0;
    s.water.colour = chance_int(&seed, 0, 0xffffff);
    s.floor.depth = chance_scale(&seed, 0.3, 10);
    s.floor.texture_size = chance_scale(&seed, 0.5, 20);
    return s;
}

/* -- from above -------------------------------------------------------------------- */

/* Colour of the floor at a point under light of brightness `lit`. */
static double floor_of(const view_of_ref *v, const noise_picture *p, double x, double z,
                       double lit, int k)
{
    const double size = v->scene.floor.texture_size / 65536.0;
    return tents_of(p, x / size, z / size, k) / 255
         * channel(v->scene.floor.colour, k) * lit * tint_of(&v->scene, k);
}

/* Measures a look north through water tilted north by `tilt` radians; all rays lie in a
 * vertical plane, angles from straight down. Red is refracted least. */
static void measure_bent(measure *off, const view_of_ref *v, const noise_picture *p,
                         double tilt, double down, int n)
{
    const double met = PI / 2 - down + tilt, depth = v->scene.floor.depth / 65536.0;
    const double lit = lit_of(&v->scene, sight_cos((sight_angles){ 0, PI / 2 - tilt },
                                                   sight_light(v)));
    const double wet = lit_of(&v->scene, wet_cos(v, (sight_angles){ 0, PI / 2 }));
    const double north = v->world->eye.y / 65536.0 / tan(down);
    const ref_seen seen = sight_look(v, (sight_angles){ 0, -down });

    for (int k = 0; k < 3; k++) {
        const double index = fmax(1.15, WATER + (k - 1) * v->scene.water.dispersion
                                                    / 131072.0);
        const double way = asin(sin(met) / index) - tilt;
        const double body = between(channel(v->scene.water.deep_colour, k),
                                    channel(v->scene.water.colour, k) * lit, 0.25);
        if (fabs(met) > PI / 2 || fabs(way) > 1.4)
            continue;           /* surface seen from behind, or floor far away */
        const double sand = floor_of(v, p, 0, -north - depth * tan(way), wet, k);
        measure_add(off, seen.colour.c[k] - beer_of(&v->scene, sand, body,
                                                    depth / cos(way), k), n, k,
                    (int64_t)(1000 * tilt));
    }
}

static void the_floor_is_seen_where_light_of_each_colour_is_bent(void **state)
{
    (void)state;
    for (int spread = 0; spread < 2; spread++) {
        measure off = { .what = spread ? "dispersed floor" : "bent floor",
                        .unit = "of 255" };
        for (int n = 0; n < 400; n++) {
            static noise_picture p;
            view_of_ref v = { .scene = scene_clear() };
            plain_picture ripple;
            const int32_t aside = n % 4 ? chance_int(&seed, -60, 60) : 0;
            v.scene.water.dispersion = spread ? chance_fx(&seed, 0.001, 0.2) : 0;
            v.scene.ripple.bump = TP_FX_ONE;
            v.assets.ripple = plain_of(&ripple,
                                       0x8000c0u + ((uint32_t)(128 + aside) << 8));
            v.assets.floor_texture = noise_of(&p, &seed);
            view_open(&v, 64, 48);
            for (int i = 0; i < 8; i++)
                measure_bent(&off, &v, &p, atan2(aside, 64),
                             chance_double(&seed, 0.3, 1.2), n);
            view_close(&v);
        }
        measure_print(&off);
        assert_true(off.inputs > 8000);
        assert_true(off.worst < 1e-8);
    }
}

/* -- a beach ----------------------------------------------------------------------- */

/* Distance along a look to the floor y = rise q - depth, q in metres towards the uphill
 * side: (eye height + depth - rise at the eye's place) over the fall of the ray relative to
 * the floor. */
static double beach_met(const view_of_ref *v, sight_angles to, double high, double q)
{
    const double rise = v->scene.floor.slope / 65536.0;
    const double turn = v->scene.floor.heading / 65536.0 * PI / 180;
    const double depth = v->scene.floor.depth / 65536.0;

    return (high + depth - rise * q)
         / (rise * cos(to.elevation) * cos(to.azimuth - turn) - sin(to.elevation));
}

static void a_beach_is_lit_by_its_slope_wet_and_dry(void **state)
{
    measure wet = { .what = "wet beach", .unit = "of 255" };
    measure dry = { .what = "dry beach", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 1500; n++) {
        view_of_ref v = { .scene = scene_clear() };
        v.scene.floor.slope = chance_fx(&seed, 0.05, 0.4);
        v.scene.floor.heading = chance_fx(&seed, -180, 180);
        v.scene.camera.heading = chance_fx(&seed, -180, 180);
        view_open(&v, 64, 48);
        const sight_angles to = sight_any(&v, &seed, -PI / 2, -0.3);
        const double turn = v.scene.floor.heading / 65536.0 * PI / 180;
        const double rise = v.scene.floor.slope / 65536.0;
        const sight_angles up = { turn + PI, PI / 2 - atan(rise) };
        const double high = v.world->eye.y / 65536.0, on = high / -sin(to.elevation);
        const double land = beach_met(&v, to, high, 0);
        const ref_seen seen = sight_look(&v, to);
        const bool is_dry = land > 0 && land < on;
        const sight_angles bent = { to.azimuth, -acos(cos(to.elevation) / WATER) };
        const double q = on * cos(to.elevation) * cos(to.azimuth - turn);
        const double level = lit_of(&v.scene, sin(sight_light(&v).elevation));
        const double way = beach_met(&v, bent, 0, q);
        assert_int_equal(seen.kind, is_dry ? REF_LAND : REF_WATER);
        for (int k = 0; k < 3; k++) {
            const double lit = lit_of(&v.scene, is_dry ? sight_cos(up, sight_light(&v))
                                                       : wet_cos(&v, up));
            const double sand = channel(v.scene.floor.colour, k) * lit
                              * tint_of(&v.scene, k);
            const double body = between(channel(v.scene.water.deep_colour, k),
                                        channel(v.scene.water.colour, k) * level, 0.25);
            measure_add(is_dry ? &dry : &wet, seen.colour.c[k]
                        - (is_dry ? sand : beer_of(&v.scene, sand, body, way, k)), n, k,
                        0);
        }
        view_close(&v);
    }
    measure_print(&wet);
    measure_print(&dry);
    assert_true(wet.inputs > 1000 && dry.inputs > 100);
    assert_true(wet.worst < 1e-8 && dry.worst < 1e-8);
}

/* Height of the swash of a wave at a point, m: Hunt's run-up by a share that follows the
 * wave's phase and wanders over 37 m and 30 m. */
static double swash_of(const view_of_ref *v, double x, double z, double *runup)
{
    const tp_swell *w = &v->world->deep.swell[0];
    const double height = 2 * v->scene.wave[0].amplitude / 65536.0;
    const double length = v->scene.wave[0].length / 65536.0;
    const double rise = v->scene.floor.slope / 65536.0;
    const double period = 1 / ldexp((double)w->turns_tick, -64);
    const double ticks = (double)v->world->tick - v->world->lag / 65536.0;
    const double turn = v->scene.wave[0].phase / 65536.0 / 360 - ticks / period;
    const double far = sin(2 * PI * (1771 * x + 2203 * z) / 65536) / 8;
    const double near = sin(2 * PI * (7933 * x + 9973 * z) / 65536);

    *runup = fmin(rise * sqrt(height * length), 2 * height);
    return *runup * (0.5 + 0.35 * sin(2 * PI * (turn + far)) + 0.06 * near);
}

/* Light that sand keeps at a height over the level, and the opacities of sky and of foam
 * over the sand. */
static void coats_of(double y, double front, double runup, double coat[3])
{
    coat[0] = coat[1] = coat[2] = 0;
    if (y < runup)
        coat[0] = y > front ? (runup - y) / (runup - front) : 1;
    coat[0] = 1 - 90 / 256.0 * coat[0];
    if (y <= front) {
        coat[1] = 40 / 256.0;
        coat[2] = 200 / 256.0 * fmax(0, 1 - 10 * (front - y) / runup);
    }
}

static void swash_darkens_the_sand_and_ends_in_foam(void **state)
{
    measure off = { .what = "swash", .unit = "of 255" };
    int bare = 0, wet = 0, sheet = 0, foam = 0;

    (void)state;
    for (int n = 0; n < 3000; n++) {
        view_of_ref v = { .scene = scene_clear() };
        v.scene.wave[0].amplitude = chance_fx(&seed, 0.1, 0.5);
        v.scene.wave[0].length = chance_fx(&seed, 12, 60);
        v.scene.wave[0].steepness = 0;
        v.scene.wave[0].phase = chance_fx(&seed, 0, 359);
        v.scene.wave[0].speed = 0;
        v.scene.floor.slope = chance_fx(&seed, 0.1, 0.4);
        v.scene.camera.heading = v.scene.floor.heading;
        v.scene.foam.colour = chance_int(&seed, 0, 0xffffff);
        view_open(&v, 64, 48);
        const sight_angles to = sight_any(&v, &seed, -PI / 2, -0.3);
        const ref_seen seen = sight_look(&v, to);
        v.ref.runup = 0;
        const ref_seen sand = sight_look(&v, to);
        const double far = beach_met(&v, to, v.world->eye.y / 65536.0, 0);
        const double x = v.world->eye.x / 65536.0 + far * cos(to.elevation)
                                                        * sin(to.azimuth);
        const double z = v.world->eye.z / 65536.0 - far * cos(to.elevation)
                                                        * cos(to.azimuth);
        const double y = v.world->eye.y / 65536.0 + far * sin(to.elevation);
        double runup, coat[3];
        const double front = swash_of(&v, x, z, &runup);
        const double level = lit_of(&v.scene, sin(sight_light(&v).elevation));
        coats_of(y, front, runup, coat);
        for (int k = 0; k < 3 && seen.kind == REF_LAND; k++) {
            const double film = between(coat[0] * sand.colour.c[k],
                                        channel(v.scene.sky.horizon, k), coat[1]);
            const double white = channel(v.scene.foam.colour, k) * (1 + level) / 2;
            measure_add(&off, seen.colour.c[k] - between(film, white, coat[2]), n, k, 0);
        }
        bare += seen.kind == REF_LAND && coat[0] == 1;
        wet += seen.kind == REF_LAND && coat[0] < 1 && coat[1] == 0;
        sheet += seen.kind == REF_LAND && coat[1] > 0 && coat[2] == 0;
        foam += seen.kind == REF_LAND && coat[2] > 0;
        view_close(&v);
    }
    measure_print(&off);
    printf("    %d bare, %d wet, %d under the swash, %d in its foam\n", bare, wet, sheet,
           foam);
    assert_true(bare > 20 && wet > 20 && sheet > 20 && foam > 3);
    assert_true(off.worst < 0.1);       /* phases are rounded to 2^-32 a tick */
}

/* -- from below -------------------------------------------------------------------- */

/* Colour of light that the surface reflects down: the floor, or the water's own colour if
 * the scene has no floor. */
static double from_above(const view_of_ref *v, double up, int k)
{
    const double depth = v->scene.floor.depth / 65536.0;
    const double deep = channel(v->scene.water.deep_colour, k);
    const double lit = lit_of(&v->scene, wet_cos(v, (sight_angles){ 0, PI / 2 }));

    if (depth == 0)
        return deep;
    return beer_of(&v->scene,
                   channel(v->scene.floor.colour, k) * lit * tint_of(&v->scene, k), deep,
                   depth / sin(up), k);
}

/* Within 48.6 degrees of the zenith the surface shows the sky times the Fresnel
 * transmittance; beyond, total internal reflection. */
static void the_surface_from_below_is_a_window_and_a_mirror(void **state)
{
    measure window = { .what = "window", .unit = "of 255" };
    measure mirror = { .what = "total mirror", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 1500; n++) {
        view_of_ref v = { .scene = scene_clear() };
        v.scene.floor.depth = n % 2 ? chance_scale(&seed, 1, 10) : 0;
        v.scene.water.clarity = n % 3 ? v.scene.water.clarity : 0;
        v.scene.camera.y = -chance_fx(&seed, 0.1, 0.9);
        v.scene.camera.pitch = chance_fx(&seed, 10, 89);
        v.scene.camera.fov = 80 * TP_FX_ONE;
        v.scene.sky.kind = TP_SKY_GRADIENT;
        view_open(&v, 64, 48);
        const sight_angles to = sight_any(&v, &seed, 0.1, PI / 2 - 0.01);
        const double sine = WATER * cos(to.elevation), high = -v.world->eye.y / 65536.0;
        const ref_seen seen = sight_look(&v, to);
        for (int k = 0; k < 3; k++) {
            double back = from_above(&v, to.elevation, k);
            if (sine < 1)
                back = between(gradient_of(&v.scene, acos(sine), k), back,
                               fresnel_of(asin(sine), WATER));
            measure_add(sine < 1 ? &window : &mirror, seen.colour.c[k]
                        - beer_of(&v.scene, back, channel(v.scene.water.deep_colour, k),
                                  high / sin(to.elevation), k), n, k, 0);
        }
        view_close(&v);
    }
    measure_print(&window);
    measure_print(&mirror);
    assert_true(window.inputs > 500 && mirror.inputs > 500);
    assert_true(window.worst < 1e-8 && mirror.worst < 1e-8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_floor_is_seen_where_light_of_each_colour_is_bent),
        cmocka_unit_test(a_beach_is_lit_by_its_slope_wet_and_dry),
        cmocka_unit_test(swash_darkens_the_sand_and_ends_in_foam),
        cmocka_unit_test(the_surface_from_below_is_a_window_and_a_mirror),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
