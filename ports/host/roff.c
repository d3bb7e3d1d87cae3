/* SPDX-License-Identifier: MIT */
/* A line of source that begins with a dot or an apostrophe is a request, a backslash
 * begins an escape, and -'`^~ are printed as other signs than they are: all of them are
 * spelt out.  Lines are broken at blanks, which fill again, and where the text's own are. */
#include "roff.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define BREAK_FROM 60           /* columns; the longest words still end before 80 */

static int column;              /* of the line of source that is being written */

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
