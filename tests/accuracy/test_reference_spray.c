/* SPDX-License-Identifier: MIT */
/* Checks the reference's spray and bubbles against closed forms: place, width, colour and
 * haze of discs, what hides them, bubbles under clear water, and specks around an eye under
 * water. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/spray/spray.h"
#include "tests/lib/reference_scenes.h"

static uint64_t seed;

/* A spray of specks over level water, with nothing else that moves. */
static tp_scene scene_sprayed(void)
{
    tp_scene s = scene_clear_any(&seed);

    s.camera.heading = chance_fx(&seed, -180, 180);
    s.camera.pitch = chance_fx(&seed, -20, 60);
    s.camera.fov = 90 * TP_FX_ONE;
    s.spray.count = 64;
    s.spray.size = chance_scale(&seed, 0.05, 0.3);
    s.foam.colour = chance_int(&seed, 0, 0xffffff);
    s.sky.haze = chance_scale(&seed, 5, 100);
    return s;
}

/* Point at a distance from the eye, m. */
static void go(const view_of_ref *v, sight_angles to, double far, double at[3])
{
    at[0] = v->world->eye.x / 65536.0 + far * cos(to.elevation) * sin(to.azimuth);
    at[1] = v->world->eye.y / 65536.0 + far * sin(to.elevation);
    at[2] = v->world->eye.z / 65536.0 - far * cos(to.elevation) * cos(to.azimuth);
}

/* Direction and distance of a point from the eye. */
static sight_angles aim(const view_of_ref *v, const double at[3], double *far)
{
    const double dx = at[0] - v->world->eye.x / 65536.0;
    const double dy = at[1] - v->world->eye.y / 65536.0;
    const double dz = at[2] - v->world->eye.z / 65536.0;

    *far = hypot(hypot(dx, dz), dy);
    return (sight_angles){ atan2(dx, -dz), atan2(dy, hypot(dx, dz)) };
}

static tp_vec3 to_fixed(const double at[3], const double more[3], double by)
{
    return (tp_vec3){ (tp_fx)lround((at[0] + by * more[0]) * 65536),
                      (tp_fx)lround((at[1] + by * more[1]) * 65536),
                      (tp_fx)lround((at[2] + by * more[2]) * 65536) };
}

/* Adds a speck that is at `at` at the drawn moment and has flown `way` m in the tick. */
static uint8_t add_speck(view_of_ref *v, const double at[3], tp_speck_kind kind)
{
    tp_spray *spray = tp_spray_of_world(v->world);
    tp_speck *speck = (tp_speck *)(void *)(spray + 1) + spray->count++;
    const double lag = v->world->lag / 65536.0;
    const double way[3] = { chance_double(&seed, -1, 1), chance_double(&seed, -1, 1),
                            chance_double(&seed, -1, 1) };

    *speck = (tp_speck){ .place = to_fixed(at, way, lag),
                         .last = to_fixed(at, way, lag - 1), .kind = (uint8_t)kind,
                         .chance = (uint8_t)chance_int(&seed, 0, 255) };
    return speck->chance;
}

static void open_world(view_of_ref *v)
{
    v->world = scene_world(&v->scene, &v->assets);
    v->world->lag = chance_fx(&seed, 0, 1);
}

static void open_view(view_of_ref *v, bool meshed)
{
    ref_scene_open(&v->ref, &v->scene, &v->assets, v->world, 64, 48, meshed);
}

/* Depth ahead of the eye, m. */
static double depth_of(const view_of_ref *v, sight_angles to, double far)
{
    return far * sight_cos(to, sight_ahead(v));
}

/* Radius of a disc in a picture 48 pixels high: half of spray.size, times 0.5 to 1.5 by the
 * speck's random byte. */
static double radius_of(const view_of_ref *v, uint8_t chance, double depth)
{
    const double factor = 0.5 + fmod(chance * 77.0, 256) / 256;
    const double focal = 24 / tan(v->scene.camera.fov / 65536.0 * PI / 360);

    return factor * v->scene.spray.size / 65536.0 / 2 * focal / depth;
}

/* Colour of specks: half way between the light of a level surface and full light. */
static double own_colour(const view_of_ref *v, int k)
{
    return channel(v->scene.foam.colour, k)
         * (1 + lit_of(&v->scene, sin(sight_light(v).elevation))) / 2;
}

static double hazed(const view_of_ref *v, double colour, double depth, int k)
{
    const double h = v->scene.sky.haze / 65536.0;
    return between(colour, channel(v->scene.sky.horizon, k),
                   depth * depth / (depth * depth + h * h));
}

