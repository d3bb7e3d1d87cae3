/* SPDX-License-Identifier: MIT */
/* The water's first picture, laid over the places at rest so that it moves with the
 * water. */
#include "shade/sampler.h"

void tp_stage_plain(const tp_shade *shade, tp_run *run)
{
    for (int32_t i = 0; i < run->count; i++)
        run->colour[i] = shade->water_colour;
}

TP_ALWAYS_INLINE void texture(const tp_shade *shade, tp_run *run, int filter, int tinted)
{
    const tp_layer *layer = &shade->water;
    const uint32_t *place_s = run->ls, *place_t = run->lt;
    uint32_t tint = shade->water_colour, per_metre = layer->per_metre;
    uint32_t drift_s = layer->drift_s, drift_t = layer->drift_t;
    int32_t  count = run->count;

    for (int32_t i = 0; i < count; ) {
        tp_level l = tp_level_for(shade, layer, run->key[i]);
        int32_t  stop = tp_block_end(run, i);
        for (; i < stop; i++) {
            uint32_t s = place_s[i] * per_metre + drift_s;
            uint32_t t = place_t[i] * per_metre + drift_t;
            uint32_t texel = filter ? tp_linear(&l, s, t) : tp_nearest(&l, s, t);
            run->colour[i] = tinted ? tp_colour_times(texel, tint) : texel & 0xffffff;
        }
    }
}

#define TEXTURE_STAGE(name, filter, tinted) \
    void tp_stage_##name(const tp_shade *shade, tp_run *run) \
    { texture(shade, run, filter, tinted); }
TP_TEXTURE_STAGES(TEXTURE_STAGE)
