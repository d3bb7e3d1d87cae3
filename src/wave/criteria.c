/* SPDX-License-Identifier: MIT */
/* Breaking criteria and breaker types, [B14], [B15] and [B20] of the models. */
#include "wave/water_depth.h"
#include "wave/exp.h"

#define STEEP_Q32 3855153630            /* 2^32 2 pi / 7: H/L > 1/7 is Hk > 2 pi/7 */
#define MICHE_Q32 3832022708            /* 2^32 0.142 2 pi */

/* Returns 0.142 L tanh(kh) = 0.142 2 pi tanh(kh) / k.  For k = 0 the limit of
 * tanh(kh)/k is h. */
static tp_scaled miche(tp_scaled k, tp_fx depth)
{
    const tp_scaled h = tp_scaled_from_depth(depth),
                    share = tp_scaled_from_fixed(MICHE_Q32, 32);

    if (k.m == 0)
        return tp_scaled_mul(share, h);
    const tp_scaled t = tp_tanh_scaled(tp_scaled_mul(k, h));
    return tp_scaled_mul(share, tp_scaled_mul(t, tp_scaled_recip(k)));
}

tp_fx tp_miche_height(int64_t k_q32, tp_fx depth)
{
    return depth > 0 ? tp_scaled_fx(miche(tp_scaled_from_wave_number(k_q32), depth)) : 0;
}

uint32_t tp_breaking_flags(tp_fx height, int64_t k_q32, tp_fx depth)
{
    const tp_scaled k = tp_scaled_from_wave_number(k_q32);
    uint32_t flags = 0;

    if (height <= 0)
        return 0;
    const tp_scaled h = tp_scaled_from_fixed((uint32_t)height, 16);
    if (tp_scaled_fixed(tp_scaled_mul(h, k), 32) > STEEP_Q32)
        flags |= TP_BREAKING_STEEP;
    if ((int64_t)height * 100 > (int64_t)depth * 78)
        flags |= TP_BREAKING_DEPTH;
    if (depth <= 0 || tp_scaled_fixed(h, 32) > tp_scaled_fixed(miche(k, depth), 32))
        flags |= TP_BREAKING_MICHE;
    return flags;
}

tp_fx tp_iribarren(tp_q30 slope, tp_fx height, tp_fx length)
{
    if (slope <= 0 || length <= 0)
        return 0;
    if (height <= 0)
        return TP_FX_MAX;
    const tp_scaled over = tp_scaled_recip(tp_scaled_from_fixed((uint32_t)height, 16));
    const tp_scaled slender =
        tp_scaled_mul(tp_scaled_from_fixed((uint32_t)length, 16), over);
    return tp_scaled_fx(tp_scaled_mul(tp_scaled_from_fixed((uint32_t)slope, 30),
                                      tp_scaled_sqrt(slender)));
}

tp_breaker_type tp_breaker_classify(tp_fx iribarren)
{
    return iribarren < TP_FX(0.5) ? TP_BREAKER_SPILLING
         : iribarren <= TP_FX(3.3) ? TP_BREAKER_PLUNGING : TP_BREAKER_SURGING;
}
