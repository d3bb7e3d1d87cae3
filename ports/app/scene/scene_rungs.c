/* SPDX-License-Identifier: MIT */
/* The rungs of all kinds and effects by one name. */
#include <string.h>
#include "scene_file.h"
#include "quality/rung_sets.h"
#include "world/text.h"

enum { EXACT, PLANNED, FAST, NAMED, NAMES };

static const char *const names[NAMES] = { "exact", "planned", "fast",
                                          "named" };

/* Rungs of the kinds: visibility, shading, rate. */
static const int32_t kinds[NAMES][3] = {
    [EXACT] = { TP_VISIBILITY_TRIANGLES, TP_SHADING_EXACT, TP_RATE_FULL },
    [PLANNED] = { TP_VISIBILITY_AUTO, TP_SHADING_AUTO, TP_RATE_AUTO },
    [FAST] = { TP_VISIBILITY_AUTO, TP_SHADING_QUICK, TP_RATE_FULL },
};

static int find_name(const char *name)
{
    int n = 0;
    while (n < NAMES && strcmp(names[n], name) != 0)
        n++;
    return n;
}

bool scene_file_knows_rung(const char *name)
{
    return find_name(name) < NAMES;
}

/* Marks a row as set by the command. */
static void name_row(scene_file *file, const char *row)
{
    uint32_t count;
    file->set_at[tp_param_find(row, strlen(row)) - tp_params(&count)] = SET_BY_COMMAND;
}

/* Sets open rows to their exact rungs: a program without a plan draws these. */
static void close_rows(tp_scene *scene)
{
    const tp_rung_set exact = { .of = { 0 } };
    uint32_t open;

    tp_rung_set_named(scene, false, &open);
    tp_rung_set_apply_some(scene, &exact, open);
}

void scene_file_set_rung(scene_file *file, const char *name)
{
    const int n = find_name(name);

    if (n != PLANNED)           /* a board's plan opens rows of the drawing too */
        file->scene.quality.board = TP_BOARD_none;
    if (n == NAMED) {
        close_rows(&file->scene);
        return;
    }
    name_row(file, "quality.visibility");
    name_row(file, "quality.shading");
    name_row(file, "quality.rate");
    file->scene.quality.visibility = kinds[n][0];
    file->scene.quality.shading = kinds[n][1];
    file->scene.quality.rate = kinds[n][2];
#define X(effect, words, last, help) \
    name_row(file, "quality." #effect); \
    file->scene.quality.effect = n == EXACT ? TP_RUNG_EXACT : n == FAST ? TP_RUNG_FAST : 0;
    TP_EFFECT_LIST(X)
#undef X
    if (n == FAST)              /* low swells carry textures; without them little is saved */
        file->scene.quality.geometry = TP_RUNG_EXACT;
}
