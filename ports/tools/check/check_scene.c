/* SPDX-License-Identifier: MIT */
/* Reads the scene like the other commands, but continues after a bad line: all faults are
 * printed at once.  Old names are rewritten in the file's own lines: comments, order and
 * spacing stay. */
#define _POSIX_C_SOURCE 200809L
#include "check_scene.h"
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/ini_read.h"
#include "app/files/log.h"
#include "app/files/output_file.h"
#include "app/scene/loaded_scene.h"
#include "app/scene/older_grid.h"
#include "app/scene/scene_lines.h"
#include "world/text.h"

/* A line that is rewritten: with an old name, or with a row of the older grid (NULL). */
typedef struct {
    uint32_t        line;
    const old_name *name;
    size_t          value_bytes;
} old_line;

typedef struct {
    scene_file   *file;
    old_line     *old;
    size_t        n_old;
    unsigned      values, faults;
} scene_check;

/* -- lines --------------------------------------------------------------------------- */

/* Notes a line with an old name, or with a row of the older grid: `name` is NULL. */
static bool add_old(scene_check *c, uint32_t line, const old_name *name, size_t value_bytes)
{
    const size_t bytes = (c->n_old + 1) * sizeof *c->old;
    old_line *more = realloc(c->old, bytes);
    if (!more) {
        log_fail_memory(bytes);
        return false;
    }
    more[c->n_old++] = (old_line){ line, name, value_bytes };
    c->old = more;
    return true;
}

static bool take(void *user, uint32_t line, const char *section, const char *name,
                 const char *value)
{
    scene_check *c = user;
    char full[128], place[PATH_MAX + 16];
    snprintf(full, sizeof full, "%s%s%s", section, section[0] ? "." : "", name);
    snprintf(place, sizeof place, "%s:%u", c->file->path, (unsigned)line);
    c->values++;
    c->faults += !scene_file_apply(c->file, place, line, full, value);
    if (older_grid_has_row(full))
        return add_old(c, line, NULL, strlen(value));
    const old_name *old = old_name_find(full, strlen(full));
    return !old || add_old(c, line, old, strlen(value));
}

static int check_lines(scene_check *c)
{
    const int code = ini_read(c->file->path, take, c);
    scene_file_read_older_grid(c->file);
    return code ? code : c->faults ? EXIT_INPUT : EXIT_DONE;
}

/* -- old names ----------------------------------------------------------------------- */

static const char *member(const char *name)
{
    return strchr(name, '.') + 1;
}

static int report(const scene_check *c)
{
    const char *path = c->file->path;
    for (size_t i = 0; i < c->n_old; i++)
        if (c->old[i].name)
            log_line("%s:%u: %s is now called %s", path, (unsigned)c->old[i].line,
                     c->old[i].name->old, c->old[i].name->now);
    if (c->file->older.line)
        log_line("%s:%u: grid.vertices = %d replaces the rows of the older grid", path,
                 (unsigned)c->file->older.line, (int)c->file->scene.grid.vertices);
    return log_fail(EXIT_CHECK,
                    "%s: old names are read until version " OLD_NAMES_END
                    "; `tidepool check %s --write` rewrites them", path, path);
}

static int write_lines(const scene_lines *l, const char *path)
{
    output_file out;
    const int code = output_file_open(&out, path);
    if (code)
        return code;
    scene_lines_write(l, out.file);
    return output_file_close(&out);
}

static int rename_lines(const scene_check *c, scene_lines *l)
{
    for (size_t i = 0; i < c->n_old; i++) {
        const old_name *name = c->old[i].name;
        if (name && !scene_lines_rename(l, c->old[i].line, member(name->old),
                                        member(name->now)))
            return log_fail(EXIT_INPUT, "%s:%u: %s cannot be rewritten: no memory, or the"
                            " file is being changed", c->file->path,
                            (unsigned)c->old[i].line, name->old);
    }
    return EXIT_DONE;
}

/* Adds a row whose value the file gives by rows of the older grid alone. */
static bool append_older(const scene_check *c, scene_lines *l, const char *name)
{
    uint32_t count;
    const tp_param *param = tp_param_find(name, strlen(name));
    char text[TP_NAME_BYTES], normal[64];

    if (c->file->set_at[param - tp_params(&count)])
        return true;
    tp_param_text(&c->file->scene, param, text, sizeof text);
    tp_param_number_text(param, param->normal, normal, sizeof normal);
    return strcmp(text, normal) == 0 || scene_lines_append(l, name, text);
}

/* Puts grid.vertices in the place of the older grid's rows. */
static int replace_older(const scene_check *c, scene_lines *l)
{
    for (size_t i = 0; i < c->n_old; i++)
        if (!c->old[i].name)
            scene_lines_value(l, c->old[i].line, LINE_OLDER_GRID, c->old[i].value_bytes);
    if (c->file->older.line
        && !(append_older(c, l, "grid.vertices") && append_older(c, l, "tank.sea")))
        return log_fail_memory(TP_NAME_BYTES);
    scene_lines_remove(l, LINE_OLDER_GRID);
    return EXIT_DONE;
}

static int rewrite(const scene_check *c)
{
    scene_lines l = { 0 };
    int code = scene_lines_read(&l, c->file->path);
    if (!code)
        code = rename_lines(c, &l);
    if (!code)
        code = replace_older(c, &l);
    if (!code)
        code = write_lines(&l, c->file->path);
    scene_lines_free(&l);
    for (size_t i = 0; i < c->n_old && !code; i++)
        if (c->old[i].name)
            printf("%s:%u: %s is now %s\n", c->file->path, (unsigned)c->old[i].line,
                   c->old[i].name->old, c->old[i].name->now);
    if (c->file->older.line && !code)
        printf("%s:%u: grid.vertices = %d replaces the rows of the older grid\n",
               c->file->path, (unsigned)c->file->older.line,
               (int)c->file->scene.grid.vertices);
    return code;
}

/* -- the scene ----------------------------------------------------------------------- */

static int check_world(loaded_scene *s, const options *o)
{
    options strict = *o;
    strict.strict = true;
    int code = loaded_scene_load_assets(s, &s->assets, &strict);
    if (!code)
        code = loaded_scene_make_world(s);
    return code;
}

static int check_file(loaded_scene *s, const options *o, scene_check *c)
{
    int code = check_lines(c);
    if (code)
        return code;
    if (c->n_old)
        code = o->write ? rewrite(c) : report(c);
    const int world = check_world(s, o);
    return world ? world : code;
}

int check_scene(const options *o)
{
    loaded_scene s = { 0 };
    scene_check c = { .file = &s.file };
    int code = scene_file_find(&s.file, o->scene);
    if (!code)
        code = check_file(&s, o, &c);
    if (!code)
        printf("%s: %u values, no fault\n", s.file.path, c.values);
    free(c.old);
    loaded_scene_close(&s);
    return code;
}
