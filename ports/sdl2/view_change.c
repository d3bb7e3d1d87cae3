/* SPDX-License-Identifier: MIT */
/* What is shown, and how it is changed: scenes, values, undo, saving, what is kept for
 * --resume.  A change goes three ways at once: to the scene, to the tape, to the list that
 * undo reads. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../host/path.h"
#include "../host/say.h"
#include "../host/scene_save.h"
#include "view.h"

#define KEEP_US 1000000u

/* -- what there is --------------------------------------------------------------- */

static void add_scene(view *v, const char *folder, const char *name, const char *given)
{
    view_scenes *all = &v->scenes;
    const uint32_t room = all->count + 1;
    char **names = realloc(all->name, room * sizeof *names);
    all->name = names ? names : all->name;
    char **shows = realloc(all->shows, room * sizeof *shows);
    all->shows = shows ? shows : all->shows;
    char *path = path_join(folder, name, ".ini");
    scene_file file = { 0 };
    if (!names || !shows || !path || (given && scene_file_open(&file, path))) {
        free(path);
        scene_file_close(&file);
        return;
    }
    const char *text = given ? file.scene.shows : "an INI file in this folder";
    all->shows[all->count] = path_copy(text, strlen(text));
    all->name[all->count] = path_copy(given ? given : path, strlen(given ? given : path));
    all->count += all->shows[all->count] && all->name[all->count];
    free(path);
    scene_file_close(&file);
}

static void add_folder(view *v, const char *folder, bool shipped)
{
    size_t count;
    char **names = path_scene_names(folder, &count);
    for (size_t i = 0; i < count; i++)
        add_scene(v, folder, names[i], shipped ? names[i] : NULL);
    path_free_names(names, count);
}

/* As a scene file of the shipped ones names them: "../textures/foam.png". */
static void add_pictures(view *v, const char *scenes, const char *folder)
{
    size_t count;
    char *path = path_join(scenes, folder, "");
    char **names = path ? path_names(path, ".png", &count) : NULL;
    for (size_t i = 0; names && i < count; i++) {
        char **more = realloc(v->pictures, (v->picture_count + 1) * sizeof *more);
        if (!more)
            break;
        v->pictures = more;
        more[v->picture_count] = path_join(folder, names[i], ".png");
        v->picture_count += more[v->picture_count] != NULL;
    }
    if (names)
        path_free_names(names, count);
    free(path);
}

void view_list(view *v)
{
    char *folder = path_of_scenes();
    if (folder) {
        add_folder(v, folder, true);
        add_pictures(v, folder, "../textures");
        add_pictures(v, folder, "../skies");
        free(folder);
    }
    add_folder(v, ".", false);
}

void view_unlist(view *v)
{
    for (uint32_t i = 0; i < v->scenes.count; i++) {
        free(v->scenes.name[i]);
        free(v->scenes.shows[i]);
    }
    free(v->scenes.name);
    free(v->scenes.shows);
    path_free_names(v->pictures, v->picture_count);
    v->scenes = (view_scenes){ 0 };
    v->pictures = NULL;
    v->picture_count = 0;
}

/* -- opening --------------------------------------------------------------------- */

static void find_at(view *v, const char *scene)
{
    v->scenes.at = 0;
    while (v->scenes.at < v->scenes.count && strcmp(v->scenes.name[v->scenes.at], scene))
        v->scenes.at++;
}

void view_refit(view *v, bool opened)
{
    if (opened)
        governing_begin(&v->governing, v->stage);
    compare_forget(v->compare);
    v->stale = true;
}

/* The settings of the command line were for the scene that it names. */
static stage *load(view *v, const char *scene)
{
    options wanted = *v->options;
    stage *next = calloc(1, sizeof *next);
    wanted.scene = scene;
    if (v->stage)
        wanted.n_settings = 0;
    if (!next) {
        fail_memory(sizeof *next);
        return NULL;
    }
    if (stage_open(next, &wanted) == EXIT_DONE)
        return next;
    stage_close(next);
    free(next);
    return NULL;
}

