/* SPDX-License-Identifier: MIT */
/* Loads and stores of two words.  Microcontrollers with Arm's DSP extension take one
 * instruction (ldrd, strd): any two registers, word alignment. */
#ifndef TP_BASE_WORD_PAIRS_H
#define TP_BASE_WORD_PAIRS_H
#include "base/dsp.h"

typedef struct {
    uint32_t first, second;
} tp_word_pair;

/* Loads from[index] and from[index + 1]; `index` is a literal. */
TP_ALWAYS_INLINE tp_word_pair tp_load_pair(const uint32_t *from, int index)
{
    tp_word_pair p;
#if TP_DSP
    __asm__("ldrd %0, %1, [%2, %3]"
            : "=r"(p.first), "=r"(p.second)
            : "r"(from), "i"(4 * index), "m"(from[index]), "m"(from[index + 1]));
#else
    p.first = from[index];
    p.second = from[index + 1];
#endif
    return p;
}

/* Loads two words and advances *from behind them. */
TP_ALWAYS_INLINE tp_word_pair tp_load_next_pair(const uint32_t **from)
{
    tp_word_pair p;
#if TP_DSP
    __asm__("ldrd %0, %1, [%2], #8"
            : "=&r"(p.first), "=&r"(p.second), "+r"(*from)
            : "m"((*from)[0]), "m"((*from)[1]));
#else
    p.first = (*from)[0];
    p.second = (*from)[1];
    *from += 2;
#endif
    return p;
}

/* Stores two words at to[index] and to[index + 1]; `index` is a literal. */
TP_ALWAYS_INLINE void tp_store_pair(uint32_t *to, int index, uint32_t first,
                                    uint32_t second)
{
#if TP_DSP
    __asm__("strd %2, %3, [%4, %5]"
            : "=m"(to[index]), "=m"(to[index + 1])
            : "r"(first), "r"(second), "r"(to), "i"(4 * index));
#else
    to[index] = first;
    to[index + 1] = second;
#endif
}

/* Stores two words at *to and advances *to behind them. */
TP_ALWAYS_INLINE void tp_store_next_pair(uint32_t **to, uint32_t first, uint32_t second)
{
#if TP_DSP
    __asm__("strd %3, %4, [%0], #8"
            : "+r"(*to), "=m"((*to)[0]), "=m"((*to)[1])
            : "r"(first), "r"(second));
#else
    (*to)[0] = first;
    (*to)[1] = second;
    *to += 2;
#endif
}

#endif
