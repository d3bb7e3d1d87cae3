/* SPDX-License-Identifier: MIT */
/* Numbers of 32 bits with an exponent, and e^-x and tanh x for waves over a depth:
 * waves/softfloat.h. */
#include <stdbool.h>
#include "fixed/arithmetic.h"
#include "waves/softfloat.h"

/* -- numbers with an exponent -------------------------------------------------------- */

/* These are functions, not inline: about a hundred calls in set-up code, where code size
 * matters more than speed. */

tp_scaled tp_scaled_from_fixed(uint64_t x, int bits)
{
    const uint32_t high = (uint32_t)(x >> 32);

    if (x == 0)
        return (tp_scaled){ 0, 0 };
    const int zeros = high != 0 ? tp_clz(high) : 32 + tp_clz((uint32_t)x);
    return (tp_scaled){ (uint32_t)(x << zeros >> 32), 32 - zeros - bits };
}

tp_scaled tp_scaled_mul(tp_scaled a, tp_scaled b)
{
    tp_scaled p = tp_scaled_from_fixed((uint64_t)a.m * b.m, 0);

    p.e += a.e + b.e;
    return p;
}

tp_scaled tp_scaled_add(tp_scaled a, tp_scaled b)
{
    const bool swap = a.m == 0 || (b.m != 0 && b.e > a.e);
    const tp_scaled large = swap ? b : a, small = swap ? a : b;
    const int down = small.m == 0 || large.e - small.e > 31 ? 32 : large.e - small.e;
    tp_scaled sum =
        tp_scaled_from_fixed((uint64_t)large.m + ((uint64_t)small.m >> down), 0);

    sum.e += large.e;
    return sum;
}

/* 1 / (m 2^e) = (2^63 / m) 2^(-63 - e); x > 0. */
tp_scaled tp_scaled_recip(tp_scaled x)
{
    return (tp_scaled){ tp_recip_norm(x.m), -63 - x.e };
}

/* For n 2^e with even e, tp_rsqrt_norm gives 2^31 / sqrt(n / 2^32) = 2^47 / sqrt(n); x > 0.
 * An odd e halves m, which loses a bit: 2^-32 of the root. */
tp_scaled tp_scaled_rsqrt(tp_scaled x)
{
    const int odd = x.e & 1;
    return (tp_scaled){ tp_rsqrt_norm(x.m >> odd), -47 - (x.e + odd) / 2 };
}

tp_scaled tp_scaled_sqrt(tp_scaled x)
{
    return x.m == 0 ? x : tp_scaled_mul(x, tp_scaled_rsqrt(x));
}

int64_t tp_scaled_fixed(tp_scaled x, int bits)
{
    const int up = x.e + bits;

    if (x.m == 0 || up < -32)
        return 0;
    if (up < 0)
        return (int64_t)(((uint64_t)x.m + ((uint64_t)1 << (-up - 1))) >> -up);
    return up > 31 ? INT64_MAX : (int64_t)((uint64_t)x.m << up);
}

tp_fx tp_scaled_fx(tp_scaled x)
{
    return tp_fx_saturate(tp_scaled_fixed(x, 16));
}

/* -- exponential functions ----------------------------------------------------------- */

/* e^-x and tanh x for waves over a depth.
 *
 * [G2] asks for a shift and a table of 64 steps with linear interpolation, to 1 LSB of
 * 16.16.  Wave numbers for tables need an error of 10^-6: a few terms of the power series
 * replace the linear interpolation, at the cost of three more products and no more bytes.
 * tanh follows from e^-2x and needs no table of its own. */

static const uint32_t power[64] = {
#include "waves/exp_table.inc"
};

/* Returns 1 - 2^-part/64 for part below 1 as Q0.32.  With s = part ln 2 / 64 < 0.01084 the
 * power is 1 - s + s^2/2 - s^3/6; the next term is 5.8e-10. */
static inline uint32_t one_minus_exp2_neg(uint32_t part_q32)
{
    const uint32_t s = (uint32_t)((uint64_t)part_q32 * 46516320 >> 32); /* 2^32 ln 2 / 64 */
    const uint32_t square = (uint32_t)((uint64_t)s * s >> 32);
    return s - square / 2 + (uint32_t)((uint64_t)square * s >> 32) / 6;
}

