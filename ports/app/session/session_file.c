/* SPDX-License-Identifier: MIT */
/* Writes and reads the session's file. */
#define _XOPEN_SOURCE 700       /* for realpath */
#include "session_file.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "app/files/ini_read.h"
#include "app/files/log.h"
#include "app/files/path.h"
#include "app/files/string_list.h"
#include "app/scene/long_name.h"
#include "pixel/pixel.h"
#include "world/text.h"

#define PART 120                /* bytes of a value per line */
#define HEAD "# State of `tidepool view`, for --resume.\n[session]\nworld = "

/* -- the folder ---------------------------------------------------------------------- */

/* Makes a folder and its parents like mkdir -p, with mode 0700 as the XDG rules demand. */
static bool make_folder(char *path)
{
    for (char *c = path + 1; *c; c++) {
        if (*c != '/')
            continue;
        *c = 0;
        const bool bad = mkdir(path, 0700) != 0 && errno != EEXIST;
        *c = '/';
        if (bad)
            return false;
    }
    return (mkdir(path, 0700) == 0 || errno == EEXIST)
        && access(path, W_OK | X_OK) == 0;
}

char *session_folder(bool make, int *why)
{
    const char *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    const bool told = state && state[0] == '/';         /* XDG ignores relative paths */
    *why = 0;
    if (!told && (!home || !home[0]))
        return NULL;
    char *folder = told ? path_join(state, "tidepool", "")
                        : path_join(home, ".local/state/tidepool", "");
    *why = ENOMEM;
    if (!folder || !make || make_folder(folder))
        return folder;
    *why = errno;
    free(folder);
    return NULL;
}

/* -- writing ------------------------------------------------------------------------- */

static void put_value(FILE *to, const char *name, const char *value)
{
    int column = 0;
    fprintf(to, "%s = ", name);
    for (const char *c = value; *c; c++) {
        const unsigned char byte = (unsigned char)*c;
        if (column >= PART) {
            fprintf(to, "\n%s = ", name);
            column = 0;
        }
        if (byte <= ' ' || byte == 127 || byte == '%' || byte == ';')
            column += fprintf(to, "%%%02x", byte);
        else
            column += putc(byte, to) != EOF;
    }
    putc('\n', to);
}

/* Writes a path as absolute, even if the file is gone. */
static void put_path(FILE *to, const char *name, const char *path)
{
    char *real = realpath(path, NULL), here[4096];
    char *joined = !real && path[0] != '/' && getcwd(here, sizeof here)
                 ? path_join(here, path, "") : NULL;
    put_value(to, name, real ? real : joined ? joined : path);
    free(real);
    free(joined);
}

/* Writes a value set by hand; the path of a file is made absolute. */
static void put_row(FILE *to, const scene_file *file, const tp_param *param)
{
    char text[TP_NAME_BYTES + 64];
    const char *dot = strchr(param->name, '.');
    tp_param_text(&file->scene, param, text, sizeof text);
    const char *name = long_name_whole(text);
    char *real = tp_param_is_file(param) && name[0] ? realpath(name, NULL) : NULL;
    fprintf(to, "[%.*s]\n", (int)(dot - param->name), param->name);
    put_value(to, dot + 1, real ? real : name);
    free(real);
}

static char *settings_text(const scene_file *file)
{
    uint32_t count;
    char *text = NULL;
    size_t bytes;
    const tp_param *params = tp_params(&count);
    FILE *to = open_memstream(&text, &bytes);
    if (!to)
        return NULL;
    put_path(to, "scene", file->path);
    for (uint32_t i = 0; i < count; i++)
        if (file->set_at[i] == SET_BY_COMMAND)
            put_row(to, file, &params[i]);
    if (fclose(to) == 0)
        return text;
    free(text);
    return NULL;
}

static void name_world(session_world_name *world, const char *settings)
{
    const uint32_t crc = tp_crc32(0, settings, strlen(settings));
    snprintf(world->name, sizeof world->name, SESSION_WORLD "%08x", (unsigned)crc);
}

char *session_text(const scene_file *file, session_world_name *world)
{
    char *settings = settings_text(file);
    const size_t room = settings ? strlen(settings) + sizeof HEAD + 24 : 0;
    char *text = settings ? malloc(room) : NULL;
    if (text) {
        name_world(world, settings);
        snprintf(text, room, "%s%s\n%s", HEAD, world->name, settings);
    }
    free(settings);
    return text;
}

void session_nameless(tp_scene *to, const tp_scene *scene)
{
    uint32_t count;
    const tp_param *params = tp_params(&count);
    *to = *scene;
    for (uint32_t i = 0; i < count; i++)
        if (tp_param_is_file(&params[i]))
            (void)tp_param_set(to, &params[i], "", 0, NULL);
}

/* -- reading ------------------------------------------------------------------------- */

