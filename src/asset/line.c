/* SPDX-License-Identifier: MIT */
/* Logical lines: asset/line.h.  A line that lies whole within one piece is handed out
 * where it lies; only others are copied. */
#include "asset/line.h"
#include "base/base.h"

void tp_lines_begin(tp_obj_lines *lines)
{
    lines->used = 0;
    lines->first = lines->next = 1;
    lines->open = lines->comment = lines->after_cr = false;
}

/* The first LF or CR, or `end`. */
static const char *find_end(const char *at, const char *end)
{
    while (at < end && *at != '\n' && *at != '\r')
        at++;
    return at;
}

/* `at` stands on a line end: steps over it and counts. */
static const char *pass_end(tp_obj_lines *lines, const char *at, const char *end)
{
    lines->next++;
    const bool cr = *at++ == '\r';
    if (cr && at < end && *at == '\n')
        at++;
    else
        lines->after_cr = cr && at == end;
    return at;
}

/* Opens a line at the first byte that is no blank; what is before it says nothing. */
static const char *begin(tp_obj_lines *lines, const char *at, const char *end)
{
    while (at < end && tp_is_blank(*at))
        at++;
    lines->open = at < end;
    lines->comment = lines->open && *at == '#';
    lines->first = lines->next;
    lines->used = 0;
    return at;
}

/* Adds a piece to the text; false once the line is longer than that. */
static bool append(tp_obj_lines *lines, const char *at, const char *end)
{
    if (lines->comment)
        return true;
    const size_t bytes = (size_t)(end - at);
    if (bytes > sizeof lines->text - lines->used) {
        lines->used = sizeof lines->text + 1;
        return false;
    }
    if (bytes > 0)
        memcpy(lines->text + lines->used, at, bytes);
    lines->used += (uint32_t)bytes;
    return true;
}

/* A line end is behind: does a backslash before it join the next line? */
static bool joins(tp_obj_lines *lines)
{
    if (lines->comment || lines->text[lines->used - 1] != '\\')
        return false;
    lines->text[lines->used - 1] = ' ';
    return true;
}

/* Is [at, stop), a line's first part, all of it?  Also true of most comments. */
static bool is_whole(const char *at, const char *stop)
{
    return stop - at <= TP_OBJ_LINE_BYTES && (at == stop || stop[-1] != '\\');
}

bool tp_lines_next(tp_obj_lines *lines, const char **from, const char *end,
                   tp_words *line)
{
    const char *at = *from;
    if (lines->after_cr && at < end) {
        lines->after_cr = false;
        at += *at == '\n';
    }
    while (at < end) {
        const char *const stop = find_end(at, end);
        if (!lines->open)
            at = begin(lines, at, stop);
        *line = (tp_words){ at, stop };
        const bool here = lines->used == 0 && stop < end && is_whole(at, stop);
        if (lines->open && !here) {
            if (!append(lines, at, stop)) {
                *from = stop;
                return true;
            }
            *line = (tp_words){ lines->text, lines->text + lines->used };
        }
        if (stop == end)
            break;
        at = pass_end(lines, stop, end);
        if (!lines->open || (!here && joins(lines)))
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
