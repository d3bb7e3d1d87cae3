/* SPDX-License-Identifier: MIT */
/* Changes, undoes and redoes values of a stage.
 *
 * Undo always restores the scene to the bit.  If only the camera has moved the world since
 * the change, the world is restored to the bit too, and hence its picture; the camera stays
 * at its present place, unless the change itself had moved the camera.  If the water has
 * moved on, the old value is set like any value, and the water continues with it. */
#ifndef HOST_UNDO_H
#define HOST_UNDO_H
#include "edits.h"

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
