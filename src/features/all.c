/* SPDX-License-Identifier: MIT */
/* The program with every module.  An application that uses tp_program_all links the whole
 * core. */
#include "tidepool/modules.h"

static const tp_use all[] = {
#define X(name) TP_USE(name),
#define N(name) TP_USE_UNSEEN(name),
#define P(name) TP_USE_PRICED(name),
    TP_MODULE_LIST(X, N, P)
#undef P
#undef N
#undef X
    { 0 }
};

const tp_program tp_program_all = {
    .modules = all,
    .check = tp_scene_check,
    .steering = &tp_world_steering,
    .stage = {
#define X(name) TP_STAGE(name),
        TP_STAGE_LIST(X)
#undef X
    },
    .store = {
#define X(name, word, bits, text) [TP_FORMAT_##name] = tp_store_##word,
        TP_FORMAT_LIST(X)
#undef X
    },
    .water = {
#define X(name) TP_WATER(name),
        TP_WATER_LIST(X)
#undef X
    },
    .method = {
#define X(name) TP_METHOD(name),
        TP_METHOD_LIST(X)
#undef X
    },
    .draw = {
#define X(name) TP_DRAW(name),
        TP_DRAW_LIST(X)
#undef X
    },
};
