/* SPDX-License-Identifier: MIT */
/* Automatic exposure.
 *
 *     meter.c           the module: how bright the camera's view is, once a tick
 *     auto_exposure.c   how the exposure follows that */
#ifndef TP_METER_MODULE_H
#define TP_METER_MODULE_H
#include "scene/module.h"
#include "tidepool/world.h"

/* True if the exposure is automatic. */
bool tp_world_is_metered(const tp_world *world);

#define TP_METER_ID TP_MODULE_ID('m', 'e', 't', 'r')

/* The mean over the view, 1 is white; 0: the world has no meter. */
tp_fx tp_meter_mean(const tp_world *world, const tp_scene *scene);
#endif
