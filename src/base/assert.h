/* SPDX-License-Identifier: MIT */
/* TP_ASSERT(condition) states a contract between functions, or with the caller of a public
 * function.  Outside data are checked by code that returns a tp_status, never by an
 * assertion.  The condition must have no side effect.
 *
 * A release build compiles the condition but does not evaluate it.  Test builds define
 * TP_CHECKED: a false condition then calls tp_assert_failed(), which the program supplies.
 * tests/assert_failed.c prints the place and aborts.  To use another TP_ASSERT, include a
 * header that defines it first: make lib CPPFLAGS='-include my_assert.h' */
#ifndef TP_BASE_ASSERT_H
#define TP_BASE_ASSERT_H

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
#endif
