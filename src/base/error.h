/* SPDX-License-Identifier: MIT */
/* Error reports: text in a bounded buffer, the report of a failed check, and checks of
 * the pointers that a caller passes to an init function. */
#ifndef TP_BASE_ERROR_H
#define TP_BASE_ERROR_H
#include <stddef.h>
#include <stdint.h>
#include "tidepool/status.h"

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
tp_status tp_error_blame(tp_error *err, tp_status code, const char *word);

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
