/* SPDX-License-Identifier: MIT */
/* Checks the reference's light on level water against closed forms. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/reference_scenes.h"
#include "tools/reference/inside.h"
#include "tests/lib/measure.h"

/* Fresnel reflectance from the sines and tangents of the sum and the difference of the
 * angles; not for a look straight down. */
static double fresnel_by_angles(double i)
{
    const double t = asin(sin(i) / 1.333);
    return (pow(sin(i - t) / sin(i + t), 2) + pow(tan(i - t) / tan(i + t), 2)) / 2;
}

static void fresnels_share_is_that_of_the_angles(void **state)
{
    measure off = { .what = "Fresnel", .unit = "" };

    (void)state;
    for (int i = 1; i < 900; i++) {
        const double angle = i * PI / 1800;
        measure_add(&off,
                    ref_fresnel_reflectance(cos(angle), 1.333) - fresnel_by_angles(angle),
                    i, 0, 0);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-12);
    assert_true(fabs(ref_fresnel_reflectance(1, 1.333) - pow(0.333 / 2.333, 2)) < 1e-15);
    assert_true(fabs(ref_fresnel_reflectance(0, 1.333) - 1) < 1e-15);
    assert_true(fabs(ref_fresnel_reflectance(cos(0.7), 1 / 1.333)
                     - fresnel_by_angles(asin(1.333 * sin(0.7)))) < 1e-12);
}

/* Unit direction of the look through the pixel (u, v). */
static ref_vec way_of(const ref_camera *c, double u, double v)
{
    return ref_unit_vec(ref_plus(ref_plus(ref_times_vec(c->right, u - c->u0),
                                          ref_times_vec(c->up, c->v0 - v)),
                                 ref_times_vec(c->ahead, c->focal)));
}

static void level_water_mirrors_the_sky_by_fresnels_share(void **state)
{
    measure off = { .what = "mirror", .unit = "of 255" };
    view_of_ref v = { .scene = scene_level() };

    (void)state;
    v.scene.light.ambient = TP_FX_ONE;
    v.scene.camera.pitch = -40 * TP_FX_ONE;
    view_open(&v, 64, 48);
    for (uint32_t y = 0; y < 48; y++)
        for (uint32_t x = 0; x < 64; x++) {
            const ref_vec way = way_of(&v.ref.camera, x + 0.5, y + 0.5);
            if (way.y > -0.001)
                continue;
            const ref_seen seen = ref_look(&v.ref, x + 0.5, y + 0.5);
            const double left = 1 + way.y, share = fresnel_by_angles(acos(-way.y));
            for (int c = 0; c < 3; c++) {
                const double low = v.scene.sky.horizon >> (16 - 8 * c) & 255;
                const double high = v.scene.sky.zenith >> (16 - 8 * c) & 255;
                const double own = v.scene.water.colour >> (16 - 8 * c) & 255;
                const double sky = high + (low - high) * left * left;
                measure_add(&off, seen.colour.c[c] - own - (sky - own) * share, x, y, c);
            }
        }
    view_close(&v);
    measure_print(&off);
    assert_true(off.inputs > 5000);
    assert_true(off.worst < 1e-8);
}

/* -- through the water ------------------------------------------------------------- */

static tp_scene scene_clear(void)
{
    tp_scene s = scene_level();

    s.light.ambient = TP_FX_ONE;
    s.water.reflection = 0;
    s.water.clarity = 3 * TP_FX_ONE;
    s.floor.depth = 2 * TP_FX_ONE;
    s.camera.pitch = -35 * TP_FX_ONE;
    return s;
}

/* A floor at depth d is hit at the horizontal distance d tan t, with t by Snell's law; the
 * path in the water is d / cos t. */
static void the_floor_lies_where_snell_says(void **state)
{
    measure off = { .what = "floor", .unit = "m" };
    measure colour = { .what = "Beer", .unit = "of 255" };
    view_of_ref v = { .scene = scene_clear() };

    (void)state;
    view_open(&v, 64, 48);
    for (uint32_t y = 0; y < 48; y++) {
        const ref_vec way = way_of(&v.ref.camera, 20.5, y + 0.5);
        if (way.y > -0.02)
            continue;
        const double t = asin(sqrt(1 - way.y * way.y) / 1.333);
        ref_ray ray = { { 0, 0, 0 }, way };
        ref_solid floor;
        assert_true(ref_refracted(way, (ref_vec){ 0, 1, 0 }, REF_INDEX, &ray.way));
        assert_true(ref_solid_meets(&v.ref, &ray, REF_FLOOR, 0, 1e5, &floor));
        measure_add(&off, hypot(floor.at.x, floor.at.z) - 2 * tan(t), y, 0, 0);
        const ref_seen seen = ref_look(&v.ref, 20.5, y + 0.5);
        for (int c = 0; c < 3; c++) {
            const double tint = (v.scene.water.tint >> (16 - 8 * c) & 255) / 255.0;
            const double left = pow(tint, 2 / cos(t) / 3);
            const double own = v.scene.water.colour >> (16 - 8 * c) & 255;
            const double deep = 0.75 * (v.scene.water.deep_colour >> (16 - 8 * c) & 255)
                              + 0.25 * own;
            const double sand = channel(v.scene.floor.colour, c) * tint_of(&v.scene, c);
            measure_add(&colour, seen.colour.c[c] - deep - (sand - deep) * left, y, c, 0);
        }
    }
    view_close(&v);
    measure_print(&off);
    measure_print(&colour);
    assert_true(colour.inputs > 100);
    assert_true(off.worst < 1e-9);
    assert_true(colour.worst < 1e-9);
}

