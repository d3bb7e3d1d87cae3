/* SPDX-License-Identifier: MIT */
/* The tank's floor and walls, seen through the surface and through the glass, compared with
 * rays in double precision: the borders of floor and walls are right to a pixel. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/water_ray.h"
#include "tests/lib/measure.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

enum { WIDE = 320, HIGH = 240 };

static uint64_t chance;

/* A tank of 3 x 2 x 1.1 m: a red floor, black walls and sky, water of the greatest
 * clarity. */
static tp_scene tank_scene(void)
{
    tp_scene s;

    tp_scene_level(&s);
    s.pool.cols = 48;
    s.pool.rows = 32;
    s.pool.cell = TP_FX_ONE / 16;
    s.grid.vertices = 1617;
    s.tank.sea = 0;
    s.tank.kind = TP_TANK_GLASS;
    s.tank.depth = TP_FX(1.1);
    s.tank.rim = TP_FX(0.05);
    s.tank.floor_colour = 0xff0000;
    s.tank.wall_colour = 0;
    s.tank.glass = 0;
    s.water.clarity = 200 * TP_FX_ONE;
    s.water.tint = 0xffffff;
    s.water.deep_colour = 0;
    s.water.colour = 0;
    s.water.specular = s.water.reflection = 0;
    s.light.ambient = TP_FX_ONE;
    s.sky.horizon = s.sky.zenith = 0;
    s.sky.haze = 0;
    s.camera.near = TP_FX(0.1);
    return s;
}

static const ref_water_box box = { -1.5, 1.5, -1, 1, 1.1 };

/* Puts the camera at a point outside, looking at the middle of the water. */
static void look_from(tp_scene *s, double x, double y, double z)
{
    const double level = sqrt(x * x + z * z), turn = 180 / 3.14159265358979;

    s->camera.x = (tp_fx)(x * 65536);
    s->camera.y = (tp_fx)(y * 65536);
    s->camera.z = (tp_fx)(z * 65536);
    s->camera.heading = (tp_fx)(atan2(-x, z) * turn * 65536);
    s->camera.pitch = (tp_fx)(atan2(-0.4 - y, level) * turn * 65536);
    s->camera.fov = 45 * TP_FX_ONE;
}

static void picture_of(const tp_scene *s, uint32_t *pixels)
{
    const tp_assets assets = { 0 };
    const tp_config c = {
        .width = WIDE, .height = HIGH, .tile_height = HIGH, .format = TP_FORMAT_XRGB8888
    };
    tp_world  *world = scene_world(s, &assets);
    test_frame f = frame_of(s, &assets, &c);
    tp_tile    tile;

    tp_frame_begin(f.frame, world);
    assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
    memcpy(pixels, tile.pixels, WIDE * HIGH * sizeof *pixels);
    assert_true(frame_guard_holds(f.block, f.bytes));
    frame_free(&f);
    free(world);
}

static ref_camera camera_of(const tp_scene *s)
{
    return ref_camera_make((tp_vec3){ s->camera.x, s->camera.y, s->camera.z },
                         tp_turn_of_degrees(s->camera.heading),
                         tp_turn_of_degrees(s->camera.pitch), s->camera.fov,
                         s->camera.near, WIDE, HIGH);
}

/* True if all nine rays within a pixel see the same part. */
static bool is_sure(const ref_camera *c, int x, int y, double index, ref_sight view)
{
    for (int k = 0; k < 9; k++)
        if (ref_look_into(&box, c->eye, ref_pixel_ray(c, x + k % 3 - 1, y + k / 3 - 1),
                          index) != view)
            return false;
    return true;
}

typedef struct {
    int sights[6];              /* pixels with a sure result, by ref_sight */
    int wrong;
} sight_tally;

/* Compares the picture: a floor is bright in the channel `shift`, walls are dark.  If `top`
 * is set, only parts seen through the surface count. */
static void compare(const tp_scene *s, int shift, double index, bool top, sight_tally *t)
{
    static uint32_t pixels[WIDE * HIGH];
    const ref_camera c = camera_of(s);

    picture_of(s, pixels);
    for (int y = 1; y < HIGH - 1; y++)
        for (int x = 1; x < WIDE - 1; x++) {
            const ref_sight view = ref_look_into(&box, c.eye, ref_pixel_ray(&c, x, y),
                                                  index);
            const uint32_t p = pixels[y * WIDE + x];
            const bool floor = (p >> shift & 0xff) > 4;
            if (view == REF_OUTSIDE || view == REF_SIDE_UP
                || (top && view != REF_TOP_FLOOR && view != REF_TOP_WALL)
                || !is_sure(&c, x, y, index, view))
                continue;
            t->sights[view]++;
            t->wrong += floor != (view == REF_TOP_FLOOR || view == REF_SIDE_FLOOR);
        }
}

static void walls_stand_where_rays_say(void **state)
{
    (void)state;
    sight_tally t = { { 0 }, 0 };

    for (int n = 0; n < 24; n++) {
        tp_scene s = tank_scene();
        const double r = chance_double(&chance, 2.6, 5);
        double a, x, z;
        do {                    /* not along a pane, where the pane reflects all light */
            a = chance_double(&chance, 0, 6.2832);
            x = r * sin(a);
            z = r * cos(a);
        } while (fabs(fabs(x) - box.x1) < 0.2 || fabs(fabs(z) - box.z1) < 0.2);
        look_from(&s, x, chance_double(&chance, n % 4 ? 0.3 : -0.6, 3.5), z);
        compare(&s, 16, 1.333, false, &t);
    }
    printf("    top: %d floor, %d wall; glass: %d floor, %d wall; %d wrong\n",
           t.sights[REF_TOP_FLOOR], t.sights[REF_TOP_WALL], t.sights[REF_SIDE_FLOOR],
           t.sights[REF_SIDE_WALL], t.wrong);
    for (int k = REF_TOP_FLOOR; k <= REF_SIDE_WALL; k++)
        assert_true(t.sights[k] > 10000);
    assert_int_equal(t.wrong, 0);
}

/* With a white floor between black walls each channel has an edge of its own. */
static void each_colour_bends_by_its_own_index(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        sight_tally t = { { 0 }, 0 };
        for (int n = 0; n < 4; n++) {
            tp_scene s = tank_scene();
            s.tank.floor_colour = 0xffffff;
            s.water.dispersion = TP_FX(0.2);
            look_from(&s, 1.2 * n - 2, 3.2, 2.2);
            compare(&s, 16 - 8 * k, 1.333 + 0.1 * (k - 1), true, &t);
        }
        printf("    channel %d: %d floor, %d wall, %d wrong\n", k,
               t.sights[REF_TOP_FLOOR], t.sights[REF_TOP_WALL], t.wrong);
        assert_true(t.sights[REF_TOP_FLOOR] > 1000 && t.sights[REF_TOP_WALL] > 1000);
        assert_true(t.wrong == 0);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_stand_where_rays_say),
        cmocka_unit_test(each_colour_bends_by_its_own_index),
    };
    return cmocka_run_group_tests_name("features/tank", tests, NULL, NULL);
}
