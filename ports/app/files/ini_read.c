/* SPDX-License-Identifier: MIT */
/* Reads INI files through libinih.  As built by distributions, libinih passes no line
 * numbers to the handler, silently cuts lines at 200 bytes, and takes an indented line for
 * a continuation of the value above.  The reader below counts lines, removes the indent,
 * and keeps a value that is too long for libinih: a file name may be as long as a path. */
#define _POSIX_C_SOURCE 200809L
#include "ini_read.h"
#include <ctype.h>
#include <errno.h>
#include <ini.h>
#include <stdio.h>
#include <string.h>
#include "log.h"

typedef struct {
    FILE       *stream;
    const char *path;
    ini_take   *take;
    void       *user;
    uint32_t    line;           /* number of the last line read, from 1 */
    bool        failed;         /* true after an error and its message */
    char        text[INI_LINE + 1];
    const char *value;          /* value of a line too long for libinih; otherwise NULL */
} ini_input;

static bool refuse_line(ini_input *in, const char *why, int limit)
{
    log_line("%s:%u: line %s %d bytes", in->path, (unsigned)in->line, why, limit);
    in->failed = true;
    return false;
}

/* Reads a line without its end and its indent; false at the end of the file or after an
 * error. */
static bool read_line(ini_input *in)
{
    int c = getc(in->stream), length = 0;
    bool indent = true;
    if (c == EOF)
        return false;
    in->line++;
    for (; c != EOF && c != '\n'; c = getc(in->stream)) {
        indent = indent && (c == ' ' || c == '\t');
        if (c == 0)
            return refuse_line(in, "with a NUL byte after", length);
        if (length == INI_LINE)
            return refuse_line(in, "longer than", INI_LINE);
        if (!indent)
            in->text[length++] = (char)c;
    }
    in->text[length] = 0;
    return true;
}

/* Trims the blanks around a value and the comment after it, by libinih's rules. */
static const char *trim_value(char *text)
{
    char *end = text;
    while (isspace((unsigned char)*text))
        end = ++text;
    while (*end && !(*end == ';' && isspace((unsigned char)end[-1])))
        end++;
    while (end > text && isspace((unsigned char)end[-1]))
        end--;
    *end = 0;
    return text;
}

/* Shortens a line that is too long for libinih: a setting keeps only its name, a comment
 * becomes empty. */
static bool shorten_line(ini_input *in, char *text, int room)
{
    const size_t name = strcspn(in->text, "=:");
    text[0] = 0;
    if (in->text[0] == ';' || in->text[0] == '#')
        return true;
    if (!in->text[name] || name + 2 >= (size_t)room)
        return refuse_line(in, "longer than", room - 1);
    snprintf(text, (size_t)room, "%.*s=-", (int)name, in->text);
    in->value = trim_value(in->text + name + 1);
    return true;
}

/* Reads a line as fgets does; NULL ends the parse. */
static char *next_line(char *text, int room, void *user)
{
    ini_input *in = user;
    in->value = NULL;
    if (in->failed || !read_line(in))
        return NULL;
    if (strlen(in->text) >= (size_t)room)
        return shorten_line(in, text, room) ? text : NULL;
    strcpy(text, in->text);
    return text;
}

static int take(void *user, const char *section, const char *name, const char *value)
{
    ini_input *in = user;
    if (in->failed)
        return 0;
    in->failed = !in->take(in->user, in->line, section, name,
                           in->value ? in->value : value);
    return !in->failed;
}

int ini_read(const char *path, ini_take *taker, void *user)
{
    ini_input in = { .stream = fopen(path, "rb"), .path = path, .take = taker,
                     .user = user };
    if (!in.stream)
        return log_fail(EXIT_INPUT, "%s: %s", path, strerror(errno));
    errno = 0;
    const int bad_line = ini_parse_stream(next_line, &in, take, &in);
    const int read_error = ferror(in.stream) ? errno : 0;
    fclose(in.stream);
    if (read_error)
        return log_fail(EXIT_INPUT, "%s: %s", path, strerror(read_error));
    if (bad_line && (!in.failed || (uint32_t)bad_line < in.line))
        return log_fail(EXIT_INPUT, "%s:%d: neither [section] nor name = value", path,
                        bad_line);
    return in.failed ? EXIT_INPUT : EXIT_DONE;
}
