/* SPDX-License-Identifier: MIT */
/* Checks the reference's objects of water against closed forms: a tank behind glass, a drop
 * as a ball. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/reference_scenes.h"

static uint64_t seed;

/* -- a tank ------------------------------------------------------------------------ */

#define HALF 4.0                /* half side, m; the eye is as far before the glass */

static tp_scene scene_tank(void)
{
    tp_scene s = scene_clear_any(&seed);

    s.pool.cols = s.pool.rows = 32;
    s.pool.cell = TP_FX(0.25);
    s.grid.vertices = 1089;
    s.tank.sea = 0;
    s.tank.kind = TP_TANK_GLASS;
    s.tank.depth = chance_scale(&seed, 1, 6);
    s.tank.rim = TP_FX(1.5);
    s.tank.tile = chance_scale(&seed, 0.5, 4);
    s.tank.glass = chance_fx(&seed, 0, 1);
    s.camera.z = 8 * TP_FX_ONE;
    s.camera.x = chance_fx(&seed, -3, 3);
    s.camera.y = chance_fx(&seed, -1.5, 1.5);
    s.camera.pitch = 0;
    s.camera.fov = 100 * TP_FX_ONE;
    return s;
}

/* Colour in the water for a look `up` radians above the horizontal that meets the glass at
 * `height`. A ray that meets the surface from below continues as its mirror image. */
static double side_of(const view_of_ref *v, const noise_picture *p, double height,
                      double up, int k)
{
    const double depth = v->scene.tank.depth / 65536.0, steep = asin(sin(up) / WATER);
    const double wall = height + 2 * HALF * tan(steep);
    const double tile = v->scene.tank.tile / 65536.0, x = v->world->eye.x / 65536.0;
    const double deep = channel(v->scene.water.deep_colour, k);
    const double fall = steep > 0 ? depth - height : depth + height;
    const double across = fall / tan(fabs(steep));
    double seen;

    if (fabs(wall) < depth) {
        seen = tents_of(p, x / tile, fabs(wall) / tile, k) / 255
             * channel(v->scene.tank.wall_colour, k) * tint_of(&v->scene, k)
             * lit_of(&v->scene, wet_cos(v, (sight_angles){ PI, 0 }));
        return beer_of(&v->scene, seen, deep, 2 * HALF / cos(steep), k);
    }
    seen = tents_of(p, x / tile, (HALF - across) / tile, k) / 255
         * channel(v->scene.tank.floor_colour, k) * tint_of(&v->scene, k)
         * lit_of(&v->scene, wet_cos(v, (sight_angles){ 0, PI / 2 }));
    return beer_of(&v->scene, seen, deep, hypot(fall, across), k);
}

/* Colour above the water: the far wall's dry inner side, or the sky above the wall. NAN:
 * neither of the two. */
static double above_of(const view_of_ref *v, const noise_picture *p, double height,
                       double up, int k)
{
    const double wall = height + 2 * HALF * tan(up), tile = v->scene.tank.tile / 65536.0;
    const double rim = v->scene.tank.rim / 65536.0;

    if (wall > rim && height < rim)
        return gradient_of(&v->scene, up, k);
    if (!(wall > 0 && wall < rim))
        return (double)NAN;
    return tents_of(p, v->world->eye.x / 65536.0 / tile, -wall / tile, k) / 255
         * channel(v->scene.tank.wall_colour, k) * tint_of(&v->scene, k)
         * lit_of(&v->scene, sight_cos((sight_angles){ PI, 0 }, sight_light(v)));
}

/* The glass has a colour of its own and mirrors the sky behind the eye. */
static void a_tank_is_seen_through_its_glass(void **state)
{
    measure wet = { .what = "behind glass", .unit = "of 255" };
    measure dry = { .what = "above water", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 1200; n++) {
        static noise_picture p;
        view_of_ref v = { .scene = scene_tank() };
        v.assets.tank_wall = v.assets.tank_floor = noise_of(&p, &seed);
        view_open(&v, 64, 48);
        const double up = chance_double(&seed, -0.7, 0.7);
        const double height = v.world->eye.y / 65536.0 + HALF * tan(up);
        const double low = -v.scene.tank.depth / 65536.0;
        const double share = v.scene.tank.glass / 65536.0;
        const double rim = v.scene.tank.rim / 65536.0;
        const ref_seen seen = sight_look(&v, (sight_angles){ 0, up });
        for (int k = 0; k < 3 && height > low && height < rim; k++) {
            const double c = height < 0 ? side_of(&v, &p, height, up, k)
                                        : above_of(&v, &p, height, up, k);
            const double own = between(c, channel(v.scene.tank.glass_colour, k), share);
            if (!isnan(c))
                measure_add(height < 0 ? &wet : &dry, seen.colour.c[k]
                            - between(own, gradient_of(&v.scene, up, k),
                                      fresnel_of(fabs(up), WATER)), n, k, 0);
        }
        view_close(&v);
    }
    measure_print(&wet);
    measure_print(&dry);
    assert_true(wet.inputs > 1000 && dry.inputs > 300);
    assert_true(wet.worst < 1e-8 && dry.worst < 1e-8);
}

