/* SPDX-License-Identifier: MIT */
/* The distortion: a drifting picture moves the places at which the layers are sampled,
 * red along s and green along t; 128 is none, 0 is the whole strength.
 *
 * Ripples stay where they are: bent normals would have to be turned as well.
 *
 * It is always filtered, and to 24 bits: with 8 a strength of 1 m would be steps of a
 * texel or more.  Far away its levels are near their mean, so places come to rest. */
#include "features/water/water.h"
#include "shade/sampler.h"

/* Red and green in halves of a word: mixed once, each fills its half. */
TP_ALWAYS_INLINE uint32_t red_green(uint32_t texel)
{
    return (texel & 0xff0000) | (texel >> 8 & 0xff);
}

/* Between four of 16 bits by eights of a weight: 24 bits, less those of 128, at the top
 * of a word. */
TP_ALWAYS_INLINE int32_t off_none(uint32_t above, uint32_t below, uint32_t ft)
{
    return (int32_t)((above * (256 - ft) + below * ft - (128u << 16)) << 8);
}

static void bend(const tp_sampler *sampler, int32_t strength, const tp_stretch *over,
                 uint32_t *restrict bent_s, uint32_t *restrict bent_t)
{
    const tp_sampler p = *sampler;
    const uint32_t *restrict s = over->s, *restrict t = over->t;
    const int32_t count = over->count;

    for (int32_t i = 0; i < count; i++) {
        tp_four  f = tp_sampler_four(&p, s[i], t[i]);
        uint32_t above = red_green(f.texel[0]) * (256 - f.fs)
                       + red_green(f.texel[1]) * f.fs;
        uint32_t below = red_green(f.texel[2]) * (256 - f.fs)
                       + red_green(f.texel[3]) * f.fs;
        int32_t  red = off_none(above >> 16, below >> 16, f.ft);
        int32_t  green = off_none(above & 0xffff, below & 0xffff, f.ft);
        bent_s[i] = s[i] + (uint32_t)tp_mul_upper(red, strength);
        bent_t[i] = t[i] + (uint32_t)tp_mul_upper(green, strength);
    }
}

/* All of 32 bits of an offset stand for the strength twice over, at most 40 m. */
void tp_stage_bend(const tp_shade *shade, tp_run *run)
{
    const tp_layers *layers = run->mine;
    const tp_layer *layer = &layers->bend;
    tp_stretch w;

    for (int32_t i = 0; i < run->count; i += w.count) {
        w = tp_stretch_from(shade, run, layer, run->s, run->t, i);
        const tp_sampler p = tp_sampler_linear(layer, w.level);
        bend(&p, 2 * layers->strength, &w, run->bent_s + i, run->bent_t + i);
    }
    run->ls = run->bent_s;
    run->lt = run->bent_t;
}