bool view_open(view *v, const char *scene)
{
    scene_file filed;
    stage *next = load(v, scene), *before = v->stage;
    if (!next)
        return false;
    if (before) {
        view_film(v, false);
        view_untape(v);
        compare_forget(v->compare);     /* it reads what is closed now */
    }
    v->stage = next;
    v->filed = next->file.scene;
    if (scene_file_open(&filed, scene) == EXIT_DONE)
        v->filed = filed.scene;
    scene_file_close(&filed);
    v->picture = 0;
    v->base = 0;
    v->wish = (tp_input){ 0 };
    v->pokes = (poke_queue){ 0 };
    v->changed = false;
    past_forget(v->past);
    edits_clear(&v->edits);
    v->look = (look){ .mode = LOOK_FREE };
    find_at(v, scene);
    if (before)                         /* `scene` may be its name */
        stage_close(before);
    free(before);
    free(v->saved_as);
    v->saved_as = scene_save_name(&next->file);
    view_refit(v, true);
    return true;
}

void view_turn_to(view *v, int by)
{
    const uint32_t count = v->scenes.count;
    if (count == 0)
        return;
    const uint32_t at = v->scenes.at < count ? v->scenes.at : by > 0 ? count - 1 : 0;
    const uint32_t to = (at + count + (uint32_t)by) % count;
    if (view_open(v, v->scenes.name[to]))
        view_say(v, "%s: %s", v->scenes.name[to], v->scenes.shows[to]);
    v->scenes.at = to;
}

/* -- values ---------------------------------------------------------------------- */

static const tp_param *param_of(uint32_t row)
{
    uint32_t count;
    return &tp_params(&count)[row];
}

/* Before the stage changes. */
static bool may_change(view *v)
{
    if (v->playing)
        view_say(v, "a tape plays: F10 ends it");
    else
        compare_forget(v->compare);
    return !v->playing;
}

/* After it has, in a world of `tick`.  Worlds that are past name other files then. */
static void was_changed(view *v, const tp_param *param, uint64_t tick, bool opened)
{
    v->base += tick - v->stage->world->tick;
    if (tp_param_is_file(param))
        past_forget(v->past);
    v->changed = true;
    view_refit(v, opened);
}

/* The value as it is now. */
static void tell_tape(view *v, const tp_param *param)
{
    char text[PANEL_TEXT], setting[64 + PANEL_TEXT];
    scene_file_text(&v->stage->file, param, text, sizeof text);
    snprintf(setting, sizeof setting, "%s=%s", param->name, text);
    deck_set(&v->tape, v->base + v->stage->world->tick, setting);
}

/* Not to be undone. */
static bool put(view *v, const tp_param *param, const char *text)
{
    char setting[64 + PANEL_TEXT];
    bool opened = false;
    const uint64_t tick = v->stage->world->tick;
    snprintf(setting, sizeof setting, "%s=%s", param->name, text);
    if (!may_change(v)
        || stage_set(v->stage, v->options, "the panel", setting, &opened) != EXIT_DONE)
        return false;
    was_changed(v, param, tick, opened);
    tell_tape(v, param);
    return true;
}

bool view_set(view *v, uint32_t row, const char *text, bool going)
{
    bool opened = false;
    const uint64_t tick = v->stage->world->tick;
    const size_t line = v->tape.lines;
    const undo_change change = { .row = row, .going = going, .stands = v->paused,
                                 .line = line, .line_end = line + 1 };
    if (!may_change(v)
        || undo_set(&v->edits, v->stage, v->options, &change, text, &opened) != EXIT_DONE)
        return false;
    was_changed(v, param_of(row), tick, opened);
    tell_tape(v, param_of(row));
    return true;
}

void view_tape_changes(view *v)
{
    uint32_t count;
    const tp_param *params = tp_params(&count);
    for (uint32_t i = 0; i < count; i++) {
        char now[PANEL_TEXT], filed[PANEL_TEXT], setting[64 + PANEL_TEXT];
        tp_param_text(&v->stage->file.scene, &params[i], now, sizeof now);
        tp_param_text(&v->filed, &params[i], filed, sizeof filed);
        snprintf(setting, sizeof setting, "%s=%s", params[i].name, now);
        if (strcmp(now, filed) != 0)
            deck_set(&v->tape, v->base + v->stage->world->tick, setting);
    }
}

/* The tape forgets a change that is as if it had not been; a camera that goes back too
 * takes what led it since.  One that was made again is told again. */
static void tell_tape_undone(view *v, edit *change, undo_result result, bool again)
{
    const size_t lines = v->tape.lines;
    if (result == UNDO_WORLD || result == UNDO_ALL) {
        deck_drop(&v->tape, change->line, result == UNDO_ALL ? lines : change->line_end);
        return;
    }
    if (again) {
        change->line = lines;
        change->line_end = lines + 1;
    }
    tell_tape(v, param_of(change->row));
}

