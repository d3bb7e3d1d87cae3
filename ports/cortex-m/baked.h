/* SPDX-License-Identifier: MIT */
/* A baked scene: the scene and its pictures as constants, for machines without files.
 * `tidepool bake SCENE --name baked` writes the file that defines them. */
#ifndef TP_CORTEX_M_BAKED_H
#define TP_CORTEX_M_BAKED_H
#include "tidepool/modules.h"

extern const tp_scene  baked_scene;
extern const tp_assets baked_assets;

/* Written if --size or --format is given: the program and the config that draw the
 * scene, its frame, and its world at tick 0. */
extern const tp_program baked_program;
extern const tp_config baked_config;
extern const size_t baked_world_bytes;
tp_status baked_world_init(tp_world *world, size_t bytes, tp_error *err);
size_t baked_frame_bytes(void);
tp_status baked_frame_init(tp_frame **frame, void *memory, size_t bytes, tp_error *err);
extern const size_t baked_scratch_bytes, baked_direct_scratch_bytes;
#endif
