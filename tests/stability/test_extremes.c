/* SPDX-License-Identifier: MIT */
/* Any position and any input is safe: heights are requested at any x and z of 16.16, the
 * ends included, and a tick takes any 32 bits in each number of its input.  Scenes are
 * random, with every part of a world.  The build with UBSan and ASan detects faults inside;
 * the test asserts the limits that the headers state.
 *
 *     TP_SCENES=n     number of random scenes, default 100 */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/drops/drops.h"
#include "tests/lib/tilings.h"
#include "world/pools.h"
#include "world/module.h"
#include "waves/coastal_tables.h"

#define HIGHEST (2200 * (int64_t)TP_FX_ONE)     /* 16 waves, 1024 rings, two pools */
#define FAR     (8000 * TP_FX_ONE)

static uint64_t chance;
static test_kit kit;
static test_twice twice;

static int scenes(void)
{
    const char *asked = getenv("TP_SCENES");
    return asked ? atoi(asked) : 100;
}

/* A random scene; one in eight has a grid of many vertices. */
static tp_scene any_scene(void)
{
    tp_scene s = kit_scene(&chance, 196, 40);

    if (random_below(&chance, 8) == 0)
        s.grid.vertices = 8192;
    return s;
}

static tp_world *world_of(const tp_scene *scene, const tp_assets *assets)
{
    return tp_world_bytes(&tp_program_all, scene, assets) ? scene_world(scene, assets)
                                                          : NULL;
}

/* -- positions ------------------------------------------------------------------------- */

static void assert_near(tp_fx got, tp_fx place, int64_t most)
{
    assert_true(llabs((int64_t)got - place) <= most);
}

/* The result of the search and the point itself each stay within the waves'
 * displacement. */
static void ask_all(const tp_world *world, tp_fx x, tp_fx z)
{
    const tp_coastal_water *coastal = tp_world_coastal(world);
    const int64_t reach =
        coastal ? tp_coastal_max_displacement(coastal) : world->deep.max_displacement;
    const tp_surface surface = tp_world_surface(&tp_program_all, world);
    const tp_surface_point p = tp_surface_sample(&surface, x, z, NULL);

    assert_true(llabs((int64_t)p.position.y) <= HIGHEST);
    assert_near(p.position.x, x, 2 * reach + 64);
    assert_near(p.position.z, z, 2 * reach + 64);
    assert_int_equal(tp_world_sample(&tp_program_all, world, x, z).height, p.position.y);
}

static void ask_coastal(const tp_coastal_water *coastal, const tp_turn *phases, tp_fx x,
                        tp_fx z)
{
    const tp_coastal_point whole = tp_coastal_displace_point(coastal, phases, x, z);
    const tp_coastal_point smooth = tp_coastal_displace_no_overhang(coastal, phases, x, z);
    const tp_fx reach = tp_coastal_max_displacement(coastal);

    assert_near(whole.position.x, x, reach);
    assert_near(whole.position.z, z, reach);
    assert_near(smooth.position.x, x, reach);
    assert_near(smooth.position.z, z, reach);
    assert_true(abs(smooth.position.y) <= tp_coastal_max_height(coastal));
    assert_int_equal(whole.depth, tp_coastal_floor(coastal, x, z).depth);
}

/* Samples the pool and adds a splash of any size. */
static void ask_pool(tp_pool *pool, tp_fx x, tp_fx z)
{
    const tp_fx lag = chance_int(&chance, 0, TP_FX_ONE);
    const tp_height_slope r = tp_pool_height_slope(pool, x, z, lag);
    uint32_t col, row;
    const bool cell = tp_pool_open_cell_at_point(pool, x, z, &col, &row);

    assert_true(abs(r.height) <= tp_pool_height_bound(pool));
    assert_true(!cell || (col < pool->cols && row < pool->rows));
    assert_int_equal(cell, tp_pool_add_splash(pool, x, z, chance_word(&chance),
                                       chance_word(&chance)));
}

static void ask_parts(tp_world *world, tp_fx x, tp_fx z)
{
    if (tp_world_coastal(world))
        ask_coastal(tp_world_coastal(world), world->phases, x, z);
    if (tp_world_mutable_pool(world))
        ask_pool(tp_world_mutable_pool(world), x, z);
    if (tp_world_mutable_field(world))
        ask_pool(tp_world_mutable_field(world), x, z);
    if (tp_world_foam(world))
        tp_foam_sample(tp_world_foam(world), x, z);
}