/* x / ln 2 = n + i/64 + part/64: x < 23 has 29 bits in Q24, 1 / ln 2 has 32 bits in
 * Q1.31. */
uint32_t tp_exp_neg(uint32_t x_q24)
{
    if (x_q24 >= 23u << 24)
        return 0;
    const uint64_t z = (uint64_t)x_q24 * 3098164009u;               /* Q6.55 */
    const uint32_t n = (uint32_t)(z >> 55), top = power[z >> 49 & 63];
    const uint32_t y =
        top - (uint32_t)((uint64_t)top * one_minus_exp2_neg((uint32_t)(z >> 17)) >> 32);
    return n == 0 ? y : (uint32_t)((y + ((uint64_t)1 << (n - 1))) >> n);
}

/* tanh x / x = 1 - x^2/3 + 2x^4/15 - 17x^6/315 + ..., for x < 1/8, where 1 - e^-2x would
 * lose bits.  The next term is below 1.3e-9.  s is x^2, below 2^26 in Q0.32. */
static tp_tanh tanh_small(uint32_t x_q24)
{
    const uint64_t s = ((uint64_t)x_q24 * x_q24 + 0x8000) >> 16;
    const uint64_t six = s * 231791886 >> 32;                       /* 17/315 in Q32 */
    const uint64_t four = s * (572662306 - six) >> 32;              /* 2/15 */
    const uint64_t two = s * (1431655765 - four) >> 32;             /* 1/3 */
    const uint32_t ratio = (uint32_t)(0x80000000u - ((two + 1) >> 1));
    return (tp_tanh){ (uint32_t)(((uint64_t)x_q24 * ratio + (1 << 22)) >> 23), ratio };
}

/* tanh x = (1 - e) / (1 + e), e = e^-2x.  (1 + e)/2 has 32 bits: its reciprocal gives 2^32
 * / (1 + e), and the product is below 2^64.  tanh / x uses the reciprocal of the shifted x,
 * 2^63 / (x 2^up): tanh 2^32 / (x 2^24) then has 40 - up bits too many. */
tp_tanh tp_tanh_evaluate(uint32_t x_q24)
{
    if (x_q24 < 1u << 21)
        return tanh_small(x_q24);
    const uint32_t e = x_q24 >= TP_DEPTH_DEEP_Q24 ? 0 : tp_exp_neg(2 * x_q24);
    const uint32_t over = tp_recip_norm(0x80000000u + e / 2);
    const uint32_t t = (uint32_t)((0x100000000u - e) * over >> 32);
    const int up = tp_clz(x_q24);
    const uint64_t ratio = (uint64_t)t * tp_recip_norm(x_q24 << up);
    return (tp_tanh){ t, (uint32_t)(ratio >> (40 - up)) };
}

/* csch^2 = sech^2 / tanh^2.  From x = 1 on sech^2 runs out of bits, and the function uses
 * (2 e^-x / (1 - e^-2x))^2. */
tp_scaled tp_csch_squared(tp_scaled x)
{
    const uint32_t x_q24 = tp_scaled_q24(x);

    if (x_q24 < 1u << 24) {
        const tp_tanh at = tp_tanh_evaluate(x_q24);
        const tp_scaled t = tp_scaled_mul(x, tp_scaled_from_fixed(at.ratio_q31, 31));
        const tp_scaled over = tp_scaled_recip(t);
        return tp_scaled_mul(tp_scaled_from_fixed(tp_sech_squared(at), 31),
                             tp_scaled_mul(over, over));
    }
    const uint64_t e = tp_exp_neg(x_q24);
    const uint64_t below = 0x100000000u - (e * e >> 32);
    const tp_scaled over = tp_scaled_recip(tp_scaled_from_fixed(below, 32));
    const tp_scaled root = tp_scaled_mul(tp_scaled_from_fixed(e, 31), over);
    return tp_scaled_mul(root, root);
}
