/* SPDX-License-Identifier: MIT */
/* Span stage of the glint: adds the glint to the water's colour. */
#include "shade/shade.h"
#include "tidepool/modules.h"

void tp_stage_glint(const tp_shade *restrict shade, tp_run *restrict run)
{
    const uint32_t light = shade->light_colour;
    const int32_t  count = run->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t share = run->glint[i];
        if (!TP_WIDE && share == 0)         /* the usual case of most water pixels */
            continue;
        share = share > 256 ? 256 : share;
        run->colour[i] = tp_colour_add(run->colour[i], tp_colour_scale(light, share));
    }
}

const tp_stage tp_glint_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_glint(X)
#undef X
};
