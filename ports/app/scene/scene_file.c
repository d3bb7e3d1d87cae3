/* SPDX-License-Identifier: MIT */
/* Finds a scene, reads its file, and sets its values with messages for users.
 *
 * The file is read through libinih, numbers through the core's own reader.  A section and a
 * name in the section form the name of a parameter:
 *
 *     [wave0]
 *     steepness = 0.4         sets wave0.steepness */

#define _POSIX_C_SOURCE 200809L
#include "scene_file.h"
#include <ctype.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "app/files/did_you_mean.h"
#include "app/files/ini_read.h"
#include "app/files/log.h"
#include "app/files/path.h"
#include "long_name.h"
#include "world/text.h"

/* -- lines of a file ------------------------------------------------------------------ */

static bool apply_line(void *user, uint32_t line, const char *section, const char *name,
                       const char *value)
{
    scene_file *file = user;
    char full[128], place[PATH_MAX + 16];
    snprintf(full, sizeof full, "%s%s%s", section, section[0] ? "." : "", name);
    snprintf(place, sizeof place, "%s:%u", file->path, (unsigned)line);
    return scene_file_apply(file, place, line, full, value);
}

static int scene_ini_read(scene_file *file)
{
    return ini_read(file->path, apply_line, file);
}

/* -- one value ----------------------------------------------------------------------- */

/* Returns the best match if an old name is nearer than every present name, else NULL. */
static const old_name *offer_old_names(did_you_mean *best)
{
    uint32_t count;
    const old_name *names = old_names(&count), *nearest = NULL;
    for (uint32_t i = 0; i < count; i++) {
        const unsigned before = best->distance;
        did_you_mean_offer(best, names[i].old);
        nearest = best->distance < before ? &names[i] : nearest;
    }
    return nearest;
}

static void refuse_name(const char *place, const char *name)
{
    uint32_t count;
    const tp_param *params = tp_params(&count);
    did_you_mean best = did_you_mean_make(name);
    for (uint32_t i = 0; i < count; i++)
        did_you_mean_offer(&best, params[i].name);
    const old_name *const old = offer_old_names(&best);
    const char *const why = old_name_why_gone(name, strlen(name));
    if (why)
        log_line("%s: %s is gone, %s; delete it", place, name, why);
    else if (old)
        log_line("%s: no parameter is called %s; did you mean %s, once called %s?", place,
                 name, old->now, old->old);
    else if (best.name)
        log_line("%s: no parameter is called %s; did you mean %s?", place, name, best.name);
    else
        log_line("%s: no parameter is called %s; `tidepool params` lists them", place,
                 name);
}

/* name: the row's name as given, possibly an old one. */
static void refuse_value(const char *place, const tp_param *param, const char *name,
                         const char *value, const tp_error *err)
{
    char low[32], high[32], sentence[256], row[TP_NAME_BYTES];
    const char *gap = param->unit[0] ? " " : "";
    const bool is_old = strcmp(name, param->name) != 0;
    snprintf(row, sizeof row, "%s%s%s%s", param->name, is_old ? " (once called " : "",
             is_old ? name : "", is_old ? ")" : "");
    switch (err->code) {
    case TP_E_RANGE:
        tp_param_number_text(param, err->a, low, sizeof low);
        tp_param_number_text(param, err->b, high, sizeof high);
        log_line("%s: %s = %s is outside %s..%s%s%s%s", place, row, value, low,
                 high, gap, param->unit, log_check_place(err));
        break;
    case TP_E_CHOICE:
        log_line("%s: %s = %s is none of %s%s", place, row, value,
            param->kind == TP_PARAM_BOOL ? "off|on" : param->unit, log_check_place(err));
        break;
    default:
        tp_error_text(err, sentence, sizeof sentence);
        log_line("%s: %s: %s%s", place, row, sentence, log_check_place(err));
    }
}

static bool has_control(const char *text, size_t bytes)
{
    for (size_t i = 0; i < bytes; i++)
        if (iscntrl((unsigned char)text[i]))
            return true;
    return false;
}

/* Returns text with control characters unchanged: the table of parameters refuses the
 * text. */
