/* SPDX-License-Identifier: MIT */
/* Helpers for every rank: assertions, the four memory functions that a port must supply,
 * pseudo-random numbers, and an attribute for loop bodies that are written once and
 * inlined several times. */
#ifndef TP_BASE_BASE_H
#define TP_BASE_BASE_H
#include <stddef.h>
#include <stdint.h>

/* -- assertions ---------------------------------------------------------------------- */

/* TP_ASSERT(condition) states a contract between functions, or with the caller of a public
 * function.  Outside data are checked by code that returns a tp_status, never by an
 * assertion.  The condition must have no side effect.
 *
 * A release build compiles the condition but does not evaluate it.  Test builds define
 * TP_CHECKED: a false condition then calls tp_assert_failed(), which the program supplies.
 * tests/lib/assert_failed.c prints the place and aborts.  To use another TP_ASSERT, include
 * a header that defines it first: make lib CPPFLAGS='-include my_assert.h' */

#ifdef TP_CHECKED
/* Never returns. */
_Noreturn void tp_assert_failed(const char *file, int line, const char *condition);
#endif

#ifndef TP_ASSERT
#ifdef TP_CHECKED
#define TP_ASSERT(condition) \
    ((condition) ? (void)0 : tp_assert_failed(__FILE__, __LINE__, #condition))
#else
#define TP_ASSERT(condition) ((void)sizeof((condition) ? 1 : 0))
#endif
#endif

/* -- memory, random numbers, inlining ------------------------------------------------ */

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
