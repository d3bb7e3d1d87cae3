/* SPDX-License-Identifier: MIT */
/* The water point under a pixel: the point projects to the pixel, lies on the water, and no
 * visible water stands in front. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/worlds.h"

#define WIDTH  640
#define HEIGHT 480

static uint64_t chance;

typedef struct {
    tp_scene  scene;
    tp_world *world;
} pick_water;

static void water_free(pick_water *w)
{
    free(w->world);
}

/* A world after ticks with pokes, drops and a walk. */
static pick_water water_of(const tp_scene *scene, int ticks)
{
    pick_water w = { *scene, scene_world(scene, NULL) };

    assert_non_null(w.world);
    for (int i = 0; i < ticks; i++) {
        const tp_fx height = i % 20 ? 0 : scene->pool.splash_height;
        const tp_input in = { .drops = i % 7 == 0,
                              .push[0] = { height, scene->pool.x, scene->pool.z } };
        tp_world_step(&tp_program_all, w.world, &w.scene, &in);
    }
    return w;
}

/* -- scenes ------------------------------------------------------------------------- */

static tp_scene seas(void)
{
    tp_scene s = scene_plain();

    s.boat.mesh[0] = '\0';
    s.wave[0].amplitude = TP_FX_ONE;
    s.wave[0].length = 24 * TP_FX_ONE;
    for (int i = 0; i < 3; i++)
        s.wave[i].steepness = TP_FX(0.25);
    return s;
}

static tp_scene pool(void)
{
    tp_scene s = seas();

    for (int i = 0; i < TP_WAVES; i++)
        s.wave[i].amplitude = 0;
    s.pool.cols = s.pool.rows = 96;
    s.pool.cell = TP_FX(0.1);
    s.pool.z = TP_FX(-6);
    s.pool.max_height = TP_FX_ONE;
    s.pool.splash_height = TP_FX(0.4);
    s.drops.count = 20;
    s.drops.z = TP_FX(-6);
    s.drops.radius = TP_FX(0.1);
    s.camera.y = TP_FX(1.7);
    s.camera.pitch = TP_FX(-15);
    return s;
}

static tp_scene deep_sea(void)
{
    tp_scene s = seas();

    s.wind.strength = TP_FX(0.22);
    s.wind.heading = TP_FX(30);
    return s;
}

static tp_scene tank(void)
{
    tp_scene s = pool();

    s.tank.kind = TP_TANK_GLASS;
    s.pool.cols = s.pool.rows = 48;
    s.drops.count = 0;
    return s;
}

/* -- the reference in double precision --------------------------------------------- */

typedef struct { double u, v, depth; } seen;

static double focal_of(const tp_scene *s)
{
    return HEIGHT / 2.0 / tan(s->camera.fov / 65536.0 * 3.14159265358979 / 360);
}

static double axis(const tp_dir3 *d, const double p[3])
{
    return (d->x * p[0] + d->y * p[1] + d->z * p[2]) / TP_Q30_ONE;
}

static seen seen_at(const pick_water *w, tp_vec3 place)
{
    const tp_camera c = tp_world_camera(w->world);
    const double p[3] = { (place.x - c.eye.x) / 65536.0, (place.y - c.eye.y) / 65536.0,
                          (place.z - c.eye.z) / 65536.0 };
    const double depth = -axis(&c.turn.z, p), focal = focal_of(&w->scene);
    return (seen){ WIDTH / 2.0 + axis(&c.turn.x, p) * focal / depth,
                   HEIGHT / 2.0 - axis(&c.turn.y, p) * focal / depth, depth };
}

/* Largest height in pixels by which water covers the point, over steps of half a pixel
 * along the ray. */
