/* SPDX-License-Identifier: MIT */
/* Writes roff source.  A source line that begins with a dot or an apostrophe is a request,
 * a backslash begins an escape, and roff prints -'`^~ as other characters: all of them are
 * escaped.  Source lines are broken at blanks, where roff fills, and at the text's line
 * feeds. */
#include "roff.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define BREAK_FROM 60           /* columns; the longest words still end before column 80 */

static int column;              /* column in the current source line */

void roff_end(void)
{
    if (column)
        putchar('\n');
    column = 0;
}

void roff_macro(const char *format, ...)
{
    va_list list;
    roff_end();
    va_start(list, format);
    vprintf(format, list);
    va_end(list);
    putchar('\n');
}

static const char *spelt(char c)
{
    switch (c) {
    case '\\': return "\\e";
    case '-':  return "\\-";
    case '\'': return "\\(aq";
    case '`':  return "\\(ga";
    case '^':  return "\\(ha";
    case '~':  return "\\(ti";
    default:   return NULL;
    }
}

static void put(const char *text)
{
    column += (int)strlen(text);
    fputs(text, stdout);
}

void roff_text(const char *text)
{
    for (; *text; text++) {
        const char plain[2] = { *text, 0 }, *escape = spelt(*text);
        if (*text == '\n' || (*text == ' ' && (column == 0 || column >= BREAK_FROM))) {
            roff_end();
            continue;
        }
        if (column == 0 && *text == '.')
            put("\\&");
        put(escape ? escape : plain);
    }
}

void roff_bold(const char *text)
{
    put("\\fB");
    roff_text(text);
    put("\\fR");
}

void roff_italic(const char *text)
{
    put("\\fI");
    roff_text(text);
    put("\\fR");
}
