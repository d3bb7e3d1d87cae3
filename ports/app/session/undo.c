/* SPDX-License-Identifier: MIT */
/* Edits in a ring, and their effect on the loaded scene.  The last `undone` edits of the
 * ring are undone.  While the last edit is open, at least one edit exists and none is
 * undone.  An edit keeps the worlds before and after it; see the header. */
#include "undo.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "world/text.h"
#include "world/world.h"

/* -- the ring of edits --------------------------------------------------------------- */

/* Edits and their copies of worlds, within bounds of number and bytes. */

static undo_edit *edit_slot(undo_edits *e, uint32_t i)
{
    return &e->of[(e->first + i) % UNDO_EDITS];
}

/* -- worlds -------------------------------------------------------------------------- */

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
        let_go_both(e, edit_slot(e, i));
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
        let_go_both(e, edit_slot(e, i));
}

/* -- the ring ------------------------------------------------------------------------ */

/* Removes the last edit. */
static void drop_last(undo_edits *e)
{
    let_go_both(e, edit_slot(e, --e->count));
}

static void drop_first(undo_edits *e)
{
    let_go_both(e, edit_slot(e, 0));
    e->first = (e->first + 1) % UNDO_EDITS;
    e->count--;
}

/* Removes the last edit if it changed nothing: a drag that ended edit_slot its start. */
static void drop_nothing(undo_edits *e)
{
    const undo_edit *last = edit_slot(e, e->count - 1);
    const loaded_scene_value *from = &last->before.value, *to = &last->after.value;
    if (strcmp(from->text, to->text) == 0 && from->set_at == to->set_at)
        drop_last(e);
}

