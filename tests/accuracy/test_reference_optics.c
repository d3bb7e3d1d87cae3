/* SPDX-License-Identifier: MIT */
/* Checks the reference's light at the water's surface against closed forms: mirror, Fresnel
 * share, diffuse light, lobes, haze and exposure, on level water and on water tilted by a
 * normal map of one colour. All closed forms use angles; none uses a vector formula of the
 * reference. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/reference_scenes.h"

static uint64_t seed;

/* Normal map that tilts level water by whole texels, towards the north or the east. */
typedef struct {
    plain_picture picture;
    double        north, east;  /* tilt in radians; one of the two is 0 */
} tilt;

static void tilt_any(tilt *t, view_of_ref *v, bool north)
{
    const int32_t aside = chance_int(&seed, -70, 70), up = chance_int(&seed, 60, 127);
    const double angle = atan2(aside, up);

    *t = (tilt){ .north = north ? angle : 0, .east = north ? 0 : angle };
    v->scene.ripple.bump = TP_FX_ONE;
    v->assets.ripple = plain_of(&t->picture, 0x808080u + (uint32_t)up
                                             + ((uint32_t)aside << (north ? 8 : 16)));
}

/* Normal as a direction. */
static sight_angles tilt_normal(const tilt *t)
{
    return (sight_angles){ t->north != 0 ? 0 : PI / 2, PI / 2 - t->north - t->east };
}

static tp_scene scene_tilted(void)
{
    tp_scene s = scene_level();

    s.camera.pitch = -35 * TP_FX_ONE;
    s.camera.fov = 60 * TP_FX_ONE;
    s.light.ambient = TP_FX_ONE;
    s.water.colour = 0x204060;
    return s;
}

/* -- the mirror -------------------------------------------------------------------- */

/* Elevation of the mirrored ray for a look north, `down` radians below the horizontal. A
 * north tilt turns the ray by twice the tilt in the plane of both; an east tilt turns the
 * ray about the look's own axis. */
static double mirrored_up(const tilt *t, double down)
{
    return t->north != 0 ? down - 2 * t->north : asin(sin(down) * cos(2 * t->east));
}

/* Angle of incidence on the surface. */
static double met_at(const tilt *t, double down)
{
    return t->north != 0 ? fabs(PI / 2 - down + t->north) : acos(sin(down) * cos(t->east));
}

/* Fresnel share: Schlick's form [F2] for the indices 1 and 1.333, or the exact share. */
static double share_of(const tp_scene *s, double angle)
{
    const double straight = pow(0.333 / 2.333, 2);

    if (s->water.fresnel == TP_FRESNEL_SCHLICK)
        return straight + (1 - straight) * pow(1 - cos(angle), 5);
    return fresnel_of(angle, WATER);
}

/* Measures the mirror. A mirrored ray below the horizon meets water and is darker: at least
 * half as bright. */
static void measure_mirror(measure *off, const tilt *t, const view_of_ref *v, double down)
{
    const double up = mirrored_up(t, down), angle = met_at(t, down);
    const ref_seen seen = sight_look(v, (sight_angles){ 0, -down });
    const double part = v->scene.water.reflection / 65536.0
                      * fmin(1, fmax(0.5, 1 + 4 * sin(up)));

    if (cos(angle) < 0.101 || PI / 2 - down + t->north > PI / 2)
        return;                 /* seen from behind, or clamped: tested below */
    for (int k = 0; k < 3; k++)
        measure_add(off, seen.colour.c[k] - between(channel(v->scene.water.colour, k),
                                                    gradient_of(&v->scene, up, k),
                                                    part * share_of(&v->scene, angle)),
                    (int64_t)(down * 1000), (int64_t)((t->north + t->east) * 1000), k);
}

static void tilted_water_mirrors_by_twice_its_tilt(void **state)
{
    (void)state;
    for (int rule = 0; rule < 2; rule++) {
        measure off = { .what = rule ? "Schlick" : "Fresnel", .unit = "of 255" };
        for (int n = 0; n < 400; n++) {
            view_of_ref v = { .scene = scene_tilted() };
            tilt t;
            v.scene.water.fresnel = rule ? TP_FRESNEL_SCHLICK : TP_FRESNEL_TABLE;
            v.scene.water.reflection = chance_fx(&seed, 0, 1);
            tilt_any(&t, &v, n % 2);
            view_open(&v, 64, 48);
            for (int k = 0; k < 10; k++)
                measure_mirror(&off, &t, &v, chance_double(&seed, 0.15, 1.1));
            view_close(&v);
        }
        measure_print(&off);
        assert_true(off.inputs > 5000);
        assert_true(off.worst < 1e-10);
    }
}

