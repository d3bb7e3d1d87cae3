/* SPDX-License-Identifier: MIT */
/* Area vectors: asset/area.h. */
#include "asset/area.h"
#include "base/assert.h"
#include "fx/fx.h"

tp_area tp_area_cross(tp_vec3 a, tp_vec3 b)
{
    return (tp_area){ tp_area_product_difference(a.y, b.z, a.z, b.y),
                      tp_area_product_difference(a.z, b.x, a.x, b.z),
                      tp_area_product_difference(a.x, b.y, a.y, b.x) };
}

static uint32_t bit_length(uint32_t x)
{
    return x == 0 ? 0 : 32 - (uint32_t)tp_clz(x);
}

/* Each edge component < 2^e and count < 2^c.  The components of all vectors sum up
 * to below 2^(2e + 1 + c).  The lengths, at most sqrt(3) times as long, sum up to
 * below 2^(2e + 2 + c). */
uint32_t tp_area_sum_shift(uint32_t extent, uint32_t count)
{
    const uint32_t bits = 2 * bit_length(extent) + 2 + bit_length(count);
    return bits > 63 ? bits - 63 : 0;
}

tp_area tp_area_divide_pow2(tp_area a, uint32_t shift)
{
    TP_ASSERT(shift < 63);
    const int64_t unit = (int64_t)1 << shift;
    return (tp_area){ a.x / unit, a.y / unit, a.z / unit };
}

static uint64_t magnitude(int64_t x)
{
    return x < 0 ? 0 - (uint64_t)x : (uint64_t)x;
}

/* Returns the number of bits by which the longest component exceeds 30 bits. */
static uint32_t excess_bits(tp_area a)
{
    const uint64_t most = magnitude(a.x) | magnitude(a.y) | magnitude(a.z);
    uint32_t shift = 0;
    while (most >> shift >= (uint64_t)1 << 30)
        shift++;
    return shift;
}

uint64_t tp_area_length(tp_area a)
{
    const uint32_t shift = excess_bits(a);
    const tp_area small = tp_area_divide_pow2(a, shift);
    const uint64_t square = (uint64_t)(small.x * small.x) + (uint64_t)(small.y * small.y)
                          + (uint64_t)(small.z * small.z);
    return (uint64_t)tp_isqrt64(square) << shift;
}

tp_dir3 tp_area_direction(tp_area a)
{
    const tp_area small = tp_area_divide_pow2(a, excess_bits(a));
    return tp_normalise((int32_t)small.x, (int32_t)small.y, (int32_t)small.z);
}
