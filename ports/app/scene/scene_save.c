/* SPDX-License-Identifier: MIT */
/* Saves a scene by editing the lines of its file.
 *
 * libinih reports the parameter and value that each line sets.  The position of the value
 * in the line follows from the report; the rest of the line is the user's own spelling and
 * stays unchanged.  After a value " ;" begins a comment, "#" does not: no text with " ;"
 * can be saved. */
#define _POSIX_C_SOURCE 200809L
#include "scene_save.h"
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "app/files/ini_read.h"
#include "app/files/log.h"
#include "app/files/output_file.h"
#include "app/files/path.h"
#include "long_name.h"
#include "older_grid.h"
#include "scene_lines.h"
#include "world/text.h"

#define LINE_MOST 199           /* bytes of a line with a comment */

typedef struct {
    const scene_file *file;
    const char *name;           /* name of the file to be written */
    scene_lines lines;
    uint32_t   *at;             /* for each row: last line that sets the row; 0: none */
    bool       *bad;            /* for each row: that line has an invalid value */
    tp_scene    filed;          /* the scene according to the lines */
    older_grid  older;          /* rows of the older grid in the lines */
    bool        moved;          /* the new file is in another folder */
} save;

/* -- reading the file ---------------------------------------------------------------- */

static bool take(void *user, uint32_t line, const char *section, const char *name,
                 const char *value)
{
    save *s = user;
    char full[256];
    uint32_t count;
    snprintf(full, sizeof full, "%s%s%s", section, section[0] ? "." : "", name);
    const tp_param *param = old_name_param(full, strlen(full));
    const long row = param ? (long)(param - tp_params(&count)) : LINE_OTHER;
    scene_lines_value(&s->lines, line, row, strlen(value));
    if (older_grid_has_row(full))
        older_grid_read(&s->older, NULL, line, full, value);
    if (!param)
        return true;                    /* refused when the scene was read */
    s->at[row] = line;
    value = scene_file_value(param, value);
    s->bad[row] = !value
               || tp_param_set(&s->filed, param, value, strlen(value), NULL) != TP_OK;
    return true;
}

/* Reads the lines; a deleted file is started anew. */
static int read_lines(save *s)
{
    const char *path = s->file->path;
    if (!path || access(path, F_OK) != 0)
        return EXIT_DONE;
    const int code = scene_lines_read(&s->lines, path);
    return code ? code : ini_read(path, take, s);
}

/* -- editing the lines --------------------------------------------------------------- */

/* Returns the text of a value.  A relative file name that leads from the new file to the
 * same target stays unchanged, and so does an absolute name given by a file. */
static char *format_saved_value(const save *s, const tp_param *param, uint32_t row)
{
    char value[TP_NAME_BYTES + 64];
    tp_param_text(&s->file->scene, param, value, sizeof value);
    const char *text = long_name_whole(value);
    const bool by_command = s->file->set_at[row] == SET_BY_COMMAND;
    if (!tp_param_is_file(param) || !text[0]
        || (!by_command && (!s->moved || text[0] == '/')))
        return path_copy(text, strlen(text));
    char *target = scene_file_resolve_path(s->file, param);
    char *there = path_beside(s->name, text);
    const bool known = target && there;
    const bool stays = known && text[0] != '/' && path_same_file(target, there);
    char *name = stays ? path_copy(text, strlen(text))
               : known ? path_make_relative(s->name, target) : NULL;
    free(target);
    free(there);
    return name;
}

/* Refuses a text that an INI file cannot hold, before anything is written. */
static int check_text(const save *s, const tp_param *param, const char *text)
{
    bool white = true;
    if (tp_param_is_file(param) && strlen(text) >= PATH_MAX)
        return log_fail(EXIT_INPUT, "%s: %s = %s: longer than %d bytes", s->name,
                        param->name, text, PATH_MAX - 1);
    for (const char *c = text; *c; white = isspace((unsigned char)*c++) != 0)
        if (*c == ';' && white)
            return log_fail(EXIT_INPUT,
                            "%s: %s = %s: \" ;\" begins a comment in an INI file;"
                            " expected a text without it",
                            s->name, param->name, text);
    return EXIT_DONE;
}

/* Returns the number that a file without the row's line gives. */
static int32_t number_without_line(const save *s, const tp_param *param)
{
    const tp_scene *scene = &s->file->scene;

    return param == tp_param_find("grid.vertices", 13) ? older_grid_vertices(&s->older, scene)
         : param == tp_param_find("tank.sea", 8) ? older_grid_sea(&s->older)
                                                 : param->normal;
}

