/* SPDX-License-Identifier: MIT */
/* Estimates a tick's instructions from counted costs of pools and foam. */
#ifndef TP_APP_SCENE_TICK_COST_H
#define TP_APP_SCENE_TICK_COST_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/assets.h"
#include "tidepool/scene.h"
#include "quality/rung_sets.h"

typedef struct {
    uint64_t mean, most;        /* instructions of a tick: mean, and of the dearest tick */
} tick_cost;

/* Runs a new world of the scene for a second, as the budgets do, and estimates the ticks
 * that follow.  Counts pools and foam; what else a tick does, such as boats and spray, is a
 * few per cent of such a tick.  Returns false if the scene makes no world. */
bool tick_cost_estimate(const tp_scene *scene, const tp_assets *assets,
                        tp_processor processor, tick_cost *cost);
#endif
