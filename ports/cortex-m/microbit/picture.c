/* SPDX-License-Identifier: MIT */
/* A small colour LCD of 160x128, in 16 KB of RAM: level water with the light of its waves,
 * one texture and the sky, in strips. */
#include "cortex-m/board.h"

static const tp_use modules[] = { TP_USE_WITH(haze, tp_stage_haze, NULL, NULL), { 0 } };

static const tp_kit kit = {
    .modules = modules,
    .stage = { TP_STAGE(sky), TP_STAGE(plain), TP_STAGE(texture_linear_graded),
               TP_STAGE(diffuse) },
    .store[TP_FORMAT_RGB565BE] = tp_store_rgb565be,
    .water.swells = &tp_water_few_swells,
    .method.flat = &tp_method_flat,
};

const tp_kit *const board_kit = &kit;
const tp_frame_config board_picture = { 160, 128, 32, 8, TP_FORMAT_RGB565BE };
