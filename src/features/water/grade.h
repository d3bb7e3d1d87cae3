/* SPDX-License-Identifier: MIT */
/* Grading of a texel: saturation, clamp and colour.
 *
 * A channel c becomes v = y + (c - y) saturation, y its grey (.30 .59 .11), clamped to
 * 0..1, then (v - clamp) / (1 - clamp), clamped at 0, times the colour.  Both clamps
 * together equal one clamp of v - clamp to 0..1 - clamp, so the division becomes a part
 * of the colour's gain.  The arithmetic is in Q8 and rounds once. */
#ifndef TP_WATER_GRADE_H
#define TP_WATER_GRADE_H
#include <stdbool.h>
#include "fx/fx.h"
#include "shade/colour.h"
#include "tidepool/modules.h"

/* The grading of a layer's texels.  Levels of 255 are stored in Q8. */
typedef struct {
    int32_t  saturation;        /* 0: grey; 256: unchanged; at most 1024 */
    int32_t  clamp;             /* darker values become black, 0..0.95 of white */
    int32_t  range;              /* white minus the clamp */
    uint32_t gain[3];           /* red, green, blue of the colour / span, Q24 */
} tp_grade;

/* layers_stage.c.  Returns the grading for saturation 0..4, clamp 0..0.95. */
tp_grade tp_grade_make(tp_fx saturation, tp_fx clamp, uint32_t colour);

/* True if a layer needs grading; false if a multiplication by the colour is enough. */
static inline bool tp_is_graded(tp_fx saturation, tp_fx clamp)
{
    return saturation != TP_FX_ONE || clamp > 0;
}

/* Returns a graded channel.  v <= span, and span x gain <= 255 << 24 rounded down, so
 * adding a half still fits. */
TP_ALWAYS_INLINE uint32_t tp_graded_channel(const tp_grade *grade, int32_t grey,
                                            uint32_t c, int channel)
{
    int32_t v = grey + (int32_t)c * grade->saturation;

    v = tp_clamp(v, 0, grade->range);
    return ((uint32_t)v * grade->gain[channel] + (1u << 23)) >> 24;
}

TP_ALWAYS_INLINE uint32_t tp_graded(const tp_grade *grade, tp_split_rgb texel)
{
    uint32_t r = texel.rb >> 16, g = texel.g, b = texel.rb & 0xff;
    int32_t  grey = (int32_t)(77 * r + 150 * g + 29 * b);

    grey = (grey * (256 - grade->saturation) >> 8) - grade->clamp;
    return tp_graded_channel(grade, grey, r, 0) << 16
         | tp_graded_channel(grade, grey, g, 1) << 8
         | tp_graded_channel(grade, grey, b, 2);
}
#endif
