/* SPDX-License-Identifier: MIT */
/* A single wave over a depth and under wind, formula by formula: wave numbers [B1]-[B6],
 * speeds and heights [B3] [B7], breaking [B14] [B15] [B20], wind [B10] of the models. */
#include "base/base.h"
#include "waves/softfloat.h"
#include "waves/water_depth.h"

/* -- wave numbers -------------------------------------------------------------------- */

/* Wave numbers over a depth, [B1]-[B6] of the models.
 *
 * With y = k_inf h, x = kh and T(x) = tanh x / x, Newton's step for x tanh x = y is
 *     x -= (x tanh x - y) / (tanh x + x sech^2 x)
 *        = x (T(x) - y/x^2) / (T(x) + sech^2 x),
 * and y/x^2 is T(y) for Eckart's x = y / sqrt(tanh y).  Only numbers between 0 and 1 are
 * subtracted, and the relative error stays small even for films of water. */

#define PI_Q32 13493037705              /* 2^32 pi */

tp_scaled tp_scaled_from_depth(tp_fx depth)
{
    return tp_scaled_from_fixed((uint32_t)(depth > 0 ? depth : TP_DEPTH_LEAST), 16);
}

uint32_t tp_scaled_q24(tp_scaled x)
{
    const int64_t fixed = tp_scaled_fixed(x, 24);
    return fixed > UINT32_MAX ? UINT32_MAX : (uint32_t)fixed;
}

/* Returns the factor of x in Newton's step, Q1.31; u is y/x^2.  The denominator is at least
 * 1/12: as Q2.30 it has 26 bits and more.  |T - u| < 2^29, and the reciprocal has 32
 * bits. */
static uint32_t newton_factor(tp_tanh at, uint32_t u_q31)
{
    const uint32_t below = (at.ratio_q31 >> 1) + (tp_sech_squared(at) >> 1);
    const int up = tp_clz(below);
    const int64_t gap = (int64_t)at.ratio_q31 - u_q31;
    const int64_t part = gap * (int64_t)tp_recip_norm(below << up);
    return 0x80000000u - (uint32_t)((part + ((int64_t)1 << (32 - up))) >> (33 - up));
}

tp_scaled tp_depth_wave_number_scaled(tp_scaled k_inf, tp_scaled depth, int steps)
{
    TP_ASSERT(k_inf.m != 0 && depth.m != 0 && steps >= 0);
    const tp_scaled y = tp_scaled_mul(k_inf, depth);
    const uint32_t y_q24 = tp_scaled_q24(y);

    if (y_q24 >= TP_DEPTH_DEEP_Q24)
        return k_inf;
    tp_scaled u = tp_scaled_from_fixed(tp_tanh_evaluate(y_q24).ratio_q31, 31);
    tp_scaled k = tp_scaled_mul(k_inf, tp_scaled_rsqrt(tp_scaled_mul(y, u)));
    for (int i = 0; i < steps; i++) {
        const tp_tanh at = tp_tanh_evaluate(tp_scaled_q24(tp_scaled_mul(k, depth)));
        const uint32_t u_q31 = (uint32_t)tp_scaled_fixed(u, 31);
        const tp_scaled factor = tp_scaled_from_fixed(newton_factor(at, u_q31), 31);
        k = tp_scaled_mul(k, factor);
        if (i + 1 == steps)
            break;
        const tp_scaled over = tp_scaled_recip(factor);
        u = tp_scaled_mul(u, tp_scaled_mul(over, over));
    }
    return k;
}

static int64_t solve_wave_number(int64_t k_inf_q32, tp_fx depth, int steps)
{
    if (k_inf_q32 <= 0)
        return 0;
    const tp_scaled k_inf = tp_scaled_from_wave_number(k_inf_q32);
    const tp_scaled k =
        tp_depth_wave_number_scaled(k_inf, tp_scaled_from_depth(depth), steps);
    const int64_t rounded = tp_scaled_fixed(k, 32);
    return rounded > k_inf_q32 ? rounded : k_inf_q32;   /* k >= k_inf: its scaled form may
                                                         * have been truncated */
}

int64_t tp_depth_wave_number_eckart(int64_t k_inf_q32, tp_fx depth)
{
    return solve_wave_number(k_inf_q32, depth, 0);
}

int64_t tp_depth_wave_number(int64_t k_inf_q32, tp_fx depth)
{
    return solve_wave_number(k_inf_q32, depth, 1);
}

int64_t tp_depth_wave_number_exact(int64_t k_inf_q32, tp_fx depth)
{
    return solve_wave_number(k_inf_q32, depth, 3);
}

