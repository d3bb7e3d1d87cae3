/* SPDX-License-Identifier: MIT */
/* Reporting of a failed check: TP_FAIL fills the caller's tp_error and returns its
 * status. */
#ifndef TP_BASE_FAIL_H
#define TP_BASE_FAIL_H
#include "tidepool/status.h"

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
tp_status tp_error_blame(tp_error *err, tp_status code, const char *word);
#endif
