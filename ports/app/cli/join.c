/* SPDX-License-Identifier: MIT */
/* tidepool join: joins films of ranges of frames, drawn anywhere, into one film.  A
 * YUV4MPEG2 film is a head followed by frames: parts with the same head join byte for byte.
 * Each part is read to its end; a truncated part is refused. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "app/files/log.h"
#include "app/files/output_file.h"
#include "app/files/path.h"
#include "args.h"
#include "command_help.h"
#include "commands.h"

#define HEAD_BYTES 256          /* tidepool's own head has 70 */
#define SIDE_HIGH  65536u
#define PIECE_BYTES 16384u

typedef struct {
    FILE       *file;
    const char *name;
    char        head[HEAD_BYTES];
} film_part;

typedef struct {
    output_file out;
    const char *first;          /* first part; other heads must equal its head */
    char        head[HEAD_BYTES];
    uint64_t    bytes;          /* size of a frame, without the line FRAME */
} joined;

/* Reads a line without its end; false: end of the file, or the line is too long. */
static bool read_line(FILE *file, char line[HEAD_BYTES])
{
    if (!fgets(line, HEAD_BYTES, file))
        return false;
    const size_t bytes = strcspn(line, "\n");
    const bool whole = line[bytes] == '\n';
    line[bytes] = 0;
    return whole;
}

/* Returns the number after the letter in a head, as in "W640", or 0. */
static uint32_t parse_side(const char *head, char letter)
{
    const char mark[] = { ' ', letter, 0 };
    const char *at = strstr(head, mark);
    const unsigned long side = at ? strtoul(at + 2, NULL, 10) : 0;
    return side <= SIDE_HIGH ? (uint32_t)side : 0;
}

static int open_part(film_part *p, const char *name)
{
    *p = (film_part){ .file = fopen(name, "rb"), .name = name };
    if (!p->file)
        return log_fail(EXIT_INPUT, "%s: %s", name, strerror(errno));
    errno = 0;
    if (!read_line(p->file, p->head) || strncmp(p->head, "YUV4MPEG2 ", 10) != 0)
        return log_fail(EXIT_INPUT, "%s: %s", name, errno ? strerror(errno)
                                                      : "not a YUV4MPEG2 film");
    return EXIT_DONE;
}

/* Takes the head of the first part; the size of frames follows from the head. */
static int take_head(joined *j, const film_part *p)
{
    const uint32_t w = parse_side(p->head, 'W'), h = parse_side(p->head, 'H');
    if (!w || !h || !strstr(p->head, " C420"))
        return log_fail(EXIT_INPUT, "%s: not a 4:2:0 film with width and height",
                        p->name);
    j->first = p->name;
    memcpy(j->head, p->head, sizeof j->head);
    j->bytes = (uint64_t)w * h + 2 * (uint64_t)((w + 1) / 2) * ((h + 1) / 2);
    fprintf(j->out.file, "%s\n", j->head);
    return EXIT_DONE;
}

/* Copies the frame after its FRAME line, in pieces: a head may name any size. */
static int copy_frame(joined *j, const film_part *p, unsigned number)
{
    char piece[PIECE_BYTES];
    for (uint64_t left = j->bytes; left > 0;) {
        const size_t bytes = left < PIECE_BYTES ? (size_t)left : PIECE_BYTES;
        if (fread(piece, 1, bytes, p->file) != bytes)
            return log_fail(EXIT_INPUT, "%s: ends inside of frame %u", p->name, number);
        if (fwrite(piece, 1, bytes, j->out.file) != bytes)
            return output_file_fail(&j->out, EIO);
        left -= bytes;
    }
    return EXIT_DONE;
}

static int add_frames(joined *j, const film_part *p)
{
    char mark[HEAD_BYTES];
    unsigned count = 0;
    int c, code = EXIT_DONE;
    for (; !code && (c = getc(p->file)) != EOF; count++) {
        ungetc(c, p->file);
        if (!read_line(p->file, mark)
            || (strcmp(mark, "FRAME") != 0 && strncmp(mark, "FRAME ", 6) != 0))
            return log_fail(EXIT_INPUT, "%s: expected the head of frame %u", p->name,
                            count);
        code = fprintf(j->out.file, "%s\n", mark) < 0 ? output_file_fail(&j->out, EIO)
                                                      : copy_frame(j, p, count);
    }
    if (code)
        return code;
    if (ferror(p->file))
        return log_fail(EXIT_INPUT, "%s: %s", p->name, strerror(errno));
    return count ? EXIT_DONE : log_fail(EXIT_INPUT, "%s: a film without frames", p->name);
}

static int add_part(joined *j, const char *name)
{
    film_part p;
    int code = open_part(&p, name);
    if (!code && !j->first)
        code = take_head(j, &p);
    if (!code && strcmp(p.head, j->head) != 0)
        code = log_fail(EXIT_INPUT, "%s: its head differs from that of %s: %s; %s", name,
                        j->first, p.head + 10, j->head + 10);
    if (!code)
        code = add_frames(j, &p);
    if (p.file)
        fclose(p.file);
    return code;
}

static int run(const options *o)
{
    joined j = { .first = NULL };
    const bool to_stdout = strcmp(o->names[0], "-") == 0;
    if (!to_stdout && !path_ends(o->names[0], ".y4m"))
        return log_fail(EXIT_USAGE, "tidepool join: %s: a film's name ends in .y4m, or is -"
                    " for standard output", o->names[0]);
    if (to_stdout && isatty(STDOUT_FILENO))
        return log_fail(EXIT_USAGE, "tidepool join: standard output is a terminal; send"
                                    " it to a file or a player");
    int code = output_file_open(&j.out, o->names[0]);
    if (code)
        return code;
    for (uint32_t i = 1; i < o->n_names && !code; i++)
        code = add_part(&j, o->names[i]);
    if (code)
        output_file_discard(&j.out);
    else
        code = output_file_close(&j.out);
    return code;
}

int join_command(int argc, char **argv)
{
    options o;
    int code = args_read(&o, FOR_JOIN, argc, argv);
    if (!code && o.help)
        command_help_print(FOR_JOIN);
    else if (!code)
        code = run(&o);
    const int end = o.help ? streams_finish() : EXIT_DONE;
    free(o.settings);
    return code ? code : end;
}
