/* SPDX-License-Identifier: MIT */
/* The light of a world, and its camera's exposure. */
#ifndef TP_WORLD_LIGHT_H
#define TP_WORLD_LIGHT_H
#include "shade/shade.h"
#include "world/module.h"

/* Returns the unit vector from the world towards the light. */
tp_dir3 tp_light_direction(tp_turn heading, tp_turn elevation);

/* tp_has_dome: true if the scene's sky is a dome. tp_dome_config_make: returns the
 * configuration of the dome; any other kind of sky gives a day dome. */
bool tp_has_dome(const tp_scene *scene);
tp_dome_config tp_dome_config_make(const tp_scene *scene);

void tp_light_init(tp_world *world, const tp_scene *scene);
/* Takes over a changed direction of the scene's light, and the exposure if it is fixed.
 * Otherwise a light moved by time or input stays. */
void tp_light_apply_scene(tp_world *world, const tp_scene *scene);

/* Moves the light by one tick; the exposure does not change. */
void tp_light_step(tp_world *world, const tp_scene *scene, const tp_input *in);

/* True if light and exposure of a world from outside the program are in the ranges that
 * tp_light_step keeps. */
bool tp_light_is_valid(const tp_world *world);

/* True if the sky is a cube map of six textures.  If a texture is missing, the gradient
 * is drawn instead. */
static inline bool tp_has_cube(const tp_scene *scene, const tp_assets *assets)
{
    for (int i = 0; i < TP_FACES; i++)
        if (!assets || !assets->sky[i])
            return false;
    return scene->sky.kind == TP_SKY_CUBE;
}
#endif
