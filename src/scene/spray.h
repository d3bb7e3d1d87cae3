/* SPDX-License-Identifier: MIT */
/* Spray and bubbles as the world steps them. */
#ifndef TP_SCENE_SPRAY_H
#define TP_SCENE_SPRAY_H
#include "tidepool/kit.h"
#include "tidepool/scene.h"

/* Of the block, aligned to 8; 0: the scene has none. */
size_t tp_spray_bytes(const tp_scene *scene);
void   tp_spray_init(tp_spray *spray, const tp_scene *scene);

/* One tick, after all else has moved. */
void tp_spray_step(const tp_kit *kit, tp_world *world, const tp_scene *scene);

/* Whether spray whose bytes come from outside can be stepped and drawn: its room equals
 * `fresh`'s, that of the same scene; specks are in the ranges that steps keep. */
bool tp_spray_is_valid(const tp_spray *spray, const tp_spray *fresh);

/* A drop has struck water of this level: a crown of specks, and bubbles under it. */
void tp_spray_splash(tp_spray *spray, const tp_scene *scene, const tp_impact *impact,
                     tp_fx level);
#endif
