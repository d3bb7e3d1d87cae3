/* SPDX-License-Identifier: MIT */
/* Worlds with a boat, for tests. */
#ifndef TP_TESTS_BOATS_H
#define TP_TESTS_BOATS_H
#include "scene/world.h"
#include "scenes.h"
#include "tidepool/modules.h"

#define LSB (1 / 65536.0)

/* Initialises the world of a scene that needs no memory behind the world's head. */
static inline tp_world boat_world(const tp_scene *scene)
{
    tp_world world;

    assert_int_equal(tp_world_bytes(&tp_program_all, scene, NULL), sizeof world);
    assert_int_equal(
        tp_world_init(&tp_program_all, &world, sizeof world, scene, NULL, NULL), TP_OK);
    return world;
}

/* Still water, and a boat away from the origin. */
static inline tp_scene boat_calm_scene(void)
{
    tp_scene scene;

    tp_scene_level(&scene);
    strcpy(scene.boat.mesh, "boat.obj");
    for (int i = 0; i < TP_WAVES; i++)
        scene.wave[i].amplitude = 0;
    scene.boat.x = TP_FX(12.5);
    scene.boat.z = TP_FX(-31.25);
    return scene;
}

static inline void boat_steps(tp_world *world, const tp_scene *scene,
                              const tp_input *in, int ticks)
{
    for (int t = 0; t < ticks; t++)
        tp_world_step(&tp_program_all, world, scene, in);
}

/* Three swells under a boat of any size and heading. */
static inline tp_scene boat_swells(uint64_t *chance, double steepness)
{
    tp_scene scene = scene_plain();

    for (int i = 0; i < 3; i++) {
        scene.wave[i].amplitude = chance_fx(chance, 0.05, 0.5);
        scene.wave[i].length = chance_fx(chance, 8, 40);
        scene.wave[i].steepness = chance_fx(chance, 0, steepness / 3);
        scene.wave[i].heading = chance_fx(chance, -360, 360);
    }
    scene.boat.heading = chance_fx(chance, -720, 720);
    scene.boat.length = chance_fx(chance, 2, 20);
    scene.boat.beam = chance_fx(chance, 2, 6);
    scene.boat.lift = chance_fx(chance, -3, 3);
    return scene;
}
#endif
