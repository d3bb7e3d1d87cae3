/* SPDX-License-Identifier: MIT */
/* Edits in a ring; the last `undone` of them are undone.  While the last one is open
 * there is one, and none is undone. */
#include "edits.h"
#include <stdio.h>
#include <string.h>

static edit *at(edits *e, uint32_t i)
{
    return &e->of[(e->first + i) % EDITS];
}

/* The one that is added to: the drag that goes on, or a new one. */
static edit *last(edits *e, uint32_t row, const char *before)
{
    e->fresh = !e->open;
    if (e->open)
        return at(e, e->count - 1);
    if (e->count == EDITS) {
        e->first = (e->first + 1) % EDITS;
        e->count--;
    }
    edit *new = at(e, e->count++);
    memset(new, 0, sizeof *new);
    new->row = row;
    snprintf(new->before, sizeof new->before, "%s", before);
    return new;
}

/* A drag that ended where it began. */
static void drop_nothing(edits *e)
{
    const edit *to = at(e, e->count - 1);
    if (strcmp(to->before, to->after) == 0) {
        e->count--;
        e->kept = false;
    }
}

void edits_add(edits *e, uint32_t row, const char *before, const char *after, bool going)
{
    if (e->open && at(e, e->count - 1)->row != row)
        edits_part(e);
    e->count -= e->undone;
    e->undone = 0;
    edit *to = last(e, row, before);
    snprintf(to->after, sizeof to->after, "%s", after);
    e->kept = true;
    e->open = going;
    if (!going)
        drop_nothing(e);
}

void edits_part(edits *e)
{
    if (e->open)
        drop_nothing(e);
    e->open = e->kept = false;
}

void edits_named(edits *e, bool before, bool after)
{
    if (!e->kept)
        return;
    edit *to = at(e, e->count - 1);
    if (e->fresh)
        to->named[0] = before;
    to->named[1] = after;
}

const edit *edits_undo(edits *e)
{
    edits_part(e);
    return e->undone < e->count ? at(e, e->count - ++e->undone) : NULL;
}

const edit *edits_redo(edits *e)
{
    edits_part(e);
    return e->undone > 0 ? at(e, e->count - e->undone--) : NULL;
}

void edits_clear(edits *e)
{
    e->first = e->count = e->undone = 0;
    e->open = e->fresh = e->kept = false;
}
