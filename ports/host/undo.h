/* SPDX-License-Identifier: MIT */
/* Values of a stage, changed, undone and made again.
 *
 * The scene is put back to the bit always.  The world is, where it stood: if nothing but
 * the camera has moved it since the change, it becomes again what it was before, to the
 * bit, and so does its picture; the camera stays where it was led since, unless the change
 * itself had moved it.  Where the water has moved on, the old value is put as any value
 * is, and the water goes on with it. */
#ifndef HOST_UNDO_H
#define HOST_UNDO_H
#include "edits.h"

/* As stage_set of one row; *change is remembered with it.  `going`: see edits_add;
 * `stands`: nothing moves the water until the next tick, so its world is worth keeping. */
typedef struct {
    uint32_t row;
    bool     going, stands;
    size_t   line, line_end;    /* see edit */
} undo_change;
int undo_set(edits *e, stage *s, const options *o, const undo_change *change,
             const char *text, bool *opened);

typedef enum {
    UNDO_NOTHING,               /* to undo, or to make again */
    UNDO_REFUSED,               /* which was said; nothing has changed */
    UNDO_VALUE,                 /* the value; the world goes on with it */
    UNDO_WORLD,                 /* and the world, but for the camera */
    UNDO_ALL                    /* and the camera */
} undo_result;

/* Undoes the last change, or makes it again: that is UNDO_VALUE, and leads from the same
 * world to the same.  *done is its edit. */
undo_result undo_back(edits *e, stage *s, const options *o, edit **done, bool *opened);
undo_result undo_again(edits *e, stage *s, const options *o, edit **done, bool *opened);
#endif
