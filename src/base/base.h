/* SPDX-License-Identifier: MIT */
/* What every rank may use: the four memory functions that a port must supply,
 * assertions, chance, and the attribute of loop bodies that are written once and
 * inlined. */
#ifndef TP_BASE_BASE_H
#define TP_BASE_BASE_H
#include <stddef.h>
#include <stdint.h>
#include "base/assert.h"

/* The whole of the C library that the core asks for. */
void *memcpy(void *restrict to, const void *restrict from, size_t bytes);
void *memmove(void *to, const void *from, size_t bytes);
void *memset(void *to, int value, size_t bytes);
int   memcmp(const void *a, const void *b, size_t bytes);

/* The next of a linear congruential sequence; its high bits are the good ones. */
static inline uint32_t tp_random(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state;
}

/* For a body that takes literal flags: plain `inline` at -Os leaves the flags' tests in
 * the loop. */
#if defined(__GNUC__)
#define TP_ALWAYS_INLINE static inline __attribute__((always_inline))
#else
#define TP_ALWAYS_INLINE static inline
#endif
#endif
