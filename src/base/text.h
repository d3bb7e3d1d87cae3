/* SPDX-License-Identifier: MIT */
/* Text put together in a caller's buffer: always terminated, cut where the buffer ends,
 * while the length goes on counting what the whole would have. */
#ifndef TP_BASE_TEXT_H
#define TP_BASE_TEXT_H
#include <stddef.h>
#include <stdint.h>

typedef struct {
    char  *text;
    size_t bytes;           /* of the buffer; 0: nothing is written, only counted */
    size_t length;          /* of the whole text, its end not included */
} tp_text;

tp_text tp_text_over(char *buffer, size_t bytes);
void    tp_text_char(tp_text *text, char c);
void    tp_text_add(tp_text *text, const char *string);     /* terminated */
void    tp_text_int(tp_text *text, int32_t number);

/* Bytes of a terminated string, its end not included. */
size_t tp_text_length(const char *string);
#endif
