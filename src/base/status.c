/* SPDX-License-Identifier: MIT */
/* Status codes and the texts of error messages: tidepool/status.h. */
#include "base/base.h"
#include "base/fail.h"
#include "base/text.h"

static const char *const sentences[TP_STATUS_COUNT] = {
#define X(name, text) [TP_##name] = text,
    TP_STATUS_LIST(X)
#undef X
};

const char *tp_status_text(tp_status code)
{
    return (unsigned)code < TP_STATUS_COUNT ? sentences[code] : "unknown status";
}

static void put_placeholder(tp_text *out, char part, const tp_error *err)
{
    switch (part) {
    case 'a': tp_text_int(out, err->a);    break;
    case 'b': tp_text_int(out, err->b);    break;
    case 's': tp_text_add(out, err->word); break;
    default:  tp_text_char(out, part);     break;
    }
}

size_t tp_error_text(const tp_error *err, char *text, size_t bytes)
{
    TP_ASSERT(err != NULL);
    tp_text out = tp_text_init(text, bytes);
    for (const char *at = tp_status_text(err->code); *at != '\0'; at++) {
        if (*at == '%' && at[1] != '\0')
            put_placeholder(&out, *++at, err);
        else
            tp_text_char(&out, *at);
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

tp_status tp_error_blame(tp_error *err, tp_status code, const char *word)
{
    tp_error_set_word(err, word, tp_text_length(word));
    return code;
}
