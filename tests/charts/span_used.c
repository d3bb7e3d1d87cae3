/* SPDX-License-Identifier: MIT */
#include "tests/charts/span_used.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/path.h"
#include "app/scene/loaded_scene.h"

#define FOLDER "assets/scenes"

enum { SCENES = 64 };

static struct {
    tp_scene scene;
    tp_rungs rungs;
} shipped[SCENES];
static char **names;
static size_t count;

static void read_scene(size_t i)
{
    char *path = path_join(FOLDER, names[i], ".ini");
    const options o = { .command = "charts", .scene = path, .width = 320, .height = 240 };
    loaded_scene s;

    if (loaded_scene_load(&s, &o))
        exit(EXIT_FAILURE);
    shipped[i].scene = s.file.scene;
    shipped[i].rungs = (tp_rungs){
        (tp_visibility)(s.plan.set.of[TP_KIND_VISIBILITY] + 1),
        (tp_shading)(s.plan.set.of[TP_KIND_SHADING] + 1),
        (tp_rate)(s.plan.set.of[TP_KIND_RATE] + 1),
    };
    loaded_scene_close(&s);
    free(path);
}

const char *span_used(rungs_test *test, const void *of)
{
    static char text[SCENES * 64];
    size_t found = 0, length = 0;

    if (!names) {
        names = path_scene_names(FOLDER, &count);
        for (size_t i = 0; i < count && i < SCENES; i++)
            read_scene(i);
    }
    for (size_t i = 0; i < count && i < SCENES; i++)
        if (test(&shipped[i].scene, &shipped[i].rungs, of)
            && length + strlen(names[i]) + 2 < sizeof text) {
            length += (size_t)sprintf(text + length, "%s%s", found ? " " : "", names[i]);
            found++;
        }
    return found == 0 ? "-" : found == count ? "all" : text;
}
