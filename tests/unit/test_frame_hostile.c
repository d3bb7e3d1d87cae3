/* SPDX-License-Identifier: MIT */
/* Every scene, world and input within the table's ranges can be drawn: no undefined
 * behaviour (under the sanitizers), no write outside the requested memory, and every pixel
 * of the picture is set. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "world/pools.h"
#include "tests/lib/tilings.h"

static uint64_t chance;
static test_kit kit;
static test_twice twice;

/* Limits the grid to a size for which the test has time. */
static void hold_grid(tp_scene *s)
{
    if (tp_fan_budget(s) > 4000)
        s->grid.vertices = 4000;
}

/* Draws the frame whole and in tiles: the same picture. */
static void draw_both(const tp_scene *scene, const tp_assets *assets,
                      const tp_world *world)
{
    twice_begin(&twice, scene, assets, &chance);
    twice_draw(&twice, world);
    twice_end(&twice);
}

/* Draws a scene with a world of its own and every visible feature. */
static void draw_any(tp_scene *scene, const test_boat *boat)
{
    tp_assets assets = kit_assets(&kit, scene, &chance);

    assets.boat = &boat->mesh;
    strcpy(scene->boat.mesh, "boat.obj");
    kit_switch_on(scene, &chance);
    kit_hold(scene, 3600, 24);
    scene->pool.cols = chance_int(&chance, 0, 1) * 20;
    tp_world *world = scene_world(scene, &assets);
    if (world)
        draw_both(scene, &assets, world);
    free(world);
}

static tp_input any_input(void)
{
    const int32_t far = random_below(&chance, 2) ? INT32_MAX : 65536;
    return (tp_input){ .forward = chance_int(&chance, -far, far),
                       .strafe = chance_int(&chance, -far, far),
                       .up = chance_int(&chance, -far, far),
                       .turn = chance_int(&chance, -far, far),
                       .tilt = chance_int(&chance, -far, far) };
}

static void any_scene_of_the_table_is_drawn(void **state)
{
    (void)state;
    const int count = random_rounds(300, 120);
    for (int n = 0; n < count; n++) {
        tp_scene scene = n % 2 ? scene_any(&chance) : kit_scene(&chance, 3600, 100);
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        hold_grid(&scene);
        tp_world *world = scene_world(&scene, &assets);
        if (!world)
            continue;
        if (n % 3 == 0) {
            world->tick = random_next(&chance);
            tp_world_apply(&tp_program_all, world, &scene, &assets);
        }
        for (int k = 0; k < n % 4; k++) {
            const tp_input input = any_input();
            tp_world_step(&tp_program_all, world, &scene, k ? &input : NULL);
        }
        draw_both(&scene, &assets, world);
        free(world);
    }
    twice_print(&twice.reached);
    assert_true(twice.reached.water > (uint32_t)count / 6);
}

/* All rows at their minimum, all at their maximum, and each row alone at either end. */
static void every_row_at_its_ends_is_drawn(void **state)
{
    (void)state;
    uint32_t count = 0;
    const tp_param *rows = tp_params(&count);

    for (uint32_t i = 0; i < 2 * (count + 1); i++) {
        const bool high = i % 2;
        tp_scene scene = scene_plain();
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        for (uint32_t k = 0; k < count; k++) {
            if (scene_is_number(&rows[k]) && (i / 2 == k || i / 2 == count))
                *scene_number(&scene, &rows[k]) = high ? rows[k].high : rows[k].low;
        }
        hold_grid(&scene);
        tp_world *world = scene_world(&scene, &assets);
        if (world)
            draw_both(&scene, &assets, world);
        free(world);
    }
}

static void grids_of_any_size_are_drawn(void **state)
{
    (void)state;
    static const int32_t sizes[] = { 1, 64, 65, 100, 561, 5000, 65536 };

    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        tp_scene scene = scene_plain();
        const tp_assets assets = { 0 };
        tp_world world;
        scene.grid.vertices = sizes[i];
        for (int k = 0; k < 8; k++) {
            scene.camera.heading = 33 * k * TP_FX_ONE;
            scene.camera.pitch = (11 * k - 80) * TP_FX_ONE;
            if (sizes[i] == 65536 && k % 3)
                continue;
            tp_world_init(&tp_program_all, &world, sizeof world, &scene, NULL, NULL);
            draw_both(&scene, &assets, &world);
        }
    }
}

