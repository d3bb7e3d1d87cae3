/* SPDX-License-Identifier: MIT */
/* Words of a line: asset/word.h.  No function reads at or beyond `end`: lines
 * have no terminator. */
#include "asset/word.h"
#include "fx/fx.h"

static void skip_blanks(tp_words *words)
{
    while (words->at < words->end && tp_is_blank(*words->at))
        words->at++;
}

bool tp_words_at_end(tp_words *words)
{
    skip_blanks(words);
    return words->at == words->end || *words->at == '#';
}

tp_word tp_word_next(tp_words *words)
{
    skip_blanks(words);
    const char *const text = words->at;
    while (words->at < words->end && !tp_is_blank(*words->at))
        words->at++;
    return (tp_word){ text, (uint32_t)(words->at - text) };
}

tp_word tp_word_rest(tp_words *words)
{
    skip_blanks(words);
    const char *const text = words->at, *end = words->end;
    while (end > text && tp_is_blank(end[-1]))
        end--;
    words->at = words->end;
    return (tp_word){ text, (uint32_t)(end - text) };
}

bool tp_word_is(tp_word word, const char *name)
{
    uint32_t i = 0;
    while (i < word.bytes && name[i] != '\0' && word.text[i] == name[i])
        i++;
    return i == word.bytes && name[i] == '\0';
}

bool tp_word_is_any_case(tp_word word, const char *name)
{
    uint32_t i = 0;
    for (; i < word.bytes && name[i] != '\0'; i++) {
        const char c = word.text[i];
        if ((c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c) != name[i])
            return false;
    }
    return i == word.bytes && name[i] == '\0';
}

bool tp_word_holds_nul(tp_word word)
{
    for (uint32_t i = 0; i < word.bytes; i++) {
        if (word.text[i] == '\0')
            return true;
    }
    return false;
}

bool tp_word_number(tp_words *words, int64_t *x)
{
    skip_blanks(words);
    const uint32_t n = tp_fx_read_wide(words->at, (uint32_t)(words->end - words->at), x);
    const char *const end = words->at + n;
    if (n == 0 || (end < words->end && !tp_is_blank(*end)))
        return false;
    words->at = end;
    return true;
}

bool tp_word_int(tp_words *words, int32_t *x)
{
    const char *at = words->at;
    const bool negative = at < words->end && *at == '-';
    if (at < words->end && (*at == '-' || *at == '+'))
        at++;
    const char *const digits = at;
    int32_t n = 0;
    for (; at < words->end && *at >= '0' && *at <= '9'; at++) {
        const int32_t digit = *at - '0';
        n = n > (INT32_MAX - digit) / 10 ? INT32_MAX : n * 10 + digit;
    }
    if (at == digits)
        return false;
    *x = negative ? -n : n;
    words->at = at;
    return true;
}