static void add_colour(measure *off, const view_of_ref *v, const ref_seen *seen,
                       double depth, int n)
{
    for (int k = 0; k < 3; k++)
        measure_add(off, seen->colour.c[k] - hazed(v, own_colour(v, k), depth, k), n, k, 0);
}

/* Looks at a place beside the middle of a disc. */
static ref_seen look_beside(const view_of_ref *v, sight_angles to, double aside)
{
    const double turn = chance_double(&seed, 0, 2 * PI);
    double place[2];

    sight_place(v, to, 64, 48, place);
    return ref_look(&v->ref, place[0] + aside * cos(turn), place[1] + aside * sin(turn));
}

/* -- in the air ---------------------------------------------------------------------- */

/* The inside of a disc ends at its radius. Places are rounded to 2^-17 m, radii of 0.025 m
 * or more. */
static void a_speck_is_a_disc_in_the_haze(void **state)
{
    measure off = { .what = "specks", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 3000; n++) {
        view_of_ref v = { .scene = scene_sprayed() };
        double at[3];
        open_world(&v);
        const sight_angles to = sight_any(&v, &seed, 0, PI / 2);
        const double far = chance_double(&seed, 2, 40);
        go(&v, to, far, at);
        const uint8_t chance = add_speck(&v, at, TP_SPECK_SPRAY);
        open_view(&v, false);
        const double depth = depth_of(&v, to, far), radius = radius_of(&v, chance, depth);
        const ref_seen inside =
            look_beside(&v, to, radius * chance_double(&seed, 0, 0.998));
        const ref_seen outside =
            look_beside(&v, to, radius * chance_double(&seed, 1.002, 3));
        assert_int_equal(inside.kind, REF_SPRAY);
        assert_int_not_equal(outside.kind, REF_SPRAY);
        measure_add(&off, 1 / inside.near / depth - 1, n, 3, 0);
        add_colour(&off, &v, &inside, depth, n);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-3);      /* haze of a depth rounded to 1e-5 */
}

