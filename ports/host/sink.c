/* SPDX-License-Identifier: MIT */
/* Choosing an output by its name; numbering PNGs.  A pattern is read here and never
 * given to printf: its text is the user's. */
#define _POSIX_C_SOURCE 200809L
#include "sink.h"
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "path.h"
#include "say.h"

#define NAME_BYTES 4096
#define DIGITS_MAX 9

/* The place of %d or %0Nd in a pattern; *digits is N, or 0.  0: not such a place. */
static size_t number_at(const char *c, int *digits)
{
    size_t n = 1;
    *digits = 0;
    if (c[n] == '0' && c[n + 1] >= '1' && c[n + 1] <= '0' + DIGITS_MAX) {
        *digits = c[n + 1] - '0';
        n += 2;
    }
    return c[n] == 'd' ? n + 1 : 0;
}

/* The name of a frame; "%%" is a percent sign.  *numbers counts the frame's number in
 * it.  False: some % is neither, or the name is too long. */
static bool frame_name(const char *pattern, uint32_t frame, char name[NAME_BYTES],
                       unsigned *numbers)
{
    size_t length = 0;
    *numbers = 0;
    for (const char *c = pattern; *c;) {
        int digits;
        if (length + 16 > NAME_BYTES)
            return false;
        if (*c != '%' || c[1] == '%') {
            name[length++] = *c;
            c += *c == '%' ? 2 : 1;
            continue;
        }
        const size_t skip = number_at(c, &digits);
        if (!skip)
            return false;
        length += (size_t)snprintf(name + length, 16, "%0*u", digits, (unsigned)frame);
        c += skip;
        (*numbers)++;
    }
    name[length] = 0;
    return true;
}

static bool is_device(const char *name)
{
    struct stat info;
    return stat(name, &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode);
}

static int open_png(sink *s, const options *o)
{
    char name[NAME_BYTES];
    unsigned numbers;
    s->kind = SINK_PNG;
    if (!frame_name(o->out, o->last, name, &numbers))
        return fail(EXIT_USAGE, "tidepool render: --out %s: a number's place is written"
                    " %%d or %%04d, a percent sign %%%%", o->out);
    if (!numbers && o->last > o->first)
        return fail(EXIT_USAGE, "tidepool render: --out %s: %u frames need a place for"
                    " their number, as in f-%%04d.png", o->out,
                    (unsigned)(o->last - o->first + 1));
    return EXIT_DONE;
}

int sink_open(sink *s, const options *o)
{
    *s = (sink){ .out = o->out };
    if (!o->out)
        return EXIT_DONE;
    if (path_ends(o->out, ".png"))
        return open_png(s, o);
    const bool to_stdout = strcmp(o->out, "-") == 0;
    if (!to_stdout && !path_ends(o->out, ".y4m") && !is_device(o->out))
        return fail(EXIT_USAGE, "tidepool render: --out %s: a name ends in .png or .y4m,"
                    " or is - for a film on standard output", o->out);
    if (to_stdout && isatty(STDOUT_FILENO))
        return fail(EXIT_USAGE, "tidepool render: --out -: standard output is a terminal;"
                    " lead it into a file or a player");
    s->kind = SINK_FILM;
    return film_open(&s->film, o->out, o->width, o->height);
}

int sink_add(sink *s, const picture *p, uint32_t frame)
{
    char name[NAME_BYTES];
    unsigned numbers;
    if (s->kind == SINK_FILM)
        return film_add(&s->film, p);
    if (s->kind == SINK_NONE)
        return EXIT_DONE;
    frame_name(s->out, frame, name, &numbers);
    return picture_write_png(p, name);
}

int sink_close(sink *s)
{
    return s->kind == SINK_FILM ? film_close(&s->film) : EXIT_DONE;
}

void sink_discard(sink *s)
{
    if (s->kind == SINK_FILM)
        film_discard(&s->film);
}
