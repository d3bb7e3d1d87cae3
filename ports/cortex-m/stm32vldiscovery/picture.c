/* SPDX-License-Identifier: MIT */
/* An OLED of 128x64 in black and white, in 8 KB of RAM: level water with the light of its
 * waves, one texture and the sky, in small tiles. */
#include "cortex-m/board.h"

static const tp_use modules[] = { TP_USE_WITH(haze, tp_stage_haze, NULL, NULL), { 0 } };

static const tp_kit kit = {
    .modules = modules,
    .stage = { TP_STAGE(sky), TP_STAGE(plain), TP_STAGE(texture_linear_graded),
               TP_STAGE(diffuse) },
    .store[TP_FORMAT_I1] = tp_store_i1,
    .water.swells = &tp_water_few_swells,
    .method.flat = &tp_method_flat,
};

const tp_kit *const board_kit = &kit;
const tp_frame_config board_picture = { 128, 64, 16, 4, TP_FORMAT_I1 };
