/* SPDX-License-Identifier: MIT */
/* An output file that is whole or not there: it replaces the one of its name when all of
 * it is on its way to the disk (atomic_file.h).  Devices, pipes and "-" (standard output)
 * are written as they are.
 *
 * The first write that fails is the one that messages tell of: those who fill the stream
 * need not look. */
#ifndef HOST_OUTPUT_H
#define HOST_OUTPUT_H
#include <stdio.h>
#include "atomic_file.h"

typedef struct output_end output_end;

typedef struct {
    FILE       *file;       /* NULL: not open */
    const char *name;       /* as messages call it; the caller's */
    char       *target;     /* that a temporary file replaces; NULL: written as it is */
    atomic_file temporary;
    output_end *end;        /* private part: of the stream */
} output;

/* Each returns an exit code and has said why; after a failure nothing is left open. */
int  output_open(output *out, const char *name);
int  output_take(output *out, int fd, const char *name);    /* closes fd in any case */
int  output_close(output *out);         /* EXIT_INPUT: not all could be written */
void output_discard(output *out);

/* Discards it and says what failed first: a write, or else `error`; EXIT_INPUT. */
int  output_failed(output *out, int error);
#endif
