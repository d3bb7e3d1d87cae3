/* SPDX-License-Identifier: MIT */
/* A texel's saturation, clamp and colour.
 *
 * A channel c becomes v = y + (c - y) saturation, y its grey (.30 .59 .11), held within
 * 0..1, then (v - clamp) / (1 - clamp), held at 0, times the colour.  Holding twice is
 * holding v - clamp within 0..1 - clamp, so the division is a part of the colour's gain;
 * all of it is done in Q8 and rounded once. */
#ifndef TP_WATER_GRADE_H
#define TP_WATER_GRADE_H
#include <stdbool.h>
#include "fx/fx.h"
#include "shade/colour.h"
#include "tidepool/modules.h"

/* The grading of a layer's texels.  Levels of 255 are Q8 here. */
typedef struct {
    int32_t  saturation;        /* 0 is its grey, 256 leaves it as it is, 1024 at most */
    int32_t  clamp;             /* darker is black, 0..0.95 of white */
    int32_t  span;              /* white less the clamp */
    uint32_t gain[3];           /* red, green, blue of the colour / span, Q24 */
} tp_grade;

/* layers_stage.c: saturation 0..4, clamp 0..0.95 */
tp_grade tp_grade_of(tp_fx saturation, tp_fx clamp, uint32_t colour);

/* False: the colour is all that is done. */
static inline bool tp_is_graded(tp_fx saturation, tp_fx clamp)
{
    return saturation != TP_FX_ONE || clamp > 0;
}

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
