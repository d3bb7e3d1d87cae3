/* SPDX-License-Identifier: MIT */
/* Checks the reference's spray and bubbles against closed forms: place, shape, opacity,
 * colour and haze of streaks, what hides them, bubbles under clear water, and specks around
 * an eye under water. */
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

/* Adds a speck that is at `at` at the drawn moment and has flown *way m in the tick. */
static uint8_t add_speck(view_of_ref *v, const double at[3], tp_speck_kind kind,
                         double way[3])
{
    tp_spray *spray = tp_spray_of_world(v->world);
    tp_speck *speck = (tp_speck *)(void *)(spray + 1) + spray->count++;
    const double lag = v->world->lag / 65536.0;

    for (int k = 0; k < 3; k++)
        way[k] = chance_double(&seed, -0.1, 0.1);
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

/* A streak in a picture of 64x48 pixels. */
typedef struct {
    double middle[2], half[2];  /* middle; half of the way, pixels */
    double radius, opacity, depth;
} streak;

/* Streak of a speck that is seen at `at`. Half of the way is a quarter of a tick's. The
 * radius is spray.size times 0.5 to 1.5 by the speck's random byte. At most 6 pixels of
 * length; fainter by the share of the way in the length, and nearer than 2 m. */
static streak streak_of(const view_of_ref *v, const double at[3], const double way[3],
                        uint8_t chance, bool meshed)
{
    const double focal = 24 / tan(v->scene.camera.fov / 65536.0 * PI / 360);
    const double factor = 0.5 + fmod(chance * 77.0, 256) / 256;
    const double end[3] = { at[0] + way[0] / 4, at[1] + way[1] / 4, at[2] + way[2] / 4 };
    streak s;
    double far, last[2];

    sight_place(v, aim(v, end, &far), 64, 48, last);
    const sight_angles to = aim(v, at, &far);
    sight_place(v, to, 64, 48, s.middle);
    s.depth = depth_of(v, to, far);
    s.half[0] = last[0] - s.middle[0];
    s.half[1] = last[1] - s.middle[1];
    const double r = factor * v->scene.spray.size / 65536.0 * focal / s.depth;
    const double length = 2 * r + 2 * hypot(s.half[0], s.half[1]);
    const double by = length > 6 ? 6 / length : 1;
    s.radius = r * by;
    s.half[0] *= by;
    s.half[1] *= by;
    s.opacity = fmax(0, fmin(1, s.depth - 1)) * 2 * r / length;
    if (meshed && s.radius < 1) {
        const double half = hypot(s.half[0], s.half[1]);
        s.opacity *= s.radius * (s.radius + half) / (1 + half);
        s.radius = 1;
    }
    return s;
}

/* Opacity at a place: a parabola of the distance from the nearest point of the way. */
static double opacity_of(const streak *s, double x, double y)
{
    double least = HUGE_VAL;

    for (int i = -4000; i <= 4000; i++)
        least = fmin(least, hypot(x - s->middle[0] - s->half[0] * i / 4000,
                                  y - s->middle[1] - s->half[1] * i / 4000));
    return least < s->radius ? s->opacity * (1 - pow(least / s->radius, 2)) : 0;
}

/* Colour of specks: the light of a level surface, and more towards the light. */
static double own_colour(const view_of_ref *v, sight_angles to, int k)
{
    const double lit = lit_of(&v->scene, sin(sight_light(v).elevation));
    const double glow = (1 + sight_cos(to, sight_light(v))) / 2;

    return channel(v->scene.foam.colour, k) * (lit + (1 - lit) * glow * glow);
}

static double hazed(const view_of_ref *v, double colour, double depth, int k)
{
    const double h = v->scene.sky.haze / 65536.0;
    return between(colour, channel(v->scene.sky.horizon, k),
                   depth * depth / (depth * depth + h * h));
}

/* Looks at a place, with and without specks. */
typedef struct {
    ref_seen with, bare;
} seen_twice;

static seen_twice look_twice(view_of_ref *v, const double place[2])
{
    seen_twice seen = { .with = ref_look(&v->ref, place[0], place[1]) };
    const int specks = v->ref.specks;

    v->ref.specks = 0;
    seen.bare = ref_look(&v->ref, place[0], place[1]);
    v->ref.specks = specks;
    return seen;
}

/* Adds the difference from a speck of an opacity over what is seen without specks. */
static void add_colour(measure *off, const view_of_ref *v, const seen_twice *seen,
                       sight_angles to, double depth, double opacity, int n)
{
    for (int k = 0; k < 3; k++)
        measure_add(off, seen->with.colour.c[k]
                    - between(seen->bare.colour.c[k],
                              hazed(v, own_colour(v, to, k), depth, k), opacity), n, k, 0);
}

/* Place beside a streak's middle, up to four radii away. */
static void place_beside(const streak *s, double place[2])
{
    const double turn = chance_double(&seed, 0, 2 * PI);
    const double aside = s->radius * chance_double(&seed, 0, 2)
                       + hypot(s->half[0], s->half[1]) * chance_double(&seed, 0, 1.2);

    place[0] = s->middle[0] + aside * cos(turn);
    place[1] = s->middle[1] + aside * sin(turn);
}

/* Direction of a place of the picture: sight_place, solved by Newton's differences. */
static sight_angles sight_of(const view_of_ref *v, const double place[2], sight_angles at)
{
    for (int i = 0; i < 20; i++) {
        const double d = 1e-6;
        const sight_angles right = { at.azimuth + d, at.elevation },
                           over = { at.azimuth, at.elevation + d };
        double p[2], q[2], r[2];
        sight_place(v, at, 64, 48, p);
        sight_place(v, right, 64, 48, q);
        sight_place(v, over, 64, 48, r);
        const double a = (q[0] - p[0]) / d, b = (r[0] - p[0]) / d;
        const double c = (q[1] - p[1]) / d, e = (r[1] - p[1]) / d;
        const double x = place[0] - p[0], y = place[1] - p[1], det = a * e - b * c;
        at.azimuth += (x * e - b * y) / det;
        at.elevation += (a * y - c * x) / det;
    }
    return at;
}

/* -- in the air ---------------------------------------------------------------------- */

/* A speck in the air, at `least` m or farther, seen at a place beside its middle. */
static void compare_streak(measure *off, bool meshed, double least, double most, int n,
                           uint32_t count[3])
{
    view_of_ref v = { .scene = scene_sprayed() };
    double at[3], way[3], place[2];

    open_world(&v);
    const sight_angles to = sight_any(&v, &seed, 0.1, PI / 2 - 0.1);
    go(&v, to, chance_double(&seed, least, most), at);
    const uint8_t chance = add_speck(&v, at, TP_SPECK_SPRAY, way);
    open_view(&v, meshed);
    const streak s = streak_of(&v, at, way, chance, meshed);
    place_beside(&s, place);
    const seen_twice seen = look_twice(&v, place);
    const double opacity = opacity_of(&s, place[0], place[1]);
    count[0] += opacity > 0.01;
    count[1] += opacity == 0;
    count[2] += s.depth < 1 && seen.with.spray == 0;
    measure_add(off, 255 * (seen.with.spray - opacity), n, 3, 0);
    add_colour(off, &v, &seen, sight_of(&v, place, to), s.depth, opacity, n);
    view_close(&v);
}

/* Places are rounded to 2^-17 m, 3e-4 of a small radius: 0.2 of 255. */
static void a_speck_is_a_soft_streak_in_the_haze(void **state)
{
    measure off = { .what = "specks", .unit = "of 255" };
    uint32_t count[3] = { 0 };

    (void)state;
    for (int n = 0; n < 600; n++)
        compare_streak(&off, false, 2, 12, n, count);
    measure_print(&off);
    assert_true(count[0] > 100 && count[1] > 20);
    assert_true(off.worst < 0.3);
}

static void specks_before_the_eye_fade(void **state)
{
    measure off = { .what = "near specks", .unit = "of 255" };
    uint32_t count[3] = { 0 };

    (void)state;
    for (int n = 0; n < 600; n++)
        compare_streak(&off, false, 0.4, 2.5, n, count);
    measure_print(&off);
    assert_true(count[0] > 60 && count[2] > 10);
    assert_true(off.worst < 0.3);
}

/* With the engine's levels far specks are two pixels wide, and fainter. */
static void far_specks_are_wide_and_faint(void **state)
{
    measure off = { .what = "far specks", .unit = "of 255" };
    uint32_t count[3] = { 0 };

    (void)state;
    for (int n = 0; n < 600; n++)
        compare_streak(&off, true, 2, 40, n, count);
    measure_print(&off);
    assert_true(count[0] > 60 && count[1] > 20);
    assert_true(off.worst < 0.3);
}

/* Specks before a drop lie over the drop; the drop hides the specks beyond. */
static void a_drop_hides_the_specks_beyond(void **state)
{
    int before = 0, beyond = 0;

    (void)state;
    for (int n = 0; n < 1000; n++) {
        view_of_ref v = { .scene = scene_sprayed() };
        const sight_angles to = { 0, 0 };
        const double far = chance_double(&seed, 3, 30), middle[2] = { 32, 24 };
        double at[3], way[3];
        v.scene.camera.pitch = v.scene.camera.heading = 0;
        v.scene.drops.count = 1;
        v.scene.drops.radius = TP_FX_ONE;
        v.scene.drops.y = v.scene.camera.y;
        v.scene.drops.z = -8 * TP_FX_ONE;       /* from 6 to 10 m before the eye */
        open_world(&v);
        go(&v, to, far, at);
        add_speck(&v, at, TP_SPECK_SPRAY, way);
        open_view(&v, false);
        const seen_twice seen = look_twice(&v, middle);
        assert_int_equal(seen.with.kind, REF_DROP);
        assert_true(fabs(far - 6) < 0.01 || (seen.with.spray > 0) == (far < 6));
        before += far < 6;
        beyond += far > 6;
        view_close(&v);
    }
    assert_true(before > 40 && beyond > 40);
}

/* -- in the water -------------------------------------------------------------------- */

/* A bubble appears at 3/4 of its depth over clear water; opaque water hides it. Spray below
 * the surface is hidden by either. */
static void bubbles_show_through_clear_water(void **state)
{
    measure off = { .what = "bubbles", .unit = "of 255" };
    int hidden = 0;

    (void)state;
    for (int n = 0; n < 2000; n++) {
        view_of_ref v = { .scene = scene_sprayed() };
        const bool bubble = n % 3 != 0, clear = n % 4 != 0;
        double at[3], way[3], far, place[2];
        if (!clear)
            v.scene.water.clarity = 0;
        v.scene.camera.pitch = -45 * TP_FX_ONE;
        open_world(&v);
        const sight_angles over = sight_any(&v, &seed, -PI / 2, -0.2);
        go(&v, over, v.world->eye.y / 65536.0 / sin(-over.elevation)
                     + chance_double(&seed, 0.2, 5), at);
        const double seen_at[3] = { at[0], at[1] * (bubble ? 0.75 : 1), at[2] };
        const sight_angles to = aim(&v, seen_at, &far);
        const bool inside = sight_place(&v, to, 64, 48, place);
        const uint8_t chance =
            add_speck(&v, at, bubble ? TP_SPECK_BUBBLE : TP_SPECK_SPRAY, way);
        open_view(&v, false);
        const streak s = streak_of(&v, seen_at, way, chance, false);
        const seen_twice seen = look_twice(&v, s.middle);
        if (inside) {
            assert_int_equal(seen.with.kind, REF_WATER);
            assert_int_equal(seen.with.spray > 0, bubble && clear);
            hidden += seen.with.spray == 0;
        }
        if (inside && bubble && clear)
            add_colour(&off, &v, &seen, to, s.depth, seen.with.spray, n);
        if (inside && bubble && clear)
            measure_add(&off, 255 * (seen.with.spray - s.opacity), n, 3, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.inputs > 2000 && hidden > 300);
    assert_true(off.worst < 0.3);
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
        double at[3], way[3], place[2];
        v.scene.camera.y = -4 * TP_FX_ONE;
        open_world(&v);
        const sight_angles to = sight_any(&v, &seed, -PI / 2, PI / 2);
        const double far = chance_double(&seed, 2, 12);
        go(&v, to, far, at);
        if (fabs(at[1]) < 0.01)
            continue;
        add_speck(&v, at, TP_SPECK_BUBBLE, way);
        open_view(&v, false);
        sight_place(&v, to, 64, 48, place);
        const seen_twice seen = look_twice(&v, place);
        assert_true((seen.with.spray > 0) == (at[1] < 0));
        above += at[1] > 0;
        for (int k = 0; k < 3 && at[1] < 0; k++)
            measure_add(&off, seen.with.colour.c[k]
                        - between(seen.bare.colour.c[k],
                                  beer_of(&v.scene, own_colour(&v, to, k),
                                          channel(v.scene.water.deep_colour, k), far, k),
                                  seen.with.spray), n, k, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(above > 50 && off.inputs > 2000);
    assert_true(off.worst < 1e-2);      /* clear water of 1 m, a way rounded to 1e-5 */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_speck_is_a_soft_streak_in_the_haze),
        cmocka_unit_test(specks_before_the_eye_fade),
        cmocka_unit_test(far_specks_are_wide_and_faint),
        cmocka_unit_test(a_drop_hides_the_specks_beyond),
        cmocka_unit_test(bubbles_show_through_clear_water),
        cmocka_unit_test(an_eye_under_water_sees_bubbles),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