void undo_edits_add(undo_edits *e, const undo_edit *change, bool going)
{
    if (e->open && edit_slot(e, e->count - 1)->row != change->row)
        undo_edits_split(e);
    for (; e->undone > 0; e->undone--)
        drop_last(e);
    if (e->open) {
        undo_edit *last = edit_slot(e, e->count - 1);
        undo_edits_release_world(e, change->before.world);
        undo_edits_release_world(e, last->after.world);
        last->after = change->after;
        last->line_end = change->line_end;
    } else {
        if (e->count == UNDO_EDITS)
            drop_first(e);
        *edit_slot(e, e->count++) = *change;
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
    return e->undone < e->count ? edit_slot(e, e->count - e->undone - 1) : NULL;
}

undo_edit *undo_edits_step_back(undo_edits *e)
{
    undo_edits_split(e);
    return e->undone < e->count ? edit_slot(e, e->count - ++e->undone) : NULL;
}

undo_edit *undo_edits_step_forward(undo_edits *e)
{
    undo_edits_split(e);
    return e->undone > 0 ? edit_slot(e, e->count - e->undone--) : NULL;
}

void undo_edits_clear(undo_edits *e)
{
    while (e->count > 0)
        drop_last(e);
    e->first = e->undone = 0;
    e->open = false;
}

/* -- changes of the loaded scene ----------------------------------------------------- */

/* Sets, undoes and redoes a value; the camera's part of a world is compared and kept
 * apart. */

static const tp_param *row_param(uint32_t row)
{
    uint32_t count;
    return &tp_params(&count)[row];
}

/* -- the camera ---------------------------------------------------------------------- */

/* The camera's members are contiguous in a world: CAMERA_BYTES from `eye` on. */
#define CAMERA       offsetof(tp_world, eye)
#define CAMERA_BYTES (offsetof(tp_world, phases) - CAMERA)
_Static_assert(CAMERA_BYTES == 2 * sizeof(tp_vec3) + 6 * sizeof(tp_turn),
               "the camera's members, and no others");

static bool same_camera(const void *a, const void *b)
{
    return memcmp((const char *)a + CAMERA, (const char *)b + CAMERA, CAMERA_BYTES) == 0;
}

static void copy_camera(void *to, const void *from)
{
    memcpy((char *)to + CAMERA, (const char *)from + CAMERA, CAMERA_BYTES);
}

static bool same_value(const loaded_scene_value *a, const loaded_scene_value *b)
{
    return a->set_at == b->set_at && strcmp(a->text, b->text) == 0;
}

/* True if the loaded scene's world equals `was` except for the camera. */
static bool still_stands(const loaded_scene *s, const undo_world *was)
{
    const size_t behind = CAMERA + CAMERA_BYTES;
    const char *now = (const char *)s->world, *then = (const char *)was->world;
    return was->bytes == s->world_bytes && memcmp(now, then, CAMERA) == 0
        && memcmp(now + behind, then + behind, was->bytes - behind) == 0;
}

/* -- changes ------------------------------------------------------------------------- */

/* A drag is one change as long as nothing else happens: a moved camera ends the change. */
static void part(undo_edits *e, const loaded_scene *s, uint32_t row)
{
    const undo_edit *last = undo_edits_last(e);
    const undo_world *after = last && e->open && last->row == row ? last->after.world
                                                                  : NULL;
    if (after && (!still_stands(s, after) || !same_camera(s->world, after->world)))
        undo_edits_split(e);
}

/* Keeps the origin of a value: a number equal to the number before the change gets its
 * set_at back. */
static void keep_origin(undo_edits *e, loaded_scene *s, undo_edit *new)
{
    const tp_param *param = row_param(new->row);
    const loaded_scene_value *from =
        e->open ? &undo_edits_last(e)->before.value : &new->before.value;
    if (tp_param_is_file(param) || strcmp(from->text, new->after.value.text) != 0)
        return;
    s->file.set_at[new->row] = new->after.value.set_at = from->set_at;
}

int undo_set(undo_edits *e, loaded_scene *s, const options *o, const undo_change *change,
             const char *text, bool *opened)
{
    const tp_param *param = row_param(change->row);
    char setting[64 + TP_NAME_BYTES + 64];
    part(e, s, change->row);
    undo_edit new = { .row = change->row,
                      .line = change->line,
                      .line_end = change->line_end };
    new.before.value = loaded_scene_get(s, param);
    if (change->stands && !e->open)
        new.before.world = undo_edits_world(e, s->world, s->world_bytes);
    snprintf(setting, sizeof setting, "%s=%s", param->name, text);
    const int code = loaded_scene_set(s, o, "the panel", setting, opened);
    if (code) {
        undo_edits_release_world(e, new.before.world);
        return code;
    }
    new.after.value = loaded_scene_get(s, param);
    keep_origin(e, s, &new);
    if (change->stands)
        new.after.world = undo_edits_world(e, s->world, s->world_bytes);
    undo_edits_add(e, &new, change->going);
    return EXIT_DONE;
}

/* -- undo and redo ------------------------------------------------------------------- */

/* Restores the world before the change, but keeps a camera moved since. */
static undo_result put_world(loaded_scene *s, const undo_edit *change,
                             const tp_world *camera)
{
    const tp_world *before = (const void *)change->before.world->world;
    const tp_world *after = (const void *)change->after.world->world;
    const bool keeps = !same_camera(camera, after) && same_camera(after, before);
    memcpy(s->world, before, change->before.world->bytes);
    if (keeps)
        copy_camera(s->world, camera);
    return keeps ? UNDO_WORLD : UNDO_ALL;
}

undo_result undo_back(undo_edits *e, loaded_scene *s, const options *o, undo_edit **done,
                      bool *opened)
{
    undo_edit *last = *done = undo_edits_step_back(e);
    tp_world camera;
    if (!last)
        return UNDO_NOTHING;
    const undo_world *before = last->before.world, *after = last->after.world;
    const loaded_scene_value now = loaded_scene_get(s, row_param(last->row));
    const bool stood = before && after && still_stands(s, after)
                    && same_value(&now, &last->after.value);
    copy_camera(&camera, s->world);
    if (loaded_scene_put(s, o, "undo", row_param(last->row), &last->before.value, opened)) {
        (void)undo_edits_step_forward(e);
        return UNDO_REFUSED;
    }
    return stood && s->world_bytes == before->bytes ? put_world(s, last, &camera)
                                                    : UNDO_VALUE;
}

undo_result undo_again(undo_edits *e, loaded_scene *s, const options *o, undo_edit **done,
                       bool *opened)
{
    const undo_edit *next = *done = undo_edits_step_forward(e);
    if (!next)
        return UNDO_NOTHING;
    if (loaded_scene_put(s, o, "redo", row_param(next->row), &next->after.value, opened)) {
        (void)undo_edits_step_back(e);
        return UNDO_REFUSED;
    }
    return UNDO_VALUE;
}
