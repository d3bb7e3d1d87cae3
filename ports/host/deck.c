/* SPDX-License-Identifier: MIT */
/* Tapes as files of lines, read whole before anything runs. */
#include "deck.h"
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "say.h"

/* -- reading --------------------------------------------------------------------- */

typedef struct {
    const char *name, *scene;
    FILE       *file;
    uint32_t    line;
} reader;

static int fail_line(const reader *r, tp_error *err)
{
    err->where = r->line;
    return fail_at(r->name, err);
}

/* A line without its end into text, terminated: its bytes, which may be zeros, or -1 at
 * the end of the file.  Of one that is too long TP_TAPE_LINE, and all of it is read. */
static int next_line(reader *r, char text[TP_TAPE_LINE])
{
    int c = getc(r->file), n = 0;
    if (c == EOF)
        return -1;
    for (; c != EOF && c != '\n'; c = getc(r->file))
        if (n < TP_TAPE_LINE)
            text[n++] = (char)c;
    if (n > 0 && n < TP_TAPE_LINE && text[n - 1] == '\r')
        n--;
    text[n < TP_TAPE_LINE ? n : TP_TAPE_LINE - 1] = '\0';
    r->line++;
    return n;
}

static int fail_long(const reader *r)
{
    tp_error err = { .code = TP_E_LONG, .a = TP_TAPE_LINE - 1 };
    return fail_line(r, &err);
}

static int read_head(reader *r)
{
    char text[TP_TAPE_LINE], scene[TP_NAME_BYTES];
    tp_error err = { 0 };
    const int bytes = next_line(r, text);
    if (bytes < 0 && ferror(r->file))
        return fail(EXIT_INPUT, "%s: %s", r->name, strerror(errno));
    if (bytes < 0)
        return fail(EXIT_INPUT, "%s: empty; expected \"tape 1 SCENE\"", r->name);
    if (bytes == TP_TAPE_LINE)
        return fail_long(r);
    if (tp_tape_head_read(scene, sizeof scene, text, (size_t)bytes, &err))
        return fail_line(r, &err);
    if (strcmp(scene, r->scene) != 0)
        return fail(EXIT_INPUT, "%s:1: a tape of %s, not of %s", r->name, scene,
                    r->scene);
    return EXIT_DONE;
}

static int add(deck *d, const reader *r, const tp_tape_entry *entry)
{
    if (d->count > 0 && entry->tick <= d->entries[d->count - 1].tick)
        return fail(EXIT_INPUT, "%s:%u: ticks must rise", r->name, (unsigned)r->line);
    if ((d->count & (d->count - 1)) == 0) {         /* full at powers of two */
        const size_t room = d->count ? 2 * d->count : 1;
        tp_tape_entry *more = realloc(d->entries, room * sizeof *more);
        if (!more)
            return fail_memory(room * sizeof *more);
        d->entries = more;
    }
    d->entries[d->count++] = *entry;
    return EXIT_DONE;
}

static int read_lines(deck *d, reader *r)
{
    char text[TP_TAPE_LINE];
    int code = read_head(r), bytes;
    while (!code && (bytes = next_line(r, text)) >= 0) {
        tp_tape_entry entry;
        tp_error err = { 0 };
        if (bytes == 0 || text[0] == '#')
            continue;
        if (bytes == TP_TAPE_LINE)
            code = fail_long(r);
        else if (tp_tape_read(&entry, text, (size_t)bytes, &err))
            code = fail_line(r, &err);
        else
            code = add(d, r, &entry);
    }
    return code;
}

int deck_read(deck *d, const char *name, const char *scene)
{
    reader r = { name, scene, fopen(name, "r"), 0 };
    *d = (deck){ 0 };
    if (!r.file)
        return fail(EXIT_INPUT, "%s: %s", name, strerror(errno));
    int code = read_lines(d, &r);
    if (!code && ferror(r.file))
        code = fail(EXIT_INPUT, "%s: cannot be read", name);
    fclose(r.file);
    return code;
}

const tp_input *deck_input(deck *d, uint64_t tick)
{
    while (d->at < d->count && d->entries[d->at].tick < tick)
        d->at++;
    return d->at < d->count && d->entries[d->at].tick == tick ? &d->entries[d->at].input
                                                              : NULL;
}

/* -- recording ------------------------------------------------------------------- */

int deck_record(deck *d, const char *name, const char *scene)
{
    char text[TP_TAPE_LINE];
    *d = (deck){ .file = fopen(name, "w"), .name = name };
    if (!d->file)
        return fail(EXIT_INPUT, "%s: %s", name, strerror(errno));
    setvbuf(d->file, NULL, _IOLBF, 0);
    tp_tape_head_write(scene, text, sizeof text);
    fprintf(d->file, "%s\n", text);
    return EXIT_DONE;
}

void deck_add(deck *d, uint64_t tick, const tp_input *input)
{
    char text[TP_TAPE_LINE];
    const tp_tape_entry entry = { tick, *input };
    if (d->file && tp_tape_write(&entry, text, sizeof text) > 0)
        fprintf(d->file, "%s\n", text);
}

int deck_close(deck *d)
{
    int code = EXIT_DONE;
    if (d->file && (ferror(d->file) | fclose(d->file)))
        code = fail(EXIT_INPUT, "%s: cannot be written", d->name);
    free(d->entries);
    *d = (deck){ 0 };
    return code;
}
