/* SPDX-License-Identifier: MIT */
/* Rungs that change the world: values of a scene that make a tick cheaper.  Nothing sets them
 * but the scene itself, or a --set: they change the water. */
#ifndef TP_APP_SCENE_WORLD_RUNGS_H
#define TP_APP_SCENE_WORLD_RUNGS_H
#include "loaded_scene.h"
#include "interact/tick_cost.h"

#define WORLD_RUNGS 12

typedef struct {
    char text[512];             /* settings apart by spaces: "pool.cols=48 pool.rows=48" */
    tick_cost cost;             /* of a tick with them */
    bool all;                   /* all other rungs together */
} world_rung;

typedef struct {
    tick_cost  now;
    world_rung rung[WORLD_RUNGS];
    int        count;           /* 0: the scene has neither pools nor foam */
} world_rungs;

/* Estimates a tick of a new world of the scene; false: the scene makes no world. */
bool world_rungs_tick(const tp_scene *scene, const tp_assets *assets,
                      tp_processor processor, tick_cost *cost);

/* Finds the rungs of a scene that make a tick cheaper and that its checks accept, each
 * alone, the cheapest first, and last all together if there are several.  Runs a second of
 * the scene for each. */
world_rungs world_rungs_find(const loaded_scene *s, tp_processor processor);
#endif
