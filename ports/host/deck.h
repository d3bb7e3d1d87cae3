/* SPDX-License-Identifier: MIT */
/* Tapes as files: a whole one to replay, or one that grows while it is recorded.
 *
 * Beside inputs before a step a tape tells, of the preview, what else moved a picture:
 *
 *     tape 1 three-swells
 *     120 ahead=0.05 turn=-1200          the input of the step after tick 120
 *     121 look turn=900                  the camera alone moved, while the water stood
 *     121 set wave0.amplitude=0.8        a parameter was changed (to the end of the line)
 *
 * `tick` counts tp_world_step calls since the tape's beginning: world->tick, where the
 * world began with it.  Ticks rise; of one tick any number of looks and sets in their
 * order, then at most one input. */
#ifndef HOST_DECK_H
#define HOST_DECK_H
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include "tidepool/world.h"

typedef enum { DECK_STEP, DECK_LOOK, DECK_SET } deck_kind;

typedef struct {
    uint64_t  tick;
    deck_kind kind;
    uint32_t  line;             /* of the file */
    tp_input  input;            /* of a look what moves the camera alone */
    char     *setting;          /* "name=value" that the table takes; NULL: no set */
} deck_entry;

typedef struct { uint32_t picture; long at; } deck_mark;

typedef struct {
    const char *name;
    deck_entry *entries;        /* by rising tick */
    size_t count, at;           /* at: the next to be given */
    FILE  *file;                /* of a recording, written line by line: what led to a
                                 * crash is on the tape */
    uint32_t   picture;         /* of the recording preview, that is shown now */
    deck_mark *marks;           /* of its lines: when and where they begin */
    size_t     lines;
    bool       failed;
} deck;

/* Both return an exit code and have said why, with file and line; `scene` is the name
 * that the tape must have, or gets.  `name` must outlive the deck. */
int  deck_read(deck *d, const char *name, const char *scene);
int  deck_record(deck *d, const char *name, const char *scene);

/* The next entry of `tick`, in order, or NULL: no more of it. */
const deck_entry *deck_next(deck *d, uint64_t tick);
bool deck_over(const deck *d, uint64_t tick);   /* nothing comes at this tick or later */

/* Each keeps it; inputs and looks if anything is set. */
void deck_add(deck *d, uint64_t tick, const tp_input *input);
void deck_look(deck *d, uint64_t tick, const tp_input *input);
void deck_set(deck *d, uint64_t tick, const char *setting);

/* Recording: what was kept since pictures after this one were shown is taken off again;
 * or the lines from number `from` to the one before `end`, where 0 follows the head. */
void deck_cut(deck *d, uint32_t picture);
void deck_drop(deck *d, size_t from, size_t end);

int  deck_close(deck *d);       /* EXIT_INPUT: not all of a recording could be written */
#endif