static void every_place_has_a_height(void **state)
{
    (void)state;
    uint32_t asked = 0;

    for (int i = 0; i < scenes(); i++) {
        tp_scene scene = any_scene();
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        tp_world *world = world_of(&scene, &assets);
        for (int n = 0; world && n < 60; n++) {
            if (n % 10 == 0)
                tp_world_step(&tp_program_all, world, &scene, NULL);
            ask_all(world, chance_word(&chance), chance_word(&chance));
            ask_parts(world, chance_word(&chance), chance_word(&chance));
            asked++;
        }
        free(world);
    }
    printf("# %u places\n", (unsigned)asked);
    assert_true(asked > 30 * (uint32_t)scenes());
}

/* Floors with a map as in tp_floor, for the edges of the map. */
static void every_place_has_a_floor(void **state)
{
    (void)state;
    for (int n = 0; n < 20000; n++) {
        const tp_floor floor = {
            .depth = chance_fx(&chance, -8000, 8000), .slope = chance_fx(&chance, 0, 1),
            .heading = chance_fx(&chance, -32400, 32400),
            .map = random_below(&chance, 2) ? &kit.floor : NULL,
            .map_x = chance_fx(&chance, -8000, 8000),
            .map_z = chance_fx(&chance, -8000, 8000),
            .map_size = chance_scale(&chance, 1, 8000),
            .map_low = chance_fx(&chance, -8000, 100),
            .map_high = chance_fx(&chance, -8000, 100),
        };
        const tp_floor_at at = tp_floor_sample(&floor, chance_word(&chance),
                                              chance_word(&chance));
        assert_true(abs(at.rise_x) <= 8 * TP_FX_ONE && abs(at.rise_z) <= 8 * TP_FX_ONE);
    }
}

/* -- input ----------------------------------------------------------------------------- */

static void assert_held(const tp_world *world)
{
    const tp_drops *drops = tp_world_drops(world);
    const tp_camera camera = tp_world_camera(world);
    const tp_hull *hull = &world->boat_state.hull;

    assert_near(camera.eye.x, 0, FAR);
    assert_near(camera.eye.y, 0, FAR);
    assert_near(camera.eye.z, 0, FAR);
    assert_near(hull->x, 0, FAR);
    assert_near(hull->z, 0, FAR);
    assert_true(!drops || (llabs(drops->sphere.x) <= FAR && llabs(drops->sphere.z) <= FAR));
    assert_true(!drops || drops->count <= drops->capacity);
}

static void a_tick_takes_any_input(void **state)
{
    (void)state;
    for (int i = 0; i < scenes(); i++) {
        tp_scene scene = any_scene();
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        tp_world *world = world_of(&scene, &assets);
        if (!world)
            continue;
        twice_begin(&twice, &scene, &assets, &chance);
        for (int n = 0; n < 20; n++) {
            const tp_input in = chance_input(&chance);
            tp_world_step(&tp_program_all, world, &scene, &in);
            assert_held(world);
            if (n % 10 == 9)
                twice_draw(&twice, world);
        }
        twice_end(&twice);
        free(world);
    }
}

/* Eleven minutes at 100 m/s are 67 km, the same as hours at a usual speed. */
static void a_boat_that_sails_on_and_on_stays_within_8_km(void **state)
{
    (void)state;
    for (int n = 0; n < 4; n++) {
        tp_scene scene = scene_plain();
        scene.boat.speed = n % 2 ? 30 * TP_FX_ONE : -30 * TP_FX_ONE;
        scene.boat.heading = chance_fx(&chance, -180, 180);
        scene.boat.rudder = n / 2 ? TP_FX(0.01) : 0;
        tp_world *world = scene_world(&scene, NULL);
        const tp_input ahead = { .throttle = n % 2 ? TP_FX_MAX : TP_FX_MIN };
        for (int tick = 0; tick < 40000; tick++)
            tp_world_step(&tp_program_all, world, &scene, &ahead);
        assert_held(world);
        assert_true(llabs(world->boat_state.hull.x) == FAR
                    || llabs(world->boat_state.hull.z) == FAR || n / 2);
        free(world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_place_has_a_height),
        cmocka_unit_test(every_place_has_a_floor),
        cmocka_unit_test(a_tick_takes_any_input),
        cmocka_unit_test(a_boat_that_sails_on_and_on_stays_within_8_km),
    };
    chance = random_seed();
    kit_make(&kit, &chance);
    return cmocka_run_group_tests_name("stability at extremes", tests, NULL, NULL);
}
