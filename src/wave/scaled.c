/* SPDX-License-Identifier: MIT */
/* Numbers of 32 bits with an exponent; see scaled.h.  These are functions, not inline:
 * about a hundred calls in set-up code, where code size matters more than speed. */
#include <stdbool.h>
#include "wave/scaled.h"
#include "fx/fx.h"

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
