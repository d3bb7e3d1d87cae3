/* SPDX-License-Identifier: MIT */
/* Tapes as files: a whole one to replay, or one that grows while it is recorded. */
#ifndef HOST_DECK_H
#define HOST_DECK_H
#include <stddef.h>
#include <stdio.h>
#include "tidepool/tape.h"

typedef struct {
    tp_tape_entry *entries;     /* by rising tick */
    size_t count, at;           /* at: the next to be given */
    FILE  *file;                /* of a recording, written line by line: what led to a
                                 * crash is on the tape */
    const char *name;
} deck;

/* Both return an exit code and have said why, with file and line; `scene` is the name
 * that the tape must have, or gets. */
int  deck_read(deck *d, const char *name, const char *scene);
int  deck_record(deck *d, const char *name, const char *scene);

/* The input before the step that follows `tick`, or NULL. */
const tp_input *deck_input(deck *d, uint64_t tick);

/* Keeps it, if anything is set. */
void deck_add(deck *d, uint64_t tick, const tp_input *input);

int  deck_close(deck *d);       /* EXIT_INPUT: not all of a recording could be written */
#endif
