/* SPDX-License-Identifier: MIT */
/* Speeds and heights over a depth, [B3] and [B7] of the models.
 *
 * With x = kh and T = tanh x / x, the factor 1 + 2x / sinh 2x of [B7] is (T
 * + sech^2 x) / T. */
#include "wave/water_depth.h"
#include "wave/exp.h"

/* Returns (1 + 2x / sinh 2x) / 2 = cg / c at x = kh: 1/2 in deep water, 1 in shallow
 * water.  T >= 1/256. */
static tp_scaled group_speed_ratio(tp_scaled k, tp_fx depth)
{
    const tp_scaled x = tp_scaled_mul(k, tp_scaled_from_depth(depth));
    const tp_tanh at = tp_tanh_evaluate(tp_scaled_q24(x));
    const uint64_t sum = (uint64_t)at.ratio_q31 + tp_sech_squared(at);
    const tp_scaled over = tp_scaled_recip(tp_scaled_from_fixed(at.ratio_q31, 31));
    return tp_scaled_mul(tp_scaled_from_fixed(sum, 32), over);
}

static tp_scaled speed(tp_scaled k_inf, tp_scaled k, tp_fx gravity)
{
    const tp_scaled g = tp_scaled_from_fixed((uint32_t)(gravity > 0 ? gravity : 0), 16);
    const tp_scaled omega = tp_scaled_sqrt(tp_scaled_mul(g, k_inf));
    return tp_scaled_mul(omega, tp_scaled_recip(k));
}

tp_fx tp_depth_speed(int64_t k_inf_q32, int64_t k_q32, tp_fx gravity)
{
    if (k_q32 <= 0)
        return 0;
    return tp_scaled_fx(speed(tp_scaled_from_wave_number(k_inf_q32),
                              tp_scaled_from_wave_number(k_q32), gravity));
}

tp_fx tp_depth_group_speed(int64_t k_inf_q32, int64_t k_q32, tp_fx depth, tp_fx gravity)
{
    if (k_q32 <= 0)
        return 0;
    const tp_scaled k = tp_scaled_from_wave_number(k_q32);
    const tp_scaled c = speed(tp_scaled_from_wave_number(k_inf_q32), k, gravity);
    return tp_scaled_fx(tp_scaled_mul(c, group_speed_ratio(k, depth)));
}

/* Ks^2 = c_inf / 2 cg = (k / k_inf) / (2 cg/c). */
tp_fx tp_depth_shoaling(int64_t k_inf_q32, int64_t k_q32, tp_fx depth)
{
    if (k_inf_q32 <= 0 || k_q32 <= 0)
        return TP_FX_ONE;
    const tp_scaled k = tp_scaled_from_wave_number(k_q32);
    tp_scaled below =
        tp_scaled_mul(tp_scaled_from_wave_number(k_inf_q32), group_speed_ratio(k, depth));
    below.e++;
    const tp_scaled square = tp_scaled_mul(k, tp_scaled_recip(below));
    return tp_scaled_fx(tp_scaled_sqrt(square));
}

/* Returns cos^2 of the angle between a wave and the shore's normal, Q1.31, at least 1/256.
 * The product (k - kz)(k + kz) keeps the bits that 1 - (kz/k)^2 would lose. */
static tp_scaled cosine_squared(int64_t k_q32, uint64_t kz_q32)
{
    const tp_scaled least = tp_scaled_from_fixed(1, 8);
    const uint64_t k = k_q32 > 0 ? (uint64_t)k_q32 : 0;

    if (k <= kz_q32)
        return least;
    const tp_scaled over = tp_scaled_recip(tp_scaled_from_fixed(k, 32));
    const tp_scaled less = tp_scaled_mul(tp_scaled_from_fixed(k - kz_q32, 32), over);
    const tp_scaled more = tp_scaled_mul(tp_scaled_from_fixed(k + kz_q32, 32), over);
    const tp_scaled square = tp_scaled_mul(less, more);
    return tp_scaled_fixed(square, 31) > 1 << 23 ? square : least;
}

/* Kr^4 = cos^2 th_inf / cos^2 th, 1/256..256 before the roots. */
tp_fx tp_depth_refraction(int64_t k_inf_q32, int64_t k_q32, int64_t kz_q32)
{
    const uint64_t kz = kz_q32 < 0 ? 0u - (uint64_t)kz_q32 : (uint64_t)kz_q32;
    const tp_scaled over = tp_scaled_recip(cosine_squared(k_q32, kz));
    const tp_scaled ratio = tp_scaled_mul(cosine_squared(k_inf_q32, kz), over);
    return tp_scaled_fx(tp_scaled_sqrt(tp_scaled_sqrt(ratio)));
}

static tp_scaled scaled_from_positive(tp_fx x)
{
    return tp_scaled_from_fixed((uint32_t)(x > 0 ? x : 0), 16);
}

tp_fx tp_depth_amplitude(tp_fx amplitude, tp_fx ks, tp_fx kr, tp_fx depth)
{
    if (depth <= 0)
        return 0;
    const tp_scaled grown =
        tp_scaled_mul(scaled_from_positive(amplitude), scaled_from_positive(ks));
    const tp_fx most = tp_q30_mul(depth, TP_Q30(0.39));
    const tp_fx a = tp_scaled_fx(tp_scaled_mul(grown, scaled_from_positive(kr)));
    return a < most ? a : most;
}
