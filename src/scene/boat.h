/* SPDX-License-Identifier: MIT */
/* The boat on the waves. */
#ifndef TP_SCENE_BOAT_H
#define TP_SCENE_BOAT_H
#include "tidepool/scene.h"

/* Sets world->boat and world->boat_turn from the surface under the hull [E2]. */
void tp_boat_place(tp_world *world, const tp_scene *scene);
#endif
