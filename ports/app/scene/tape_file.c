/* SPDX-License-Identifier: MIT */
/* Tapes as text files.  A tape is read completely before it is replayed. */
#define _POSIX_C_SOURCE 200809L
#include "tape_file.h"
#include <errno.h>
#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "app/files/log.h"
#include "app/files/path.h"
#include "base/base.h"
#include "long_name.h"
#include "old_name_note.h"
#include "scene_file.h"
#include "world/text.h"

#define WHITE " \t\r\v\f"

enum { LINE = PATH_MAX + TP_TAPE_LINE };        /* bytes; a set may name a file */

/* -- reading ------------------------------------------------------------------------- */

typedef struct {
    const char *name, *scene;
    FILE       *file;
    uint32_t    line;
    old_name_note old;          /* old names of rows that were read */
} tape_file_reader;

static int fail_line(const tape_file_reader *r, tp_error *err)
{
    err->where = r->line;
    return log_fail_error(r->name, err);
}

/* Reads a line into text, without the line end, terminated.  Returns its number of bytes
 * (zero bytes included), -1 at the end of the file, or LINE for a line that is too long;
 * such a line is skipped to its end. */
static int next_line(tape_file_reader *r, char text[LINE])
{
    int c = getc(r->file), n = 0;
    if (c == EOF)
        return -1;
    for (; c != EOF && c != '\n'; c = getc(r->file))
        if (n < LINE)
            text[n++] = (char)c;
    if (n > 0 && n < LINE && text[n - 1] == '\r')
        n--;
    text[n < LINE ? n : LINE - 1] = '\0';
    r->line++;
    return n;
}

static int fail_long(const tape_file_reader *r)
{
    tp_error err = { .code = TP_E_LONG, .a = TP_TAPE_LINE - 1 };
    return fail_line(r, &err);
}

static int read_head(tape_file_reader *r)
{
    char text[LINE], scene[TP_NAME_BYTES];
    tp_error err = { 0 };
    const int bytes = next_line(r, text);
    if (bytes < 0 && ferror(r->file))
        return log_fail(EXIT_INPUT, "%s: %s", r->name, strerror(errno));
    if (bytes < 0)
        return log_fail(EXIT_INPUT, "%s: empty; expected \"tape 2 SCENE\"", r->name);
    if (bytes >= TP_TAPE_LINE)
        return fail_long(r);
    if (tp_tape_head_read(scene, sizeof scene, text, (size_t)bytes, &err))
        return fail_line(r, &err);
    if (strcmp(scene, r->scene) != 0)
        return log_fail(EXIT_INPUT, "%s:1: a tape of %s, not of %s", r->name, scene,
                        r->scene);
    return EXIT_DONE;
}

static int add(tape_file *d, const tape_file_reader *r, const tape_file_entry *entry)
{
    const tape_file_entry *last = d->count > 0 ? &d->entries[d->count - 1] : NULL;
    if (last && entry->tick == last->tick && last->kind == TAPE_FILE_STEP
        && entry->kind != TAPE_FILE_STEP)
        return log_fail(EXIT_INPUT,
                        "%s:%u: expected look and set lines before the input"
                        " of their tick",
                        r->name, (unsigned)r->line);
    if (last
        && (entry->tick < last->tick
            || (entry->tick == last->tick && last->kind == TAPE_FILE_STEP)))
        return log_fail(EXIT_INPUT, "%s:%u: ticks must increase", r->name,
                        (unsigned)r->line);
    if ((d->count & (d->count - 1)) == 0) {         /* the array is full at powers of two */
        const size_t room = d->count ? 2 * d->count : 1;
        tape_file_entry *more = realloc(d->entries, room * sizeof *more);
        if (!more)
            return log_fail_memory(room * sizeof *more);
        d->entries = more;
    }
    d->entries[d->count++] = *entry;
    return EXIT_DONE;
}

/* -- lines --------------------------------------------------------------------------- */

/* Returns the second word of a line if it equals `word`; else NULL. */
static char *second_word(char *text, const char *word)
{
    char *c = text + strspn(text, WHITE);
    c += strspn(c, "0123456789");
    const size_t gap = strspn(c, WHITE), bytes = strlen(word);
    c += gap;
    return gap > 0 && strncmp(c, word, bytes) == 0 && (!c[bytes] || strchr(WHITE, c[bytes]))
         ? c : NULL;
}