/* The eye at the world's corners, at the surface, below the surface, straight down and
 * straight up. */
static void the_eye_may_be_anywhere(void **state)
{
    (void)state;
    static const tp_fx far[3] = { TP_FX(-8000), 0, TP_FX(8000) };
    static const tp_fx high[5] = { TP_FX(-100), 0, 1, TP_FX(0.3), TP_FX(2000) };
    static const tp_fx pitch[3] = { TP_FX(-89), TP_FX(3), TP_FX(89) };

    for (int n = 0; n < 135; n++) {
        tp_scene scene = scene_plain();
        scene.camera.x = far[n % 3];
        scene.camera.z = far[n / 3 % 3];
        scene.camera.y = high[n / 9 % 5];
        scene.camera.pitch = pitch[n / 45];
        scene.camera.heading = chance_fx(&chance, 0, 360);
        scene.camera.near = random_below(&chance, 2) ? TP_FX(0.05) : 10 * TP_FX_ONE;
        scene.boat.x = far[random_below(&chance, 3)];
        scene.boat.z = far[random_below(&chance, 3)];
        scene.drops.x = far[random_below(&chance, 3)];
        scene.pool.x = far[random_below(&chance, 3)];
        scene.pool.z = far[random_below(&chance, 3)];
        scene.floor.depth = high[random_below(&chance, 5)] / 4 + 25 * TP_FX_ONE;
        draw_any(&scene, &kit.boat);
    }
}

/* A mesh at the ends of the reader's range, at every scale. */
static void a_boat_of_any_size_is_drawn(void **state)
{
    (void)state;
    static test_boat giant;
    static const tp_fx scales[] = { TP_FX(0.01), TP_FX_ONE, 3 * TP_FX_ONE,
                                    100 * TP_FX_ONE };

    boat_make(&giant, &chance);
    for (int n = 0; n < 96; n++) {
        tp_scene scene = scene_plain();
        const tp_fx side =
            n & 1 ? 16384 * TP_FX_ONE - 1 : chance_scale(&chance, 0.01, 16000);
        const bool aside = random_below(&chance, 2);
        boat_box(&giant, side, n & 2 ? 1 : side, n & 4 ? 1 : side);
        for (int i = 0; i < 8; i++) {
            giant.vertex[i].s = i & 1 ? 16384 * TP_FX_ONE - 1 : 1 - 16384 * TP_FX_ONE;
            giant.vertex[i].t = i & 2 ? 16384 * TP_FX_ONE - 1 : 1 - 16384 * TP_FX_ONE;
        }
        for (int i = 0; aside && i < 8; i++)    /* origin of the mesh at a corner */
            giant.vertex[i].position = (tp_vec3){ i & 1 ? side : 0, i & 2 ? side : 0,
                                                  i & 4 ? side : 0 };
        giant.mesh.low = giant.vertex[0].position;
        giant.mesh.high = giant.vertex[7].position;
        scene.boat.scale = scales[n / 8 % 4];
        scene.boat.x = n & 8 ? 8000 * TP_FX_ONE : 0;
        scene.boat.z = n & 16 ? -8000 * TP_FX_ONE : 0;
        scene.camera.x = n & 32 ? -8000 * TP_FX_ONE : 0;
        scene.camera.heading = chance_fx(&chance, 0, 360);
        scene.camera.follow = chance_int(&chance, TP_FOLLOW_NONE, TP_FOLLOW_BOAT);
        draw_any(&scene, &giant);
    }
}

int main(void)
{
    chance = random_seed();
    kit_make(&kit, &chance);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_scene_of_the_table_is_drawn),
        cmocka_unit_test(every_row_at_its_ends_is_drawn),
        cmocka_unit_test(grids_of_any_size_are_drawn),
        cmocka_unit_test(the_eye_may_be_anywhere),
        cmocka_unit_test(a_boat_of_any_size_is_drawn),
    };
    return cmocka_run_group_tests_name("frame/hostile", tests, NULL, NULL);
}
