/* SPDX-License-Identifier: MIT */
/* Contents of a frame: sky above the horizon and water below in every pixel; the boat where
 * no water hides the boat. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/frame.h"
#include "frame/tools.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

enum { WIDTH = 150, HEIGHT = 90 };

static uint64_t chance;
static test_boat boat;

typedef struct {
    uint32_t sky, water, solid;
} marks;

/* Counts stencil values in rows [from, to), or in the whole picture, of a frame drawn as
 * one tile. */
static marks marks_of(const test_frame *f, uint32_t from, uint32_t to)
{
    const uint32_t *key = (const uint32_t *)(const void *)f->scratch;
    marks m = { 0, 0, 0 };

    for (uint32_t i = from * WIDTH; i < to * WIDTH; i++) {
        m.sky += TP_MARK(key[i]) == TP_MARK_SKY;
        m.water += TP_MARK(key[i]) == TP_MARK_WATER;
        m.solid += TP_MARK(key[i]) >= TP_MARK_SOLID;
    }
    return m;
}

static tp_scene calm_scene(void)
{
    tp_scene s = scene_plain();

    for (int i = 0; i < TP_WAVES; i++)
        s.wave[i].amplitude = 0;
    s.camera.pitch = 0;
    return s;
}

/* Row of the horizon, counted from the top: level water seen from the camera's height ends
 * `far` m away. */
static double horizon_row(const tp_scene *s, double far)
{
    const double half = s->camera.fov / 65536.0 / 2 * 3.14159265358979 / 180;
    const double pitch = s->camera.pitch / 65536.0 * 3.14159265358979 / 180;
    const double dip = atan(s->camera.y / 65536.0 / far);
    return HEIGHT / 2.0 * (1 + tan(pitch + dip) / tan(half));
}

/* Calm water, level or tilted camera, any heading: sky above the horizon, water below, no
 * holes.  The grid ends between 16 km and its corner, and the eye is 1/10 from its rear;
 * all columns of a grid line share one row. */
static void calm_water_fills_everything_below_the_horizon(void **state)
{
    (void)state;
    const tp_config config = {
        .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = TP_FORMAT_P8
    };
    const tp_assets none = { 0 };

    for (int n = 0; n < 150; n++) {
        tp_scene scene = calm_scene();
        tp_world world;
        tp_tile tile;
        scene.camera.x = chance_fx(&chance, -8000, 8000);
        scene.camera.z = chance_fx(&chance, -8000, 8000);
        scene.camera.y = chance_scale(&chance, 0.5, 30);
        scene.camera.heading = chance_fx(&chance, -720, 720);
        scene.camera.pitch = chance_fx(&chance, -20, 20);
        scene.camera.near = TP_FX(0.05);
        test_frame f = frame_of(&scene, &none, &config);
        tp_world_init(&tp_program_all, &world, sizeof world, &scene, NULL, NULL);
        tp_frame_begin(f.frame, &world);
        assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
        /* The grid's edge is a straight line in the world: in the picture the edge bends by
         * no more than the dip of its nearest point, at 15 km. */
        const double first = horizon_row(&scene, 40000),
                     last = horizon_row(&scene, 15000);
        const uint32_t sky = (uint32_t)fmax(0, fmin(HEIGHT, floor(first - 0.6)));
        const uint32_t sea = (uint32_t)fmax(0, fmin(HEIGHT, ceil(last + 0.6)));
        assert_int_equal(marks_of(&f, 0, sky).sky, sky * WIDTH);
        assert_int_equal(marks_of(&f, sea, HEIGHT).water, (HEIGHT - sea) * WIDTH);
        assert_int_equal(tp_frame_water_pixels(f.frame, f.scratch, &tile),
                         marks_of(&f, 0, HEIGHT).water);
        frame_free(&f);
    }
}

/* With waves the horizon is ragged, but no pixel slightly below shows the sky: neighbouring
 * triangles leave no gap, clipped triangles neither. */
static void waves_leave_no_holes(void **state)
{
    (void)state;
    const tp_config config = {
        .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = TP_FORMAT_P8
    };
    const tp_assets none = { 0 };

    for (int n = 0; n < 150; n++) {
        tp_scene scene = calm_scene();
        tp_world world;
        tp_tile tile;
        for (int i = 0; i < 3; i++) {
            scene.wave[i].amplitude = chance_scale(&chance, 0.02, 0.5);
            scene.wave[i].length = chance_scale(&chance, 4, 60);
            scene.wave[i].steepness = TP_FX(0.3);
            scene.wave[i].heading = chance_fx(&chance, 0, 360);
        }
        scene.camera.y = chance_scale(&chance, 1.8, 12);
        scene.camera.heading = chance_fx(&chance, 0, 360);
        scene.camera.pitch = chance_fx(&chance, -60, 0);
        scene.camera.near = TP_FX(0.05);
        test_frame f = frame_of(&scene, &none, &config);
        tp_world_init(&tp_program_all, &world, sizeof world, &scene, NULL, NULL);
        tp_frame_begin(f.frame, &world);
        assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
        /* Lowest possible row of the water's edge: level water at 15 km, minus 1.5 m. */
        const double last = horizon_row(&scene, 15000);
        const uint32_t sea = (uint32_t)fmax(0, fmin(HEIGHT, ceil(last + 0.6)));
        assert_int_equal(marks_of(&f, sea, HEIGHT).water, (HEIGHT - sea) * WIDTH);
        frame_free(&f);
    }
}

static marks marks_with_lift(tp_fx lift)
{
    tp_scene scene = calm_scene();
    const tp_config config = {
        .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = TP_FORMAT_P8
    };
    const tp_assets assets = { .boat = &boat.mesh };
    tp_world world;
    tp_tile tile;

    scene.boat.lift = lift;
    scene.camera.pitch = -10 * TP_FX_ONE;
    test_frame f = frame_of(&scene, &assets, &config);
    tp_world_init(&tp_program_all, &world, sizeof world, &scene, NULL, NULL);
    tp_frame_begin(f.frame, &world);
    assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
    const marks m = marks_of(&f, 0, HEIGHT);
    frame_free(&f);
    return m;
}

static void the_boat_floats_on_the_water_and_sinks_below_it(void **state)
{
    (void)state;
    const marks floating = marks_with_lift(0), flying = marks_with_lift(TP_FX_ONE);
    const marks immersion = marks_with_lift(TP_FX(-0.6)),
                half = marks_with_lift(TP_FX(-0.25));

    assert_true(flying.solid > floating.solid);     /* half of the boat was under water */
    assert_true(floating.solid > half.solid && half.solid > 0);
    assert_int_equal(immersion.solid, 0);
    assert_int_equal(immersion.sky, floating.sky);
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(calm_water_fills_everything_below_the_horizon),
        cmocka_unit_test(waves_leave_no_holes),
        cmocka_unit_test(the_boat_floats_on_the_water_and_sinks_below_it),
    };
    return cmocka_run_group_tests_name("frame/horizon", tests, NULL, NULL);
}
