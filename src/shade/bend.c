/* SPDX-License-Identifier: MIT */
/* The distortion: a drifting picture moves the places at which the layers are sampled,
 * red along s and green along t; 128 is none, 0 is the whole strength.
 *
 * Ripples stay where they are: bent normals would have to be turned as well.
 *
 * It is always filtered, and to 24 bits: with 8 a strength of 1 m would be steps of a
 * texel or more.  Far away its levels are near their mean, so places come to rest. */
#include "shade/sampler.h"

/* Between four of 16 bits by eights of a weight: 24 bits, less those of 128. */
TP_ALWAYS_INLINE int32_t off_none(uint32_t above, uint32_t below, uint32_t ft)
{
    return (int32_t)(above * (256 - ft) + below * ft) - (128 << 16);
}

/* Red and green in halves of a word: mixed once, each fills its half. */
TP_ALWAYS_INLINE uint32_t red_green(uint32_t texel)
{
    return (texel & 0xff0000) | (texel >> 8 & 0xff);
}

void tp_stage_bend(const tp_shade *shade, tp_run *run)
{
    const tp_layer *layer = &shade->layers.bend;
    int64_t strength = shade->layers.strength;

    for (int32_t i = 0; i < run->count; ) {
        tp_level l = tp_level_for(shade, layer, run->key[i]);
        int32_t  stop = tp_block_end(run, i);
        for (; i < stop; i++) {
            uint32_t s = run->s[i] * layer->per_metre + layer->drift_s;
            uint32_t t = run->t[i] * layer->per_metre + layer->drift_t;
            tp_four  f = tp_four_around(&l, s, t);
            uint32_t above = red_green(f.texel[0]) * (256 - f.fs)
                           + red_green(f.texel[1]) * f.fs;
            uint32_t below = red_green(f.texel[2]) * (256 - f.fs)
                           + red_green(f.texel[3]) * f.fs;
            int32_t  red = off_none(above >> 16, below >> 16, f.ft);
            int32_t  green = off_none(above & 0xffff, below & 0xffff, f.ft);
            run->bent_s[i] = run->s[i] + (uint32_t)(int32_t)(red * strength >> 23);
            run->bent_t[i] = run->t[i] + (uint32_t)(int32_t)(green * strength >> 23);
        }
    }
    run->ls = run->bent_s;
    run->lt = run->bent_t;
}
