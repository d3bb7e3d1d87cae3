/* SPDX-License-Identifier: MIT */
/* Edits in a ring; the last `undone` of them are undone.  While the last edit is open, at
 * least one edit exists and none is undone. */
#include "edits.h"
#include <stdlib.h>
#include <string.h>

static undo_edit *at(undo_edits *e, uint32_t i)
{
    return &e->of[(e->first + i) % UNDO_EDITS];
}

/* -- worlds ------------------------------------------------------------------------ */

void undo_edits_release_world(undo_edits *e, undo_world *world)
{
    if (!world || --world->users > 0)
        return;
    e->bytes -= world->bytes;
    free(world);
}

static void let_go_both(undo_edits *e, undo_edit *of)
{
    undo_edits_release_world(e, of->before.world);
    undo_edits_release_world(e, of->after.world);
    of->before.world = of->after.world = NULL;
}

static void make_room(undo_edits *e, size_t bytes)
{
    for (uint32_t i = 0; i < e->count && e->bytes + bytes > UNDO_EDITS_BYTES; i++)
        let_go_both(e, at(e, i));
}

undo_world *undo_edits_world(undo_edits *e, const tp_world *world, size_t bytes)
{
    const undo_edit *last = undo_edits_last(e);
    undo_world *same = last ? last->after.world : NULL;
    if (same && same->bytes == bytes && memcmp(same->world, world, bytes) == 0) {
        same->users++;
        return same;
    }
    make_room(e, bytes);
    if (e->bytes + bytes > UNDO_EDITS_BYTES)
        return NULL;
    undo_world *copy = malloc(sizeof *copy + bytes);
    if (!copy)
        return NULL;
    copy->users = 1;
    copy->bytes = bytes;
    memcpy(copy->world, world, bytes);
    e->bytes += bytes;
    return copy;
}

void undo_edits_forget_worlds(undo_edits *e)
{
    for (uint32_t i = 0; i < e->count; i++)
        let_go_both(e, at(e, i));
}

/* -- the ring ---------------------------------------------------------------------- */

/* Removes the last edit. */
static void drop_last(undo_edits *e)
{
    let_go_both(e, at(e, --e->count));
}

static void drop_first(undo_edits *e)
{
    let_go_both(e, at(e, 0));
    e->first = (e->first + 1) % UNDO_EDITS;
    e->count--;
}

/* Removes the last edit if it changed nothing: a drag that ended at its start. */
static void drop_nothing(undo_edits *e)
{
    const undo_edit *last = at(e, e->count - 1);
    const loaded_scene_value *from = &last->before.value, *to = &last->after.value;
    if (strcmp(from->text, to->text) == 0 && from->set_at == to->set_at)
        drop_last(e);
}

void undo_edits_add(undo_edits *e, const undo_edit *change, bool going)
{
    if (e->open && at(e, e->count - 1)->row != change->row)
        undo_edits_split(e);
    for (; e->undone > 0; e->undone--)
        drop_last(e);
    if (e->open) {
        undo_edit *last = at(e, e->count - 1);
        undo_edits_release_world(e, change->before.world);
        undo_edits_release_world(e, last->after.world);
        last->after = change->after;
        last->line_end = change->line_end;
    } else {
        if (e->count == UNDO_EDITS)
            drop_first(e);
        *at(e, e->count++) = *change;
    }
    e->open = going;
    if (!going)
        drop_nothing(e);
}

void undo_edits_split(undo_edits *e)
{
    if (e->open)
        drop_nothing(e);
    e->open = false;
}

undo_edit *undo_edits_last(undo_edits *e)
{
    return e->undone < e->count ? at(e, e->count - e->undone - 1) : NULL;
}

undo_edit *undo_edits_step_back(undo_edits *e)
{
    undo_edits_split(e);
    return e->undone < e->count ? at(e, e->count - ++e->undone) : NULL;
}

undo_edit *undo_edits_step_forward(undo_edits *e)
{
    undo_edits_split(e);
    return e->undone > 0 ? at(e, e->count - e->undone--) : NULL;
}

void undo_edits_clear(undo_edits *e)
{
    while (e->count > 0)
        drop_last(e);
    e->first = e->undone = 0;
    e->open = false;
}
