/* SPDX-License-Identifier: MIT */
#include "tests/charts/used.h"
#include "world/module.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/path.h"
#include "app/scene/scene_file.h"

#define FOLDER "assets/scenes"

enum { SCENES = 64, NAME_BYTES = 64 };

static struct {
    char     name[NAME_BYTES];
    tp_scene scene;
} shipped[SCENES];
static size_t n_shipped;

static void give_up(const char *what)
{
    fprintf(stderr, "used: %s: %s\n", FOLDER, what);
    exit(EXIT_FAILURE);
}

static void read_scene(const char *name)
{
    scene_file file;
    char path[sizeof FOLDER + NAME_BYTES + 8];

    if (strlen(name) >= NAME_BYTES || n_shipped == SCENES)
        give_up("a longer list than there is room for");
    snprintf(path, sizeof path, FOLDER "/%s.ini", name);
    if (scene_file_open(&file, path))
        give_up("a scene cannot be read");
    strcpy(shipped[n_shipped].name, name);
    shipped[n_shipped++].scene = file.scene;
    scene_file_close(&file);
}

static void read_all(void)
{
    size_t count;
    char **names = path_scene_names(FOLDER, &count);

    if (count == 0)
        give_up("no scenes");
    for (size_t i = 0; i < count; i++)
        read_scene(names[i]);
    path_free_names(names, count);
}

const char *used_by(used_test *test, int32_t of)
{
    static char text[SCENES * (NAME_BYTES + 1)];
    size_t found = 0, length = 0;

    if (!n_shipped)
        read_all();
    for (size_t i = 0; i < n_shipped; i++)
        if (test(&shipped[i].scene, of)) {
            length += (size_t)sprintf(text + length, "%s%s", found ? " " : "",
                                      shipped[i].name);
            found++;
        }
    return found == n_shipped ? "all" : found ? text : "-";
}

void used_row(const char *chart, const char *point, used_test *test, int32_t of)
{
    printf("%s,%s,used,%s\n", chart, point, test ? used_by(test, of) : "all");
}

const tp_scene *used_scene(size_t i, const char **name)
{
    if (!n_shipped)
        read_all();
    if (i >= n_shipped)
        return NULL;
    *name = shipped[i].name;
    return &shipped[i].scene;
}

bool used_coast(const tp_scene *scene)
{
    return tp_modules_is_any_active(tp_program_all.modules,
                                    &(tp_module_conditions){ .scene = scene },
                                    TP_MODULE_COASTAL);
}
