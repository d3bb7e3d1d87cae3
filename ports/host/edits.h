/* SPDX-License-Identifier: MIT */
/* Changes of parameters, to be undone and made again. */
#ifndef HOST_EDITS_H
#define HOST_EDITS_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/scene.h"

#define EDITS 256               /* that are remembered; older ones are forgotten */

typedef struct {
    uint32_t row;               /* of the table of parameters */
    bool     named[2];          /* before and after: set by hand (scene_file.set_at) */
    char     before[TP_NAME_BYTES + 64], after[TP_NAME_BYTES + 64];
} edit;

/* All 0 to begin with. */
typedef struct {
    edit     of[EDITS];         /* a ring: of[(first + i) % EDITS] is the i-th of count */
    uint32_t first, count, undone;
    bool     open;              /* the last one goes on: a drag */
    bool     fresh, kept;       /* the last edits_add began one, and it is there */
} edits;

/* `going`: more of the same row's will follow, and all are one, from the first `before`
 * to the last `after`; one that ends where it began is none.  What was undone can no
 * longer be made again.  Longer texts are cut. */
void edits_add(edits *e, uint32_t row, const char *before, const char *after, bool going);
void edits_part(edits *e);                      /* what follows is a new one */

/* What edits_add added to had been set by hand before, and is now; else it counts as not.
 * Of a drag it is the first `before` that counts. */
void edits_named(edits *e, bool before, bool after);

/* The change to be made now, or NULL: undo wants `before` put in place, redo `after`.
 * It stays until the next edits_add. */
const edit *edits_undo(edits *e);
const edit *edits_redo(edits *e);
void edits_clear(edits *e);
#endif
