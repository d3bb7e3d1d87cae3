/* SPDX-License-Identifier: MIT */
/* Changes of parameters for undo and redo.  Each keeps the world before and after the
 * change, if the world stood still. */
#ifndef HOST_EDITS_H
#define HOST_EDITS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "stage.h"

#define EDITS 256               /* edits remembered; older edits are forgotten */
#define EDITS_BYTES (64u << 20) /* of all worlds; the oldest lose theirs first */

/* A copy of a world, shared by the edit before it and the edit after it. */
typedef struct {
    uint32_t users;
    size_t   bytes;
    uint64_t world[];
} edit_world;

typedef struct {
    stage_value value;
    edit_world *world;          /* NULL: the world moved, or no memory */
} edit_side;

typedef struct {
    uint32_t  row;              /* index in the table of parameters */
    edit_side before, after;
    size_t    line, line_end;   /* lines of the tape that record the edit: first, end */
} edit;

/* Initially all 0. */
typedef struct {
    edit     of[EDITS];         /* ring: of[(first + i) % EDITS] is edit i of count */
    uint32_t first, count, undone;
    bool     open;              /* the last edit continues: a drag */
    size_t   bytes;             /* bytes of all worlds */
} edits;

/* Returns a copy of the world with one more user: the last edit's copy if it is equal, else
 * a new copy.  NULL: no memory. */
edit_world *edits_world(edits *e, const tp_world *world, size_t bytes);
void        edits_let_go(edits *e, edit_world *world);  /* one user less; accepts NULL */

void        edits_forget_worlds(edits *e);

/* Adds an edit and removes all undone edits.  going: more changes of the same row follow,
 * and all count as one edit, from the first `before` to the last `after`; an edit without
 * effect is dropped.  Takes over the users of the worlds. */
void edits_add(edits *e, const edit *change, bool going);
void edits_part(edits *e);                      /* the next change is a new edit */

/* Returns the last edit that is not undone, or NULL. */
edit *edits_last(edits *e);

/* Return the edit to apply now, or NULL: for undo the caller applies `before`, for redo
 * `after`.  The edit is valid until the next edits_add. */
edit *edits_undo(edits *e);
edit *edits_redo(edits *e);
void  edits_clear(edits *e);
#endif
