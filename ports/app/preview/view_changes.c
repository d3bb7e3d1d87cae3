/* SPDX-License-Identifier: MIT */
/* Changes of the shown scene: values, undo, saving, the session for --resume.  A change
 * goes to three places at once: the scene, the tape, and the undo list. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/scene/scene_save.h"
#include "interact/setting.h"
#include "view.h"
#include "world/text.h"
#include "world/world.h"

#define KEEP_US 1000000u

/* -- values -------------------------------------------------------------------------- */

static const tp_param *row_param(uint32_t row)
{
    uint32_t count;
    return &tp_params(&count)[row];
}

/* To call before the loaded scene changes.  Returns false while a tape plays. */
static bool may_change(view *v)
{
    if (v->playing)
        view_say(v, "a tape plays: F10 ends it");
    else
        compare_forget(v->compare);
    return !v->playing;
}

/* To call after the loaded scene has changed; `tick` is the world's tick before the change.
 * A changed file name makes the kept worlds useless, because they refer to other files. */
static void was_changed(view *v, const tp_param *param, uint64_t tick, bool opened)
{
    v->base += tick - v->loaded->world->tick;
    if (setting_names_files(param))
        rewind_forget(v->history);
    v->changed = true;
    view_refit(v, opened);
}

/* Records the parameter's current value on the tape. */
static void tell_tape(view *v, const tp_param *param)
{
    char text[PANEL_TEXT], setting[64 + PANEL_TEXT];
    scene_file_text(&v->loaded->file, param, text, sizeof text);
    snprintf(setting, sizeof setting, "%s=%s", param->name, text);
    tape_file_add_setting(&v->tape, v->base + v->loaded->world->tick, setting);
}

/* Sets a value without an entry in the undo list. */
static bool put(view *v, const tp_param *param, const char *text)
{
    char setting[64 + PANEL_TEXT];
    bool opened = false;
    const uint64_t tick = v->loaded->world->tick;
    snprintf(setting, sizeof setting, "%s=%s", param->name, text);
    if (!may_change(v)
        || loaded_scene_set(v->loaded, v->options, "the panel", setting, &opened)
               != EXIT_DONE)
        return false;
    was_changed(v, param, tick, opened);
    tell_tape(v, param);
    return true;
}

bool view_set(view *v, uint32_t row, const char *text, bool going)
{
    bool opened = false;
    const uint64_t tick = v->loaded->world->tick;
    const size_t line = v->tape.lines;
    const undo_change change = { .row = row, .going = going, .stands = v->paused,
                                 .line = line, .line_end = line + 1 };
    if (!may_change(v)
        || undo_set(&v->edits, v->loaded, v->options, &change, text, &opened) != EXIT_DONE)
        return false;
    view_hush(v);
    was_changed(v, row_param(row), tick, opened);
    tell_tape(v, row_param(row));
    return true;
}

void view_tape_changes(view *v)
{
    uint32_t count;
    const tp_param *params = tp_params(&count);
    for (uint32_t i = 0; i < count; i++) {
        char now[PANEL_TEXT], filed[PANEL_TEXT], setting[64 + PANEL_TEXT];
        tp_param_text(&v->loaded->file.scene, &params[i], now, sizeof now);
        tp_param_text(&v->filed, &params[i], filed, sizeof filed);
        snprintf(setting, sizeof setting, "%s=%s", params[i].name, now);
        if (strcmp(now, filed) != 0)
            tape_file_add_setting(&v->tape, v->base + v->loaded->world->tick, setting);
    }
}

/* Brings the tape in line with an undo or redo.  If the undo restored the world from
 * before the change, the change's tape lines are dropped; if it restored the camera too,
 * all later lines are dropped.  Otherwise the new value is recorded as a new line. */
static void tell_tape_undone(view *v, undo_edit *change, undo_result result, bool again)
{
    const size_t lines = v->tape.lines;
    if (result == UNDO_WORLD || result == UNDO_ALL) {
        tape_file_drop(&v->tape, change->line,
                       result == UNDO_ALL ? lines : change->line_end);
        return;
    }
    if (again) {
        change->line = lines;
        change->line_end = lines + 1;
    }
    tell_tape(v, row_param(change->row));
}

