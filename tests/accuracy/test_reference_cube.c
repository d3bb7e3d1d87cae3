/* SPDX-License-Identifier: MIT */
/* Checks the reference's cube map sky against closed forms: seen directly and mirrored,
 * with highlights brighter than white. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/reference_scenes.h"

static uint64_t seed;

enum { SIDE = 32 };

typedef struct {
    tp_texture face[6];
    uint32_t   texel[6][2 * SIDE * SIDE];
} ramps;

/* Paints the six faces: red grows to the right, green downwards, blue is the number of the
 * face. */
static void paint_cube(ramps *r, view_of_ref *v, uint32_t alpha)
{
    uint32_t pixel[SIDE * SIDE];

    for (uint32_t f = 0; f < 6; f++) {
        for (uint32_t i = 0; i < SIDE * SIDE; i++)
            pixel[i] = alpha << 24 | (i % SIDE * 3 + 9) << 16 | (i / SIDE * 3 + 5) << 8
                     | (f * 11 + 7);
        if (tp_texture_init(&r->face[f], pixel, SIDE, SIDE, r->texel[f],
                            tp_texture_bytes(SIDE, SIDE), NULL)
            != TP_OK)
            abort();
        v->assets.sky[f] = &r->face[f];
    }
}

/* Returns the face that a direction passes, and the place on the face. Faces: east, west,
 * up, down, south, north. On an upright face the place is given by tangents from the face's
 * middle; up and down join the south face. */
static int cube_place(sight_angles to, double place[2])
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

static double ramp_of(sight_angles to, int k)
{
    double place[2];
    const int face = cube_place(to, place);

    if (k == 2)
        return face * 11 + 7;
    return 3 * fmin(SIDE - 1, fmax(0, place[k] * SIDE - 0.5)) + (k ? 5 : 9);
}

/* Alpha is brightness above white, unless alpha is full everywhere. */
static void a_cube_shows_the_face_that_lies_there(void **state)
{
    static ramps r;
    measure off = { .what = "cube", .unit = "of 255" };
    int faces = 0;

    (void)state;
    for (int n = 0; n < 1500; n++) {
        static const uint32_t alphas[3] = { 0, 40, 255 };
        view_of_ref v = { .scene = scene_sky(&seed, TP_SKY_CUBE) };
        double place[2];
        paint_cube(&r, &v, alphas[n % 3]);
        v.scene.hdr.share = chance_fx(&seed, 0, 1);
        if (n % 2)
            go_ashore(&v.scene);
        view_open(&v, 64, 48);
        const sight_angles to = sight_any(&v, &seed, -PI / 2, PI / 2);
        const bool mirrored = to.elevation < 0 && n % 2 == 0;
        const double up = mirrored ? -to.elevation : to.elevation;
        const double share = mirrored ? fresnel_of(PI / 2 - up, WATER) : 1;
        const double more = n % 3 == 1 ? 40 / 255.0 * 16 * v.scene.hdr.share / 65536.0
                                       : 0;
        const ref_seen seen = sight_look(&v, to);
        faces |= 1 << cube_place((sight_angles){ to.azimuth, up }, place);
        const bool far = mirrored ? up < 1e-3 : seen.kind != REF_SKY;
        for (int k = 0; k < 3 && !far; k++)
            measure_add(&off, seen.colour.c[k]
                        - fmin(255, (1 - share) * channel(v.scene.water.colour, k)
                               + share * (1 + more)
                                 * ramp_of((sight_angles){ to.azimuth, up }, k)), n, k,
                        mirrored);
        view_close(&v);
    }
    measure_print(&off);
    assert_int_equal(faces, 63);
    assert_true(off.worst < 1e-9);
}

/* On water tilted away from the eye a shallow look (less than twice the tilt below the
 * horizontal) is mirrored downwards. The mirror then shows the colour at the horizon below
 * the direction, darker the farther the direction points down. */
static void a_mirrored_look_ends_at_the_horizon(void **state)
{
    static ramps r;
    measure off = { .what = "mirrored down", .unit = "of 255" };
    const double tilt = atan2(40, 64);
    plain_picture ripple;

    (void)state;
    for (int n = 0; n < 300; n++) {
        view_of_ref v = { .scene = scene_sky(&seed, TP_SKY_CUBE) };
        paint_cube(&r, &v, 0);
        v.scene.camera.heading = 0;
        v.scene.camera.pitch = -45 * TP_FX_ONE;
        v.scene.ripple.bump = TP_FX_ONE;
        v.assets.ripple = plain_of(&ripple, 0x80a8c0);
        view_open(&v, 64, 48);
        const double down = chance_double(&seed, tilt + 0.11, 2 * tilt);
        const double share = fresnel_of(PI / 2 - down + tilt, WATER)
                           * fmax(0.5, 1 + 4 * sin(down - 2 * tilt));
        const ref_seen seen = sight_look(&v, (sight_angles){ 0, -down });
        for (int k = 0; k < 3; k++)
            measure_add(&off, seen.colour.c[k]
                        - between(channel(v.scene.water.colour, k),
                                  ramp_of((sight_angles){ 0, 0 }, k), share), n, k, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cube_shows_the_face_that_lies_there),
        cmocka_unit_test(a_mirrored_look_ends_at_the_horizon),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
