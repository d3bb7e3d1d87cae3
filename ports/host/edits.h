/* SPDX-License-Identifier: MIT */
/* Changes of parameters, to be undone and made again; with each the world before and
 * after it, if it stood then. */
#ifndef HOST_EDITS_H
#define HOST_EDITS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "stage.h"

#define EDITS 256               /* that are remembered; older ones are forgotten */
#define EDITS_BYTES (64u << 20) /* of worlds; those of the oldest edits go first */

/* A copy of a world's block, shared by the edit after which it stood and the next one. */
typedef struct {
    uint32_t users;
    size_t   bytes;
    uint64_t world[];
} edit_world;

typedef struct {
    stage_value value;
    edit_world *world;          /* NULL: it moved, or there was no memory */
} edit_side;

typedef struct {
    uint32_t  row;              /* of the table of parameters */
    edit_side before, after;
    size_t    line, line_end;   /* of a tape's lines, that tell of it */
} edit;

/* All 0 to begin with. */
typedef struct {
    edit     of[EDITS];         /* a ring: of[(first + i) % EDITS] is the i-th of count */
    uint32_t first, count, undone;
    bool     open;              /* the last one goes on: a drag */
    size_t   bytes;             /* of worlds */
} edits;

/* The copy of a world that lies behind the last edit, if it is this one, or a new copy:
 * one user more.  NULL: no memory. */
edit_world *edits_world(edits *e, const tp_world *world, size_t bytes);
void        edits_let_go(edits *e, edit_world *world);  /* one user less; NULL is taken */

void        edits_forget_worlds(edits *e);

/* `going`: more of the same row's will follow, and all are one, from the first `before`
 * to the last `after`; one that ends where it began is none.  What was undone can no
 * longer be made again.  The worlds' users become the edit. */
void edits_add(edits *e, const edit *change, bool going);
void edits_part(edits *e);                      /* what follows is a new one */

/* The last one that is not undone, or NULL. */
edit *edits_last(edits *e);

/* The change to be made now, or NULL: undo wants `before` put in place, redo `after`.
 * It stays until the next edits_add. */
edit *edits_undo(edits *e);
edit *edits_redo(edits *e);
void  edits_clear(edits *e);
#endif