/* Returns the cube root of n < 2^63, rounded down, bit by bit. */
static uint32_t cube_root(uint64_t n)
{
    uint64_t r = 0;

    for (uint64_t bit = 1u << 20; bit != 0; bit >>= 1) {
        const uint64_t more = r | bit;
        if (more * more * more <= n)
            r = more;
    }
    return (uint32_t)r;
}

/* m 2^e = (m 2^up) 2^(e - up) with e - up a multiple of 3.  m 2^up has 60 bits and more:
 * the root has 20 bits, with a relative error below 2^-20. */
static tp_scaled scaled_cube_root(tp_scaled x)
{
    const int up = 29 + ((x.e - 29) % 3 + 3) % 3;
    tp_scaled root = tp_scaled_from_fixed(cube_root((uint64_t)x.m << up), 0);

    root.e += (x.e - up) / 3;
    return root;
}

/* Returns tanh x for any x >= 0. */
static tp_scaled tanh_scaled(tp_scaled x)
{
    const tp_tanh at = tp_tanh_evaluate(tp_scaled_q24(x));
    if (x.e + 31 >= 4)                                              /* x >= 16 */
        return tp_scaled_from_fixed(1, 0);
    return tp_scaled_mul(x, tp_scaled_from_fixed(at.ratio_q31, 31));
}

int64_t tp_depth_wave_number_fenton(int64_t k_inf_q32, tp_fx depth)
{
    if (k_inf_q32 <= 0)
        return 0;
    const tp_scaled k_inf = tp_scaled_from_wave_number(k_inf_q32);
    const tp_scaled root =
        tp_scaled_sqrt(tp_scaled_mul(k_inf, tp_scaled_from_depth(depth)));
    const tp_scaled t = tanh_scaled(tp_scaled_mul(root, tp_scaled_sqrt(root)));
    const tp_scaled below = scaled_cube_root(tp_scaled_mul(t, t));
    return tp_scaled_fixed(tp_scaled_mul(k_inf, tp_scaled_recip(below)), 32);
}

/* 2 pi 2^32 / (length / 2^16): the numerator has 51 bits. */
int64_t tp_depth_wave_number_deep(tp_fx length)
{
    const int64_t least = length > TP_FX_ONE / 64 ? length : TP_FX_ONE / 64;
    return (2 * (int64_t)PI_Q32 * 65536 + least / 2) / least;
}

tp_depth_regime tp_depth_classify(int64_t k_q32, tp_fx depth)
{
    const tp_scaled k = tp_scaled_from_wave_number(k_q32);
    const int64_t x = tp_scaled_fixed(tp_scaled_mul(k, tp_scaled_from_depth(depth)), 32);
    return x >= PI_Q32 ? TP_DEPTH_DEEP
         : x > PI_Q32 / 10 ? TP_DEPTH_TRANSITION : TP_DEPTH_SHALLOW;
}

/* -- speeds and heights -------------------------------------------------------------- */

/* Speeds and heights over a depth, [B3] and [B7] of the models.
 *
 * With x = kh and T = tanh x / x, the factor 1 + 2x / sinh 2x of [B7] is (T
 * + sech^2 x) / T. */

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

static tp_scaled phase_speed(tp_scaled k_inf, tp_scaled k, tp_fx gravity)
{
    const tp_scaled g = tp_scaled_from_fixed((uint32_t)(gravity > 0 ? gravity : 0), 16);
    const tp_scaled omega = tp_scaled_sqrt(tp_scaled_mul(g, k_inf));
    return tp_scaled_mul(omega, tp_scaled_recip(k));
}

tp_fx tp_depth_speed(int64_t k_inf_q32, int64_t k_q32, tp_fx gravity)
{
    if (k_q32 <= 0)
        return 0;
    return tp_scaled_fx(phase_speed(tp_scaled_from_wave_number(k_inf_q32),
                                    tp_scaled_from_wave_number(k_q32), gravity));
}

tp_fx tp_depth_group_speed(int64_t k_inf_q32, int64_t k_q32, tp_fx depth, tp_fx gravity)
{
    if (k_q32 <= 0)
        return 0;
    const tp_scaled k = tp_scaled_from_wave_number(k_q32);
    const tp_scaled c = phase_speed(tp_scaled_from_wave_number(k_inf_q32), k, gravity);
    return tp_scaled_fx(tp_scaled_mul(c, group_speed_ratio(k, depth)));
}