void view_undo(view *v, bool again)
{
    edit *done;
    bool opened = false;
    const uint64_t tick = v->stage->world->tick;
    if (!may_change(v))
        return;
    const undo_result result =
        (again ? undo_again : undo_back)(&v->edits, v->stage, v->options, &done, &opened);
    if (result == UNDO_NOTHING)
        view_say(v, again ? "nothing to make again" : "nothing to undo");
    if (result == UNDO_NOTHING || result == UNDO_REFUSED)
        return;
    const tp_param *param = param_of(done->row);
    was_changed(v, param, tick, opened);
    tell_tape_undone(v, done, result, again);
    view_say(v, "%s = %s", param->name, again ? done->after.value.text
                                              : done->before.value.text);
}

/* The way to look, and what the scene has to say for it. */
void view_look(view *v, look_mode mode)
{
    static const char *const words[] = { "none", "boat" };
    stage *s = v->stage;
    const tp_param *row = tp_param_find("camera.follow", strlen("camera.follow"));
    if (v->playing) {
        view_say(v, "a tape plays: F10 ends it");
        return;
    }
    if (!look_begin(&v->look, mode, s->world, &s->file.scene)) {
        view_say(v, "this scene has no %s", look_name(mode));
        return;
    }
    const tp_camera_follow follow = look_follow(&v->look, &v->filed);
    if ((int32_t)follow != s->file.scene.camera.follow)
        put(v, row, words[follow]);
    view_say(v, "%s", look_name(mode));
}

/* In degrees, 16.16, within half a turn. */
static int32_t degrees_of(tp_turn turn)
{
    return (int32_t)(((int64_t)(int32_t)turn * 360 + 0x8000) >> 16);
}

void view_begin_here(view *v)
{
    const tp_world *w = v->stage->world;
    const struct { const char *name; int32_t number; } camera[] = {
        { "camera.x", w->eye.x }, { "camera.y", w->eye.y }, { "camera.z", w->eye.z },
        { "camera.heading", degrees_of(w->heading) },
        { "camera.pitch", degrees_of(w->pitch) },
    };
    uint32_t count;
    if (v->stage->file.scene.camera.follow != v->filed.camera.follow) {
        view_say(v, "the scene cannot begin in this way to look");
        return;
    }
    for (size_t i = 0; i < sizeof camera / sizeof *camera; i++) {
        const tp_param *row = tp_param_find(camera[i].name, strlen(camera[i].name));
        char text[32];
        tp_param_number_text(row, camera[i].number, text, sizeof text);
        if (!view_set(v, (uint32_t)(row - tp_params(&count)), text, false))
            return;
    }
    view_say(v, "the scene begins here");
}

/* -- files ----------------------------------------------------------------------- */

void view_save(view *v)
{
    scene_file *file = &v->stage->file;
    const int32_t follow = file->scene.camera.follow;
    if (v->look.mode != LOOK_FREE)      /* a way to look is none of the scene's */
        file->scene.camera.follow = v->filed.camera.follow;
    if (v->saved_as && scene_save(file, v->saved_as) == EXIT_DONE) {
        v->filed = file->scene;
        view_say(v, "saved as %s", v->saved_as);
    }
    file->scene.camera.follow = follow;
}

int view_resume(view *v, const char *otherwise)
{
    session_state state;
    uint32_t number;
    int code = session_read(&state);
    if (code || !state.scene) {
        session_free(&state);
        return code ? code : view_open(v, otherwise) ? EXIT_DONE : EXIT_INPUT;
    }
    bool opened = view_open(v, state.scene);
    stage_setting *all = opened ? malloc((state.count + 1) * sizeof *all) : NULL;
    for (uint32_t i = 0; all && i < state.count; i++)
        all[i] = (stage_setting){ "--resume", state.settings[i] };
    if (all) {
        bool open = false;
        (void)stage_set_all(v->stage, v->options, all, state.count, &open);
        view_refit(v, open);
    }
    free(all);
    if (opened && session_world(&v->stage->file.scene, &v->stage->assets.names,
                                v->stage->world, v->stage->world_bytes, &number)) {
        v->picture = number;
        v->changed = true;
        say("going on with %s at picture %u", v->stage->file.name, (unsigned)number);
    }
    session_free(&state);
    return opened ? EXIT_DONE : EXIT_INPUT;
}

void view_keep(view *v, uint64_t now)
{
    const stage *s = v->stage;
    if (now - v->kept_at < KEEP_US)
        return;
    v->kept_at = now;
    session_offer(v->session, &s->file, &s->assets.names, s->world, s->world_bytes,
                  v->picture);
}
