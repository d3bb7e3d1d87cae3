/* SPDX-License-Identifier: MIT */
/* File names, and the folder of the shipped scenes. */
#define _XOPEN_SOURCE 700       /* for realpath */
#include "path.h"
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define EXE_BYTES 4096

char *path_copy(const char *text, size_t bytes)
{
    char *copy = malloc(bytes + 1);
    if (copy) {
        memcpy(copy, text, bytes);
        copy[bytes] = 0;
    }
    return copy;
}

char *path_join(const char *folder, const char *name, const char *suffix)
{
    const size_t room = strlen(folder) + strlen(name) + strlen(suffix) + 2;
    char *path = malloc(room);
    if (path)
        snprintf(path, room, "%s/%s%s", folder, name, suffix);
    return path;
}

char *path_beside(const char *from, const char *name)
{
    const char *slash = strrchr(from, '/');
    if (name[0] == '/' || !slash)
        return path_copy(name, strlen(name));
    const size_t folder = (size_t)(slash - from) + 1;
    char *path = malloc(folder + strlen(name) + 1);
    if (path) {
        memcpy(path, from, folder);
        memcpy(path + folder, name, strlen(name) + 1);
    }
    return path;
}

char *path_stem(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *base = slash ? slash + 1 : path;
    return path_copy(base, strlen(base) - (path_ends(base, ".ini") ? 4 : 0));
}

/* Returns the folder of a file, without links and dots; NULL: no such folder. */
static char *resolve_folder(const char *path)
{
    const char *slash = strrchr(path, '/');
    char *folder = slash ? path_copy(path, (size_t)(slash - path) + 1)
                         : path_copy(".", 1);
    char *real = folder ? realpath(folder, NULL) : NULL;
    free(folder);
    return real;
}

bool path_same_file(const char *a, const char *b)
{
    struct stat of_a, of_b;
    return stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev
        && of_a.st_ino == of_b.st_ino;
}

bool path_same_folder(const char *a, const char *b)
{
    char *of_a = resolve_folder(a), *of_b = resolve_folder(b);
    const bool same = of_a && of_b && strcmp(of_a, of_b) == 0;
    free(of_a);
    free(of_b);
    return same;
}

/* Returns the relative path between two absolute folders: up to their common part, then
 * down. */
static char *way(const char *from, const char *to, const char *base)
{
    size_t shared = 0, ups = 0;
    for (size_t i = 0; from[i] == to[i] || !from[i] || !to[i]; i++) {
        if ((from[i] == '/' || !from[i]) && (to[i] == '/' || !to[i]))
            shared = i;
        if (!from[i] || !to[i])
            break;
    }
    for (const char *c = from + shared; *c; c++)
        ups += *c == '/' && c[1];
    const char *down = to + shared + (to[shared] == '/');
    const size_t room = 3 * ups + strlen(down) + strlen(base) + 2;
    char *path = malloc(room);
    for (size_t i = 0; path && i < ups; i++)
        memcpy(path + 3 * i, "../", 3);
    if (path)
        snprintf(path + 3 * ups, room - 3 * ups, "%s%s%s", down, *down ? "/" : "", base);
    return path;
}

char *path_make_relative(const char *file, const char *target)
{
    const char *slash = strrchr(target, '/');
    char *from = resolve_folder(file);
    bool memory = from || errno != ENOMEM;
    char *to = resolve_folder(target);
    memory = memory && (to || errno != ENOMEM);
    char *path = from && to ? way(from, to, slash ? slash + 1 : target)
               : memory ? path_copy(target, strlen(target)) : NULL;
    free(from);
    free(to);
    return path;
}

#define NUMBERS 9999

void path_numbered(char *name, size_t bytes, const char *stem, const char *suffix)
{
    for (int number = 1; number <= NUMBERS; number++) {
        snprintf(name, bytes, "%.100s-%04d%s", stem, number, suffix);
        if (access(name, F_OK) != 0)
            return;
    }
}

bool path_is_file(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 && !S_ISDIR(info.st_mode);
}

static bool is_folder(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

bool path_ends(const char *path, const char *suffix)
{
    const size_t n = strlen(path), m = strlen(suffix);
    return n > m && strcmp(path + n - m, suffix) == 0;
}

/* Removes the last component; "/" stays. */
static void cut_last_component(char *path)
{
    char *slash = strrchr(path, '/');
    if (slash)
        slash[slash == path] = 0;
}

/* The link is absolute and has no "..": removing a component moves up. */
char *path_of_scenes(void)
{
    static const struct { int up; const char *tail; } tries[] = {
        { 2, "assets/scenes" },                 /* build/host/tidepool in the sources */
        { 1, "share/tidepool/scenes" },         /* bin/tidepool of an installation */
        { 0, "assets/scenes" },                 /* an unpacked archive */
    };
    char exe[EXE_BYTES];
    const ssize_t bytes = readlink("/proc/self/exe", exe, sizeof exe - 1);
    for (size_t i = 0; bytes > 0 && i < sizeof tries / sizeof *tries; i++) {
        char folder[EXE_BYTES];
        memcpy(folder, exe, (size_t)bytes);
        folder[bytes] = 0;
        for (int up = -1; up < tries[i].up; up++)
            cut_last_component(folder);
        char *path = path_join(folder, tries[i].tail, "");
        if (path && is_folder(path))
            return path;
        free(path);
    }
#ifdef TP_PREFIX
    if (is_folder(TP_PREFIX "/share/tidepool/scenes"))
        return path_join(TP_PREFIX, "share/tidepool/scenes", "");
#endif
    return NULL;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

void path_free_names(char **names, size_t count)
{
    for (size_t i = 0; i < count; i++)
        free(names[i]);
    free(names);
}

char **path_names(const char *folder, const char *suffix, size_t *count)
{
    char **names = NULL;
    *count = 0;
    DIR *dir = opendir(folder);
    for (struct dirent *entry; dir && (entry = readdir(dir)) != NULL;) {
        const char *file = entry->d_name;
        if (file[0] == '.' || !path_ends(file, suffix))
            continue;
        char **more = realloc(names, (*count + 1) * sizeof *names);
        if (!more)
            break;
        names = more;
        names[*count] = path_copy(file, strlen(file) - strlen(suffix));
        if (names[*count])
            (*count)++;
    }
    if (dir)
        closedir(dir);
    if (*count)
        qsort(names, *count, sizeof *names, by_name);
    return names;
}

char **path_scene_names(const char *folder, size_t *count)
{
    return path_names(folder, ".ini", count);
}
