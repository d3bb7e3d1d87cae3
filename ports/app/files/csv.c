/* SPDX-License-Identifier: MIT */
/* Reads tables.  The whole file is read into memory and split in place: a field is a
 * pointer, and lines may have any length. */
#include "csv.h"
#include <errno.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "log.h"

#define BYTES_MOST (64u << 20)
#define CHUNK      65536u

unsigned csv_note_line(unsigned note)
{
    return note + 1;
}

unsigned csv_columns_line(const csv *table)
{
    return table->n_notes + 1;
}

unsigned csv_row_line(const csv *table, unsigned row)
{
    return table->n_notes + 2 + row;
}

const char *csv_field(const csv *table, unsigned row, unsigned column)
{
    return table->fields[(size_t)(row + 1) * table->n_columns + column];
}

/* Checks the characters first: strtod also accepts blanks, "inf", "nan" and hexadecimal. */
const char *csv_number(const char *text, double *value)
{
    char *end;
    const size_t length = strspn(text, "+-.0123456789eE");
    if (length == 0)
        return NULL;
    errno = 0;
    *value = strtod(text, &end);
    if (end == text || end > text + length || !isfinite(*value))
        return NULL;
    return end;
}

/* -- reading the file ---------------------------------------------------------------- */

static int take_bytes(csv *table, FILE *file, size_t *bytes)
{
    for (size_t room = 0;;) {
        if (*bytes + CHUNK + 1 > room) {
            room = 2 * room + CHUNK + 1;
            char *more = realloc(table->text, room);
            if (!more)
                return log_fail_memory(room);
            table->text = more;
        }
        const size_t got = fread(table->text + *bytes, 1, CHUNK, file);
        *bytes += got;
        if (*bytes > BYTES_MOST)
            return log_fail(EXIT_INPUT, "%s: more than %u MB", table->name,
                            BYTES_MOST >> 20);
        if (got < CHUNK)
            break;
    }
    if (ferror(file))
        return log_fail(EXIT_INPUT, "%s: %s", table->name, strerror(errno));
    table->text[*bytes] = 0;
    if (memchr(table->text, 0, *bytes))
        return log_fail(EXIT_INPUT, "%s: contains a zero byte; not a table", table->name);
    return EXIT_DONE;
}

static int take_file(csv *table, size_t *bytes)
{
    FILE *file = fopen(table->name, "rb");
    if (!file)
        return log_fail(EXIT_INPUT, "%s: %s", table->name, strerror(errno));
    const int code = take_bytes(table, file, bytes);
    fclose(file);
    return code;
}

/* -- splitting into lines ------------------------------------------------------------ */

static unsigned count_characters(const char *text, char what)
{
    unsigned count = 0;
    for (; (text = strchr(text, what)) != NULL; text++)
        count++;
    return count;
}

/* Terminates the line at `text` and returns the next line. */
static char *cut_line(char *text)
{
    char *end = text + strcspn(text, "\n");
    char *next = *end ? end + 1 : end;
    *end = 0;
    if (end > text && end[-1] == '\r')
        end[-1] = 0;
    return next;
}

static char *take_notes(csv *table, char *text)
{
    while (*text == '#') {
        char *note = text + 1 + strspn(text + 1, " ");
        text = cut_line(text);
        table->notes[table->n_notes++] = note;
    }
    return text;
}

/* Splits a line at its commas.  number: line number in the file, of a row or of the column
 * names. */
static int take_fields(csv *table, char *line, const char **field, unsigned number)
{
    const unsigned count = count_characters(line, ',') + 1;
    if (count != table->n_columns)
        return log_fail(EXIT_INPUT, "%s:%u: %u fields; there are %u columns", table->name,
                        number, *line ? count : 0, table->n_columns);
    for (unsigned i = 0; i < count; i++) {
        field[i] = line;
        line += strcspn(line, ",");
        *line++ = 0;
    }
    return EXIT_DONE;
}

static int take_rows(csv *table, char *text)
{
    for (int heading = 1; *text; heading = 0) {
        char *line = text;
        const unsigned number = csv_row_line(table, table->n_rows) - (unsigned)heading;
        text = cut_line(text);
        const size_t at = heading ? 0 : (size_t)(table->n_rows + 1) * table->n_columns;
        const int code = take_fields(table, line, table->fields + at, number);
        if (code)
            return code;
        table->n_rows += !heading;
    }
    if (table->n_rows == 0)
        return log_fail(EXIT_INPUT, "%s:%u: no rows", table->name, csv_columns_line(table));
    return EXIT_DONE;
}

static int take_table(csv *table)
{
    size_t bytes = 0;
    const int code = take_file(table, &bytes);
    if (code)
        return code;
    const size_t lines = count_characters(table->text, '\n') + 1;
    table->notes = calloc(lines, sizeof *table->notes);
    if (!table->notes)
        return log_fail_memory(lines * sizeof *table->notes);
    char *text = take_notes(table, table->text);
    const size_t length = strcspn(text, "\n");
    if (length == 0)
        return log_fail(EXIT_INPUT, "%s:%u: no column names", table->name,
                        csv_columns_line(table));
    for (size_t i = 0; i < length; i++)
        table->n_columns += text[i] == ',';
    table->n_columns++;
    const size_t fields = (lines - table->n_notes) * table->n_columns;
    table->fields = calloc(fields, sizeof *table->fields);
    if (!table->fields)
        return log_fail_memory(fields * sizeof *table->fields);
    return take_rows(table, text);
}

int csv_read(csv *table, const char *name)
{
    *table = (csv){ .name = name };
    const int code = take_table(table);
    if (code)
        csv_free(table);
    return code;
}

void csv_free(csv *table)
{
    free(table->text);
    free(table->notes);
    free(table->fields);
    *table = (csv){ 0 };
}