/* From below, the sky fills Snell's window of 48.6 degrees around the zenith; beyond the
 * window the surface mirrors the water alone. */
static void a_sunken_eye_sees_snells_window(void **state)
{
    view_of_ref v = { .scene = scene_clear() };

    (void)state;
    v.scene.floor.depth = 0;
    v.scene.camera.y = TP_FX(-0.5);
    v.scene.camera.pitch = 45 * TP_FX_ONE;
    v.scene.camera.fov = 80 * TP_FX_ONE;
    v.scene.water.clarity = 200 * TP_FX_ONE;
    view_open(&v, 64, 48);
    assert_true(v.ref.immersion);
    const ref_colour deep = ref_colour_unpack((uint32_t)v.scene.water.deep_colour);
    for (uint32_t y = 0; y < 48; y++) {
        const ref_vec way = way_of(&v.ref.camera, 32, y + 0.5);
        const double angle = acos(way.y) * 180 / PI;
        const ref_seen seen = ref_look(&v.ref, 32, y + 0.5);
        if (angle > 48.7)
            assert_true(fabs(seen.colour.c[2] - deep.c[2]) < 1e-9);
        else if (angle < 48)
            assert_true(seen.colour.c[2] > deep.c[2] + 20);
    }
    view_close(&v);
}

/* -- mirrored objects -------------------------------------------------------------- */

/* Level water mirrors the view of an eye as deep below the level as the camera is above. */
static void a_mirror_is_an_eye_below_the_level(void **state)
{
    static test_boat boat;
    uint64_t seed = random_seed();
    view_of_ref v = { .scene = scene_level() };
    int mirrored = 0;

    (void)state;
    boat_make(&boat, &seed);
    strcpy(v.scene.boat.mesh, "boat.obj");
    v.assets.boat = &boat.mesh;
    v.scene.boat.z = -12 * TP_FX_ONE;
    v.scene.boat.lift = TP_FX_ONE;
    v.scene.mirror.method = TP_MIRROR_STENCIL;
    v.scene.camera.pitch = -12 * TP_FX_ONE;
    view_open(&v, 96, 72);
    ref_scene *s = &v.ref;
    for (uint32_t y = 0; y < 72; y++)
        for (uint32_t x = 0; x < 96; x++) {
            const ref_vec way = way_of(&s->camera, x + 0.5, y + 0.5), e = s->camera.eye;
            const ref_ray below = { { e.x, -e.y, e.z }, { way.x, -way.y, way.z } };
            ref_vec at;
            if (way.y > -0.01 || ref_look(s, x + 0.5, y + 0.5).kind != REF_WATER)
                continue;
            const ref_seen want = ref_dry(s, &below, -e.y / way.y, 1e5, &at);
            const double share = ref_fresnel_reflectance(-way.y, REF_INDEX);
            ref_colour c = ref_scale(ref_colour_unpack((uint32_t)v.scene.water.colour),
                                     s->ambient + (1 - s->ambient) * s->light.y);
            c = ref_mix(c, want.colour, share);
            const ref_colour got = ref_look(s, x + 0.5, y + 0.5).colour;
            for (int k = 0; k < 3; k++)
                assert_true(fabs(got.c[k] - c.c[k]) < 1e-6);
            mirrored += want.kind == REF_BOAT;
        }
    view_close(&v);
    printf("    %d pixels of the boat mirrored\n", mirrored);
    assert_true(mirrored > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fresnels_share_is_that_of_the_angles),
        cmocka_unit_test(level_water_mirrors_the_sky_by_fresnels_share),
        cmocka_unit_test(the_floor_lies_where_snell_says),
        cmocka_unit_test(a_sunken_eye_sees_snells_window),
        cmocka_unit_test(a_mirror_is_an_eye_below_the_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
