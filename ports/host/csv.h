/* SPDX-License-Identifier: MIT */
/* Tables as text: lines that begin with '#', a line of column names, then rows, their
 * fields separated by commas.  No quotes, no blanks, at least one row. */
#ifndef HOST_CSV_H
#define HOST_CSV_H
#include <stdbool.h>

typedef struct {
    const char *name;           /* as messages call it; the caller's */
    unsigned    n_notes, n_columns, n_rows;
    char       *text;           /* the file; what follows points into it */
    const char **notes;         /* without "# " */
    const char **fields;        /* the columns' names, then the rows' fields */
} csv;

/* EXIT_INPUT: said why, and nothing is held.  Otherwise free it with csv_free. */
int  csv_read(csv *table, const char *name);
void csv_free(csv *table);

/* Numbers of lines in the file, from 1. */
unsigned csv_note_line(unsigned note);
unsigned csv_columns_line(const csv *table);
unsigned csv_row_line(const csv *table, unsigned row);

const char *csv_field(const csv *table, unsigned row, unsigned column);

/* Reads a decimal number that begins at `text`: digits, point, sign and exponent alone.
 * NULL: none is there, or it is beyond what a double holds; else where it ends. */
const char *csv_number(const char *text, double *value);
#endif