/* Of two specks the nearer is seen; water, and a drop, hide the specks beyond. */
static void the_nearest_of_all_is_seen(void **state)
{
    measure off = { .what = "order", .unit = "of 255" };
    int drops = 0, specks = 0;

    (void)state;
    for (int n = 0; n < 2000; n++) {
        view_of_ref v = { .scene = scene_sprayed() };
        double at[3], nearest = HUGE_VAL;
        v.scene.camera.pitch = v.scene.camera.heading = 0;
        v.scene.drops.count = 1;
        v.scene.drops.radius = TP_FX_ONE;
        v.scene.drops.y = v.scene.camera.y;
        v.scene.drops.z = -8 * TP_FX_ONE;       /* from 6 to 10 m before the eye */
        open_world(&v);
        const sight_angles to = { 0, 0 };
        for (int i = 0; i < 3; i++) {
            const double far = chance_double(&seed, 3, 30);
            if (fabs(far - 6) < 0.01)
                continue;
            go(&v, to, far, at);
            add_speck(&v, at, TP_SPECK_SPRAY);
            nearest = fmin(nearest, far);
        }
        open_view(&v, false);
        const ref_seen seen = sight_look(&v, to);
        assert_int_equal(seen.kind, nearest < 6 ? REF_SPRAY : REF_DROP);
        drops += nearest > 6;
        specks += nearest < 6;
        if (nearest < 6)
            add_colour(&off, &v, &seen, nearest, n);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(drops > 100 && specks > 100);
    assert_true(off.worst < 1e-3);
}

/* -- in the water -------------------------------------------------------------------- */

/* A bubble appears at 3/4 of its depth over clear water; opaque water hides it. Spray below
 * the surface is hidden by either. */
static void bubbles_show_through_clear_water(void **state)
{
    measure off = { .what = "bubbles", .unit = "of 255" };
    int hidden = 0;

    (void)state;
    for (int n = 0; n < 3000; n++) {
        view_of_ref v = { .scene = scene_sprayed() };
        const bool bubble = n % 3 != 0, clear = n % 4 != 0;
        double at[3], far;
        if (!clear)
            v.scene.water.clarity = 0;
        v.scene.camera.pitch = -45 * TP_FX_ONE;
        open_world(&v);
        const sight_angles over = sight_any(&v, &seed, -PI / 2, -0.2);
        go(&v, over, v.world->eye.y / 65536.0 / sin(-over.elevation)
                     + chance_double(&seed, 0.01, 5), at);
        const double seen_at[3] = { at[0], at[1] * (bubble ? 0.75 : 1), at[2] };
        const sight_angles to = aim(&v, seen_at, &far);
        double place[2];
        const bool inside = sight_place(&v, to, 64, 48, place);
        const uint8_t chance = add_speck(&v, at, bubble ? TP_SPECK_BUBBLE
                                                        : TP_SPECK_SPRAY);
        open_view(&v, false);
        const double depth = depth_of(&v, to, far);
        const ref_seen seen =
            look_beside(&v, to, bubble ? 0.99 * radius_of(&v, chance, depth) : 0);
        if (inside) {
            assert_int_equal(seen.kind, bubble && clear ? REF_SPRAY : REF_WATER);
            hidden += seen.kind == REF_WATER;
        }
        if (inside && bubble && clear)
            add_colour(&off, &v, &seen, depth, n);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.inputs > 3000 && hidden > 500);
    assert_true(off.worst < 1e-3);
}

/* An eye under water sees bubbles at their place, by Beer's law and without haze; specks
 * beyond the surface are hidden. */
static void an_eye_under_water_sees_bubbles(void **state)
{
    measure off = { .what = "bubbles from below", .unit = "of 255" };
    int above = 0;

    (void)state;
    for (int n = 0; n < 2000; n++) {
        view_of_ref v = { .scene = scene_sprayed() };
        double at[3];
        v.scene.camera.y = -4 * TP_FX_ONE;
        open_world(&v);
        const sight_angles to = sight_any(&v, &seed, -PI / 2, PI / 2);
        const double far = chance_double(&seed, 1, 12);
        go(&v, to, far, at);
        if (fabs(at[1]) < 0.01)
            continue;
        add_speck(&v, at, TP_SPECK_BUBBLE);
        open_view(&v, false);
        const ref_seen seen = sight_look(&v, to);
        assert_int_equal(seen.kind, at[1] < 0 ? REF_SPRAY : REF_WATER);
        above += at[1] > 0;
        for (int k = 0; k < 3 && at[1] < 0; k++)
            measure_add(&off, seen.colour.c[k]
                        - beer_of(&v.scene, own_colour(&v, k),
                                  channel(v.scene.water.deep_colour, k), far, k), n, k, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(above > 50 && off.inputs > 2000);
    assert_true(off.worst < 1e-2);      /* clear water of 1 m, a way rounded to 1e-5 */
}

/* -- discs of the engine ------------------------------------------------------------- */

/* With the engine's levels a far speck is the pixel with its centre, or nothing where its
 * width in 1/256 pixel is not above its random byte. */
static void a_far_speck_is_a_pixel_or_nothing(void **state)
{
    int drawn = 0;

    (void)state;
    for (int n = 0; n < 2000; n++) {
        view_of_ref v = { .scene = scene_sprayed() };
        double at[3], place[2];
        open_world(&v);
        const sight_angles to = sight_any(&v, &seed, 0, PI / 2);
        const double far = chance_double(&seed, 2, 40);
        go(&v, to, far, at);
        const uint8_t chance = add_speck(&v, at, TP_SPECK_SPRAY);
        open_view(&v, true);
        const double wide = 2 * radius_of(&v, chance, depth_of(&v, to, far));
        sight_place(&v, to, 64, 48, place);
        const double x = floor(place[0]), y = floor(place[1]);
        const double u = x + chance_double(&seed, 0.001, 0.999);
        const double w = y + chance_double(&seed, 0.001, 0.999);
        const bool edge = fabs(place[0] - x - 0.5) > 0.499
                       || fabs(place[1] - y - 0.5) > 0.499;
        if (wide < 0.999 && !edge && fabs(wide * 256 - chance) > 0.01) {
            const bool there = wide * 256 > chance;
            assert_int_equal(ref_look(&v.ref, u, w).kind == REF_SPRAY, there);
            assert_int_not_equal(ref_look(&v.ref, u + 1, w).kind, REF_SPRAY);
            drawn += there;
        }
        view_close(&v);
    }
    assert_true(drawn > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_speck_is_a_disc_in_the_haze),
        cmocka_unit_test(the_nearest_of_all_is_seen),
        cmocka_unit_test(bubbles_show_through_clear_water),
        cmocka_unit_test(an_eye_under_water_sees_bubbles),
        cmocka_unit_test(a_far_speck_is_a_pixel_or_nothing),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
