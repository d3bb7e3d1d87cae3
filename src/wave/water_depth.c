/* SPDX-License-Identifier: MIT */
/* Wave numbers over a depth, [B1]-[B6] of the models.
 *
 * With y = k_inf h, x = kh and T(x) = tanh x / x, Newton's step for x tanh x = y is
 *     x -= (x tanh x - y) / (tanh x + x sech^2 x)
 *        = x (T(x) - y/x^2) / (T(x) + sech^2 x),
 * and y/x^2 is T(y) for Eckart's x = y / sqrt(tanh y).  Only numbers between 0 and 1 are
 * subtracted, and the relative error stays small even for films of water. */
#include "base/assert.h"
#include "wave/water_depth.h"
#include "wave/exp.h"

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

tp_scaled tp_tanh_scaled(tp_scaled x)
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
    const tp_scaled t = tp_tanh_scaled(tp_scaled_mul(root, tp_scaled_sqrt(root)));
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
