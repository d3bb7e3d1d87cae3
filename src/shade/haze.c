/* SPDX-License-Identifier: MIT */
/* Air between the eye and the water: colours go into the horizon's.
 *
 * The share is z^2 / (z^2 + h^2), a half at h and nothing near the eye.  It is a rule of
 * our own: smooth in 1/z, which is what a sample holds, so a short table serves. */
#include "shade/shade.h"

void tp_stage_haze(const tp_shade *shade, tp_run *run)
{
    uint32_t horizon = shade->sky[0], scale = shade->haze_scale;

    for (int32_t i = 0; i < run->count; i++) {
        uint32_t entry = (uint32_t)((uint64_t)(run->key[i] >> 1) * scale >> 32);
        uint32_t share = shade->haze[entry < TP_HAZE ? entry : TP_HAZE];
        run->colour[i] = tp_colour_mix(run->colour[i], horizon, share);
    }
}
