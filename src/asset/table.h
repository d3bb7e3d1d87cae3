/* SPDX-License-Identifier: MIT */
/* Sizes and the mixing step shared by the reader's hash tables. */
#ifndef TP_ASSET_TABLE_H
#define TP_ASSET_TABLE_H
#include <stdint.h>
#include "base/assert.h"

/* Returns the smallest power of two >= 1.5 n, at least 2; n <= 2^26. */
static inline uint32_t tp_table_size(uint32_t n)
{
    TP_ASSERT(n <= 1u << 26);
    uint32_t size = 2;
    while (size < n + n / 2)
        size *= 2;
    return size;
}

/* Mixes a number into a hash; every bit of both affects the low half.  The multiplier is
 * 2^64 over the golden ratio (Knuth, TAOCP 3, 6.4). */
static inline uint64_t tp_mix(uint64_t hash, uint64_t x)
{
    hash = (hash ^ x) * 0x9e3779b97f4a7c15u;
    return hash ^ hash >> 32;
}
#endif
