/* SPDX-License-Identifier: MIT */
/* Tapes as files: read completely for replay, or written line by line while recording.
 *
 * Beside the input of each step, a tape of the preview has the other changes of its
 * pictures:
 *
 *     tape 1 three-swells
 *     120 ahead=0.05 turn=-1200          input of the step after tick 120
 *     121 look turn=900                  the camera moved while the water stood still
 *     121 set wave0.amplitude=0.8        a parameter changed (value up to the line end)
 *
 * The first number is the tick: the number of tp_world_step calls since the tape's
 * beginning, equal to world->tick if the world began with the tape.  Ticks ascend.  A tick
 * has any number of looks and sets, in order, and then at most one input. */
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
    uint32_t  line;             /* line number in the file */
    tp_input  input;            /* input; of a look: only the camera's members are set */
    char     *setting;          /* "name=value", a valid setting; NULL: not a set */
} deck_entry;

typedef struct { uint32_t picture; long at; } deck_mark;

typedef struct {
    const char *name;
    deck_entry *entries;        /* in order of ticks */
    size_t count, at;           /* count; index of the next entry */
    FILE  *file;                /* file of a recording.  Written line by line: after a crash
                                 * the tape holds the inputs before the crash */
    uint32_t   picture;         /* number of the picture shown while recording */
    deck_mark *marks;           /* of each line: picture, offset in the file */
    size_t     lines;
    bool       failed;
} deck;

/* Both return an exit code, and print the reason of a failure with file and line.  scene:
 * name of the scene, which a tape for replay must have.  name must outlive the deck. */
int  deck_read(deck *d, const char *name, const char *scene);
int  deck_record(deck *d, const char *name, const char *scene);

/* Returns the next entry of `tick`, in order, or NULL: no further entry. */
const deck_entry *deck_next(deck *d, uint64_t tick);
bool deck_has_ended(const deck *d, uint64_t tick);   /* true if no entry is left */

/* Each records an entry; inputs and looks only if a member is not 0. */
void deck_add(deck *d, uint64_t tick, const tp_input *input);
void deck_look(deck *d, uint64_t tick, const tp_input *input);
void deck_set(deck *d, uint64_t tick, const char *setting);

/* For recordings.  deck_cut removes the lines recorded after picture `picture`.  deck_drop
 * removes the lines from..end - 1; line 0 follows the head. */
void deck_cut(deck *d, uint32_t picture);
void deck_drop(deck *d, size_t from, size_t end);

int  deck_close(deck *d);       /* EXIT_INPUT: a recording is incomplete on disk */
#endif
