/* SPDX-License-Identifier: MIT */
/* Fast shading of the visible dome.  The colour is looked up at every 16th column and
 * linear in between.  Close to the sun the colour is looked up at every column.
 *
 * Channels are 8.8 in the halves of a word, so one addition serves two channels. */
#ifndef TP_SKY_DOME_QUICK_H
#define TP_SKY_DOME_QUICK_H
#include "base/dsp.h"

/* Red and blue packed, and green; each with its step per column. */
typedef struct {
    uint32_t rb, g, rb_step, g_step;
} tp_quick_shade;

static inline tp_quick_shade tp_quick_shade_make(uint32_t a, uint32_t b)
{
    uint32_t from = tp_even_bytes(a), to = tp_even_bytes(b);

    return (tp_quick_shade){
        .rb = (from << 8) + 0x00800080, .g = (a & 0xff00) + 0x80,
        .rb_step = tp_pair16((tp_high16(to) - tp_high16(from)) * 16,
                             (tp_low16(to) - tp_low16(from)) * 16),
        .g_step = ((b & 0xff00) - (a & 0xff00)) >> 4,
    };
}

/* Fills columns [k, end) of a block of 16. */
static inline void tp_plain_fill(uint32_t *colour, tp_quick_shade s, int32_t k,
                                 int32_t end)
{
    const int32_t r = tp_high16(s.rb_step), b = tp_low16(s.rb_step);
    const int32_t g = (int16_t)s.g_step;

    for (; k < end; k++) {
        uint32_t red = (s.rb >> 16) + (uint32_t)(r * k);
        uint32_t blue = (s.rb & 0xffff) + (uint32_t)(b * k);
        uint32_t green = s.g + (uint32_t)(g * k);
        *colour++ = (red & 0xff00) << 8 | (green & 0xff00) | (blue >> 8 & 0xff);
    }
}

static inline void tp_packed_fill(uint32_t *colour, tp_quick_shade s, int32_t k,
                                  int32_t end)
{
    s.g_step = (uint32_t)(int32_t)(int16_t)s.g_step;
    for (int32_t i = 0; i < k; i++) {
        s.rb = tp_sadd16(s.rb, s.rb_step);
        s.g += s.g_step;
    }
    for (; k < end; k++) {
        *colour++ = tp_add_odd_bytes(s.g & 0xff00, s.rb);
        s.rb = tp_sadd16(s.rb, s.rb_step);
        s.g += s.g_step;
    }
}
#endif
