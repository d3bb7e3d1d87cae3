/* SPDX-License-Identifier: MIT */
/* Automatic exposure.
 *
 *     meter.c           the module: mean brightness of the camera's view, once per tick
 *     auto_exposure.c   the adaptation of the exposure to the mean */
#ifndef TP_METER_MODULE_H
#define TP_METER_MODULE_H
#include "scene/module.h"
#include "tidepool/world.h"

/* True if the exposure is automatic. */
bool tp_world_is_metered(const tp_world *world);

#define TP_METER_ID TP_MODULE_ID('m', 'e', 't', 'r')

/* Returns the mean brightness of the view, white is 1; 0: the world has no meter. */
tp_fx tp_meter_mean(const tp_world *world, const tp_scene *scene);
#endif
