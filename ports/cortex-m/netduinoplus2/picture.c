/* SPDX-License-Identifier: MIT */
/* An LCD of 320x240 in bands, in the order of bytes that it takes them in.  The megabyte
 * of flash holds every effect; crossings are streamed, since 128 KB would not hold them
 * all. */
#include "cortex-m/board.h"

static const tp_use modules[] = {
#define X(name) TP_USE(name),
#define N(name) TP_USE_UNSEEN(name),
    TP_MODULE_LIST(X, N)
#undef N
#undef X
    { 0 }
};

static const tp_kit kit = {
    .modules = modules,
#define X(name) .name = tp_stage_##name,
    .stage = { TP_STAGE_LIST(X) },
#undef X
    .store[TP_FORMAT_RGB565BE] = tp_store_rgb565be,
#define X(name) .name = &tp_water_##name,
    .water = { TP_WATER_LIST(X) },
#undef X
#define X(name) .name = &tp_move_##name,
    .move = { TP_MOVE_LIST(X) },
#undef X
#define X(name) .name = &tp_draw_##name,
    .draw = { TP_DRAW_LIST(X) },
#undef X
    .method.triangles = &tp_method_streamed,
    .method.rows = &tp_method_rows,
    .method.projected = &tp_method_projected,
    .method.flat = &tp_method_flat,
};

const tp_kit *const board_kit = &kit;
const tp_frame_config board_picture = { 320, 240, 0, 4, TP_FORMAT_RGB565BE };
