/* SPDX-License-Identifier: MIT */
/* The span stages of fast light: selects one of two implementations with identical
 * results. */
#include "features/water/quick_light.h"
#if TP_DSP
#include "features/water/quick_light_m4.h"
#define LIGHT packed_light
#else
#include "features/water/quick_light_plain.h"
#define LIGHT plain_light
#endif

#define STAGE(name, env, lobe) \
    void tp_stage_quick_##name(const tp_shade *shade, tp_run *run) \
    { LIGHT(shade, run, env, lobe); }
TP_QUICK_LIGHT_STAGES(STAGE)

const tp_stage tp_fast_water_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_fast_water(X)
#undef X
};
