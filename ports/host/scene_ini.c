/* SPDX-License-Identifier: MIT */
/* Scene files: INI through libinih, numbers through the core's own reader.  A section and a
 * name in the section form the name of a parameter:
 *
 *     [wave0]
 *     steepness = 0.4         sets wave0.steepness */
#define _POSIX_C_SOURCE 200809L
#include <limits.h>
#include <stdio.h>
#include "ini_read.h"
#include "scene_file.h"

static bool take(void *user, uint32_t line, const char *section, const char *name,
                 const char *value)
{
    scene_file *file = user;
    char full[128], place[PATH_MAX + 16];
    snprintf(full, sizeof full, "%s%s%s", section, section[0] ? "." : "", name);
    snprintf(place, sizeof place, "%s:%u", file->path, (unsigned)line);
    return scene_file_apply(file, place, line, full, value);
}

int scene_ini_read(scene_file *file)
{
    return ini_read(file->path, take, file);
}
