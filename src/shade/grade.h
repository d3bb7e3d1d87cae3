/* SPDX-License-Identifier: MIT */
/* A texel's saturation, clamp and colour.
 *
 * A channel c becomes v = y + (c - y) saturation, y its grey (.30 .59 .11), held within
 * 0..1, then (v - clamp) / (1 - clamp), held at 0, times the colour.  Holding twice is
 * holding v - clamp within 0..1 - clamp, so the division is a part of the colour's gain;
 * all of it is done in Q8 and rounded once. */
#ifndef TP_SHADE_GRADE_H
#define TP_SHADE_GRADE_H
#include "shade/colour.h"
#include "shade/layer.h"

/* v <= span, span gain <= 255 << 24 rounded down: a half more still fits. */
TP_ALWAYS_INLINE uint32_t tp_graded_channel(const tp_grade *grade, int32_t grey,
                                            uint32_t c, int channel)
{
    int32_t v = grey + (int32_t)c * grade->saturation;

    v = tp_clamp(v, 0, grade->span);
    return ((uint32_t)v * grade->gain[channel] + (1u << 23)) >> 24;
}

TP_ALWAYS_INLINE uint32_t tp_graded(const tp_grade *grade, tp_parted texel)
{
    uint32_t r = texel.rb >> 16, g = texel.g, b = texel.rb & 0xff;
    int32_t  grey = (int32_t)(77 * r + 150 * g + 29 * b);

    grey = (grey * (256 - grade->saturation) >> 8) - grade->clamp;
    return tp_graded_channel(grade, grey, r, 0) << 16
         | tp_graded_channel(grade, grey, g, 1) << 8
         | tp_graded_channel(grade, grey, b, 2);
}
#endif
