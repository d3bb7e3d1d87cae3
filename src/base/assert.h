/* SPDX-License-Identifier: MIT */
/* TP_ASSERT(condition): a contract between functions, or with the caller of a public one.
 * Never the check of outside data, which gets a tp_status; never with an effect.
 *
 * A release has none: the condition is compiled, not evaluated.  With -DTP_CHECKED, as
 * tests are built, one that does not hold calls tp_assert_failed(), which the program
 * supplies; tests/assert_failed.c prints the place and aborts.  A header that defines
 * TP_ASSERT otherwise goes before: make lib CPPFLAGS='-include my_assert.h' */
#ifndef TP_BASE_ASSERT_H
#define TP_BASE_ASSERT_H

#ifdef TP_CHECKED
/* Does not return. */
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
#endif
