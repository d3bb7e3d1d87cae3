/* SPDX-License-Identifier: MIT */
/* Chooses an output by its name, and numbers PNGs.  Patterns are parsed here and never
 * passed to printf: their text comes from the user. */
#define _POSIX_C_SOURCE 200809L
#include "frame_sink.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "app/files/log.h"
#include "app/files/path.h"

#define NAME_BYTES 4096
#define DIGITS_MAX 9

/* Parses %d or %0Nd in a pattern; *digits: N, or 0.  Returns the length, or 0 for other
 * text. */
static size_t parse_number_field(const char *c, int *digits)
{
    size_t n = 1;
    *digits = 0;
    if (c[n] == '0' && c[n + 1] >= '1' && c[n + 1] <= '0' + DIGITS_MAX) {
        *digits = c[n + 1] - '0';
        n += 2;
    }
    return c[n] == 'd' ? n + 1 : 0;
}

/* Makes the name of a frame; "%%" becomes a percent sign.  *numbers: how often the frame's
 * number occurs.  False: invalid use of %, or the name is too long. */
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
        const size_t skip = parse_number_field(c, &digits);
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

static int open_png(frame_sink *s, const options *o)
{
    char name[NAME_BYTES];
    unsigned numbers;
    s->kind = FRAME_SINK_PNG;
    if (!frame_name(o->out, o->last, name, &numbers))
        return log_fail(EXIT_USAGE, "tidepool render: --out %s: write %%d or %%04d for the"
                    " number, %%%% for a percent sign", o->out);
    if (!numbers && args_frames(o) > 1)
        return log_fail(EXIT_USAGE, "tidepool render: --out %s: %u frames need a number in"
                    " the name, as in f-%%04d.png", o->out,
                    (unsigned)args_frames(o));
    return EXIT_DONE;
}

static int open_animation(frame_sink *s, const options *o)
{
    s->kind = FRAME_SINK_ANIMATION;
    return animation_open(&s->animation, s->out, args_frames(o), o->every);
}

/* Chooses the name.  A user's picture with the scene's name may exist: that file is
 * refused. */
static int open_own(frame_sink *s, const options *o)
{
    const bool many = args_frames(o) > 1;
    char *stem = path_stem(o->scene);
    const size_t room = stem ? strlen(stem) + sizeof ".apng" : 0;
    s->own = stem ? malloc(room) : NULL;
    if (s->own)
        snprintf(s->own, room, "%s%s", stem, many ? ".apng" : ".png");
    free(stem);
    if (!s->own)
        return log_fail_memory(room);
    if (access(s->own, F_OK) == 0 && !picture_is_ours(s->own))
        return log_fail(EXIT_INPUT, "%s: exists, and tidepool did not make it; --out %s"
                    " replaces it", s->own, s->own);
    s->out = s->own;
    s->kind = FRAME_SINK_PNG;
    return many ? open_animation(s, o) : EXIT_DONE;
}

int frame_sink_open(frame_sink *s, const options *o)
{
    *s = (frame_sink){ .options = o, .out = o->out };
    if (!o->out)
        return o->hash || o->stats || o->expect ? EXIT_DONE : open_own(s, o);
    if (path_ends(o->out, ".png"))
        return open_png(s, o);
    if (path_ends(o->out, ".apng"))
        return open_animation(s, o);
    const bool to_stdout = strcmp(o->out, "-") == 0;
    if (!to_stdout && !path_ends(o->out, ".y4m") && !is_device(o->out))
        return log_fail(EXIT_USAGE, "tidepool render: --out %s: a name ends in .png, .apng"
                    " or .y4m, or is - for a film on standard output", o->out);
    if (to_stdout && isatty(STDOUT_FILENO))
        return log_fail(EXIT_USAGE,
                        "tidepool render: --out -: standard output is a terminal;"
                        " send it to a file or a player");
    s->kind = FRAME_SINK_FILM;
    return film_open(&s->film, o->out, o->width, o->height, o->every);
}

int frame_sink_add(frame_sink *s, const picture *p, uint32_t frame)
{
    char name[NAME_BYTES];
    unsigned numbers;
    if (s->kind == FRAME_SINK_FILM)
        return film_add(&s->film, p);
    if (s->kind == FRAME_SINK_ANIMATION)
        return animation_add(&s->animation, p);
    if (s->kind == FRAME_SINK_NONE)
        return EXIT_DONE;
    if (s->own)
        return picture_write_png(p, s->own);
    frame_name(s->out, frame, name, &numbers);
    return picture_write_png(p, name);
}

static void say_own(const frame_sink *s)
{
    const options *o = s->options;
    const unsigned last = (unsigned)(o->first + (args_frames(o) - 1) * o->every);
    if (s->kind == FRAME_SINK_PNG)
        log_line("%s: frame %u, %ux%u", s->own, (unsigned)o->first, (unsigned)o->width,
                 (unsigned)o->height);
    else if (TP_TICKS_PER_SECOND % o->every == 0)
        log_line("%s: frames %u..%u, %ux%u, %u a second", s->own, (unsigned)o->first, last,
            (unsigned)o->width, (unsigned)o->height,
            (unsigned)(TP_TICKS_PER_SECOND / o->every));
    else
        log_line("%s: frames %u..%u, %ux%u, each for %u/%u s", s->own, (unsigned)o->first,
                 last, (unsigned)o->width, (unsigned)o->height, (unsigned)o->every,
                 TP_TICKS_PER_SECOND);
}

int frame_sink_close(frame_sink *s)
{
    const int code = s->kind == FRAME_SINK_FILM ? film_close(&s->film)
                   : s->kind == FRAME_SINK_ANIMATION ? animation_close(&s->animation)
                   : EXIT_DONE;
    if (!code && s->own)
        say_own(s);
    free(s->own);
    s->own = NULL;
    return code;
}

void frame_sink_discard(frame_sink *s)
{
    if (s->kind == FRAME_SINK_FILM)
        film_discard(&s->film);
    if (s->kind == FRAME_SINK_ANIMATION)
        animation_discard(&s->animation);
    free(s->own);
    s->own = NULL;
}
