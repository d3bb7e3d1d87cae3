/* SPDX-License-Identifier: MIT */
/* Helpers for every rank: the four memory functions that a port must supply, assertions,
 * pseudo-random numbers, and an attribute for loop bodies that are written once and
 * inlined several times. */
#ifndef TP_BASE_BASE_H
#define TP_BASE_BASE_H
#include <stddef.h>
#include <stdint.h>
#include "base/assert.h"

/* The core calls no other function of the C library. */
void *memcpy(void *restrict to, const void *restrict from, size_t bytes);
void *memmove(void *to, const void *from, size_t bytes);
void *memset(void *to, int value, size_t bytes);
int   memcmp(const void *a, const void *b, size_t bytes);

/* Returns the next number of a linear congruential sequence.  The high bits are
 * the most random. */
static inline uint32_t tp_random(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state;
}

/* Forces inlining of a function that takes literal flags.  Plain `inline` at -Os leaves the
 * tests of the flags inside the loop. */
#if defined(__GNUC__)
#define TP_ALWAYS_INLINE static inline __attribute__((always_inline))
#else
#define TP_ALWAYS_INLINE static inline
#endif
#endif
