/* SPDX-License-Identifier: MIT */
/* Frames that look into the water: the same picture for every tiling and any contents; and
 * the light on the floor. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/water_ray.h"
#include "features/underwater/underwater.h"
#include "frame/frame.h"
#include "tests/lib/measure.h"
#include "world/pools.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

enum { WIDE = 160, HIGH = 96 };

static uint64_t chance;
static test_boat boat;

/* Water of 3.2 m across with waves: in a glass tank, in a stone basin, or open water over a
 * slope. */
static tp_scene wet_scene(int kind)
{
    tp_scene s;

    tp_scene_level(&s);
    s.water.clarity = 3 * TP_FX_ONE;
    s.water.caustics = TP_FX_ONE;
    s.water.caustic_cells = 32;
    s.camera.near = TP_FX(0.05);
    if (kind == 2) {
        s.wave[0] = (tp_wave){ .amplitude = TP_FX(0.2), .length = 9 * TP_FX_ONE,
                               .steepness = TP_FX(0.1), .speed = TP_FX_ONE,
                               .exponent = 1 };
        s.floor.depth = 2 * TP_FX_ONE;
        s.floor.slope = TP_FX(0.1);
        return s;
    }
    s.pool.cols = s.pool.rows = 32;
    s.pool.cell = TP_FX(0.1);
    s.grid.vertices = 1089;
    s.tank.sea = 0;
    s.tank.kind = kind == 0 ? TP_TANK_GLASS : TP_TANK_STONE;
    return s;
}

static tp_assets wet_assets(void)
{
    return (tp_assets){ .layer[0] = &boat.texture[0], .ripple = &boat.texture[1],
                        .tank_wall = &boat.texture[0], .tank_floor = &boat.texture[1],
                        .floor_texture = &boat.texture[0] };
}

static void look_anywhere(tp_scene *s)
{
    const bool in = random_below(&chance, 3) == 0;

    s->camera.x = chance_fx(&chance, in ? -1.5 : -4, in ? 1.5 : 4);
    s->camera.z = chance_fx(&chance, in ? -1.5 : -4, in ? 1.5 : 4);
    s->camera.y = chance_fx(&chance, -0.9, in ? 0.1 : 3);
    s->camera.heading = chance_fx(&chance, 0, 360);
    s->camera.pitch = chance_fx(&chance, -60, in ? 60 : 0);
    s->water.dispersion = random_below(&chance, 2) ? TP_FX(0.1) : 0;
    s->light.heading = chance_fx(&chance, 0, 360);
}

static void picture_of(const tp_scene *s, const tp_assets *assets, const tp_world *world,
                       uint32_t tile_wide, uint32_t tile_high, uint32_t *pixels)
{
    const tp_config c = { .width = WIDE,
                          .height = HIGH,
                          .tile_width = tile_wide,
                          .tile_height = tile_high,
                          .format = TP_FORMAT_XRGB8888 };
    test_frame f = frame_of(s, assets, &c);

    frame_draw_picture(&f, world, pixels);
    frame_free(&f);
}

static void every_tiling_sees_the_same_water(void **state)
{
    (void)state;
    static uint32_t whole[WIDE * HIGH], cut[WIDE * HIGH];
    const tp_assets assets = wet_assets();

    for (int n = 0; n < 60; n++) {
        tp_scene s = wet_scene(n % 3);
        look_anywhere(&s);
        tp_world *world = scene_world(&s, &assets);
        const tp_input poke = { .push[0].height = TP_FX(0.1) };
        for (int i = 0; i < 20; i++)
            tp_world_step(&tp_program_all, world, &s, i ? NULL : &poke);
        picture_of(&s, &assets, world, 0, 0, whole);
        picture_of(&s, &assets, world, 16u * (1 + random_below(&chance, 5)),
                   1 + random_below(&chance, 40), cut);
        assert_memory_equal(whole, cut, sizeof whole);
        free(world);
    }
}

/* -- a beach -------------------------------------------------------------------------- */

/* Distance through still water to the plane y = -depth + slope x; < 0: no hit, or above the
 * water. */
static double way_to_beach(ref_vec eye, ref_vec way, double depth, double slope)
{
    const ref_vec at = ref_along(eye, way, -eye.y / way.y);
    const ref_vec in = ref_bent(way, (ref_vec){ 0, 1, 0 }, 1.333);
    return (depth - slope * at.x) / (slope * in.x - in.y);
}

