/* SPDX-License-Identifier: MIT */
/* An output file that is either complete or absent: a temporary file replaces the file of
 * that name after all bytes are written (atomic_file.h).  Devices, pipes and "-" (standard
 * output) are written directly.
 *
 * Messages report the first failed write: code that fills the stream need not check
 * writes. */
#ifndef TP_APP_FILES_OUTPUT_FILE_H
#define TP_APP_FILES_OUTPUT_FILE_H
#include <stdio.h>
#include "atomic_file.h"

typedef struct output_stream output_stream;

typedef struct {
    FILE       *file;       /* NULL: not open */
    const char *name;       /* name in messages; owned by the caller */
    char       *target;     /* file to be replaced; NULL: written directly */
    atomic_file temporary;
    output_stream *end;     /* private: state of the stream */
} output_file;

/* Each function returns an exit code, and prints the reason of a failure; after a failure
 * nothing is left open. */
int output_file_open(output_file *out, const char *name);
int output_file_adopt(output_file *out, int fd,
                      const char *name); /* closes fd in every case */
int output_file_close(output_file *out); /* EXIT_INPUT: some data could not be written */
void output_file_discard(output_file *out);

/* Discards the output and prints the first failure: a write, or else `error`.  Returns
 * EXIT_INPUT. */
int  output_file_fail(output_file *out, int error);
#endif