/* Reads a look: replaces the word by blanks and reads the rest like an input. */
static int read_look(const tape_file_reader *r, char *text, size_t bytes, char *word,
                     tape_file_entry *entry)
{
    tp_tape_entry read;
    tp_error err = { 0 };
    memset(word, ' ', 4);
    if (tp_tape_read(&read, text, bytes, &err))
        return fail_line(r, &err);
    tp_input rest = read.input;
    rest.forward = rest.strafe = rest.up = 0;
    rest.turn = rest.tilt = 0;
    if (memcmp(&rest, &(tp_input){ 0 }, sizeof rest) != 0)
        return log_fail(EXIT_INPUT,
                        "%s:%u: a look only moves the camera: expected ahead,"
                        " aside, up, turn or tilt",
                        r->name, (unsigned)r->line);
    *entry = (tape_file_entry){ .tick = read.tick,
                                .kind = TAPE_FILE_LOOK,
                                .input = read.input };
    return EXIT_DONE;
}

/* Returns a copy of "name=value" with the row's present name; NULL: no memory. */
static char *copy_setting(tape_file_reader *r, const char *setting)
{
    const size_t bytes = strcspn(setting, "=");
    const old_name *old = old_name_note_add(&r->old, setting, bytes, r->line);
    if (!old)
        return path_copy(setting, strlen(setting));
    const size_t room = strlen(old->now) + strlen(setting + bytes) + 1;
    char *copy = malloc(room);
    if (copy)
        snprintf(copy, room, "%s%s", old->now, setting + bytes);
    return copy;
}

static int read_set(tape_file_reader *r, char *text, size_t bytes, char *word,
                    tape_file_entry *entry)
{
    char place[PATH_MAX + 16];
    const char *value;
    tp_tape_entry read;
    tp_error err = { 0 };
    if (memchr(text, 0, bytes)) {
        err.code = TP_E_TEXT;
        tp_error_set_word(&err, text, strlen(text));
        return fail_line(r, &err);
    }
    if (tp_tape_read(&read, text, (size_t)(word - text), &err))
        return fail_line(r, &err);
    word += 3 + strspn(word + 3, WHITE);
    for (size_t n = strlen(word); n > 0 && strchr(WHITE, word[n - 1]); n--)
        word[n - 1] = 0;
    snprintf(place, sizeof place, "%s:%u", r->name, (unsigned)r->line);
    if (!scene_file_check(place, word, &value))
        return EXIT_INPUT;
    *entry = (tape_file_entry){ .tick = read.tick, .kind = TAPE_FILE_SET };
    entry->setting = copy_setting(r, word);
    return entry->setting ? EXIT_DONE : log_fail_memory(bytes);
}

static int read_line(tape_file_reader *r, char *text, size_t bytes,
                     tape_file_entry *entry)
{
    tp_tape_entry read;
    tp_error err = { 0 };
    char *look = second_word(text, "look"), *set = second_word(text, "set");
    if (bytes >= (set ? LINE : TP_TAPE_LINE))
        return fail_long(r);
    if (look)
        return read_look(r, text, bytes, look, entry);
    if (set)
        return read_set(r, text, bytes, set, entry);
    if (tp_tape_read(&read, text, bytes, &err))
        return fail_line(r, &err);
    *entry = (tape_file_entry){ .tick = read.tick, .input = read.input };
    return EXIT_DONE;
}

static int read_lines(tape_file *d, tape_file_reader *r)
{
    char text[LINE];
    int code = read_head(r), bytes;
    while (!code && (bytes = next_line(r, text)) >= 0) {
        tape_file_entry entry = { 0 };
        if (bytes == 0 || text[0] == '#')
            continue;
        code = read_line(r, text, (size_t)bytes, &entry);
        entry.line = r->line;
        if (!code)
            code = add(d, r, &entry);
        if (code)
            free(entry.setting);
    }
    return code;
}

int tape_file_read(tape_file *d, const char *name, const char *scene)
{
    tape_file_reader r = { .name = name, .scene = scene, .file = fopen(name, "r") };
    *d = (tape_file){ .name = name };
    if (!r.file)
        return log_fail(EXIT_INPUT, "%s: %s", name, strerror(errno));
    int code = read_lines(d, &r);
    if (!code && ferror(r.file))
        code = log_fail(EXIT_INPUT, "%s: cannot be read", name);
    fclose(r.file);
    if (!code)
        old_name_note_print(&r.old, name, NULL);
    return code;
}

/* -- replaying ----------------------------------------------------------------------- */

const tape_file_entry *tape_file_next(tape_file *d, uint64_t tick)
{
    while (d->at < d->count && d->entries[d->at].tick < tick)
        d->at++;
    return d->at < d->count && d->entries[d->at].tick == tick ? &d->entries[d->at++]
                                                              : NULL;
}

