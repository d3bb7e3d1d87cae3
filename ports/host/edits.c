/* SPDX-License-Identifier: MIT */
/* Edits in a ring; the last `undone` of them are undone.  While the last edit is open, at
 * least one edit exists and none is undone. */
#include "edits.h"
#include <stdlib.h>
#include <string.h>

static edit *at(edits *e, uint32_t i)
{
    return &e->of[(e->first + i) % EDITS];
}

/* -- worlds ------------------------------------------------------------------------ */

void edits_let_go(edits *e, edit_world *world)
{
    if (!world || --world->users > 0)
        return;
    e->bytes -= world->bytes;
    free(world);
}

static void let_go_both(edits *e, edit *of)
{
    edits_let_go(e, of->before.world);
    edits_let_go(e, of->after.world);
    of->before.world = of->after.world = NULL;
}

static void make_room(edits *e, size_t bytes)
{
    for (uint32_t i = 0; i < e->count && e->bytes + bytes > EDITS_BYTES; i++)
        let_go_both(e, at(e, i));
}

edit_world *edits_world(edits *e, const tp_world *world, size_t bytes)
{
    const edit *last = edits_last(e);
    edit_world *same = last ? last->after.world : NULL;
    if (same && same->bytes == bytes && memcmp(same->world, world, bytes) == 0) {
        same->users++;
        return same;
    }
    make_room(e, bytes);
    if (e->bytes + bytes > EDITS_BYTES)
        return NULL;
    edit_world *copy = malloc(sizeof *copy + bytes);
    if (!copy)
        return NULL;
    copy->users = 1;
    copy->bytes = bytes;
    memcpy(copy->world, world, bytes);
    e->bytes += bytes;
    return copy;
}

void edits_forget_worlds(edits *e)
{
    for (uint32_t i = 0; i < e->count; i++)
        let_go_both(e, at(e, i));
}

/* -- the ring ---------------------------------------------------------------------- */

/* Removes the last edit. */
static void drop_last(edits *e)
{
    let_go_both(e, at(e, --e->count));
}

static void drop_first(edits *e)
{
    let_go_both(e, at(e, 0));
    e->first = (e->first + 1) % EDITS;
    e->count--;
}

/* Removes the last edit if it changed nothing: a drag that ended at its start. */
static void drop_nothing(edits *e)
{
    const edit *last = at(e, e->count - 1);
    const stage_value *from = &last->before.value, *to = &last->after.value;
    if (strcmp(from->text, to->text) == 0 && from->set_at == to->set_at)
        drop_last(e);
}

void edits_add(edits *e, const edit *change, bool going)
{
    if (e->open && at(e, e->count - 1)->row != change->row)
        edits_part(e);
    for (; e->undone > 0; e->undone--)
        drop_last(e);
    if (e->open) {
        edit *last = at(e, e->count - 1);
        edits_let_go(e, change->before.world);
        edits_let_go(e, last->after.world);
        last->after = change->after;
        last->line_end = change->line_end;
    } else {
        if (e->count == EDITS)
            drop_first(e);
        *at(e, e->count++) = *change;
    }
    e->open = going;
    if (!going)
        drop_nothing(e);
}

void edits_part(edits *e)
{
    if (e->open)
        drop_nothing(e);
    e->open = false;
}

edit *edits_last(edits *e)
{
    return e->undone < e->count ? at(e, e->count - e->undone - 1) : NULL;
}

edit *edits_undo(edits *e)
{
    edits_part(e);
    return e->undone < e->count ? at(e, e->count - ++e->undone) : NULL;
}

edit *edits_redo(edits *e)
{
    edits_part(e);
    return e->undone > 0 ? at(e, e->count - e->undone--) : NULL;
}

void edits_clear(edits *e)
{
    while (e->count > 0)
        drop_last(e);
    e->first = e->undone = 0;
    e->open = false;
}
