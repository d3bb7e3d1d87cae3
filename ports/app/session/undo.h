/* SPDX-License-Identifier: MIT */
/* Undo and redo: the list of changes of parameters, and the changes themselves.
 *
 * An edit keeps the value and, if the world stood still, the world before and after the
 * change.  Undo always restores the scene to the bit.  If only the camera has moved the
 * world since the change, the world is restored to the bit too, and hence its picture; the
 * camera stays at its present place, unless the change itself had moved the camera.  If the
 * water has moved on, the old value is set like any value, and the water continues with
 * it. */
#ifndef TP_APP_SESSION_UNDO_H
#define TP_APP_SESSION_UNDO_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "app/scene/loaded_scene.h"

#define UNDO_EDITS 256               /* edits remembered; older edits are forgotten */
#define UNDO_EDITS_BYTES (64u << 20) /* of all worlds; the oldest lose theirs first */

/* A copy of a world, shared by the edit before it and the edit after it. */
typedef struct {
    uint32_t users;
    size_t   bytes;
    uint64_t world[];
} undo_world;

typedef struct {
    loaded_scene_value value;
    undo_world *world;          /* NULL: the world moved, or no memory */
} undo_side;

typedef struct {
    uint32_t  row;              /* index in the table of parameters */
    undo_side before, after;
    size_t    line, line_end;   /* lines of the tape that record the edit: first, end */
} undo_edit;

/* Initially all 0. */
typedef struct {
    undo_edit of[UNDO_EDITS];   /* ring: of[(first + i) % EDITS] is edit i of count */
    uint32_t first, count, undone;
    bool     open;              /* the last edit continues: a drag */
    size_t   bytes;             /* bytes of all worlds */
} undo_edits;

/* Returns a copy of the world with one more user: the last edit's copy if it is equal, else
 * a new copy.  NULL: no memory. */
undo_world *undo_edits_world(undo_edits *e, const tp_world *world, size_t bytes);
void undo_edits_release_world(undo_edits *e,
                              undo_world *world); /* one user less; accepts NULL */

void        undo_edits_forget_worlds(undo_edits *e);

/* Adds an edit and removes all undone edits.  going: more changes of the same row follow,
 * and all count as one edit, from the first `before` to the last `after`; an edit without
 * effect is dropped.  Takes over the users of the worlds. */
void undo_edits_add(undo_edits *e, const undo_edit *change, bool going);
void undo_edits_split(undo_edits *e); /* the next change is a new edit */

/* Returns the last edit that is not undone, or NULL. */
undo_edit *undo_edits_last(undo_edits *e);

/* Return the edit to apply now, or NULL: for undo the caller applies `before`, for redo
 * `after`.  The edit is valid until the next undo_edits_add. */
undo_edit *undo_edits_step_back(undo_edits *e);
undo_edit *undo_edits_step_forward(undo_edits *e);
void  undo_edits_clear(undo_edits *e);

/* Sets one row like loaded_scene_set, and remembers *change with the edit.  going: see
 * undo_edits_add. stands: nothing moves the water until the next tick, so the world is
 * kept. */
typedef struct {
    uint32_t row;
    bool     going, stands;
    size_t   line, line_end;    /* see edit */
} undo_change;
int undo_set(undo_edits *e, loaded_scene *s, const options *o, const undo_change *change,
             const char *text, bool *opened);

typedef enum {
    UNDO_NOTHING,               /* nothing to undo or redo */
    UNDO_REFUSED,               /* refused, after a message; nothing has changed */
    UNDO_VALUE,                 /* value restored; the world continues with it */
    UNDO_WORLD,                 /* world restored, except for the camera */
    UNDO_ALL                    /* world and camera restored */
} undo_result;

/* Undo or redo the last change; *done: its edit.  Redo returns UNDO_VALUE, and leads from
 * the same world to the same world. */
undo_result undo_back(undo_edits *e, loaded_scene *s, const options *o, undo_edit **done,
                      bool *opened);
undo_result undo_again(undo_edits *e, loaded_scene *s, const options *o, undo_edit **done,
                       bool *opened);

#endif
