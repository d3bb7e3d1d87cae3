/* SPDX-License-Identifier: MIT */
/* Tapes as files: read completely for replay, or written line by line while recording.
 *
 * Beside the input of each step, a tape of the preview has the other changes of its
 * pictures:
 *
 *     tape 2 three-swells
 *     120 ahead=0.05 turn=-1200          input of the step after tick 120
 *     121 look turn=900                  the camera moved while the water stood still
 *     121 set wave0.amplitude=0.8        a parameter changed (value up to the line end)
 *
 * The first number is the tick: the number of tp_world_step calls since the tape's
 * beginning, equal to world->tick if the world began with the tape.  Ticks ascend.  A tick
 * has any number of looks and sets, in order, and then at most one input. */
#ifndef TP_APP_SCENE_TAPE_FILE_H
#define TP_APP_SCENE_TAPE_FILE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include "tidepool/world.h"

typedef enum { TAPE_FILE_STEP, TAPE_FILE_LOOK, TAPE_FILE_SET } tape_file_kind;

typedef struct {
    uint64_t  tick;
    tape_file_kind kind;
    uint32_t  line;             /* line number in the file */
    tp_input  input;            /* input; of a look: only the camera's members are set */
    char     *setting;          /* "name=value", a valid setting; NULL: not a set */
} tape_file_entry;

typedef struct { uint32_t picture; long at; } tape_file_mark;

typedef struct {
    const char *name;
    tape_file_entry *entries;   /* in order of ticks */
    size_t count, at;           /* count; index of the next entry */
    FILE  *file;                /* file of a recording.  Written line by line: after a crash
                                 * the tape holds the inputs before the crash */
    uint32_t   picture;         /* number of the picture shown while recording */
    tape_file_mark *marks;      /* of each line: picture, offset in the file */
    size_t     lines;
    bool       failed;
} tape_file;

/* Both return an exit code, and print the reason of a failure with file and line.  scene:
 * name of the scene, which a tape for replay must have.  name must outlive the tape
 * file. */
int  tape_file_read(tape_file *d, const char *name, const char *scene);
int  tape_file_record(tape_file *d, const char *name, const char *scene);

/* Returns the next entry of `tick`, in order, or NULL: no further entry. */
const tape_file_entry *tape_file_next(tape_file *d, uint64_t tick);
bool tape_file_has_ended(const tape_file *d,
                         uint64_t tick); /* true if no entry is left */

/* Each records an entry; inputs and looks only if a member is not 0. */
void tape_file_add_input(tape_file *d, uint64_t tick, const tp_input *input);
void tape_file_add_look(tape_file *d, uint64_t tick, const tp_input *input);
void tape_file_add_setting(tape_file *d, uint64_t tick, const char *setting);

/* For recordings.  tape_file_cut removes the lines recorded after picture `picture`.
 * tape_file_drop removes the lines from..end - 1; line 0 follows the head. */
void tape_file_cut(tape_file *d, uint32_t picture);
void tape_file_drop(tape_file *d, size_t from, size_t end);

int tape_file_close(tape_file *d); /* EXIT_INPUT: a recording is incomplete on disk */
#endif