const char *scene_file_value(const tp_param *param, const char *value)
{
    const char *text = value + strspn(value, " \t\r\n");
    size_t bytes = strlen(text);
    while (bytes > 0 && isspace((unsigned char)text[bytes - 1]))
        bytes--;
    if (!tp_param_is_file(param) || bytes < TP_NAME_BYTES || has_control(text, bytes))
        return value;
    return long_name_shorten(text, bytes);
}

/* Checks the value in an empty scene: the allowed values depend on the row alone. */
const tp_param *scene_file_check(const char *place, const char *setting,
                                 const char **value)
{
    const char *equals = strchr(setting, '=');
    if (!equals || equals == setting) {
        log_line("%s: expected NAME=VALUE, found %s", place,
                 *setting ? setting : "nothing");
        return NULL;
    }
    tp_scene scene = { 0 };
    char *name = path_copy(setting, (size_t)(equals - setting));
    const tp_param *param = name ? old_name_param(name, strlen(name)) : NULL;
    tp_error err = { 0 };
    *value = equals + 1;
    if (!name) {
        log_fail_memory(strlen(setting));
    } else if (!param) {
        refuse_name(place, name);
    } else if (!(*value = scene_file_value(param, *value))) {
        param = NULL;
    } else if (tp_param_set(&scene, param, *value, strlen(*value), &err)) {
        refuse_value(place, param, name, *value, &err);
        param = NULL;
    }
    free(name);
    return param;
}

bool scene_file_apply(scene_file *file, const char *place, uint32_t set_at,
                      const char *name, const char *value)
{
    const tp_param *param = old_name_param(name, strlen(name));
    if (set_at != SET_BY_COMMAND && older_grid_has_row(name))
        return older_grid_read(&file->older, place, set_at, name, value);
    if (!param) {
        refuse_name(place, name);
        return false;
    }
    tp_error err = { 0 };
    value = scene_file_value(param, value);
    if (!value)
        return false;
    if (tp_param_set(&file->scene, param, value, strlen(value), &err)) {
        refuse_value(place, param, name, value, &err);
        return false;
    }
    uint32_t count;
    file->set_at[param - tp_params(&count)] = set_at;
    const bool by_command = set_at == SET_BY_COMMAND;
    (void)old_name_note_add(by_command ? &file->old_by_command : &file->old_in_file, name,
                            strlen(name), by_command ? 0 : set_at);
    return true;
}

int scene_file_set(scene_file *file, const char *setting)
{
    const char *equals = strchr(setting, '=');
    if (!equals || equals == setting)
        return log_fail(EXIT_USAGE, "tidepool: --set %s: expected name=value",
                    *setting ? setting : "''");
    char *name = path_copy(setting, (size_t)(equals - setting));
    if (!name)
        return log_fail_memory(strlen(setting));
    const bool done = scene_file_apply(file, "--set", SET_BY_COMMAND, name, equals + 1);
    free(name);
    return done ? EXIT_DONE : EXIT_USAGE;
}

/* -- the file ------------------------------------------------------------------------ */

static int refuse_scene(const char *given, const char *folder)
{
    if (!folder)
        return log_fail(EXIT_INPUT, "%s: no such file, and no shipped scenes were found"
                    " beside the program", given);
    size_t count;
    char **names = path_scene_names(folder, &count);
    did_you_mean best = did_you_mean_make(given);
    for (size_t i = 0; i < count; i++)
        did_you_mean_offer(&best, names[i]);
    if (best.name)
        log_line("%s: no such scene or file; did you mean %s?", given, best.name);
    else
        log_line("%s: no such scene or file; `tidepool scenes` lists the scenes", given);
    path_free_names(names, count);
    return EXIT_INPUT;
}

/* Finds the file.  A plain word is first a shipped scene's name, then a file name. */
static int find_path(scene_file *file, const char *given)
{
    if (strchr(given, '/') || path_ends(given, ".ini")) {
        file->path = path_copy(given, strlen(given));
        return file->path ? EXIT_DONE : log_fail_memory(strlen(given));
    }
    char *folder = path_of_scenes();
    int code = EXIT_DONE;
    if (folder)
        file->path = path_join(folder, given, ".ini");
    if (!file->path || !path_is_file(file->path)) {
        free(file->path);
        file->path = access(given, F_OK) == 0 ? path_copy(given, strlen(given)) : NULL;
        if (!file->path)
            code = refuse_scene(given, folder);
    }
    free(folder);
    return code;
}

