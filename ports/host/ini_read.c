/* SPDX-License-Identifier: MIT */
/* INI files through libinih, which distributions build so that it tells the handler no
 * line number, cuts lines at 200 bytes in silence and takes an indented line for more of
 * the value above.  The reader below counts lines, refuses long ones and takes the indent
 * away. */
#define _POSIX_C_SOURCE 200809L
#include "ini_read.h"
#include <errno.h>
#include <ini.h>
#include <stdio.h>
#include <string.h>
#include "say.h"

typedef struct {
    FILE       *stream;
    const char *path;
    ini_take   *take;
    void       *user;
    uint32_t    line;           /* of the last line read, from 1 */
    bool        failed;         /* and said why */
} ini_input;

static char *refuse_line(ini_input *in, const char *why, int limit)
{
    say("%s:%u: line %s %d bytes", in->path, (unsigned)in->line, why, limit);
    in->failed = true;
    return NULL;
}

/* As fgets, without the line's end and its indent; NULL at the file's end or after a
 * failure, which ends the parse. */
static char *next_line(char *text, int room, void *user)
{
    ini_input *in = user;
    if (in->failed)
        return NULL;
    int c = getc(in->stream), length = 0;
    bool indent = true;
    if (c == EOF)
        return NULL;
    in->line++;
    for (; c != EOF && c != '\n'; c = getc(in->stream)) {
        indent = indent && (c == ' ' || c == '\t');
        if (c == 0)
            return refuse_line(in, "with a NUL byte after", length);
        if (length == room - 1)
            return refuse_line(in, "longer than", room - 1);
        if (!indent)
            text[length++] = (char)c;
    }
    text[length] = 0;
    return text;
}

static int take(void *user, const char *section, const char *name, const char *value)
{
    ini_input *in = user;
    if (in->failed)
        return 0;
    in->failed = !in->take(in->user, in->line, section, name, value);
    return !in->failed;
}

int ini_read(const char *path, ini_take *taker, void *user)
{
    ini_input in = { .stream = fopen(path, "rb"), .path = path, .take = taker,
                     .user = user };
    if (!in.stream)
        return fail(EXIT_INPUT, "%s: %s", path, strerror(errno));
    errno = 0;
    const int bad_line = ini_parse_stream(next_line, &in, take, &in);
    const int read_error = ferror(in.stream) ? errno : 0;
    fclose(in.stream);
    if (read_error)
        return fail(EXIT_INPUT, "%s: %s", path, strerror(read_error));
    if (bad_line && (!in.failed || (uint32_t)bad_line < in.line))
        return fail(EXIT_INPUT, "%s:%d: neither [section] nor name = value", path,
                    bad_line);
    return in.failed ? EXIT_INPUT : EXIT_DONE;
}
