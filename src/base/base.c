/* SPDX-License-Identifier: MIT */
/*
 * The arena, texts and error reports of base/base.h and tidepool/status.h.
 *
 * In an arena a size that overflows saturates `used`.  Every later allocation then fails
 * as well, and the caller sees one failure at the end.
 *
 * The text of a report is a template of the status, with two numbers and a word of the
 * report in it.  Text goes into a bounded buffer; no other file needs to count bytes.  The
 * version of the library, tidepool/tidepool.h, stands here too.
 */
#include "base/base.h"
#include "tidepool/tidepool.h"

/* -- the arena ----------------------------------------------------------------------- */

enum { ALIGNMENT = 8 };

tp_arena tp_arena_init(void *block, size_t bytes)
{
    TP_ASSERT((uintptr_t)block % ALIGNMENT == 0);
    return (tp_arena){ .block = block, .bytes = bytes, .used = 0, .failed = false };
}

/* Returns count x size in bytes, rounded up to the alignment.  Returns SIZE_MAX if the
 * product does not fit a size_t: no block is that large. */
static size_t aligned_size(size_t count, size_t size)
{
    if (size != 0 && count > (SIZE_MAX - ALIGNMENT) / size)
        return SIZE_MAX;
    return (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
}

void *tp_arena_alloc(tp_arena *arena, size_t count, size_t size)
{
    TP_ASSERT(arena != NULL);
    TP_ASSERT(arena->failed || arena->block == NULL || arena->used <= arena->bytes);
    const size_t bytes = aligned_size(count, size);
    if (bytes > SIZE_MAX - arena->used) {
        arena->used = SIZE_MAX;
        arena->failed = true;
        return NULL;
    }
    const size_t at = arena->used;
    arena->used += bytes;
    if (arena->block == NULL)
        return NULL;
    if (arena->used > arena->bytes) {
        arena->failed = true;
        return NULL;
    }
    return arena->block + at;
}

/* -- text in a bounded buffer -------------------------------------------------------- */

tp_text tp_text_init(char *buffer, size_t bytes)
{
    TP_ASSERT(buffer != NULL || bytes == 0);
    if (bytes > 0)
        buffer[0] = '\0';
    return (tp_text){ .text = buffer, .bytes = bytes, .length = 0 };
}

void tp_text_append_char(tp_text *text, char c)
{
    if (text->length + 1 < text->bytes) {
        text->text[text->length] = c;
        text->text[text->length + 1] = '\0';
    }
    text->length++;
}

void tp_text_append(tp_text *text, const char *string)
{
    for (; *string != '\0'; string++)
        tp_text_append_char(text, *string);
}

void tp_text_append_int(tp_text *text, int32_t number)
{
    char digits[10];
    int n = 0;
    uint32_t left = number < 0 ? 0u - (uint32_t)number : (uint32_t)number;
    do {
        digits[n++] = (char)('0' + left % 10);
        left /= 10;
    } while (left > 0);
    if (number < 0)
        tp_text_append_char(text, '-');
    while (n > 0)
        tp_text_append_char(text, digits[--n]);
}

size_t tp_string_length(const char *string)
{
    size_t n = 0;
    while (string[n] != '\0')
        n++;
    return n;
}

/* -- reports ------------------------------------------------------------------------- */

static const char *const sentences[TP_STATUS_COUNT] = {
#define X(name, text) [TP_##name] = text,
    TP_STATUS_LIST(X)
#undef X
};

const char *tp_status_text(tp_status code)
{
    return (unsigned)code < TP_STATUS_COUNT ? sentences[code] : "unknown status";
}

static void append_placeholder_value(tp_text *out, char letter, const tp_error *err)
{
    switch (letter) {
    case 'a': tp_text_append_int(out, err->a);    break;
    case 'b': tp_text_append_int(out, err->b);    break;
    case 's': tp_text_append(out, err->word); break;
    default:  tp_text_append_char(out, letter);     break;
    }
}

size_t tp_error_text(const tp_error *err, char *text, size_t bytes)
{
    TP_ASSERT(err != NULL);
    tp_text out = tp_text_init(text, bytes);
    for (const char *at = tp_status_text(err->code); *at != '\0'; at++) {
        if (*at == '%' && at[1] != '\0')
            append_placeholder_value(&out, *++at, err);
        else
            tp_text_append_char(&out, *at);
    }
    return out.length;
}

tp_status tp_fail_(tp_error *err, tp_status code, const char *file, int line,
                   uint32_t where, int32_t a, int32_t b)
{
    if (err != NULL)
        *err = (tp_error){ .code = code, .file = file, .line = line,
                           .where = where, .a = a, .b = b };
    return code;
}

/* Control bytes of a hostile file must not reach a terminal: each becomes '?'. */
void tp_error_set_word(tp_error *err, const char *word, size_t bytes)
{
    TP_ASSERT(word != NULL || bytes == 0);
    if (err == NULL)
        return;
    size_t n = bytes < sizeof err->word ? bytes : sizeof err->word - 1;
    for (size_t i = 0; i < n; i++) {
        const unsigned char c = (unsigned char)word[i];
        err->word[i] = c < 0x20 || c == 0x7f ? '?' : (char)c;
    }
    err->word[n] = '\0';
}

tp_status tp_error_add_word(tp_error *err, tp_status code, const char *word)
{
    tp_error_set_word(err, word, tp_string_length(word));
    return code;
}

/* -- pointers of a caller ------------------------------------------------------------ */

tp_status tp_pointer_check(const void *given, const char *name, tp_error *err)
{
    return given != NULL ? TP_OK
                         : tp_error_add_word(err, TP_FAIL(err, TP_E_NULL, 0, 0, 0), name);
}

tp_status tp_pointer_check_aligned(const void *block, uint32_t align, const char *name,
                                   tp_error *err)
{
    TP_ASSERT(align > 0 && (align & (align - 1)) == 0);
    if ((uintptr_t)block % align != 0)
        return tp_error_add_word(err, TP_FAIL(err, TP_E_ALIGN, 0, align, 0), name);
    return tp_pointer_check(block, name, err);
}

/* -- version ------------------------------------------------------------------------- */

const char *tp_version(void) { return TP_VERSION_TEXT; }
