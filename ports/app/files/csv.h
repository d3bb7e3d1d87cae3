/* SPDX-License-Identifier: MIT */
/* Tables as text: lines that begin with '#', a line of column names, then rows; commas
 * separate fields.  No quotes, no blanks, at least one row. */
#ifndef TP_APP_FILES_CSV_H
#define TP_APP_FILES_CSV_H
#include <stdbool.h>

typedef struct {
    const char *name;           /* name in messages; owned by the caller */
    unsigned    n_notes, n_columns, n_rows;
    char       *text;           /* the file; the members below point into text */
    const char **notes;         /* texts of the lines with '#', without "# " */
    const char **fields;        /* names of the columns, then the fields of the rows */
} csv;

/* Reads a table; csv_free frees it.  Returns EXIT_INPUT after printing the reason, with
 * nothing to free. */
int  csv_read(csv *table, const char *name);
void csv_free(csv *table);

/* Return line numbers in the file, from 1. */
unsigned csv_note_line(unsigned note);
unsigned csv_columns_line(const csv *table);
unsigned csv_row_line(const csv *table, unsigned row);

const char *csv_field(const csv *table, unsigned row, unsigned column);

/* Reads a decimal number at `text`: digits, point, sign and exponent.  Returns the end of
 * the number, or NULL if there is no number or a double cannot hold it. */
const char *csv_number(const char *text, double *value);
#endif