/* Under a sky of one colour only the Fresnel share is seen. The share's cosine is clamped
 * to at least 0.1, also where the water is seen from behind. */
static void the_share_of_rippled_water_is_held(void **state)
{
    measure off = { .what = "held share", .unit = "of 255" };
    view_of_ref v = { .scene = scene_tilted() };
    plain_picture picture;
    const double held = fresnel_of(acos(0.1), WATER);

    (void)state;
    v.scene.sky.horizon = v.scene.sky.zenith = 0xf0d0b0;
    v.assets.ripple = plain_of(&picture, 0x80e4c0);     /* tilted 57 degrees to the north */
    v.scene.ripple.bump = TP_FX_ONE;
    view_open(&v, 64, 48);
    for (int n = 0; n < 100; n++) {
        const double down = chance_double(&seed, 0.15, 1);
        const ref_seen seen = sight_look(&v, (sight_angles){ 0, -down });
        const double up = asin(-sin(down) + 0.2 * cos(atan2(100, 64)));
        for (int k = 0; k < 3; k++)
            measure_add(&off, seen.colour.c[k]
                        - between(channel(v.scene.water.colour, k),
                                  channel(v.scene.sky.zenith, k),
                                  held * fmin(1, fmax(0.5, 1 + 4 * sin(up)))), n, k, 0);
    }
    view_close(&v);
    measure_print(&off);
    assert_true(off.worst < 1e-10);
}

/* -- the light --------------------------------------------------------------------- */

static void any_light(view_of_ref *v)
{
    v->scene.light.heading = chance_fx(&seed, -180, 180);
    v->scene.light.elevation = chance_fx(&seed, 1, 90);
    v->scene.light.colour = chance_int(&seed, 0, 0xffffff);
}

