/* SPDX-License-Identifier: MIT */
/* What still things wear, as it is seen and lit. */
#ifndef TP_SHADE_COAT_H
#define TP_SHADE_COAT_H
#include "shade/shade.h"

/* Four texels of a level around (s, t), repeats in Q0.32; weights are eight bits. */
TP_ALWAYS_INLINE uint32_t tp_coat_texel(const tp_texture *texture, int l, uint32_t s,
                                        uint32_t t)
{
    uint32_t w = 1u << (texture->log2_w > l ? texture->log2_w - l : 0);
    uint32_t h = 1u << (texture->log2_h > l ? texture->log2_h - l : 0);
    uint64_t su = (uint64_t)s * w - 0x80000000u, tv = (uint64_t)t * h - 0x80000000u;
    uint32_t u = (uint32_t)(su >> 32) & (w - 1), u1 = (u + 1) & (w - 1);
    uint32_t v = (uint32_t)(tv >> 32) & (h - 1), v1 = (v + 1) & (h - 1);
    uint32_t fs = (uint32_t)su >> 24, ft = (uint32_t)tv >> 24;
    const uint32_t *row = texture->level[l] + v * w, *below = texture->level[l] + v1 * w;

    return tp_colour_mix(tp_colour_mix(row[u], row[u1], fs),
                         tp_colour_mix(below[u], below[u1], fs), ft);
}

/* At (x, z) metres of its plane, which may be the ground, seen from `far` metres away. */
TP_ALWAYS_INLINE uint32_t tp_coat_at(const tp_coat *coat, tp_fx x, tp_fx z, tp_fx far,
                                     bool ground)
{
    if (!coat->texture)
        return coat->colour;
    int32_t log_far = tp_log2_q8((uint32_t)far | 1) - 16 * 256;
    int     l = tp_level_of(coat->lod, log_far, ground, coat->texture->levels);
    uint32_t texel = tp_coat_texel(coat->texture, l, (uint32_t)x * coat->per_metre,
                                   (uint32_t)z * coat->per_metre);
    return tp_colour_times(texel, coat->colour);
}
#endif
