/* SPDX-License-Identifier: MIT */
/* Foam and spray at their limits: any numbers of the parameter table, an eye that jumps,
 * and the slowest fading.
 *
 *     TP_SCENES=n     number of random scenes, default 300 */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/foam/foam.h"
#include "features/spray/spray.h"
#include "world/module.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

static uint64_t chance;

static uint64_t asked(const char *name, uint64_t normal)
{
    const char *const given = getenv(name);
    return given != NULL ? strtoull(given, NULL, 0) : normal;
}

static tp_scene any_with_foam(void)
{
    tp_scene s = scene_any(&chance);

    s.pool.cols = s.pool.cols < 40 ? s.pool.cols : 40;
    s.pool.rows = s.pool.rows < 40 ? s.pool.rows : 40;
    s.field.cols = 0;
    s.drops.count = s.drops.count < 20 ? s.drops.count : 20;
    s.foam.cells = 1 + s.foam.cells % 48;
    s.spray.count = 1 + s.spray.count % 200;
    strcpy(s.boat.mesh, random_below(&chance, 2) ? "boat.obj" : "");
    return s;
}

/* Moves the eye to any position and changes the water and the parameters. */
static void shake(tp_world *world, tp_scene *scene)
{
    const tp_scene other = any_with_foam();

    scene->foam.map = other.foam.map;
    scene->foam.fade = other.foam.fade;
    scene->foam.hull = other.foam.hull;
    scene->spray.crest = other.spray.crest;
    if (random_below(&chance, 4) == 0)
        world->eye = (tp_vec3){ chance_int(&chance, -8000, 8000) * TP_FX_ONE, 0,
                                chance_int(&chance, -8000, 8000) * TP_FX_ONE };
}

static void nothing_shakes_foam_or_spray(void **state)
{
    (void)state;
    const uint64_t scenes = asked("TP_SCENES", 300);
    uint64_t ran = 0, specks = 0;

    for (uint64_t n = 0; n < scenes; n++) {
        tp_scene scene = any_with_foam();
        tp_world *world = scene_world(&scene, NULL);
        if (!world)
            continue;
        ran++;
        for (int i = 0; i < 60; i++) {
            const tp_input in = { .drops = chance_int(&chance, 0, 3),
                                  .throttle = chance_fx(&chance, -20, 20),
                                  .rudder = chance_fx(&chance, -90, 90) };
            if (i % 7 == 0)
                shake(world, &scene);
            tp_world_step(&tp_program_all, world, &scene, &in);
        }
        const tp_foam *foam = tp_world_foam(world);
        const tp_spray *spray = tp_world_spray(world);
        assert_int_equal(foam->cells, scene.foam.cells);
        assert_true(foam->drift_x >= 0 && foam->drift_z >= 0);
        assert_true(spray->count <= spray->capacity);
        specks += spray->count;
        free(world);
    }
    printf("    %" PRIu64 " of %" PRIu64 " scenes ran, %" PRIu64 " specks in the end\n",
           ran, scenes, specks);
    assert_true(ran > scenes / 3);
}

/* Every fade time, from white to zero, with drift: at most 255 units and some rounds of the
 * threshold, each of 2^24 visits / (a visit's loss). */
static void foam_always_ends(void **state)
{
    static const double fades[] = { 0.1, 0.3, 1, 3.7, 20, 60 };
    (void)state;

    for (int n = 0; n < 6; n++) {
        tp_scene scene;
        tp_scene_level(&scene);
        scene.foam.cells = 24;
        scene.foam.fade = (tp_fx)lround(fades[n] * 65536);
        scene.foam.map.drift_x = chance_int(&chance, -20 * 65536, 20 * 65536);
        tp_world *world = scene_world(&scene, NULL);
        uint8_t *cover = tp_foam_cover(tp_foam_of_world(world)), zero[24 * 24] = { 0 };
        memset(cover, 255, sizeof zero);
        scene.foam.map.drift_x = 0;
        double s = 0;
        for (; memcmp(cover, zero, sizeof zero) != 0; s += 1 / 60.0) {
            assert_true(s < fades[n] * 60);
            tp_world_step(&tp_program_all, world, &scene, NULL);
        }
        printf("    fade %5.1f s: gone after %6.1f s, %.1f fades\n", fades[n], s,
               s / fades[n]);
        free(world);
    }
}

/* From a storm to a calm: thrown spray comes down, white foam fades. */
static void a_storm_ends_in_clear_water(void **state)
{
    (void)state;
    tp_scene scene = scene_plain();

    scene.boat.mesh[0] = '\0';
    scene.foam.cells = 64;
    scene.spray.count = 400;
    for (int i = 0; i < 3; i++)
        scene.wave[i].steepness = TP_FX(0.32);
    tp_world *world = scene_world(&scene, NULL);
    for (int i = 0; i < 300; i++)
        tp_world_step(&tp_program_all, world, &scene, NULL);
    assert_true(tp_world_spray(world)->count > 0);
    for (int i = 0; i < 3; i++)
        scene.wave[i].amplitude = 0;
    assert_true(tp_world_apply(&tp_program_all, world, &scene, NULL));
    for (int i = 0; i < 60 * 60; i++)
        tp_world_step(&tp_program_all, world, &scene, NULL);
    assert_int_equal(tp_world_spray(world)->count, 0);
    for (int i = 0; i < 64 * 64; i++)
        assert_int_equal(tp_foam_cover(tp_foam_of_world(world))[i], 0);
    free(world);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_shakes_foam_or_spray),
        cmocka_unit_test(foam_always_ends),
        cmocka_unit_test(a_storm_ends_in_clear_water),
    };
    return cmocka_run_group_tests_name("stability/foam", tests, NULL, NULL);
}
