/* SPDX-License-Identifier: MIT */
/* Plays tapes. */
#include "replay.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "world/text.h"
#include "world/world.h"

/* -- checks before the replay -------------------------------------------------------- */

static void format_location(const replay *r, const tape_file_entry *entry, char *place,
                            size_t bytes)
{
    snprintf(place, bytes, "%s:%u", r->tape.name, (unsigned)entry->line);
}

/* Returns the number of consecutive sets at one tick, from entry `at` on. */
static size_t count_sets(const tape_file *d, size_t at)
{
    size_t n = 0;
    while (at + n < d->count && d->entries[at + n].kind == TAPE_FILE_SET
           && d->entries[at + n].tick == d->entries[at].tick)
        n++;
    return n;
}

typedef struct { char text[512]; } replay_place;

static int set_all(const replay *r, size_t at, size_t count, loaded_scene *s,
                   const options *o, bool *opened)
{
    replay_place *places = malloc(count * sizeof *places);
    loaded_scene_setting *all = malloc(count * sizeof *all);
    for (size_t i = 0; places && all && i < count; i++) {
        const tape_file_entry *entry = &r->tape.entries[at + i];
        format_location(r, entry, places[i].text, sizeof places[i].text);
        all[i] = (loaded_scene_setting){ places[i].text, entry->setting };
    }
    const int code = places && all ? loaded_scene_set_all(s, o, all, count, opened)
                                   : log_fail_memory(count * sizeof *places);
    free(places);
    free(all);
    return code;
}

static int try_all(const replay *r, loaded_scene *s, const options *o, replay_room room)
{
    int code = EXIT_DONE;
    for (size_t i = 0; i < r->tape.count && !code; i++) {
        const tape_file_entry *entry = &r->tape.entries[i];
        const tp_world *world = s->world;
        const size_t count = count_sets(&r->tape, i);
        bool opened = false;
        if (count == 0)
            continue;
        code = set_all(r, i, count, s, o, &opened);
        i += count - 1;
        if (!code && room == REPLAY_SAME_WORLD && s->world != world)
            code = log_fail(EXIT_INPUT, "%s:%u: %s restarts the world, but `tidepool show`"
                        " plays only changes that keep the world;"
                        " `tidepool render` plays every tape", r->tape.name,
                        (unsigned)entry->line, entry->setting);
    }
    return code;
}

/* Applies all sets of the tape to a second, hidden loaded scene. */
static int try(const replay *r, const options *o, replay_room room)
{
    options quiet = *o;
    loaded_scene s;
    quiet.quiet = true;
    int code = loaded_scene_load(&s, &quiet);
    if (!code)
        code = try_all(r, &s, &quiet, room);
    loaded_scene_close(&s);
    return code;
}

static bool has_sets(const tape_file *d)
{
    for (size_t i = 0; i < d->count; i++)
        if (d->entries[i].kind == TAPE_FILE_SET)
            return true;
    return false;
}

int replay_open(replay *r, const loaded_scene *s, const options *o, replay_room room)
{
    *r = (replay){ 0 };
    if (!o->tape)
        return EXIT_DONE;
    const int code = tape_file_read(&r->tape, o->tape, s->file.name);
    return code || !has_sets(&r->tape) ? code : try(r, o, room);
}

int replay_close(replay *r)
{
    return tape_file_close(&r->tape);
}

/* -- replay -------------------------------------------------------------------------- */

static int act(replay *r, const tape_file_entry *entry, loaded_scene *s, const options *o,
               bool *opened)
{
    const size_t at = (size_t)(entry - r->tape.entries);
    const size_t count = count_sets(&r->tape, at);
    if (entry->kind == TAPE_FILE_LOOK) {
        tp_world_move_camera(s->world, &entry->input);
        return EXIT_DONE;
    }
    r->tape.at = at + count;
    return set_all(r, at, count, s, o, opened);
}

int replay_acts(replay *r, loaded_scene *s, const options *o, bool *opened)
{
    int code = EXIT_DONE;
    const tape_file_entry *entry;
    while (!code && !r->step && (entry = tape_file_next(&r->tape, r->tick)) != NULL) {
        if (entry->kind == TAPE_FILE_STEP)
            r->step = entry;
        else
            code = act(r, entry, s, o, opened);
    }
    return code;
}

const tp_input *replay_step(replay *r)
{
    const tape_file_entry *step = r->step;
    r->step = NULL;
    r->tick++;
    return step ? &step->input : NULL;
}

/* -- continuing from a kept world ---------------------------------------------------- */

/* Returns the number of entries played; a step that waits for its tick is not yet
 * played. */
uint32_t replay_played(const replay *r)
{
    return (uint32_t)(r->step ? (size_t)(r->step - r->tape.entries) : r->tape.at);
}

bool replay_remake(const replay *r, loaded_scene *s, uint32_t played)
{
    tp_scene *scene = played <= r->tape.count ? malloc(sizeof *scene) : NULL;
    if (!scene)
        return false;
    *scene = s->file.scene;
    for (uint32_t i = 0; i < played; i++) {
        const tape_file_entry *entry = &r->tape.entries[i];
        const char *value;
        const tp_param *param = entry->kind != TAPE_FILE_SET ? NULL
                              : scene_file_check(r->tape.name, entry->setting, &value);
        if (param)
            (void)tp_param_set(scene, param, value, strlen(value), NULL);
    }
    const bool made = tp_world_init(&tp_program_all, s->world, s->world_bytes, scene,
                                    &s->assets.names, NULL)
                      == TP_OK;
    free(scene);
    return made;
}

/* Skips entries already contained in a kept world.  The kept file has no scene, so sets are
 * applied to the scene here. */
void replay_skip(replay *r, loaded_scene *s, uint32_t played)
{
    for (; r->tape.at < played; r->tape.at++) {
        const tape_file_entry *entry = &r->tape.entries[r->tape.at];
        if (entry->kind == TAPE_FILE_SET)
            (void)scene_file_set(&s->file, entry->setting);
    }
    r->tick = r->tick < s->world->tick ? s->world->tick : r->tick;
}
