/* SPDX-License-Identifier: MIT */
/* The tokenizer of OBJ and MTL text, mesh/obj.h: bytes that arrive in pieces become
 * logical lines, and a line becomes words and numbers. */
#include "base/base.h"
#include "fixed/arithmetic.h"
#include "mesh/obj.h"

/* -- words of a line ----------------------------------------------------------------- */

/* No function reads at or beyond `end`: lines have no terminator. */

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

bool tp_words_read_number(tp_words *words, int64_t *x)
{
    skip_blanks(words);
    const uint32_t n = tp_fx_read_wide(words->at, (uint32_t)(words->end - words->at), x);
    const char *const end = words->at + n;
    if (n == 0 || (end < words->end && !tp_is_blank(*end)))
        return false;
    words->at = end;
    return true;
}

bool tp_words_read_int_prefix(tp_words *words, int32_t *x)
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

/* -- logical lines ------------------------------------------------------------------- */

/* A line that lies entirely within one piece is returned in place; only other lines are
 * copied. */

void tp_lines_begin(tp_obj_lines *lines)
{
    lines->used = lines->part = 0;
    lines->first = lines->next = 1;
    lines->open = lines->comment = lines->after_cr = false;
    lines->continues = lines->goes_on = lines->split = false;
}

/* Returns the first LF or CR, or `end`. */
static const char *find_line_end(const char *at, const char *end)
{
    while (at < end && *at != '\n' && *at != '\r')
        at++;
    return at;
}

/* Steps over the line end at `at` and counts the line. */
static const char *skip_line_end(tp_obj_lines *lines, const char *at, const char *end)
{
    lines->next++;
    const bool cr = *at++ == '\r';
    if (cr && at < end && *at == '\n')
        at++;
    else
        lines->after_cr = cr && at == end;
    return at;
}

/* Opens a line at the first byte that is not a blank; leading blanks have no meaning. */
static const char *begin_line(tp_obj_lines *lines, const char *at, const char *end)
{
    while (at < end && tp_is_blank(*at))
        at++;
    lines->open = at < end;
    lines->comment = lines->open && *at == '#';
    lines->first = lines->next;
    lines->used = 0;
    lines->continues = false;
    return at;
}

/* Appends as many bytes as fit to the text.  Returns the first byte that does not fit. */
static const char *append(tp_obj_lines *lines, const char *at, const char *end)
{
    TP_ASSERT(lines->used <= sizeof lines->text && at <= end);
    if (lines->comment)
        return end;
    const size_t room = sizeof lines->text - lines->used, left = (size_t)(end - at);
    const size_t bytes = left < room ? left : room;
    if (bytes > 0)
        memcpy(lines->text + lines->used, at, bytes);
    lines->used += (uint32_t)bytes;
    return at + bytes;
}

/* The text is full and more bytes follow: hands out the text up to the last blank. */
static void emit_line_part(tp_obj_lines *lines, tp_words *line)
{
    uint32_t part = lines->used;
    while (part > 0 && !tp_is_blank(lines->text[part - 1]))
        part--;
    lines->split = part == 0;
    lines->part = lines->split ? lines->used : part;
    lines->goes_on = true;
    *line = (tp_words){ lines->text, lines->text + lines->part };
}

/* Removes the part that was handed out, before the next part is read. */
static void remove_emitted_part(tp_obj_lines *lines)
{
    if (!lines->goes_on)
        return;
    lines->used -= lines->part;
    memmove(lines->text, lines->text + lines->part, lines->used);
    lines->goes_on = lines->split = false;
    lines->continues = true;
}

/* True if a backslash joins the next line.  Called after a line end, with text not
 * empty. */
static bool join_continuation(tp_obj_lines *lines)
{
    if (lines->comment || lines->text[lines->used - 1] != '\\')
        return false;
    lines->text[lines->used - 1] = ' ';
    return true;
}

/* True if [at, stop), the first part of a line, is the whole line.  Also true
 * for most comments. */
static bool can_read_line_in_place(const char *at, const char *stop)
{
    return stop - at <= TP_OBJ_LINE_BYTES && (at == stop || stop[-1] != '\\');
}

bool tp_lines_next(tp_obj_lines *lines, const char **from, const char *end,
                   tp_words *line)
{
    const char *at = *from;
    remove_emitted_part(lines);
    if (lines->after_cr && at < end) {
        lines->after_cr = false;
        at += *at == '\n';
    }
    while (at < end) {
        const char *const stop = find_line_end(at, end);
        if (!lines->open)
            at = begin_line(lines, at, stop);
        *line = (tp_words){ at, stop };
        const bool here =
            lines->used == 0 && stop < end && can_read_line_in_place(at, stop);
        if (lines->open && !here) {
            at = append(lines, at, stop);
            if (at < stop) {
                emit_line_part(lines, line);
                *from = at;
                return true;
            }
            *line = (tp_words){ lines->text, lines->text + lines->used };
        }
        if (stop == end)
            break;
        at = skip_line_end(lines, stop, end);
        if (!lines->open || (!here && join_continuation(lines)))
            continue;
        lines->open = false;
        if (!lines->comment) {
            *from = at;
            return true;
        }
    }
    *from = end;
    return false;
}

bool tp_lines_last(tp_obj_lines *lines, tp_words *line)
{
    const bool any = lines->open && !lines->comment;
    lines->open = false;
    *line = (tp_words){ lines->text, lines->text + lines->used };
    return any;
}
