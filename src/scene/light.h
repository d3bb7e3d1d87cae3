/* SPDX-License-Identifier: MIT */
/* The light of a world, and its camera's exposure. */
#ifndef TP_SCENE_LIGHT_H
#define TP_SCENE_LIGHT_H
#include "scene/parts.h"
#include "shade/skies.h"

/* From the world to the light. */
tp_dir3 tp_light_direction(tp_turn heading, tp_turn elevation);

/* Whether the scene's sky is a dome, and what of: of other skies a day's. */
bool tp_has_dome(const tp_scene *scene);
tp_dome_config tp_dome_of(const tp_scene *scene);

void tp_light_init(tp_world *world, const tp_scene *scene);
void tp_light_refresh(tp_world *world, const tp_scene *scene);

/* Moves the light; the exposure stays. */
void tp_light_step(tp_world *world, const tp_scene *scene, const tp_input *in);

/* True if the light and the exposure of a world from outside are in the ranges that steps
 * keep. */
bool tp_light_is_valid(const tp_world *world);

/* A sky of six pictures: one that is missing leaves the gradient. */
static inline bool tp_has_cube(const tp_scene *scene, const tp_assets *assets)
{
    for (int i = 0; i < TP_FACES; i++)
        if (!assets || !assets->sky[i])
            return false;
    return scene->sky.kind == TP_SKY_CUBE;
}
#endif