/* A white beach in grey water that sends no light: the remaining white gives the
 * distance. */
static void a_beach_lies_as_deep_as_rays_say(void **state)
{
    (void)state;
    static uint32_t pixels[WIDE * HIGH];
    const tp_assets assets = { 0 };
    measure off = { .what = "beach", .unit = "levels" };

    for (int n = 0; n < 20; n++) {
        tp_scene s = wet_scene(2);
        const double slope = chance_double(&chance, 0.02, 0.3);
        s.wave[0].amplitude = 0;
        s.floor.slope = (tp_fx)(slope * 65536);
        s.floor.heading = 90 * TP_FX_ONE;
        s.floor.colour = s.light.colour = 0xffffff;
        s.water.tint = 0x808080;
        s.water.colour = s.water.deep_colour = 0;
        s.water.specular = s.water.reflection = s.water.caustics = 0;
        s.light.ambient = TP_FX_ONE;
        s.sky.haze = 0;
        s.camera.x = chance_fx(&chance, -4, 4);
        s.camera.y = chance_fx(&chance, 0.5, 6);
        s.camera.heading = chance_fx(&chance, 0, 360);
        s.camera.pitch = chance_fx(&chance, -60, -20);
        tp_world *world = scene_world(&s, &assets);
        picture_of(&s, &assets, world, 0, 0, pixels);
        const ref_camera c = ref_camera_make(
            (tp_vec3){ s.camera.x, s.camera.y, s.camera.z },
            tp_turn_of_degrees(s.camera.heading), tp_turn_of_degrees(s.camera.pitch),
            s.camera.fov, s.camera.near, WIDE, HIGH);
        for (int i = 0; i < WIDE * HIGH; i++) {
            const ref_vec way = ref_pixel_ray(&c, i % WIDE, i / WIDE);
            const double m = way.y < -0.1 ? way_to_beach(c.eye, way, 2, slope) : -1;
            if (m < 0.05)
                continue;
            const double left = 255 * pow(128.5 / 256, m / 3);
            measure_add(&off, (pixels[i] & 0xff) - left, n, i, 0);
        }
        free(world);
    }
    measure_print(&off);
    assert_true(off.inputs > 50000 && off.worst < 2.5);
}

/* -- caustics ------------------------------------------------------------------------- */

/* Caustic map of a scene's light, 256 is even light; its side has water.caustic_cells
 * cells. */
static void light_of(const tp_scene *s, const tp_world *world, uint16_t *light)
{
    const tp_assets assets = { 0 };
    const tp_config c = {
        .width = WIDE, .height = HIGH, .tile_height = HIGH, .format = TP_FORMAT_XRGB8888
    };
    const size_t cells = (size_t)s->water.caustic_cells;
    test_frame f = frame_of(s, &assets, &c);

    tp_frame_begin(f.frame, world);
    const tp_caustics *map = tp_frame_module_memory(f.frame, TP_CAUSTICS_ID);
    memcpy(light, map->light, cells * cells * sizeof *light);
    frame_free(&f);
}

static void still_water_lights_its_floor_evenly(void **state)
{
    (void)state;
    static uint16_t light[64 * 64];

    for (int n = 0; n < 20; n++) {
        tp_scene s = wet_scene(n % 3);
        s.water.caustic_cells = 64;
        s.wave[0].amplitude = 0;
        s.light.heading = chance_fx(&chance, 0, 360);
        s.light.elevation = chance_fx(&chance, 5, 90);
        tp_world *world = scene_world(&s, NULL);
        light_of(&s, world, light);
        for (int i = 0; i < 64 * 64; i++)
            assert_int_equal(light[i], 256);
        free(world);
    }
}

