/* SPDX-License-Identifier: MIT */
/* Checks the reference's stars against their places as angles on the sphere. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/reference_scenes.h"

enum { WIDE = 640, HIGH = 480, CELLS = 64 };

static uint64_t seed;

typedef struct {
    sight_angles at;
    double bright;              /* at the centre, 1: white; 0: no star */
    uint32_t tint;
} star;

/* Number of a cell, scrambled: the definition of the stars. */
static uint32_t scrambled(uint32_t n)
{
    n ^= n >> 15;
    n *= 0x2c1b3c6du;
    n ^= n >> 12;
    n *= 0x297a2d39u;
    return n ^ n >> 15;
}

/* Angles of a place on a face of the cube. East, west, south and north stand upright around
 * the viewer; the lower edge of the face overhead joins the south face. */
static sight_angles angles_of(int face, double right, double up)
{
    static const double azimuth[6] = { PI / 2, -PI / 2, 0, 0, PI, 0 };

    if (face == 2)
        return (sight_angles){ atan2(-right, up), atan2(1, hypot(right, up)) };
    return (sight_angles){ azimuth[face] + atan(right), atan2(up, hypot(1, right)) };
}

/* Star of a cell. Stars keep a quarter of the cell free at each edge; their brightness
 * grows with the cube of their rank; the air dims the lowest ones. */
static star star_of(const tp_scene *s, int face, int row, int col)
{
    static const uint32_t tints[4] = { 0xffffff, 0xd8e4ff, 0xfff0d8, 0xecf2ff };
    const uint32_t h = scrambled((uint32_t)(4096 * face + 64 * row + col) + 1);
    const double right = (col + 0.25 + (h >> 8 & 255) / 512.0) / CELLS * 2 - 1;
    const double down = (row + 0.25 + (h >> 16 & 255) / 512.0) / CELLS * 2 - 1;
    star to = { .at = angles_of(face, right, -down), .tint = tints[h >> 14 & 3] };
    const double rank = (h >> 24) / 255.0;

    if ((h & 255) < (uint32_t)s->sky.stars / 1024)
        to.bright = 56 / 256.0 + 1.75 * pow(rank * 255 / 256, 3);
    return to;
}

static double air_of(double elevation)
{
    return fmin(1, fmax(0, 8 * (sin(elevation) - 500 / 16384.0)));
}

static tp_scene scene_night(void)
{
    tp_scene s = scene_sky(&seed, TP_SKY_NIGHT);

    s.sky.stars = chance_fx(&seed, 0.1, 1);
    s.camera.fov = chance_fx(&seed, 40, 100);
    return s;
}

/* Colour in a direction, with stars and without. */
static void look_twice(view_of_ref *v, sight_angles to, ref_colour with[2])
{
    const int32_t stars = v->scene.sky.stars;
    double place[2];

    assert_true(sight_place(v, to, WIDE, HIGH, place));
    with[1] = ref_look(&v->ref, place[0], place[1]).colour;
    v->scene.sky.stars = 0;
    with[0] = ref_look(&v->ref, place[0], place[1]).colour;
    v->scene.sky.stars = stars;
}

/* Direction at an angle beside another one, to a random side. */
static sight_angles beside(sight_angles a, double angle)
{
    const double side = chance_double(&seed, -PI, PI);
    const double up = asin(sin(a.elevation) * cos(angle)
                           + cos(a.elevation) * sin(angle) * cos(side));

    return (sight_angles){ a.azimuth + atan2(sin(side) * sin(angle) * cos(a.elevation),
                                             cos(angle) - sin(a.elevation) * sin(up)),
                           up };
}

/* Measures one star at a random share of its radius, up to one and a half. The radius is
 * the chord of 0.85 pixels at the picture's centre. */
