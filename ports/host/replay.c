/* SPDX-License-Identifier: MIT */
/* Playing tapes. */
#include "replay.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../live/setting.h"
#include "path.h"
#include "say.h"

/* -- before anything runs -------------------------------------------------------- */

typedef struct {
    tp_scene  *scene;
    tp_world  *world;           /* NULL: lost, what follows cannot be tried */
    const tp_assets *assets;
    replay_room room;
} trial;

static void place_of(const replay *r, const deck_entry *entry, char *place, size_t bytes)
{
    snprintf(place, bytes, "%s:%u", r->tape.name, (unsigned)entry->line);
}

static int world_anew(trial *t, const char *place)
{
    const size_t bytes = tp_world_bytes(t->scene, t->assets);
    tp_error err = { 0 };
    tp_world *world = malloc(bytes > sizeof *world ? bytes : sizeof *world);
    if (!world)
        return fail_memory(bytes);
    free(t->world);
    t->world = world;
    return tp_world_init(world, bytes, t->scene, t->assets, &err) ? fail_at(place, &err)
                                                                   : EXIT_DONE;
}

/* A file is only looked for: loading all would take as long as the film. */
static int try_set(trial *t, const char *place, const char *setting)
{
    const char *value;
    tp_error err = { 0 };
    const tp_param *param = scene_file_check(place, setting, &value);
    if (!param)
        return EXIT_INPUT;
    const setting_result result = setting_put(&tp_kit_all, t->scene, t->world, t->assets,
                                              param, value, strlen(value), &err);
    if (result == SETTING_REFUSED)
        return fail_at(place, &err);
    if (result != SETTING_DONE && t->room == REPLAY_SAME_WORLD)
        return fail(EXIT_INPUT, "%s: %s makes the world anew, which a raw screen does not"
                    " show: expected what goes on in the same world; `tidepool render`"
                    " plays all", place, setting);
    if (result == SETTING_LOAD && *value && !path_is_file(value))
        return fail(EXIT_INPUT, "%s: %s: no such file", place, setting);
    return result == SETTING_ANEW ? world_anew(t, place) : EXIT_DONE;
}

static int try_all(const replay *r, trial *t)
{
    int code = EXIT_DONE;
    for (size_t i = 0; i < r->tape.count && !code; i++) {
        const deck_entry *entry = &r->tape.entries[i];
        char place[512];
        place_of(r, entry, place, sizeof place);
        if (entry->kind == DECK_SET)
            code = try_set(t, place, entry->setting);
    }
    return code;
}

static int try(const replay *r, const stage *s, replay_room room)
{
    trial t = { .scene = malloc(sizeof *t.scene), .world = malloc(s->world_bytes),
                .assets = &s->assets.names, .room = room };
    int code;
    if (t.scene && t.world) {
        *t.scene = s->file.scene;
        memcpy(t.world, s->world, s->world_bytes);
        code = try_all(r, &t);
    } else {
        code = fail_memory(s->world_bytes);
    }
    free(t.scene);
    free(t.world);
    return code;
}

int replay_open(replay *r, const stage *s, const options *o, replay_room room)
{
    *r = (replay){ 0 };
    if (!o->tape)
        return EXIT_DONE;
    const int code = deck_read(&r->tape, o->tape, s->file.name);
    return code ? code : try(r, s, room);
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
