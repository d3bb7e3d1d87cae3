/* SPDX-License-Identifier: MIT */
/* Square roots and reciprocals without division, for the hot path, and exact division in
 * 16.16, for set-up. */
#include "base/base.h"
#include "fixed/arithmetic.h"

/* -- roots and reciprocals ----------------------------------------------------------- */

/* Square roots and reciprocals without division.  A table with linear interpolation gives
 * 15 to 16 good bits; one Newton step doubles the number of bits.
 *
 * Both hot functions take a normalised number and return a number in [2^31, 2^32).
 * Newton's step never lands above the true value, which leaves room for rounding at the
 * top: for all inputs no result wraps or leaves the range.  Worst relative errors, measured
 * over all inputs: 2^-30.86 for the reciprocal, 2^-29.82 for the reciprocal root. */

static const uint16_t recip_table[257] = {
#include "fixed/recip_table.inc"
};

static const uint16_t rsqrt_table[193] = {
#include "fixed/rsqrt_table.inc"
};

/* Interpolates between the entry at `at` and the next entry, part/2^16 of the way; the
 * result is Q1.31.  An entry is a 17-bit number without its leading bit.  Neighbours differ
 * by less than 2^10: products fit. */
static inline uint32_t interpolate(const uint16_t *at, uint32_t part)
{
    const int32_t rise = at[1] - at[0];
    return ((0x10000u + at[0]) << 15) + (uint32_t)(rise * (int32_t)part >> 1);
}

/* Newton's step for 1/n: r += r (1 - n r).  n r is 2^63 (1 + d), |d| < 2^-16: 2^63 - n r
 * has less than 48 bits, and the low 16 of them are dropped. */
uint32_t tp_recip_norm(uint32_t n)
{
    TP_ASSERT(n >> 31 == 1);
    const uint32_t r = interpolate(recip_table + (n >> 23 & 0xff), n >> 7 & 0xffff);
    const uint64_t product = (uint64_t)n * r;
    const int32_t error = (int32_t)(0u - (uint32_t)(product >> 16));
    return r + (uint32_t)((int64_t)(int32_t)(r >> 1) * error >> 46);
}

/* Newton's step for 1/sqrt(x): r += r (1 - x r^2) / 2.  x r^2 is 2^62 (1 + d), |d| <
 * 2^-14. */
uint32_t tp_rsqrt_norm(uint32_t n)
{
    TP_ASSERT(n >> 30 != 0);
    const uint32_t r = interpolate(rsqrt_table + ((n >> 24) - 64), n >> 8 & 0xffff);
    const uint32_t square = (uint32_t)((uint64_t)r * r >> 32);
    const uint64_t product = (uint64_t)n * square;
    const int32_t error = (int32_t)(0u - (uint32_t)(product >> 18));
    return r + (uint32_t)((int64_t)(int32_t)(r >> 1) * error >> 44);
}

/* Returns the square root r of n in [2^62, 2^64), rounded down.  n / sqrt(n) by the
 * approximate reciprocal is within 17 of the root.  A Newton step r += (n - r^2) / (2 r),
 * with the same reciprocal, is within 2.  Steps of 1 do the rest.
 *
 * |n - r^2| < 2^38; its low 8 bits are dropped, and the product fits 64 bits.  The Newton
 * step lands at most 2^-20 above the root.  r = 2^32, whose square would wrap, needs n
 * above 2^64 - 2^13; every n of this range was tested. */
static uint32_t sqrt_normalised(uint64_t n)
{
    TP_ASSERT(n >> 62 != 0);
    const uint32_t high = (uint32_t)(n >> 32), inverse = tp_rsqrt_norm(high);
    uint64_t r = (uint64_t)high * inverse >> 31;
    const int64_t left = (int64_t)(n - r * r);
    r += (uint64_t)((left >> 8) * (int64_t)inverse >> 56);
    while (r * r > n)
        r--;
    while (n - r * r > 2 * r)
        r++;
    return (uint32_t)r;
}

uint32_t tp_isqrt64(uint64_t x)
{
    if (x == 0)
        return 0;
    const uint32_t high = (uint32_t)(x >> 32);
    const int zeros = high != 0 ? tp_clz(high) : 32 + tp_clz((uint32_t)x);
    return sqrt_normalised(x << (zeros & ~1)) >> (zeros >> 1);
}

tp_fx tp_fx_sqrt(tp_fx x)
{
    if (x <= 0)
        return 0;
    const uint64_t square = (uint64_t)x << 16;
    const uint32_t r = tp_isqrt64(square);
    const uint64_t left = square - (uint64_t)r * r;
    return (tp_fx)(left > r ? r + 1 : r);   /* above (r + 1/2)^2 = r^2 + r + 1/4? */
}

/* x = n / 2^s gives 2^24 / sqrt(x) = 2^47 / sqrt(n) / 2^(23 - s/2). */
tp_fx tp_fx_rsqrt(tp_fx x)
{
    if (x <= 0)
        return TP_FX_MAX;
    const int half = tp_clz((uint32_t)x) >> 1;
    const uint32_t r = tp_rsqrt_norm((uint32_t)x << 2 * half);
    return (tp_fx)(((r >> (22 - half)) + 1) >> 1);
}

/* -- division ------------------------------------------------------------------------ */

/* Returns left / by; left is below 2^63, so that no bit of `by` is lost. */
TP_NEVER_INLINE uint64_t divide(uint64_t left, uint64_t by)
{
    uint64_t q = 0, bit = 1;

    for (; by < left; by <<= 1)
        bit <<= 1;
    for (; bit > 0; bit >>= 1, by >>= 1)
        if (left >= by) {
            left -= by;
            q |= bit;
        }
    return q;
}

int64_t tp_quotient_by_shifts(int64_t n, int64_t d)
{
    TP_ASSERT(d != 0 && n > INT64_MIN && d > INT64_MIN);
    const int64_t q = (int64_t)divide((uint64_t)(n < 0 ? -n : n), (uint64_t)(d < 0 ? -d : d));

    return (n < 0) != (d < 0) ? -q : q;
}

/* Division in 16.16, exact and rounded half up, some hundred cycles on a Cortex-M: use these
 * functions in set-up code, never per pixel. */

tp_fx tp_fx_div(tp_fx a, tp_fx b)
{
    if (b == 0)
        return a > 0 ? TP_FX_MAX : a < 0 ? TP_FX_MIN : 0;
    const int64_t twice = (int64_t)a * (2 * TP_FX_ONE) + b, whole = 2 * (int64_t)b;
    int64_t q = tp_quotient(twice, whole);
    if (q * whole != twice && (twice < 0) != (whole < 0))
        q--;                            /* C rounds towards 0; floor rounds down */
    return tp_fx_saturate(q);
}

tp_fx tp_fx_recip(tp_fx x)
{
    return tp_fx_div(TP_FX_ONE, x);
}