static void no_light_is_lost_or_made(void **state)
{
    (void)state;
    static uint16_t light[64 * 64];
    measure off = { .what = "mean of the light", .unit = "of 1" };

    for (int n = 0; n < 20; n++) {
        tp_scene s = wet_scene(0);
        s.water.caustic_cells = 64;
        tp_world *world = scene_world(&s, NULL);
        const tp_input poke = { .push[0] = { chance_fx(&chance, -0.2, 0.2),
                                             chance_fx(&chance, -1, 1), 0 } };
        for (int i = 0; i < 60; i++)
            tp_world_step(&tp_program_all, world, &s, i % 20 ? NULL : &poke);
        light_of(&s, world, light);
        double sum = 0;
        for (int i = 0; i < 64 * 64; i++)
            sum += light[i] / 256.0 / (64 * 64);
        measure_add(&off, sum - 1, n, 0, 0);
        free(world);
    }
    measure_print(&off);
    assert_true(off.worst < 0.01);
}

/* Rays of a zenith sun through the pool's surface, in double precision: 16 rays per side of
 * a cell. */
static void deal_rays(const tp_scene *s, const tp_world *world, double *light)
{
    const tp_pool *pool = tp_world_pool(world);
    const int    cells = s->water.caustic_cells, rays = 16 * cells;
    const double depth = s->tank.depth / 65536.0, side = 3.2;

    for (int j = 0; j < rays; j++)
        for (int i = 0; i < rays; i++) {
            const double x = (i + 0.5) / rays * side - side / 2;
            const double z = (j + 0.5) / rays * side - side / 2;
            const tp_height_slope r = tp_pool_height_slope(pool, (tp_fx)(x * 65536),
                                               (tp_fx)(z * 65536), 0);
            const ref_vec n = ref_unit_vec((ref_vec){ -r.slope_x / 65536.0, 1,
                                                      -r.slope_z / 65536.0 });
            const ref_vec t = ref_bent((ref_vec){ 0, -1, 0 }, n, 1.333);
            const double high = depth + r.height / 65536.0;
            const int u = (int)floor((x - t.x / t.y * high + side / 2) / side * cells);
            const int v = (int)floor((z - t.z / t.y * high + side / 2) / side * cells);
            if (u >= 0 && u < cells && v >= 0 && v < cells)
                light[v * cells + u] += 1 / 256.0;
        }
}

/* A splash acts as a projection: its light gathers below, in the amount that the rays
 * give. */
static void a_lens_gathers_light_where_rays_say(void **state)
{
    (void)state;
    enum { CELLS = 32 };
    uint16_t light[CELLS * CELLS];

    for (int n = 0; n < 6; n++) {
        double rays[CELLS * CELLS] = { 0 };
        tp_scene s = wet_scene(0);
        s.light.elevation = 90 * TP_FX_ONE;
        tp_world *world = scene_world(&s, NULL);
        const tp_input poke = { .push[0] = { TP_FX(0.08), chance_fx(&chance, -1, 1),
                                             chance_fx(&chance, -1, 1) } };
        s.pool.splash_width = TP_FX(0.35);
        tp_world_step(&tp_program_all, world, &s, &poke);
        light_of(&s, world, light);
        deal_rays(&s, world, rays);
        int most = 0, ray_most = 0;
        double square = 0;
        for (int i = 0; i < CELLS * CELLS; i++) {
            most = light[i] > light[most] ? i : most;
            ray_most = rays[i] > rays[ray_most] ? i : ray_most;
            square += (light[i] / 256.0 - rays[i]) * (light[i] / 256.0 - rays[i]);
        }
        const int dx = most % CELLS - ray_most % CELLS,
                  dz = most / CELLS - ray_most / CELLS;
        printf("    brightest %.2f at %d, by rays %.2f at %d; rms %.3f\n",
               light[most] / 256.0, most, rays[ray_most], ray_most,
               sqrt(square / (CELLS * CELLS)));
        assert_true(abs(dx) <= 1 && abs(dz) <= 1);
        assert_true(rays[ray_most] > 1.5);
        assert_true(fabs(light[most] / 256.0 / rays[ray_most] - 1) < 0.25);
        assert_true(sqrt(square / (CELLS * CELLS)) < 0.15);
        free(world);
    }
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tiling_sees_the_same_water),
        cmocka_unit_test(a_beach_lies_as_deep_as_rays_say),
        cmocka_unit_test(still_water_lights_its_floor_evenly),
        cmocka_unit_test(no_light_is_lost_or_made),
        cmocka_unit_test(a_lens_gathers_light_where_rays_say),
    };
    return cmocka_run_group_tests_name("features/underwater", tests, NULL, NULL);
}
