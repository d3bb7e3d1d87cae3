/* SPDX-License-Identifier: MIT */
/* Directions and lengths.  The squared length of a 16.16 vector overflows 32 bits
 * beyond 181 m [G3].  Squares are summed in 64 bits, and the sum is normalised by
 * its leading zeros. */
#include "base/assert.h"
#include "fx/fx.h"

static uint64_t square(int32_t x)
{
    return (uint64_t)((int64_t)x * x);
}

static int32_t q30_round(int64_t q60)
{
    return (int32_t)((q60 + (1 << 29)) >> 30);
}

tp_q30 tp_dir3_dot(tp_dir3 a, tp_dir3 b)
{
    return q30_round((int64_t)a.x * b.x + (int64_t)a.y * b.y + (int64_t)a.z * b.z);
}

tp_dir3 tp_dir3_cross(tp_dir3 a, tp_dir3 b)
{
    return (tp_dir3){
        q30_round((int64_t)a.y * b.z - (int64_t)a.z * b.y),
        q30_round((int64_t)a.z * b.x - (int64_t)a.x * b.z),
        q30_round((int64_t)a.x * b.y - (int64_t)a.y * b.x),
    };
}

/* Rounds to nearest, like tp_fx_sqrt. */
tp_fx tp_vec3_length(tp_vec3 v)
{
    const uint64_t sum = square(v.x) + square(v.y) + square(v.z);   /* <= 3 2^62 */
    const uint32_t r = tp_isqrt64(sum);
    if (r >= (uint32_t)TP_FX_MAX)
        return TP_FX_MAX;
    return (tp_fx)(sum - (uint64_t)r * r > r ? r + 1 : r);
}

/* Returns x / length in Q2.30, rounded half up.  |x inverse| < 2^63.  The rounding cannot
 * overflow: an x at the end of its range makes the inverse small. */
static tp_q30 normalised_component(int32_t x, uint32_t inverse, int shift)
{
    TP_ASSERT(shift >= 2 && shift <= 33);
    return (tp_q30)(((int64_t)x * inverse + ((int64_t)1 << (shift - 1))) >> shift);
}

/* n = sum 2^(2 half) / 2^32 lies in [2^30, 2^32).  The inverse is 2^47 / sqrt(n), and
 * 2^30 x / sqrt(sum) = x inverse / 2^(33 - half).  half <= 31. */
tp_dir3 tp_normalise(int32_t x, int32_t y, int32_t z)
{
    const uint64_t sum = square(x) + square(y) + square(z);
    if (sum == 0)
        return (tp_dir3){ 0, TP_Q30_ONE, 0 };
    const uint32_t high = (uint32_t)(sum >> 32);
    const int half = (high != 0 ? tp_clz(high) : 32 + tp_clz((uint32_t)sum)) >> 1;
    const uint32_t inverse = tp_rsqrt_norm((uint32_t)(sum << 2 * half >> 32));
    return (tp_dir3){
        normalised_component(x, inverse, 33 - half),
        normalised_component(y, inverse, 33 - half),
        normalised_component(z, inverse, 33 - half),
    };
}