/* Ks^2 = c_inf / 2 cg = (k / k_inf) / (2 cg/c). */
tp_fx tp_depth_shoaling_factor(int64_t k_inf_q32, int64_t k_q32, tp_fx depth)
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
tp_fx tp_depth_refraction_factor(int64_t k_inf_q32, int64_t k_q32, int64_t k_shore_q32)
{
    const uint64_t kz =
        k_shore_q32 < 0 ? 0u - (uint64_t)k_shore_q32 : (uint64_t)k_shore_q32;
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

/* -- breaking ------------------------------------------------------------------------ */

/* Breaking criteria and breaker types, [B14], [B15] and [B20] of the models. */

#define STEEP_Q32 3855153630            /* 2^32 2 pi / 7: H/L > 1/7 is Hk > 2 pi/7 */
#define MICHE_Q32 3832022708            /* 2^32 0.142 2 pi */

/* Returns 0.142 L tanh(kh) = 0.142 2 pi tanh(kh) / k.  For k = 0 the limit of
 * tanh(kh)/k is h. */
static tp_scaled miche_height_scaled(tp_scaled k, tp_fx depth)
{
    const tp_scaled h = tp_scaled_from_depth(depth),
                    share = tp_scaled_from_fixed(MICHE_Q32, 32);

    if (k.m == 0)
        return tp_scaled_mul(share, h);
    const tp_scaled t = tanh_scaled(tp_scaled_mul(k, h));
    return tp_scaled_mul(share, tp_scaled_mul(t, tp_scaled_recip(k)));
}

tp_fx tp_miche_height(int64_t k_q32, tp_fx depth)
{
    return depth > 0 ? tp_scaled_fx(
               miche_height_scaled(tp_scaled_from_wave_number(k_q32), depth))
                     : 0;
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
    if (depth <= 0
        || tp_scaled_fixed(h, 32) > tp_scaled_fixed(miche_height_scaled(k, depth), 32))
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

/* -- wind ---------------------------------------------------------------------------- */

/* Wind, [B10] of the models: crests run ahead of their phase, troughs lag behind, and the
 * front of a wave steepens.
 *
 * Phi = theta + lambda r cos Phi is a contraction by |lambda r|, iterated from theta.  The
 * source can also be read as a sum of (omega + lambda dy) dt over the ticks.  This reading
 * is not used: it slows waves down by their height and depends on history. */

#define SHIFT_MOST      TP_Q30(0.5)
#define ITERATIONS_MOST 32              /* 2^-33 of the initial error is left */
tp_fx tp_wind_lambda(tp_fx lambda, tp_q30 wind_cosine)
{
    return wind_cosine <= 0            ? 0
           : wind_cosine >= TP_Q30_ONE ? lambda
                                       : tp_q30_mul(lambda, wind_cosine);
}

/* Q32 to Q30. */
tp_q30 tp_wind_phase_shift(tp_fx lambda, tp_fx orbit_radius)
{
    return (tp_q30)tp_clamp_abs(((int64_t)lambda * orbit_radius + 2) >> 2, SHIFT_MOST);
}

int tp_wind_iterations(tp_q30 shift)
{
    return shift > TP_Q30(0.3) || shift < -TP_Q30(0.3) ? 3 : 1;
}

/* Returns turns of 2^-32: half a radian is 2^28.35. */
tp_turn tp_wind_phase(tp_turn theta, tp_q30 shift, int iterations)
{
    const tp_q30 clamped = tp_clamp(shift, -SHIFT_MOST, SHIFT_MOST);
    const int32_t turns = tp_q30_mul(TP_OVER_TWO_PI_Q32, clamped);
    const int n = iterations < ITERATIONS_MOST ? iterations : ITERATIONS_MOST;
    tp_turn phi = theta;

    for (int i = 0; i < n; i++)
        phi = theta + (tp_turn)tp_q30_mul(turns, tp_cos(phi));
    return phi;
}

tp_fx tp_wind_max_radius(int64_t k_q32, tp_fx lambda)
{
    const uint64_t l = (uint64_t)(lambda < 0 ? -(int64_t)lambda : lambda);
    const tp_scaled k = tp_scaled_from_wave_number(k_q32);
    const tp_scaled side = tp_scaled_from_fixed(l, 16);
    const tp_scaled sum = tp_scaled_add(tp_scaled_mul(k, k), tp_scaled_mul(side, side));

    if (sum.m == 0)
        return TP_FX_MAX;
    return tp_scaled_fx(tp_scaled_mul(tp_scaled_rsqrt(sum),
                                      tp_scaled_from_fixed((uint32_t)TP_Q30(0.95), 30)));
}