void view_undo(view *v, bool again)
{
    undo_edit *done;
    bool opened = false;
    const uint64_t tick = v->loaded->world->tick;
    if (!may_change(v))
        return;
    const undo_result result =
        (again ? undo_again : undo_back)(&v->edits, v->loaded, v->options, &done, &opened);
    if (result == UNDO_NOTHING)
        view_say(v, again ? "nothing to redo" : "nothing to undo");
    if (result == UNDO_NOTHING || result == UNDO_REFUSED)
        return;
    const tp_param *param = row_param(done->row);
    was_changed(v, param, tick, opened);
    tell_tape_undone(v, done, result, again);
    view_say(v, "%s = %s", param->name, again ? done->after.value.text
                                              : done->before.value.text);
}

/* Selects a camera mode, and sets camera.follow as the mode needs. */
void view_look(view *v, camera_mode_kind mode)
{
    static const char *const words[] = { "none", "boat" };
    loaded_scene *s = v->loaded;
    const tp_param *row = tp_param_find("camera.follow", strlen("camera.follow"));
    if (v->playing) {
        view_say(v, "a tape plays: F10 ends it");
        return;
    }
    if (!camera_mode_begin(&v->camera_mode, mode, s->world, &s->file.scene)) {
        view_say(v, "this scene has no %s", camera_mode_name(mode));
        return;
    }
    const tp_camera_follow follow = camera_mode_follow(&v->camera_mode, &v->filed);
    if ((int32_t)follow != s->file.scene.camera.follow)
        put(v, row, words[follow]);
    view_say(v, "%s", camera_mode_name(mode));
}

/* Converts a turn to degrees in Q16.16, within -180..180. */
static int32_t turn_degrees(tp_turn turn)
{
    return (int32_t)(((int64_t)(int32_t)turn * 360 + 0x8000) >> 16);
}

void view_begin_here(view *v)
{
    const tp_world *w = v->loaded->world;
    const struct { const char *name; int32_t number; } camera[] = {
        { "camera.x", w->eye.x }, { "camera.y", w->eye.y }, { "camera.z", w->eye.z },
        { "camera.heading", turn_degrees(w->heading) },
        { "camera.pitch", turn_degrees(w->pitch) },
    };
    uint32_t count;
    if (v->loaded->file.scene.camera.follow != v->filed.camera.follow) {
        view_say(v, "the scene cannot start in this camera mode");
        return;
    }
    for (size_t i = 0; i < sizeof camera / sizeof *camera; i++) {
        const tp_param *row = tp_param_find(camera[i].name, strlen(camera[i].name));
        char text[32];
        tp_param_number_text(row, camera[i].number, text, sizeof text);
        if (!view_set(v, (uint32_t)(row - tp_params(&count)), text, false))
            return;
    }
    view_say(v, "the scene starts at this camera");
}

/* -- files --------------------------------------------------------------------------- */

void view_save(view *v)
{
    scene_file *file = &v->loaded->file;
    const int32_t follow = file->scene.camera.follow;
    if (v->camera_mode.mode != CAMERA_FREE) /* the camera mode is not part of the scene */
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
    loaded_scene_setting *all = opened ? malloc((state.count + 1) * sizeof *all) : NULL;
    for (uint32_t i = 0; all && i < state.count; i++)
        all[i] = (loaded_scene_setting){ "--resume", state.settings[i] };
    if (all) {
        bool open = false;
        (void)loaded_scene_set_all(v->loaded, v->options, all, state.count, &open);
        view_refit(v, open);
    }
    free(all);
    if (opened && session_world(&v->loaded->file.scene, &v->loaded->assets.names,
                                v->loaded->world, v->loaded->world_bytes, &number)) {
        v->picture = number;
        v->changed = true;
        log_line("continuing %s at picture %u", v->loaded->file.name, (unsigned)number);
    }
    session_free(&state);
    return opened ? EXIT_DONE : EXIT_INPUT;
}

void view_keep(view *v, uint64_t now)
{
    const loaded_scene *s = v->loaded;
    if (now - v->kept_at < KEEP_US)
        return;
    v->kept_at = now;
    session_offer(v->session, &s->file, &s->assets.names, s->world, s->world_bytes,
                  v->picture);
}
