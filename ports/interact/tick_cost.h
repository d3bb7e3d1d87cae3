/* SPDX-License-Identifier: MIT */
/* Estimates a tick's instructions from counted costs of pools and foam. */
#ifndef TP_INTERACT_TICK_COST_H
#define TP_INTERACT_TICK_COST_H
#include <stdbool.h>
#include <stdint.h>
#include "quality/rung_sets.h"
#include "tidepool/scene.h"
#include "tidepool/world.h"

typedef struct {
    uint64_t mean, most;        /* instructions of a tick: mean, and of the dearest tick */
} tick_cost;

/* Steps a new world of the scene for a second, as the budgets do, and estimates the ticks
 * that follow.  Counts pools and foam; what else a tick does, such as boats and spray, is a
 * few per cent of such a tick. */
tick_cost tick_cost_estimate(tp_world *world, const tp_scene *scene,
                             tp_processor processor);
#endif
