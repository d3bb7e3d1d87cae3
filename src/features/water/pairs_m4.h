/* SPDX-License-Identifier: MIT */
/* Loads and stores of two words by one instruction (ldrd, strd): any two registers, word
 * alignment. */
#ifndef TP_FEATURES_WATER_PAIRS_M4_H
#define TP_FEATURES_WATER_PAIRS_M4_H
#include "base/dsp.h"

typedef struct {
    uint32_t first, second;
} word_pair;

/* Loads from[skip] and from[skip + 1]; `skip` is a literal, in words. */
TP_ALWAYS_INLINE word_pair pair_load(const uint32_t *from, int skip)
{
    word_pair p;
#if TP_DSP
    __asm__("ldrd %0, %1, [%2, %3]" : "=r"(p.first), "=r"(p.second)
            : "r"(from), "i"(4 * skip), "m"(from[skip]), "m"(from[skip + 1]));
#else
    p.first = from[skip];
    p.second = from[skip + 1];
#endif
    return p;
}

TP_ALWAYS_INLINE word_pair pair_next(const uint32_t **from)
{
    word_pair p;
#if TP_DSP
    __asm__("ldrd %0, %1, [%2], #8" : "=&r"(p.first), "=&r"(p.second), "+r"(*from)
            : "m"((*from)[0]), "m"((*from)[1]));
#else
    p.first = (*from)[0];
    p.second = (*from)[1];
    *from += 2;
#endif
    return p;
}

TP_ALWAYS_INLINE void pair_store(uint32_t *to, int skip, uint32_t first, uint32_t second)
{
#if TP_DSP
    __asm__("strd %2, %3, [%4, %5]" : "=m"(to[skip]), "=m"(to[skip + 1])
            : "r"(first), "r"(second), "r"(to), "i"(4 * skip));
#else
    to[skip] = first;
    to[skip + 1] = second;
#endif
}
#endif