static double hidden_by(const pick_water *w, tp_vec3 at)
{
    const tp_vec3 eye = tp_world_camera(w->world).eye;
    const double way[3] = { at.x - eye.x, at.y - eye.y, at.z - eye.z };
    const double focal = focal_of(&w->scene);
    const double far = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]) / 65536;
    const double near = w->scene.camera.near / 65536.0;
    double most = -1e9, side = 0;

    for (double t = 1.3 * near; t < far - 2 * far / focal; t += 0.5 * t / focal + 1e-3) {
        const tp_fx x = eye.x + (tp_fx)(way[0] * t / far);
        const tp_fx z = eye.z + (tp_fx)(way[2] * t / far);
        const double y = eye.y + way[1] * t / far;
        const double over =
            (y - tp_world_sample(&tp_program_all, w->world, x, z).height) / 65536;
        if (side == 0)
            side = over > 0 ? 1 : -1;
        most = fmax(most, -side * over * focal / t);
    }
    return most;
}

static bool pick_pixel(const tp_world *world, const tp_scene *scene, uint32_t width,
                       uint32_t height, int32_t px, int32_t py, tp_vec3 *at)
{
    return tp_world_pick(&tp_program_all, world, scene, width, height,
                         tp_pixel_middle(px), tp_pixel_middle(py), at);
}

/* Picks a pixel of the usual picture. */
static bool pick(const pick_water *w, int32_t px, int32_t py, tp_vec3 *at)
{
    return pick_pixel(w->world, &w->scene, WIDTH, HEIGHT, px, py, at);
}

/* -- tests -------------------------------------------------------------------------- */

static void look_from(pick_water *w, double y, double heading, double pitch)
{
    w->world->eye.y = (tp_fx)(y * 65536);
    w->world->heading = tp_turn_of_degrees((tp_fx)(heading * 65536));
    w->world->pitch = tp_turn_of_degrees((tp_fx)(pitch * 65536));
    tp_world_move_camera(w->world, &(tp_input){ 0 });
}

/* Distance from the water, m: at a pool's side the surface steps, and a place on the step
 * lies between the heights before and behind the step. */
static double off_water(const pick_water *w, tp_vec3 at)
{
    tp_fx low = TP_FX_MAX, high = TP_FX_MIN;

    for (int k = 0; k < 5; k++) {
        const tp_fx x = at.x + (k == 1) * 4 - (k == 2) * 4;
        const tp_fx z = at.z + (k == 3) * 4 - (k == 4) * 4;
        const tp_fx y = tp_world_sample(&tp_program_all, w->world, x, z).height;
        low = y < low ? y : low;
        high = y > high ? y : high;
    }
    return fmax(0, fmax(low - at.y, at.y - high)) / 65536;
}

typedef struct { double pixels, height, hidden; int found; } worst;

static void try_pixel(const pick_water *w, int32_t px, int32_t py, worst *most)
{
    tp_vec3 at;

    if (!pick(w, px, py, &at))
        return;
    const seen s = seen_at(w, at);
    most->found++;
    most->pixels = fmax(most->pixels, hypot(s.u - px - 0.5, s.v - py - 0.5));
    most->height = fmax(most->height, 1000 * off_water(w, at));
    most->hidden = fmax(most->hidden, hidden_by(w, at));
}

static void try_scene(const char *name, tp_scene scene, double low, double high,
                      int least)
{
    worst most = { 0, 0, 0, 0 };

    for (int ticks = 1; ticks < 400; ticks *= 3) {
        pick_water w = water_of(&scene, ticks);
        for (int n = 0; n < 30; n++) {
            look_from(&w, chance_double(&chance, low, high),
                      scene.pool.cols ? 0 : chance_double(&chance, 0, 360),
                      chance_double(&chance, -40, low < 0 ? 40 : 3));
            try_pixel(&w, chance_int(&chance, 0, WIDTH - 1),
                      chance_int(&chance, 0, HEIGHT - 1), &most);
        }
        water_free(&w);
    }
    printf("    %-10s %3d places: %.3f px off, %.2f mm over the water, %.2f px hidden\n",
           name, most.found, most.pixels, most.height, most.hidden);
    assert_true(most.found >= least);
    assert_true(most.pixels < 1);
    assert_true(most.height < 3);
    assert_true(most.hidden < 1);
}