static void water_is_lit_by_the_cosine_of_its_tilt(void **state)
{
    measure off = { .what = "lit", .unit = "of 255" };
    int dark = 0;

    (void)state;
    for (int n = 0; n < 400; n++) {
        view_of_ref v = { .scene = scene_tilted() };
        tilt t;
        v.scene.light.ambient = chance_fx(&seed, 0, 1);
        v.scene.water.reflection = 0;
        any_light(&v);
        tilt_any(&t, &v, n % 2);
        view_open(&v, 64, 48);
        const double cosine = sight_cos(tilt_normal(&t), sight_light(&v));
        const ref_seen seen = sight_look(&v, sight_any(&v, &seed, -PI / 2, -0.1));
        dark += cosine < 0;
        for (int k = 0; k < 3; k++)
            measure_add(&off, seen.colour.c[k] - channel(v.scene.water.colour, k)
                                                     * lit_of(&v.scene, cosine), n, k, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(dark > 5);
    assert_true(off.worst < 1e-10);
}

/* Specular lobe for a look north on water tilted north. Phong: by the mirrored ray, or the
 * straight ray where the water is seen from behind. Blinn: by the half vector, with length
 * 2 cos(half the angle between light and eye). */
static double lobe_of(const view_of_ref *v, const tilt *t, double down)
{
    const double power = v->scene.water.shininess / TP_FX_ONE;
    const sight_angles light = sight_light(v), eye = { PI, down }, n = tilt_normal(t);
    const sight_angles mirrored = { 0, fmax(-down, down - 2 * t->north) };
    const double half = acos(sight_cos(light, eye)) / 2;

    if (sight_cos(n, light) <= 0)
        return 0;
    if (v->scene.light.model == TP_LIGHT_BLINN)
        return pow(fmax(0, (sight_cos(n, light) + sight_cos(n, eye))
                           / (2 * cos(half))), 4 * power);
    return pow(fmax(0, sight_cos(mirrored, light)), power);
}

static void glints_are_the_lobes_of_their_angles(void **state)
{
    (void)state;
    for (int model = 0; model < 2; model++) {
        measure off = { .what = model ? "Blinn" : "Phong", .unit = "of 255" };
        int bright = 0;
        for (int n = 0; n < 3000; n++) {
            view_of_ref v = { .scene = scene_tilted() };
            tilt t;
            const double down = chance_double(&seed, 0.15, 1.1);
            v.scene.water.reflection = 0;
            v.scene.water.specular = chance_fx(&seed, 0.2, 2);
            v.scene.water.shininess = chance_int(&seed, 1, 60) * TP_FX_ONE + 1234;
            v.scene.light.model = model ? TP_LIGHT_BLINN : TP_LIGHT_PHONG;
            any_light(&v);
            tilt_any(&t, &v, true);
            view_open(&v, 64, 48);
            const double share = fmin(1, v.scene.water.specular / 65536.0
                                             * lobe_of(&v, &t, down));
            const ref_seen seen = sight_look(&v, (sight_angles){ 0, -down });
            bright += share > 0.3;
            for (int k = 0; k < 3; k++)
                measure_add(&off, seen.colour.c[k]
                            - fmin(255, channel(v.scene.water.colour, k)
                                   + share * channel(v.scene.light.colour, k)), n, k, 0);
            view_close(&v);
        }
        measure_print(&off);
        printf("    %d of 3000 bright\n", bright);
        assert_true(bright > 50);
        assert_true(off.worst < 1e-10);
    }
}

/* -- air and camera ---------------------------------------------------------------- */

/* Haze: the share z^2 / (z^2 + h^2) at depth z. z is the eye's height over the sine of the
 * look, times the cosine of the angle to the camera's axis. */
static void air_mixes_the_horizon_in_by_depth(void **state)
{
    measure off = { .what = "haze", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 300; n++) {
        view_of_ref v = { .scene = scene_tilted() };
        v.scene.water.reflection = 0;
        v.scene.sky.haze = chance_scale(&seed, 2, 2000);
        v.scene.camera.heading = chance_fx(&seed, -180, 180);
        view_open(&v, 64, 48);
        const sight_angles s = sight_any(&v, &seed, -PI / 2, -0.1);
        const double z = v.world->eye.y / 65536.0 / -sin(s.elevation)
                       * sight_cos(s, sight_ahead(&v));
        const double h = v.scene.sky.haze / 65536.0;
        const ref_seen seen = sight_look(&v, s);
        for (int k = 0; k < 3; k++)
            measure_add(&off, seen.colour.c[k]
                        - between(channel(v.scene.water.colour, k),
                                  channel(v.scene.sky.horizon, k),
                                  1 / (1 + h / z * (h / z))), n, k, 0);
        measure_add(&off, 255 * (seen.near * z - 1), n, 3, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-10);
}

/* Exposure curve E t / (1 + (E - 1) t^k) with k = 1 where E brightens and k = 4 where E
 * darkens: white stays white, black stays black, and dark tones become E times as
 * bright. */
static void exposure_bends_between_black_and_white(void **state)
{
    measure off = { .what = "exposure", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 300; n++) {
        view_of_ref v = { .scene = scene_level() };
        v.scene.hdr.exposure_factor = chance_scale(&seed, 0.125, 8);
        v.scene.camera.pitch = 20 * TP_FX_ONE;
        view_open(&v, 64, 48);
        const double e = v.scene.hdr.exposure_factor / 65536.0;
        const double up = chance_double(&seed, 0, 0.7);
        const ref_seen seen = sight_look(&v, (sight_angles){ 0, up });
        for (int k = 0; k < 3; k++) {
            const double t = gradient_of(&v.scene, up, k) / 255;
            const double most = e > 1 ? t : pow(t, 4);
            measure_add(&off, seen.colour.c[k] / 255
                              - 1 / ((1 - most) / (e * t) + most / t), n, k, 0);
        }
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tilted_water_mirrors_by_twice_its_tilt),
        cmocka_unit_test(the_share_of_rippled_water_is_held),
        cmocka_unit_test(water_is_lit_by_the_cosine_of_its_tilt),
        cmocka_unit_test(glints_are_the_lobes_of_their_angles),
        cmocka_unit_test(air_mixes_the_horizon_in_by_depth),
        cmocka_unit_test(exposure_bends_between_black_and_white),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
