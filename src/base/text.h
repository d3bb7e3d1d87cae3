/* SPDX-License-Identifier: MIT */
/* Builds text in the caller's buffer.  The text is always terminated, and cut at the end of
 * the buffer.  `length` goes on counting, to tell the size of the whole text. */
#ifndef TP_BASE_TEXT_H
#define TP_BASE_TEXT_H
#include <stddef.h>
#include <stdint.h>

typedef struct {
    char  *text;
    size_t bytes;           /* size of the buffer; 0: count only, write nothing */
    size_t length;          /* length of the whole text, without the terminator */
} tp_text;

tp_text tp_text_init(char *buffer, size_t bytes);
void    tp_text_char(tp_text *text, char c);
void    tp_text_add(tp_text *text, const char *string);     /* `string` is terminated */
void    tp_text_int(tp_text *text, int32_t number);

/* Returns the length of a terminated string in bytes, without the terminator. */
size_t tp_text_length(const char *string);
#endif