bool tape_file_has_ended(const tape_file *d, uint64_t tick)
{
    return d->count == 0 || d->entries[d->count - 1].tick < tick;
}

/* -- recording ----------------------------------------------------------------------- */

int tape_file_record(tape_file *d, const char *name, const char *scene)
{
    char text[TP_TAPE_LINE];
    *d = (tape_file){ .file = fopen(name, "w+"), .name = name };
    if (!d->file)
        return log_fail(EXIT_INPUT, "%s: %s", name, strerror(errno));
    setvbuf(d->file, NULL, _IOLBF, 0);
    tp_tape_head_write(scene, text, sizeof text);
    fprintf(d->file, "%s\n", text);
    return EXIT_DONE;
}

/* Notes the picture and the file position of the next line to be written. */
static void mark(tape_file *d)
{
    if ((d->lines & (d->lines - 1)) == 0) {
        const size_t room = d->lines ? 2 * d->lines : 1;
        tape_file_mark *more = realloc(d->marks, room * sizeof *more);
        d->failed = d->failed || !more;
        if (!more)
            return;
        d->marks = more;
    }
    d->marks[d->lines++] = (tape_file_mark){ d->picture, ftell(d->file) };
}

static void put(tape_file *d, uint64_t tick, const tp_input *input, const char *word)
{
    char text[TP_TAPE_LINE];
    const tp_tape_entry entry = { tick, *input };
    if (!d->file || d->failed || tp_tape_write(&entry, text, sizeof text) == 0)
        return;
    const int digits = (int)strcspn(text, " ");
    mark(d);
    fprintf(d->file, "%.*s%s%s\n", digits, text, word, text + digits);
}

void tape_file_add_input(tape_file *d, uint64_t tick, const tp_input *input)
{
    put(d, tick, input, "");
}

void tape_file_add_look(tape_file *d, uint64_t tick, const tp_input *input)
{
    const tp_input camera = { .forward = input->forward,
                              .strafe = input->strafe,
                              .up = input->up,
                              .turn = input->turn,
                              .tilt = input->tilt };
    put(d, tick, &camera, " look");
}

void tape_file_add_setting(tape_file *d, uint64_t tick, const char *setting)
{
    if (!d->file || d->failed)
        return;
    mark(d);
    const char *value = strchr(setting, '=') + 1;
    fprintf(d->file, "%" PRIu64 " set %.*s%s\n", tick, (int)(value - setting), setting,
            long_name_whole(value));
}

static bool truncate_file(tape_file *d, long at)
{
    return !fflush(d->file) && !ftruncate(fileno(d->file), at)
        && !fseek(d->file, at, SEEK_SET);
}

void tape_file_cut(tape_file *d, uint32_t picture)
{
    size_t keep = d->lines;
    while (keep > 0 && d->marks[keep - 1].picture > picture)
        keep--;
    tape_file_drop(d, keep, d->lines);
}

/* Removes lines from the middle: reads the rest of the file and writes the rest at the
 * position of the first dropped line. */
static bool close_gap(tape_file *d, size_t from, size_t end)
{
    const long gap = d->marks[end].at - d->marks[from].at;
    const size_t bytes = (size_t)(ftell(d->file) - d->marks[end].at);
    char *rest = malloc(bytes);
    const bool done = rest && !fseek(d->file, d->marks[end].at, SEEK_SET)
                      && fread(rest, 1, bytes, d->file) == bytes
                      && truncate_file(d, d->marks[from].at)
                      && fwrite(rest, 1, bytes, d->file) == bytes && !fflush(d->file);
    free(rest);
    for (size_t i = end; i < d->lines; i++)
        d->marks[from + i - end] = (tape_file_mark){ d->marks[i].picture,
                                                 d->marks[i].at - gap };
    return done;
}

void tape_file_drop(tape_file *d, size_t from, size_t end)
{
    if (!d->file || d->failed || from >= end || end > d->lines)
        return;
    d->failed = end == d->lines ? !truncate_file(d, d->marks[from].at)
                                : !close_gap(d, from, end);
    d->lines -= end - from;
}

int tape_file_close(tape_file *d)
{
    int code = EXIT_DONE;
    if (d->file && ((d->failed | ferror(d->file)) | fclose(d->file)))
        code = log_fail(EXIT_INPUT, "%s: cannot be written", d->name);
    for (size_t i = 0; i < d->count; i++)
        free(d->entries[i].setting);
    free(d->entries);
    free(d->marks);
    *d = (tape_file){ 0 };
    return code;
}