static char *slurp(FILE *file)
{
    char *text = NULL;
    size_t room = 0;
    if (getdelim(&text, &room, 0, file) >= 0)
        return text;
    free(text);
    return ferror(file) ? NULL : path_copy("", 0);
}

/* True if the name in the head is the CRC of the text after it. */
static bool is_whole(const char *text, session_world_name *world)
{
    const size_t head = strlen(HEAD), name = strlen(SESSION_WORLD) + 8;
    if (strncmp(text, HEAD, head) != 0 || strlen(text) <= head + name
        || text[head + name] != '\n')
        return false;
    name_world(world, text + head + name + 1);
    return strncmp(text + head, world->name, name) == 0;
}

char *session_load(const char *folder, session_world_name *world, int *code)
{
    char *path = path_join(folder, SESSION_INI, "");
    FILE *file = path ? fopen(path, "rb") : NULL;
    char *text = file ? slurp(file) : NULL;
    *code = EXIT_DONE;
    if (!text && path && !file && (errno == ENOENT || errno == ENOTDIR)) {
        log_line("%s: no saved state: a fresh start", path);
    } else if (!text) {
        *code = log_fail(EXIT_INPUT, "%s: %s: nothing to resume", path ? path : folder,
                         strerror(errno));
    } else if (!is_whole(text, world)) {
        log_line("%s: incomplete: a fresh start", path);
        free(text);
        text = NULL;
    }
    if (file)
        fclose(file);
    free(path);
    return text;
}

/* -- settings ------------------------------------------------------------------------ */

typedef struct {
    char    last[160];          /* name of the last line */
    string_list   list;               /* "name=value", encoded */
} lines;

static bool take(void *user, uint32_t line, const char *section, const char *name,
                 const char *value)
{
    lines *l = user;
    char full[160];
    (void)line;
    snprintf(full, sizeof full, "%s.%s=", section, name);
    const bool goes_on = strcmp(full, l->last) == 0;
    memcpy(l->last, full, sizeof full);
    const char *begin = goes_on ? l->list.of[l->list.count - 1] : full;
    const size_t bytes = strlen(begin) + strlen(value) + 1;
    char *text = malloc(bytes);
    if (!text)
        return log_fail_memory(bytes) == EXIT_DONE;
    strcpy(stpcpy(text, begin), value);
    if (goes_on) {
        free(l->list.of[l->list.count - 1]);
        l->list.of[l->list.count - 1] = text;
        return true;
    }
    const bool added = string_list_add(&l->list, text, strlen(text));
    free(text);
    return added || log_fail_memory(bytes) == EXIT_DONE;
}

static void decode(char *text)
{
    char *to = text;
    for (const char *c = text; *c; c++) {
        char digits[3] = "", *end = digits;
        if (*c == '%' && c[1] && c[2]) {
            memcpy(digits, c + 1, 2);
            *to = (char)strtoul(digits, &end, 16);
        }
        if (end == digits + 2)
            c += 2;
        else
            *to = *c;
        to++;
    }
    *to = 0;
}

/* Converts the list; its first two entries are session.world and session.scene. */
static int to_state(lines *l, session_state *state)
{
    static const char scene[] = "session.scene=";
    if (l->list.count < 2 || strncmp(l->list.of[1], scene, strlen(scene)) != 0)
        return log_fail(EXIT_INPUT, SESSION_INI ": no scene: nothing to resume");
    for (size_t i = 0; i < l->list.count; i++)
        decode(l->list.of[i]);
    state->scene = path_copy(l->list.of[1] + strlen(scene),
                             strlen(l->list.of[1]) - strlen(scene));
    free(l->list.of[0]);
    free(l->list.of[1]);
    state->count = (uint32_t)l->list.count - 2;
    memmove(l->list.of, l->list.of + 2, state->count * sizeof *l->list.of);
    state->settings = l->list.of;
    l->list = (string_list){ 0 };
    return state->scene ? EXIT_DONE : log_fail_memory(TP_NAME_BYTES);
}

int session_read(session_state *state)
{
    int why;
    session_world_name world;
    lines l = { .last = "" };
    *state = (session_state){ 0 };
    char *folder = session_folder(false, &why);
    if (!folder)
        return log_fail(EXIT_DONE, "tidepool view: neither XDG_STATE_HOME nor HOME is set:"
                    " a fresh start");
    int code;
    char *text = session_load(folder, &world, &code);
    char *path = text ? path_join(folder, SESSION_INI, "") : NULL;
    if (text)
        code = path ? ini_read(path, take, &l) : log_fail_memory(strlen(folder));
    if (text && !code)
        code = to_state(&l, state);
    string_list_free(&l.list);
    free(path);
    free(text);
    free(folder);
    return code;
}

void session_free(session_state *state)
{
    for (uint32_t i = 0; i < state->count; i++)
        free(state->settings[i]);
    free(state->settings);
    free(state->scene);
    *state = (session_state){ 0 };
}
