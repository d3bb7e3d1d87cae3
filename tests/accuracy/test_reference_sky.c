/* SPDX-License-Identifier: MIT */
/* The reference's skies against closed forms: gradient, generated skies and cubes, seen
 * and mirrored, with light beyond white. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "sights.h"

static uint64_t seed;

static tp_scene scene_sky(int32_t kind)
{
    tp_scene s = scene_level();

    s.sky.kind = kind;
    s.camera.heading = chance_fx(&seed, -180, 180);
    s.camera.pitch = chance_fx(&seed, -40, 80);
    s.camera.fov = 90 * TP_FX_ONE;
    s.light.heading = chance_fx(&seed, -180, 180);
    s.light.elevation = chance_fx(&seed, 1, 90);
    s.light.colour = chance_int(&seed, 0, 0xffffff);
    s.light.ambient = TP_FX_ONE;
    s.water.colour = 0x102840;
    return s;
}

/* A place with no water below it; it may still be seen, far away. */
static void go_ashore(tp_scene *s)
{
    s->camera.x = 4000 * TP_FX_ONE;
    s->grid.follow = 0;
    s->grid.reach = 0;
}

/* -- generated skies --------------------------------------------------------------- */

/* Of the light's colour: two halos over its distance, 2 sin of half the angle, which end
 * opposite of it; peaks in 256ths, widths as one over the distance's square. */
static double halo_of(const tp_scene *s, double cosine)
{
    static const double peak[3][2] = { { 96, 72 }, { 88, 96 }, { 80, 52 } };
    static const double narrow[3][2] = { { 256, 16 }, { 256, 8 }, { 1024, 32 } };
    const int kind = s->sky.kind - TP_SKY_DAY;
    double sum = 0;

    for (int i = 0; i < 2; i++)
        sum += peak[kind][i] / 256 * (1 / (1 + narrow[kind][i] * 2 * (1 - cosine))
                                      - 1 / (1 + narrow[kind][i] * 4));
    return sum;
}

/* How much of the disc is there: all of it to 1.095 degrees, none from 1.266 on. */
static double disc_of(double cosine)
{
    const double square = 2 * (1 - cosine) * 0x1p28;
    return fmin(1, fmax(0, (131072 - square) / 33072));
}

/* A day's, before the light of it is held or goes beyond white. */
static double day_of(const tp_scene *s, sight to, double cosine, bool disc, int k)
{
    const double low = pow(1 - fmax(0, sin(to.elevation)), 4) * 5 / 8;
    const double base = gradient_of(s, to.elevation, k);
    const double light = channel(s->light.colour, k);
    const double side = pow((1 + cosine) / 2, 2);      /* cos^4 of half the angle */
    const double more = disc ? fmin(1, s->sky.sun / 65536.0) * disc_of(cosine) : 0;

    return between(base, between(base, light, low), side)
         + light * (halo_of(s, disc ? cosine : fmin(cosine, 1 - 131072 / 0x1p29)) + more);
}

/* Towards the light, so that half of them see its disc. */
static sight near_light(const view_of_ref *v)
{
    sight s = sight_light(v);

    s.azimuth += chance_double(&seed, -0.05, 0.05);
    s.elevation += chance_double(&seed, -0.02, 0.02);
    return s;
}

