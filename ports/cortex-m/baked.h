/* SPDX-License-Identifier: MIT */
/* A baked scene: the scene and its pictures as constants, for machines without files.
 * `tidepool bake SCENE --name baked` writes the file that defines them. */
#ifndef TP_CORTEX_M_BAKED_H
#define TP_CORTEX_M_BAKED_H
#include "tidepool/modules.h"

extern const tp_scene  baked_scene;
extern const tp_assets baked_assets;

/* Written if --size or --format is given: the program and the config that draw the
 * scene. */
extern const tp_program baked_program;
extern const tp_config baked_config;
#endif