/* The glass mirrors the south side of a sky with another colour on each side. */
static void glass_mirrors_what_is_behind_the_eye(void **state)
{
    measure off = { .what = "mirror of glass", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 200; n++) {
        plain_picture side[TP_FACES];
        view_of_ref v = { .scene = scene_tank() };
        for (int i = 0; i < TP_FACES; i++)
            v.assets.sky[i] = plain_of(&side[i], 0x201008u * (uint32_t)(i + 1));
        v.scene.sky.kind = TP_SKY_CUBE;
        v.scene.tank.glass = TP_FX_ONE;
        view_open(&v, 64, 48);
        const double up = chance_double(&seed, -0.2, 0.2);
        const double height = v.world->eye.y / 65536.0 + HALF * tan(up);
        const ref_seen seen = sight_look(&v, (sight_angles){ 0, up });
        for (int k = 0; k < 3 && height > -1 && height < 1; k++)
            measure_add(&off, seen.colour.c[k]
                        - between(channel(v.scene.tank.glass_colour, k),
                                  channel(5 * 0x201008, k), fresnel_of(fabs(up), WATER)),
                        n, k, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.inputs > 200);
    assert_true(off.worst < 1e-9);
}

/* -- a drop ------------------------------------------------------------------------ */

/* Surroundings of a drop: the sky, and below the horizon the lit water with a quarter of
 * the sky. */
static double around_of(const tp_scene *s, double height, double lit, int k)
{
    const double sky = gradient_of(s, fmax(0, height), k);
    const double water = between(channel(s->water.colour, k) * lit, sky, 0.25);

    return between(sky, water, fmin(1, fmax(0, -4 * sin(height))));
}

/* A look meets the ball at an angle i; sin i is the distance of the ray from the centre, in
 * radii. The refracted ray is turned by 2 (i - r) towards the centre, the mirrored ray by
 * 180 - 2 i degrees away from the centre. */
static void a_drop_turns_light_as_a_ball_does(void **state)
{
    measure off = { .what = "drop", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 1500; n++) {
        view_of_ref v = { .scene = scene_clear_any(&seed) };
        v.scene.drops.count = 1;
        v.scene.drops.radius = TP_FX_ONE;
        v.scene.drops.y = 4 * TP_FX_ONE;
        v.scene.drops.z = -8 * TP_FX_ONE;
        v.scene.camera.y = chance_fx(&seed, 3, 5);
        v.scene.camera.pitch = 0;
        if (n % 2)
            v.scene.light.heading = chance_fx(&seed, 170, 190);
        view_open(&v, 64, 48);
        const double rise = 4 - v.world->eye.y / 65536.0, middle = atan2(rise, 8);
        const double pass = chance_double(&seed, -0.999, 0.999);    /* of the radius, 2 m */
        const double up = middle + asin(pass * 2 / hypot(8, rise));
        const double i = asin(pass), r = asin(pass / WATER);
        const sight_angles mirrored = { 0, up + (i > 0 ? PI : -PI) - 2 * i };
        const sight_angles normal = { 0, up + (i > 0 ? PI : -PI) - i };
        const double lit = lit_of(&v.scene, sin(sight_light(&v).elevation));
        const double glint = sight_cos(normal, sight_light(&v)) > 0
                           ? pow(fmax(0, sight_cos(mirrored, sight_light(&v))), 40) : 0;
        const ref_seen seen = sight_look(&v, (sight_angles){ 0, up });
        assert_int_equal(seen.kind, REF_DROP);
        for (int k = 0; k < 3; k++) {
            const double on = around_of(&v.scene, asin(sin(up - 2 * (i - r))), lit, k)
                            * channel(v.scene.drops.colour, k) / 255;
            const double back = around_of(&v.scene, asin(sin(mirrored.elevation)), lit,
                                          k);
            measure_add(&off, seen.colour.c[k]
                        - fmin(255, between(on, back, fresnel_of(fabs(i), WATER))
                               + glint * channel(v.scene.light.colour, k)), n, k, 0);
        }
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tank_is_seen_through_its_glass),
        cmocka_unit_test(glass_mirrors_what_is_behind_the_eye),
        cmocka_unit_test(a_drop_turns_light_as_a_ball_does),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
