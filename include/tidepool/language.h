/* SPDX-License-Identifier: MIT */
/* What C and C++ write differently in the public headers, which are C11 and C++11. */
#ifndef TP_LANGUAGE_H
#define TP_LANGUAGE_H

/* TP_BEGIN_C and TP_END_C stand around each header's declarations, so that C++ links the
 * library's C functions. */
#ifdef __cplusplus
#define TP_BEGIN_C extern "C" {
#define TP_END_C   }
#define TP_STATIC_ASSERT(condition, text) static_assert(condition, text)
#else
#define TP_BEGIN_C
#define TP_END_C
#define TP_STATIC_ASSERT(condition, text) _Static_assert(condition, text)
#endif
#endif