static void a_place_is_drawn_at_its_pixel(void **state)
{
    (void)state;
    try_scene("waves", seas(), 3, 12, 75);
    try_scene("deep sea", deep_sea(), 3, 12, 75);
    try_scene("pool", pool(), 1, 3, 75);
}

static void low_over_the_water_crests_hide_what_is_behind(void **state)
{
    (void)state;
    try_scene("waves", seas(), 1.5, 2, 75);
    try_scene("deep sea", deep_sea(), 1.5, 2, 75);
}

static void from_below_the_surface_is_met_too(void **state)
{
    (void)state;
    try_scene("waves", seas(), -6, -3, 25);
    try_scene("pool", pool(), -3, -1.5, 25);
}

/* Rows above the horizon for an eye above the water, below the horizon for an eye below. */
static void sky_and_depth_are_missed(void **state)
{
    (void)state;
    const tp_scene scene = seas();
    pick_water w = water_of(&scene, 30);
    tp_vec3 at;

    for (int i = 0; i < 200; i++) {
        const int32_t px = chance_int(&chance, 0, WIDTH - 1);
        const int32_t py = chance_int(&chance, 0, HEIGHT / 2 - 1);
        look_from(&w, 6, chance_double(&chance, 0, 360), 0);
        assert_false(pick(&w, px, py, &at));
        assert_true(pick(&w, px, HEIGHT - 60, &at));
        look_from(&w, -6, chance_double(&chance, 0, 360), 0);
        assert_false(pick(&w, px, HEIGHT - 1 - py, &at));
    }
    water_free(&w);
}

/* The tank is 4.8 m wide, around z = -6. */
static void a_tank_has_no_water_beside_it(void **state)
{
    (void)state;
    const tp_scene scene = tank();
    pick_water w = water_of(&scene, 90);
    int found = 0;

    look_from(&w, 2.5, 0, -22);
    for (int py = 0; py < HEIGHT; py += 16)
        for (int px = 0; px < WIDTH; px += 16) {
            tp_vec3 at;
            if (!pick(&w, px, py, &at))
                continue;
            found++;
            assert_true(abs(at.x) <= TP_FX(2.41) && abs(at.z + TP_FX(6)) <= TP_FX(2.41));
        }
    assert_in_range(found, 100, 800);
    water_free(&w);
}

static void pools_that_bend_the_light_only_have_no_heights(void **state)
{
    (void)state;
    tp_scene scene = pool();
    scene.water.pool_normal_strength = TP_FX_ONE;
    scene.drops.count = 0;
    pick_water w = water_of(&scene, 45);
    tp_fx highest = 0;

    look_from(&w, 1.7, 0, -15);
    for (int px = 0; px < WIDTH; px += 16) {
        tp_vec3 at;
        assert_true(pick(&w, px, HEIGHT / 2 + 20, &at));
        assert_in_range(at.y + 2, 0, 4);
        const tp_fx high = tp_world_sample(&tp_program_all, w.world, at.x, at.z).height;
        highest = abs(high) > highest ? abs(high) : highest;
    }
    assert_true(highest > TP_FX(0.01));
    water_free(&w);
}

/* A beach that rises towards -z from 2 m below the camera. */
static void land_is_no_water(void **state)
{
    (void)state;
    tp_scene scene = seas();
    scene.floor.depth = TP_FX(2);
    scene.floor.slope = TP_FX(0.1);
    pick_water w = water_of(&scene, 60);
    tp_vec3 at;

    look_from(&w, 6, 0, -15);
    assert_false(pick(&w, WIDTH / 2, HEIGHT / 2 - 40, &at));
    assert_true(pick(&w, WIDTH / 2, HEIGHT - 1, &at));
    look_from(&w, 6, 180, -15);
    assert_true(pick(&w, WIDTH / 2, HEIGHT / 2, &at));
    water_free(&w);
}

/* White sky, black water: dark pixels and picked pixels agree within a pixel, crests before
 * the sky included. */
