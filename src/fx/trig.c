/* SPDX-License-Identifier: MIT */
/* Sines by a quarter wave of 256 steps and linear interpolation: [G5] of the models, "1024
 * a turn".  The chord of a step lies below the sine by at most (pi/512)^2 / 8 = 4.7e-6.
 * Two symmetries are exact: sin(-a) = -sin(a), sin(half turn - a) = sin(a). */
#include "base/assert.h"
#include "fx/fx.h"

static const tp_q30 quarter_wave[258] = {
#include "fx/trig_table.inc"
};

static const tp_turn octant[130] = {
#include "fx/atan_table.inc"
};

/* Bit 31 of the angle is the sign.  Bit 30 marks the quarters where the wave runs back to
 * 0: there the angle is negated, which modulo half a turn mirrors the angle into [0,
 * quarter].  The step takes 9 bits, to let the quarter itself read entry 256; the
 * fraction takes 22 bits. */
tp_q30 tp_sin(tp_turn angle)
{
    const uint32_t a = angle & 0x40000000 ? 0u - angle : angle;
    const tp_q30 *at = quarter_wave + (a >> 22 & 0x1ff);
    const uint32_t rise = (uint32_t)(at[1] - at[0]);
    const int32_t y = at[0] + (int32_t)((uint64_t)rise * (a << 10) >> 32);
    return (int32_t)angle < 0 ? -y : y;
}

tp_q30 tp_cos(tp_turn angle)
{
    return tp_sin(angle + 0x40000000u);
}

tp_fx tp_fx_sin(tp_turn angle)
{
    return (tp_sin(angle) + (1 << 13)) >> 14;
}

tp_fx tp_fx_cos(tp_turn angle)
{
    return (tp_cos(angle) + (1 << 13)) >> 14;
}

/* Returns the angle of a slope small/large <= 1, by a table of 128 steps.  The chord errs
 * by at most 0.65 / 128^2 / 8 / (2 pi) = 7.9e-7 turn. */
static tp_turn octant_angle(uint32_t small, uint32_t large)
{
    TP_ASSERT(small <= large && large > 0);
    const int shift = tp_clz(large);
    const uint32_t inverse = tp_recip_norm(large << shift);
    const uint32_t slope = (uint32_t)((uint64_t)(small << shift) * inverse >> 32);
    const tp_turn *at = octant + (slope >> 24);                 /* slope is Q1.31 */
    return at[0] + (uint32_t)((uint64_t)(at[1] - at[0]) * (slope << 8) >> 32);
}

static inline uint32_t magnitude(int32_t x)
{
    return x < 0 ? 0u - (uint32_t)x : (uint32_t)x;
}

tp_turn tp_atan2(int32_t y, int32_t x)
{
    const uint32_t rise = magnitude(y), run = magnitude(x);
    if ((rise | run) == 0)
        return 0;
    tp_turn angle = rise <= run ? octant_angle(rise, run)
                                : 0x40000000u - octant_angle(run, rise);
    if (x < 0)
        angle = 0x80000000u - angle;
    return y < 0 ? 0u - angle : angle;
}

/* A degree is 2^32 / 360 of a turn, an LSB of 16.16 is 2^16 / 360; the scale has 24
 * more bits.  Whole turns are removed first: the removal is exact, and the product
 * then fits 64 bits. */
tp_turn tp_turn_of_degrees(tp_fx degrees)
{
    const int64_t scale = 3054198966;           /* round(2^40 / 360) */
    const int32_t rest = degrees % (360 * TP_FX_ONE);
    return (tp_turn)(uint64_t)((rest * scale + (1 << 23)) >> 24);
}
