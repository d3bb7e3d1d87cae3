/* SPDX-License-Identifier: MIT */
/* Playing tapes. */
#include "replay.h"
#include <stdio.h>
#include <string.h>
#include "say.h"

/* -- before anything runs -------------------------------------------------------- */

static void place_of(const replay *r, const deck_entry *entry, char *place, size_t bytes)
{
    snprintf(place, bytes, "%s:%u", r->tape.name, (unsigned)entry->line);
}

static int try_all(const replay *r, stage *s, const options *o, replay_room room)
{
    int code = EXIT_DONE;
    for (size_t i = 0; i < r->tape.count && !code; i++) {
        const deck_entry *entry = &r->tape.entries[i];
        const tp_world *world = s->world;
        char place[512];
        bool opened;
        if (entry->kind != DECK_SET)
            continue;
        place_of(r, entry, place, sizeof place);
        code = stage_set(s, o, place, entry->setting, &opened);
        if (!code && room == REPLAY_SAME_WORLD && s->world != world)
            code = fail(EXIT_INPUT, "%s: %s makes the world anew, which a raw screen does"
                        " not show: expected what goes on in the same world; `tidepool"
                        " render` plays all", place, entry->setting);
    }
    return code;
}

/* On another stage of the same scene, which nobody sees. */
static int try(const replay *r, const options *o, replay_room room)
{
    stage s;
    memset(&s, 0, sizeof s);
    int code = stage_read(&s.file, o);
    if (!code)
        code = assets_open_within(&s.assets, &s.file, o->texels);
    if (!code)
        code = stage_world(&s);
    if (!code)
        code = try_all(r, &s, o, room);
    stage_close(&s);
    return code;
}

static bool has_sets(const deck *d)
{
    for (size_t i = 0; i < d->count; i++)
        if (d->entries[i].kind == DECK_SET)
            return true;
    return false;
}

int replay_open(replay *r, const stage *s, const options *o, replay_room room)
{
    *r = (replay){ 0 };
    if (!o->tape)
        return EXIT_DONE;
    const int code = deck_read(&r->tape, o->tape, s->file.name);
    return code || !has_sets(&r->tape) ? code : try(r, o, room);
}

int replay_close(replay *r)
{
    return deck_close(&r->tape);
}

/* -- while it runs --------------------------------------------------------------- */

static int act(const replay *r, const deck_entry *entry, stage *s, const options *o,
               bool *opened)
{
    char place[512];
    if (entry->kind == DECK_LOOK) {
        tp_world_look(s->world, &entry->input);
        return EXIT_DONE;
    }
    place_of(r, entry, place, sizeof place);
    return stage_set(s, o, place, entry->setting, opened);
}

int replay_acts(replay *r, stage *s, const options *o, bool *opened)
{
    int code = EXIT_DONE;
    const deck_entry *entry;
    while (!code && !r->step && (entry = deck_next(&r->tape, r->tick)) != NULL) {
        if (entry->kind == DECK_STEP)
            r->step = entry;
        else
            code = act(r, entry, s, o, opened);
    }
    return code;
}

const tp_input *replay_step(replay *r)
{
    const deck_entry *step = r->step;
    r->step = NULL;
    r->tick++;
    return step ? &step->input : NULL;
}

/* A kept world has taken what came before it; the scene is not kept. */
void replay_skip(replay *r, stage *s)
{
    for (; r->tick < s->world->tick; (void)replay_step(r)) {
        const deck_entry *entry;
        while (!r->step && (entry = deck_next(&r->tape, r->tick)) != NULL) {
            if (entry->kind == DECK_STEP)
                r->step = entry;
            else if (entry->kind == DECK_SET)
                (void)scene_file_set(&s->file, entry->setting);
        }
    }
}