static void measure_star(measure *off, view_of_ref *v, const star *s)
{
    const double focal = HIGH / 2.0 / tan(v->scene.camera.fov / 65536.0 * PI / 360);
    const double share = chance_double(&seed, 0, 1.5);
    const sight_angles to = beside(s->at, 2 * asin(share * 0.85 / focal / 2));
    const double light = s->bright * fmax(0, 1 - share * share) * air_of(to.elevation);
    ref_colour seen[2];
    double place[2];

    if (!sight_place(v, to, WIDE, HIGH, place) || to.elevation < 0)
        return;
    look_twice(v, to, seen);
    for (int k = 0; k < 3; k++)
        measure_add(off, seen[1].c[k]
                    - fmin(255, seen[0].c[k]
                           + fmin(1, light) * channel((int32_t)s->tint, k)),
                    (int64_t)(1000 * s->at.azimuth), (int64_t)(1000 * s->at.elevation), k);
}

static void stars_stand_in_their_cells(void **state)
{
    measure off = { .what = "stars", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 30; n++) {
        view_of_ref v = { .scene = scene_night() };
        go_ashore(&v.scene);
        view_open(&v, WIDE, HIGH);
        for (int i = 0; i < 6 * CELLS * CELLS; i++) {
            const int face = i / (CELLS * CELLS);
            const star s = star_of(&v.scene, face, i / CELLS % CELLS, i % CELLS);
            if (face != 3 && s.bright > 0)
                measure_star(&off, &v, &s);
        }
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.inputs > 3000);
    assert_true(off.worst < 1e-6);
}

/* Between the stars the sky is bare: a random look meets a star with the chance of the
 * stars' number times the area of one over the sphere's area. */
static void the_sky_between_stars_is_bare(void **state)
{
    double expected = 0;
    int met = 0, looks = 0;

    (void)state;
    for (int n = 0; n < 40; n++) {
        view_of_ref v = { .scene = scene_night() };
        const double focal = HIGH / 2.0 / tan(v.scene.camera.fov / 65536.0 * PI / 360);
        go_ashore(&v.scene);
        view_open(&v, WIDE, HIGH);
        for (int i = 0; i < 20000; i++) {
            const double u = chance_double(&seed, 0, WIDE);
            const double t = chance_double(&seed, 0, HIGH);
            const ref_seen seen = ref_look(&v.ref, u, t);
            const int32_t stars = v.scene.sky.stars;
            v.scene.sky.stars = 0;
            const ref_seen bare = ref_look(&v.ref, u, t);
            v.scene.sky.stars = stars;
            if (seen.kind != REF_SKY || bare.colour.c[0] < 1)
                continue;
            looks++;
            met += seen.colour.c[0] > bare.colour.c[0];
            expected += (double)(stars / 1024) / 256 * 6 * CELLS * CELLS
                      * 0.85 * 0.85 / focal / focal / 4;
        }
        view_close(&v);
    }
    printf("    %d of %d looks met a star, expected at most %.1f\n", met, looks, expected);
    assert_true(met > 0.2 * expected && met < 1.3 * expected + 10);
}

/* Only the night has stars; water mirrors none, and none stand below the horizon. */
static void neither_water_nor_day_has_stars(void **state)
{
    (void)state;
    for (int n = 0; n < 60; n++) {
        view_of_ref v = { .scene = scene_night() };
        const bool night = n % 2;
        v.scene.sky.stars = TP_FX_ONE;
        v.scene.sky.kind = night ? TP_SKY_NIGHT : TP_SKY_DAY + n / 2 % 2;
        v.scene.camera.pitch = chance_fx(&seed, -60, 10);
        view_open(&v, WIDE, HIGH);
        for (int i = 0; i < 500; i++) {
            const sight_angles to = sight_any(&v, &seed, -PI / 2, night ? 0 : PI / 2);
            ref_colour seen[2];
            look_twice(&v, to, seen);
            for (int k = 0; k < 3; k++)
                assert_true(seen[0].c[k] == seen[1].c[k]);
        }
        view_close(&v);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stars_stand_in_their_cells),
        cmocka_unit_test(the_sky_between_stars_is_bare),
        cmocka_unit_test(neither_water_nor_day_has_stars),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
