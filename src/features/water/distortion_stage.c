/* SPDX-License-Identifier: MIT */
/* Span stage of the distortion: a drifting texture moves the places at which layers are
 * sampled.  Red moves along s, green along t; 128 is no offset, 0 is the full negative
 * strength.
 *
 * Ripples are not distorted: their normals would have to be turned as well.
 *
 * The texture is always filtered, to 24 bits: with 8 bits a strength of 1 m would give
 * steps of a texel or more.  In the distance small mipmap levels are near the mean, so
 * the places come to rest. */
#include "features/water/water.h"
#include "shade/sampler.h"

/* Returns red and green in the halves of a word; after one mix each fills its half. */
TP_ALWAYS_INLINE uint32_t red_green(uint32_t texel)
{
    return (texel & 0xff0000) | (texel >> 8 & 0xff);
}

/* Mixes two 16-bit values by the weight ft / 256, and subtracts the offset of 128.  The
 * result has 24 significant bits at the top of the word. */
TP_ALWAYS_INLINE int32_t signed_mix(uint32_t above, uint32_t below, uint32_t ft)
{
    return (int32_t)((above * (256 - ft) + below * ft - (128u << 16)) << 8);
}

static void distort_stretch(const tp_sampler *sampler, int32_t strength,
                            const tp_stretch *over, uint32_t *restrict bent_s,
                            uint32_t *restrict bent_t)
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
        int32_t  red = signed_mix(above >> 16, below >> 16, f.ft);
        int32_t  green = signed_mix(above & 0xffff, below & 0xffff, f.ft);
        bent_s[i] = s[i] + (uint32_t)tp_mul_upper(red, strength);
        bent_t[i] = t[i] + (uint32_t)tp_mul_upper(green, strength);
    }
}

/* Distorts a run.  The 32 bits of an offset span twice the strength, at most 40 m. */
void tp_stage_bend(const tp_shade *shade, tp_run *run)
{
    const tp_layers *layers = run->mine;
    const tp_layer *layer = &layers->bend;
    tp_stretch w;

    for (int32_t i = 0; i < run->count; i += w.count) {
        w = tp_stretch_find(shade, run, layer, run->s, run->t, i);
        const tp_sampler p = tp_sampler_linear(layer, w.level);
        distort_stretch(&p, 2 * layers->strength, &w, run->bent_s + i, run->bent_t + i);
    }
    run->ls = run->bent_s;
    run->lt = run->bent_t;
}