/* True if a file without the line gives the row's value. */
static bool is_normal(const save *s, const tp_param *param, const char *text)
{
    char normal[64];

    tp_param_number_text(param, number_without_line(s, param), normal, sizeof normal);
    return strcmp(text, normal) == 0;
}

/* Edits the line of a value.  Values equal to the default are removed in a second pass
 * (away), after the others are in place: a section that gets new lines then stays at its
 * place. */
static int edit(save *s, const tp_param *param, uint32_t row, const char *text, bool away)
{
    char before[TP_NAME_BYTES + 64];
    tp_param_text(&s->filed, param, before, sizeof before);
    if ((strcmp(text, long_name_whole(before)) == 0 && !s->bad[row])
        || is_normal(s, param, text) != away)
        return EXIT_DONE;
    if (away) {
        scene_lines_remove(&s->lines, row);
        return EXIT_DONE;
    }
    const int code = check_text(s, param, text);
    if (code)
        return code;
    const bool done = s->at[row]
        ? scene_lines_replace(&s->lines, s->at[row], text, LINE_MOST)
        : scene_lines_append(&s->lines, param->name, text);
    return done ? EXIT_DONE : log_fail_memory(strlen(text));
}

static int edit_all(save *s, bool away)
{
    uint32_t count;
    const tp_param *params = tp_params(&count);
    int code = EXIT_DONE;
    for (uint32_t row = 0; row < count && !code; row++) {
        char *text = format_saved_value(s, &params[row], row);
        code = text ? edit(s, &params[row], row, text, away)
                    : log_fail_memory(TP_NAME_BYTES);
        free(text);
    }
    return code;
}

/* -- writing the file ---------------------------------------------------------------- */

static int write_file(const save *s)
{
    output_file out;
    const int code = output_file_open(&out, s->name);
    if (code)
        return code;
    scene_lines_write(&s->lines, out.file);
    return output_file_close(&out);
}

/* Sets a number of the filed scene, unless the file has a line. */
static void set_filed(const save *s, const char *name, int32_t *number)
{
    uint32_t count;
    const tp_param *param = tp_param_find(name, strlen(name));

    if (!s->at[param - tp_params(&count)])
        *number = number_without_line(s, param);
}

int scene_save(const scene_file *file, const char *name)
{
    uint32_t count;
    tp_params(&count);
    save s = { .file = file, .name = name,
               .at = calloc(count, sizeof *s.at), .bad = calloc(count, sizeof *s.bad) };
    tp_scene_level(&s.filed);
    s.moved = !file->path || !path_same_folder(file->path, name);
    int code = s.at && s.bad ? read_lines(&s) : log_fail_memory(count * sizeof *s.at);
    if (!code) {
        set_filed(&s, "grid.vertices", &s.filed.grid.vertices);
        set_filed(&s, "tank.sea", &s.filed.tank.sea);
        code = edit_all(&s, false);
    }
    if (!code)
        code = edit_all(&s, true);
    if (!code)
        code = write_file(&s);
    scene_lines_free(&s.lines);
    free(s.at);
    free(s.bad);
    return code;
}

/* -- the file's name ----------------------------------------------------------------- */

static bool is_shipped(const char *path)
{
    char *folder = path_of_scenes();
    char *beside = folder ? path_join(folder, "x", ".ini") : NULL;
    const bool shipped = beside && path_same_folder(path, beside);
    free(folder);
    free(beside);
    return shipped;
}

/* True if the file can be replaced: writing replaces the file, so the folder must be
 * writable too. */
static bool can_be_written(const char *path)
{
    char *folder = path_beside(path, ".");
    const bool can = folder && access(path, W_OK) == 0 && access(folder, W_OK) == 0;
    free(folder);
    return can;
}

char *scene_save_name(const scene_file *file)
{
    if (file->path && !is_shipped(file->path) && can_be_written(file->path))
        return path_copy(file->path, strlen(file->path));
    const size_t room = strlen(file->name) + 16;
    char *name = malloc(room);
    if (name)
        snprintf(name, room, "%s.ini", file->name);
    for (int number = 2; name && access(name, F_OK) == 0 && number < 10000; number++)
        snprintf(name, room, "%s-%d.ini", file->name, number);
    return name;
}
