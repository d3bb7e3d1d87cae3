/* SPDX-License-Identifier: MIT */
/* File names and the place of the shipped scenes. */
#define _POSIX_C_SOURCE 200809L
#include "path.h"
#include <dirent.h>
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

/* Cuts the last component; "/" stays. */
static void go_up(char *path)
{
    char *slash = strrchr(path, '/');
    if (slash)
        slash[slash == path] = 0;
}

/* The link is absolute and holds no "..", so going up is cutting. */
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
            go_up(folder);
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