int scene_file_find(scene_file *file, const char *given)
{
    *file = (scene_file){ 0 };
    tp_scene_level(&file->scene);
    uint32_t count;
    tp_params(&count);
    const int code = find_path(file, given);
    if (code)
        return code;
    file->name = path_stem(file->path);
    file->set_at = calloc(count, sizeof *file->set_at);
    if (!file->name || !file->set_at)
        return log_fail_memory(count * sizeof *file->set_at);
    return EXIT_DONE;
}

/* Returns the line of the file that set a row, 0: none. */
static uint32_t file_line(const scene_file *file, const char *name)
{
    uint32_t count;
    const tp_param *param = tp_param_find(name, strlen(name));
    return param ? file->set_at[param - tp_params(&count)] : 0;
}

void scene_file_read_older_grid(scene_file *file)
{
    tp_scene *s = &file->scene;

    if (!file_line(file, "tank.sea"))
        s->tank.sea = older_grid_sea(&file->older);
    if (!file_line(file, "grid.vertices"))
        s->grid.vertices = older_grid_vertices(&file->older, s);
}

int scene_file_open(scene_file *file, const char *given)
{
    const int code = scene_file_find(file, given);
    if (code)
        return code;
    const int read = scene_ini_read(file);
    if (!read)
        scene_file_read_older_grid(file);
    return read;
}

void scene_file_report_old_names(const scene_file *file)
{
    if (file->older.line && !file_line(file, "grid.vertices"))
        log_line("%s:%u: grid.cols and grid.rows are read as grid.vertices = %d until version "
                 OLD_NAMES_END "; grid.cell, grid.reach and grid.follow have no effect;"
                 " `tidepool check %s --write` rewrites them",
                 file->path, (unsigned)file->older.line, (int)file->scene.grid.vertices,
                 file->path);
    old_name_note_print(&file->old_in_file, file->path, file->path);
    old_name_note_print(&file->old_by_command, "--set", NULL);
}

void scene_file_close(scene_file *file)
{
    free(file->name);
    free(file->path);
    free(file->set_at);
    *file = (scene_file){ 0 };
}

/* -- names in the scene -------------------------------------------------------------- */

static const char *by(const scene_file *file)
{
    return file->by ? file->by : "--set";
}

static uint32_t param_row(const tp_param *param)
{
    uint32_t count;
    return (uint32_t)(param - tp_params(&count));
}

char *scene_file_resolve_path(const scene_file *file, const tp_param *param)
{
    char text[TP_NAME_BYTES];
    tp_param_text(&file->scene, param, text, sizeof text);
    const char *name = long_name_whole(text);
    if (file->set_at[param_row(param)] == SET_BY_COMMAND && path_is_file(name))
        return path_copy(name, strlen(name));
    char *beside = path_beside(file->path, name);
    if (file->set_at[param_row(param)] != SET_BY_COMMAND
        || (beside && path_is_file(beside)))
        return beside;
    free(beside);
    return path_copy(name, strlen(name));
}

void scene_file_text(const scene_file *file, const tp_param *param, char *text,
                     size_t bytes)
{
    const size_t length = tp_param_text(&file->scene, param, text, bytes);
    char *path = tp_param_is_file(param) && length > 0
                     ? scene_file_resolve_path(file, param)
                     : NULL;
    const char *value = path ? scene_file_value(param, path) : NULL;
    if (value)
        snprintf(text, bytes, "%s", value);
    free(path);
}

int scene_file_refuse(const scene_file *file, const tp_error *err)
{
    const tp_param *param = tp_param_find(err->word, strlen(err->word));
    const uint32_t line = param ? file->set_at[param_row(param)] : 0;
    tp_error there = *err;
    if (line == SET_BY_COMMAND) {
        log_fail_error(by(file), err);
        return EXIT_USAGE;
    }
    there.where = line;
    return log_fail_error(line ? file->path : file->name, &there);
}

void scene_file_who(const scene_file *file, const tp_param *param, char *text,
                    size_t bytes)
{
    const uint32_t line = file->set_at[param_row(param)];
    if (line == SET_BY_COMMAND)
        snprintf(text, bytes, "%s: %s", by(file), param->name);
    else if (line)
        snprintf(text, bytes, "%s:%u: %s", file->path, (unsigned)line, param->name);
    else
        snprintf(text, bytes, "%s: %s", file->name, param->name);
}