static void a_day_has_its_gradient_halos_and_disc(void **state)
{
    measure off = { .what = "day", .unit = "of 255" };
    int in_disc = 0;

    (void)state;
    for (int n = 0; n < 2000; n++) {
        view_of_ref v = { .scene = scene_sky(TP_SKY_DAY) };
        v.scene.sky.sun = chance_fx(&seed, 0, 4);
        v.scene.hdr.share = n % 2 ? chance_fx(&seed, 0, 1) : 0;
        v.scene.camera.heading = v.scene.light.heading;
        v.scene.camera.pitch = v.scene.light.elevation = chance_fx(&seed, 5, 80);
        view_open(&v, 64, 48);
        const sight to = n % 4 < 2 ? near_light(&v) : sight_any(&v, &seed, 0, PI / 2);
        const double cosine = sight_cos(to, sight_light(&v));
        const double more = v.scene.sky.sun / 65536.0 * disc_of(cosine)
                          * v.scene.hdr.share / 65536.0;
        const ref_seen seen = sight_look(&v, to);
        in_disc += disc_of(cosine) > 0;
        for (int k = 0; k < 3; k++)
            measure_add(&off, seen.colour.c[k]
                        - fmin(255, fmin(255, day_of(&v.scene, to, cosine, true, k))
                               * (1 + more)), n, k, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(in_disc > 100);
    assert_true(off.worst < 1e-8);      /* the disc's edge is 1 in 8000 of a radian */
}

/* Below the horizon it grows dark, to a quarter within 11 degrees; nothing is beyond
 * white there. */
static void a_day_grows_dark_below_the_horizon(void **state)
{
    measure off = { .what = "below", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 500; n++) {
        view_of_ref v = { .scene = scene_sky(TP_SKY_DAY) };
        go_ashore(&v.scene);
        v.scene.camera.pitch = -20 * TP_FX_ONE;
        v.scene.hdr.share = TP_FX_ONE;
        if (n % 2) {            /* half of its disc has set */
            v.scene.camera.heading = v.scene.light.heading;
            v.scene.light.elevation = TP_FX_ONE;
        }
        view_open(&v, 64, 48);
        sight to = sight_any(&v, &seed, -0.5, 0);
        if (n % 2)
            to = (sight){ sight_light(&v).azimuth + chance_double(&seed, -0.01, 0.01),
                          chance_double(&seed, -0.004, 0) };
        const double cosine = sight_cos(to, sight_light(&v));
        const ref_seen seen = sight_look(&v, to);
        for (int k = 0; k < 3 && seen.kind == REF_SKY; k++)
            measure_add(&off, seen.colour.c[k]
                        - fmax(0.25, 1 + 4 * sin(to.elevation))
                          * fmin(255, day_of(&v.scene, to, cosine, true, k)), n, k, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.inputs > 1200);
    assert_true(off.worst < 1e-8);
}

/* Without a disc where there is glitter; light beyond white counts though the water shows
 * but a share of it. */
static void level_water_mirrors_a_day(void **state)
{
    measure off = { .what = "mirrored day", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 2000; n++) {
        view_of_ref v = { .scene = scene_sky(TP_SKY_DAY) };
        const bool disc = n % 2;
        v.scene.sky.sun = chance_fx(&seed, 0, 8);
        v.scene.hdr.share = chance_fx(&seed, 0, 1);
        v.scene.camera.heading = v.scene.light.heading;
        v.scene.camera.pitch = -30 * TP_FX_ONE;
        v.scene.light.elevation = chance_fx(&seed, 5, 60);
        v.scene.water.specular = disc ? 0 : 1;      /* 2^-16 */
        view_open(&v, 64, 48);
        const sight up = near_light(&v);
        const double cosine = sight_cos(up, sight_light(&v));
        const double share = fresnel_of(PI / 2 - up.elevation, WATER);
        const double more = disc ? v.scene.sky.sun / 65536.0 * disc_of(cosine)
                                 * v.scene.hdr.share / 65536.0 : 0;
        const ref_seen seen = sight_look(&v, (sight){ up.azimuth, -up.elevation });
        const double power = v.scene.water.shininess / TP_FX_ONE;
        const double glint = disc ? 0 : 0x1p-16 * pow(fmax(0, cosine), power);
        for (int k = 0; k < 3; k++)
            measure_add(&off, seen.colour.c[k]
                        - fmin(255, glint * channel(v.scene.light.colour, k)
                               + fmin(255, channel(v.scene.water.colour, k) * (1 - share)
                               + share * (1 + more)
                                 * fmin(255, day_of(&v.scene, up, cosine, disc, k)))),
                        n, k, disc);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-8);
}

/* The colour in a direction where the light is black, or of a colour. */
static ref_colour lit_sky(tp_scene scene, int32_t colour, sight to)
{
    view_of_ref v = { .scene = scene };

    v.scene.light.colour = colour;
    view_open(&v, 64, 48);
    const ref_seen seen = sight_look(&v, to);
    view_close(&v);
    return seen.colour;
}

/* Without their light, at one elevation, dusk and night go from the dark side's colour to
 * the bright one's by cos^4 of half the angle from the light: of three places the third
 * follows.  What a light adds are its halos. */
static void dusk_and_night_have_two_sides_and_halos(void **state)
{
    measure sides = { .what = "two sides", .unit = "of 255" };
    measure halos = { .what = "halos", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 600; n++) {
        tp_scene scene = scene_sky(n % 2 ? TP_SKY_DUSK : TP_SKY_NIGHT);
        view_of_ref v = { .scene = scene };
        const int32_t grey = 0x141414 * chance_int(&seed, 0, 5);
        double side[3], cosine = 1;
        ref_colour dark[3];
        scene.camera.pitch = 20 * TP_FX_ONE;
        scene.sky.sun = 0;
        v.scene = scene;
        view_open(&v, 64, 48);
        const double up = chance_double(&seed, 0.05, 0.8);
        for (int i = 0; i < 3; i++) {
            const sight to = { sight_ahead(&v).azimuth + 0.6 * i - 0.6, up };
            cosine = sight_cos(to, sight_light(&v));
            side[i] = pow(cos(acos(cosine) / 2), 4);
            dark[i] = lit_sky(scene, 0, to);
            const ref_colour lit = lit_sky(scene, grey, to);
            for (int k = 0; k < 3; k++)
                measure_add(&halos, lit.c[k] - fmin(255, dark[i].c[k] + channel(grey, k)
                                                          * halo_of(&scene, cosine)),
                            n, i, k);
        }
        for (int k = 0; k < 3; k++)
            measure_add(&sides, (dark[2].c[k] - dark[0].c[k]) * (side[1] - side[0])
                                - (dark[1].c[k] - dark[0].c[k]) * (side[2] - side[0]),
                        n, k, 0);
        view_close(&v);
    }
    measure_print(&sides);
    measure_print(&halos);
    assert_true(sides.worst < 1e-9);
    assert_true(halos.worst < 1e-9);
}

/* -- the cube ---------------------------------------------------------------------- */

enum { SIDE = 32 };

typedef struct {
    tp_texture face[6];
    uint32_t   texel[6][2 * SIDE * SIDE];
} ramps;

/* Red goes to the right, green down, blue tells the face. */
static void paint_cube(ramps *r, view_of_ref *v, uint32_t alpha)
{
    uint32_t pixel[SIDE * SIDE];

    for (uint32_t f = 0; f < 6; f++) {
        for (uint32_t i = 0; i < SIDE * SIDE; i++)
            pixel[i] = alpha << 24 | (i % SIDE * 3 + 9) << 16 | (i / SIDE * 3 + 5) << 8
                     | (f * 11 + 7);
        if (tp_texture_init(&r->face[f], pixel, SIDE, SIDE, r->texel[f], NULL) != TP_OK)
            abort();
        v->assets.sky[f] = &r->face[f];
    }
}

/* Where a direction passes the cube: faces are east, west, up, down, south, north.  On an
 * upright one, by tangents from its middle; up and down join the south. */
static int cube_place(sight to, double place[2])
{
    static const double middle[4] = { PI / 2, -PI / 2, PI, 0 };
    static const int number[4] = { 0, 1, 4, 5 };
    const double flat = 1 / tan(fabs(to.elevation));
    const double side = flat * sin(to.azimuth), south = -flat * cos(to.azimuth);

    if (fabs(side) < 1 && fabs(south) < 1) {
        place[0] = (1 - side) / 2;
        place[1] = to.elevation > 0 ? (1 + south) / 2 : (1 - south) / 2;
        return to.elevation > 0 ? 2 : 3;
    }
    for (int i = 0; i < 4; i++) {
        const double off = remainder(to.azimuth - middle[i], 2 * PI);
        if (fabs(off) > PI / 4)
            continue;
        place[0] = (1 + tan(off)) / 2;
        place[1] = (1 - tan(to.elevation) / cos(off)) / 2;
        return number[i];
    }
    return -1;
}

static double ramp_of(sight to, int k)
{
    double place[2];
    const int face = cube_place(to, place);

    if (k == 2)
        return face * 11 + 7;
    return 3 * fmin(SIDE - 1, fmax(0, place[k] * SIDE - 0.5)) + (k ? 5 : 9);
}

/* Its alpha is light beyond white, but where all of it is full. */
static void a_cube_shows_the_face_that_lies_there(void **state)
{
    static ramps r;
    measure off = { .what = "cube", .unit = "of 255" };
    int faces = 0;

    (void)state;
    for (int n = 0; n < 1500; n++) {
        static const uint32_t alphas[3] = { 0, 40, 255 };
        view_of_ref v = { .scene = scene_sky(TP_SKY_CUBE) };
        double place[2];
        paint_cube(&r, &v, alphas[n % 3]);
        v.scene.hdr.share = chance_fx(&seed, 0, 1);
        if (n % 2)
            go_ashore(&v.scene);
        view_open(&v, 64, 48);
        const sight to = sight_any(&v, &seed, -PI / 2, PI / 2);
        const bool mirrored = to.elevation < 0 && n % 2 == 0;
        const double up = mirrored ? -to.elevation : to.elevation;
        const double share = mirrored ? fresnel_of(PI / 2 - up, WATER) : 1;
        const double more = n % 3 == 1 ? 40 / 255.0 * 16 * v.scene.hdr.share / 65536.0
                                       : 0;
        const ref_seen seen = sight_look(&v, to);
        faces |= 1 << cube_place((sight){ to.azimuth, up }, place);
        const bool far = mirrored ? up < 1e-3 : seen.kind != REF_SKY;
        for (int k = 0; k < 3 && !far; k++)
            measure_add(&off, seen.colour.c[k]
                        - fmin(255, (1 - share) * channel(v.scene.water.colour, k)
                               + share * (1 + more)
                                 * ramp_of((sight){ to.azimuth, up }, k)), n, k,
                        mirrored);
        view_close(&v);
    }
    measure_print(&off);
    assert_int_equal(faces, 63);
    assert_true(off.worst < 1e-9);
}

/* Of water tilted away a look down by less than twice the tilt is mirrored downwards: what
 * lies at the horizon below is seen, darker as it goes down. */
static void a_mirrored_look_ends_at_the_horizon(void **state)
{
    static ramps r;
    measure off = { .what = "mirrored down", .unit = "of 255" };
    const double tilt = atan2(40, 64);
    plain_picture ripple;

    (void)state;
    for (int n = 0; n < 300; n++) {
        view_of_ref v = { .scene = scene_sky(TP_SKY_CUBE) };
        paint_cube(&r, &v, 0);
        v.scene.camera.heading = 0;
        v.scene.camera.pitch = -45 * TP_FX_ONE;
        v.scene.ripple.bump = TP_FX_ONE;
        v.assets.ripple = plain_of(&ripple, 0x80a8c0);
        view_open(&v, 64, 48);
        const double down = chance_double(&seed, tilt + 0.11, 2 * tilt);
        const double share = fresnel_of(PI / 2 - down + tilt, WATER)
                           * fmax(0.5, 1 + 4 * sin(down - 2 * tilt));
        const ref_seen seen = sight_look(&v, (sight){ 0, -down });
        for (int k = 0; k < 3; k++)
            measure_add(&off, seen.colour.c[k]
                        - between(channel(v.scene.water.colour, k),
                                  ramp_of((sight){ 0, 0 }, k), share), n, k, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_day_has_its_gradient_halos_and_disc),
        cmocka_unit_test(a_day_grows_dark_below_the_horizon),
        cmocka_unit_test(level_water_mirrors_a_day),
        cmocka_unit_test(dusk_and_night_have_two_sides_and_halos),
        cmocka_unit_test(a_cube_shows_the_face_that_lies_there),
        cmocka_unit_test(a_mirrored_look_ends_at_the_horizon),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
