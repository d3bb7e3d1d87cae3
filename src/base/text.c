/* SPDX-License-Identifier: MIT */
/* Text in a bounded buffer; no other file needs to count bytes. */
#include "base/assert.h"
#include "base/text.h"

tp_text tp_text_init(char *buffer, size_t bytes)
{
    TP_ASSERT(buffer != NULL || bytes == 0);
    if (bytes > 0)
        buffer[0] = '\0';
    return (tp_text){ .text = buffer, .bytes = bytes, .length = 0 };
}

void tp_text_char(tp_text *text, char c)
{
    if (text->length + 1 < text->bytes) {
        text->text[text->length] = c;
        text->text[text->length + 1] = '\0';
    }
    text->length++;
}

void tp_text_add(tp_text *text, const char *string)
{
    for (; *string != '\0'; string++)
        tp_text_char(text, *string);
}

void tp_text_int(tp_text *text, int32_t number)
{
    char digits[10];
    int n = 0;
    uint32_t left = number < 0 ? 0u - (uint32_t)number : (uint32_t)number;
    do {
        digits[n++] = (char)('0' + left % 10);
        left /= 10;
    } while (left > 0);
    if (number < 0)
        tp_text_char(text, '-');
    while (n > 0)
        tp_text_char(text, digits[--n]);
}

size_t tp_text_length(const char *string)
{
    size_t n = 0;
    while (string[n] != '\0')
        n++;
    return n;
}