static void what_is_drawn_as_water_is_picked(void **state)
{
    static const tp_config config = {
        .width = 160, .height = 120, .tile_height = 120, .format = TP_FORMAT_L8
    };
    static const tp_assets none;
    static bool picked[120][160], drawn[120][160];
    (void)state;
    tp_scene scene = seas();
    scene.sky.horizon = scene.sky.zenith = 0xffffff;
    scene.sky.haze = 0;
    scene.water.colour = 0;
    scene.water.reflection = scene.water.specular = 0;
    scene.grid.vertices = 65536;
    pick_water w = water_of(&scene, chance_int(&chance, 1, 200));
    test_frame f = frame_of(&scene, &none, &config);
    tp_tile tile;
    int wet = 0, far = 0;

    look_from(&w, tp_world_sample(&tp_program_all, w.world, 0, 0).height / 65536.0 + 0.6,
              0, -2);
    tp_frame_begin(f.frame, w.world);
    assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
    for (int y = 0; y < 120; y++)
        for (int x = 0; x < 160; x++) {
            tp_vec3 at;
            picked[y][x] = pick_pixel(w.world, &scene, 160, 120, x, y, &at);
            drawn[y][x] = ((const uint8_t *)tile.pixels)[y * 160 + x] < 128;
        }
    for (int y = 1; y < 119; y++)
        for (int x = 0; x < 160; x++) {
            wet += drawn[y][x];
            far += picked[y][x] != drawn[y - 1][x] && picked[y][x] != drawn[y][x]
                && picked[y][x] != drawn[y + 1][x];
        }
    printf("    %d pixels of water, %d picked otherwise\n", wet, far);
    assert_in_range(wet, 4000, 18700);
    assert_true(far < 10);
    frame_free(&f);
    water_free(&w);
}

static void water_before_the_near_plane_is_not_seen(void **state)
{
    (void)state;
    tp_scene scene = pool();
    scene.camera.near = 2 * TP_FX_ONE;
    pick_water w = water_of(&scene, 1);
    tp_vec3 at;

    look_from(&w, 1.5, 0, -89);
    assert_false(pick(&w, WIDTH / 2, HEIGHT / 2, &at));
    look_from(&w, 2.5, 0, -89);
    assert_true(pick(&w, WIDTH / 2, HEIGHT / 2, &at));
    water_free(&w);
}

/* At the ends of all ranges the only requirement is an answer. */
static void any_scene_and_pixel_is_answered(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        tp_scene scene = scene_any(&chance);
        scene.pool.cols = scene.field.cols = 0;
        scene.drops.count = 0;
        tp_world *world = scene_world(&scene, NULL);
        tp_vec3 at;
        if (!world)
            continue;
        const pick_water w = { scene, world };
        tp_world_step(&tp_program_all, world, &scene, NULL);
        const uint32_t width = (uint32_t)chance_int(&chance, 1, 8192);
        const uint32_t height = (uint32_t)chance_int(&chance, 1, 8192);
        if (pick_pixel(world, &scene, width, height, chance_int(&chance, -9000, 9000),
                       chance_int(&chance, -32768, 32767), &at))
            assert_true(seen_at(&w, at).depth > 0);
        assert_false(pick_pixel(world, &scene, 0, height, 0, 0, &at));
        free(world);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_place_is_drawn_at_its_pixel),
        cmocka_unit_test(low_over_the_water_crests_hide_what_is_behind),
        cmocka_unit_test(from_below_the_surface_is_met_too),
        cmocka_unit_test(sky_and_depth_are_missed),
        cmocka_unit_test(a_tank_has_no_water_beside_it),
        cmocka_unit_test(pools_that_bend_the_light_only_have_no_heights),
        cmocka_unit_test(land_is_no_water),
        cmocka_unit_test(what_is_drawn_as_water_is_picked),
        cmocka_unit_test(water_before_the_near_plane_is_not_seen),
        cmocka_unit_test(any_scene_and_pixel_is_answered),
    };
    return cmocka_run_group_tests_name("world/water_sample_pick", tests, NULL, NULL);
}
