/* SPDX-License-Identifier: MIT */
/* A scene with all that it names as constants, for machines without files;
 * `tidepool bake SCENE --name baked` writes them. */
#ifndef BAKED_H
#define BAKED_H
#include "tidepool/modules.h"

extern const tp_scene  baked_scene;
extern const tp_assets baked_assets;

/* With --size or --format: what the scene needs to be drawn so. */
extern const tp_program baked_program;
extern const tp_config baked_config;
#endif
