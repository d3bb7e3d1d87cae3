/* SPDX-License-Identifier: MIT */
/* An output file that is whole or not there: written under a temporary name in the same
 * folder and renamed when all of it is on its way to the disk.  Devices, pipes and "-"
 * (standard output) are written as they are. */
#ifndef HOST_OUTPUT_H
#define HOST_OUTPUT_H
#include <stdio.h>

#define OUTPUTS 4               /* at a time: a picture may be saved while a film is */

typedef struct {
    FILE       *file;       /* NULL: not open */
    const char *name;       /* as messages call it; the caller's */
    char       *target;     /* where the temporary file goes in the end; NULL: nowhere */
    int         slot;       /* private part: of the temporary name */
} output;

int  output_open(output *out, const char *name);
int  output_close(output *out);         /* EXIT_INPUT: not all could be written */
void output_discard(output *out);
int  output_failed(output *out, int error);     /* says so, discards; EXIT_INPUT */
#endif
