/* SPDX-License-Identifier: MIT */
/* Capillary waves: a normal map whose slopes are added to the surface's. */
#include "shade/sampler.h"

/* A normal map's texel (nx, ny, nz), green up the picture, is a slope of -nx along s and
 * +ny along t.  nz is taken as 1: a ripple of slope 0.35 comes out 6 % flat. */
TP_ALWAYS_INLINE void ripple(const tp_shade *shade, tp_run *run, int over)
{
    const tp_layer *layer = &shade->ripple;
    int32_t i = 0;

    while (i < run->count) {
        tp_level l = tp_level_for(shade, layer, run->key[i]);
        int32_t  stop = tp_block_end(run, i);
        for (; i < stop; i++) {
            uint32_t s = run->s[i] * layer->per_metre + layer->drift_s;
            uint32_t t = run->t[i] * layer->per_metre + layer->drift_t;
            uint32_t texel = tp_linear(&l, s, t);
            int32_t  nx = (int32_t)(texel >> 16 & 0xff) - 128;
            int32_t  ny = (int32_t)(texel >> 8 & 0xff) - 128;
            int32_t  sx = over ? run->sx[i] : (int16_t)(run->n[i] >> 16);
            int32_t  sz = over ? run->sz[i] : (int16_t)(run->n[i] & 0xffff);
            sx -= nx * layer->slope_gain >> 3;
            sz += ny * layer->slope_gain >> 3;
            run->sx[i] = (int16_t)tp_clamp(sx, -32000, 32000);
            run->sz[i] = (int16_t)tp_clamp(sz, -32000, 32000);
        }
    }
}

void tp_stage_ripple(const tp_shade *shade, tp_run *run)
{
    ripple(shade, run, 0);
}

void tp_stage_ripple_over(const tp_shade *shade, tp_run *run)
{
    ripple(shade, run, 1);
}
