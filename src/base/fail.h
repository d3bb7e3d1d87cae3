/* SPDX-License-Identifier: MIT */
/* How a check fails: it fills the caller's tp_error, and returns its code. */
#ifndef TP_BASE_FAIL_H
#define TP_BASE_FAIL_H
#include "tidepool/status.h"

/* The sentence of a code, with its %a, %b and %s as they stand. */
const char *tp_status_text(tp_status code);

/* Fills *err if there is one and returns `code`. */
#define TP_FAIL(err, code, where, a, b) \
    tp_fail_((err), (code), __FILE__, __LINE__, (uint32_t)(where), \
             (int32_t)(a), (int32_t)(b))
tp_status tp_fail_(tp_error *err, tp_status code, const char *file, int line,
                   uint32_t where, int32_t a, int32_t b);

/* Puts the offending word (not terminated) into an error. */
void tp_error_word(tp_error *err, const char *word, size_t bytes);

/* Puts a terminated word into an error that has just been filled; returns `code`. */
tp_status tp_error_blame(tp_error *err, tp_status code, const char *word);
#endif
