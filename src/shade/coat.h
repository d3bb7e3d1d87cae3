/* SPDX-License-Identifier: MIT */
/* What still things wear, as it is seen and lit. */
#ifndef TP_SHADE_COAT_H
#define TP_SHADE_COAT_H
#include "shade/sampler.h"

/* At (x, z) metres of its plane, which may be the ground, seen from `far` metres away. */
TP_ALWAYS_INLINE uint32_t tp_coat_at(const tp_coat *coat, tp_fx x, tp_fx z, tp_fx far,
                                     bool ground)
{
    if (!coat->texture)
        return coat->colour;
    int32_t log_far = tp_log2_q8((uint32_t)far | 1) - 16 * 256;
    int     l = tp_level_of(coat->lod, log_far, ground, coat->texture->levels);
    tp_level level = tp_level_at(coat->texture, l);
    uint32_t texel = tp_linear(&level, (uint32_t)x * coat->per_metre,
                               (uint32_t)z * coat->per_metre);
    return tp_colour_times(texel, coat->colour);
}
#endif
