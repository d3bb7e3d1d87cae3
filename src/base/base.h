/* SPDX-License-Identifier: MIT */
/*
 * Helpers for every rank: assertions, the four memory functions that a port must supply,
 * pseudo-random numbers, an attribute for loop bodies that are written once and inlined
 * several times; the arena; and error reports: text in a bounded buffer, the report of a
 * failed check, and checks of the pointers that a caller passes to an init function.
 */
#ifndef TP_BASE_BASE_H
#define TP_BASE_BASE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/status.h"

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

/* TP_ALWAYS_INLINE forces inlining of a function that takes literal flags.  Plain `inline` at
 * -Os leaves the tests of the flags inside the loop.  TP_NEVER_INLINE keeps the arrays of a
 * function off the stack of its caller's other calls, or one copy of a function. */
#if defined(__GNUC__)
#define TP_ALWAYS_INLINE static inline __attribute__((always_inline))
#define TP_NEVER_INLINE static __attribute__((noinline))
#else
#define TP_ALWAYS_INLINE static inline
#define TP_NEVER_INLINE static
#endif

/* -- the arena ----------------------------------------------------------------------- */

/* A bump allocator over one block of the caller's memory.  With a NULL block the arena only
 * counts: the function that makes a layout then also answers how large the block must
 * be. */

typedef struct {
    uint8_t *block;         /* aligned to 8 bytes; NULL to count only */
    size_t   bytes;         /* size of the block */
    size_t   used;          /* bytes allocated; also counts beyond `bytes`, to
                             * tell the size needed */
    bool     failed;        /* true if an allocation did not fit or its size overflowed */
} tp_arena;

/* Makes an arena over `block`, which must be aligned to 8 bytes. */
tp_arena tp_arena_init(void *block, size_t bytes);

/* Allocates count x size bytes, aligned to 8.  Returns NULL when counting, or when the
 * block has no room left. */
void *tp_arena_alloc(tp_arena *arena, size_t count, size_t size);

/* -- text ---------------------------------------------------------------------------- */

/* Builds text in the caller's buffer.  The text is always terminated, and cut at the end of
 * the buffer.  `length` goes on counting, to tell the size of the whole text. */

typedef struct {
    char  *text;
    size_t bytes;           /* size of the buffer; 0: count only, write nothing */
    size_t length;          /* length of the whole text, without the terminator */
} tp_text;

tp_text tp_text_init(char *buffer, size_t bytes);
void    tp_text_append_char(tp_text *text, char c);
void    tp_text_append(tp_text *text, const char *string);     /* `string` is terminated */
void    tp_text_append_int(tp_text *text, int32_t number);

/* Returns the length of a terminated string in bytes, without the terminator. */
size_t tp_string_length(const char *string);

/* -- reports ------------------------------------------------------------------------- */

/* Reporting of a failed check: TP_FAIL fills the caller's tp_error and returns its
 * status. */

/* Returns the message template of a status; %a, %b and %s are not yet replaced. */
const char *tp_status_text(tp_status code);

/* Fills *err if `err` is not NULL.  Returns `code`. */
#define TP_FAIL(err, code, where, a, b) \
    tp_fail_((err), (code), __FILE__, __LINE__, (uint32_t)(where), \
             (int32_t)(a), (int32_t)(b))
tp_status tp_fail_(tp_error *err, tp_status code, const char *file, int line,
                   uint32_t where, int32_t a, int32_t b);

/* Copies the offending word, which has no terminator, into an error. */
void tp_error_set_word(tp_error *err, const char *word, size_t bytes);

/* Copies a terminated word into an error that has just been filled.  Returns `code`. */
tp_status tp_error_add_word(tp_error *err, tp_status code, const char *word);

/* -- pointers of a caller ------------------------------------------------------------ */

/* Checks of the pointers that a caller passes to an init function.  `name` is the name of
 * the argument, for the error message. */

/* Returns TP_E_NULL for a NULL pointer, or TP_OK. */
tp_status tp_pointer_check(const void *given, const char *name, tp_error *err);

/* Checks a block of memory.  Returns TP_E_NULL for a NULL pointer, TP_E_ALIGN if the
 * address is not a multiple of `align` bytes, or TP_OK. */
tp_status tp_pointer_check_aligned(const void *block, uint32_t align, const char *name,
                                   tp_error *err);

#endif
