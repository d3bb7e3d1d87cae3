/* SPDX-License-Identifier: MIT */
/* The rungs of all kinds and effects by one name. */
#include <string.h>
#include "scene_file.h"
#include "world/text.h"

enum { EXACT, PLANNED, FAST, NAMES };

static const char *const names[NAMES] = { "exact", "planned", "fast" };

/* Rungs of the kinds: visibility, shading, rate. */
static const int32_t kinds[NAMES][3] = {
    [EXACT] = { TP_VISIBILITY_TRIANGLES, TP_SHADING_EXACT, TP_RATE_FULL },
    [PLANNED] = { TP_VISIBILITY_AUTO, TP_SHADING_AUTO, TP_RATE_AUTO },
    [FAST] = { TP_VISIBILITY_AUTO, TP_SHADING_QUICK, TP_RATE_AUTO },
};

static const int32_t effects[NAMES][TP_EFFECTS] = {
#define X(name, words, last, help) TP_RUNG_EXACT,
    [EXACT] = { TP_EFFECT_LIST(X) },
#undef X
#define X(name, words, last, help) last,
    [FAST] = { TP_EFFECT_LIST(X) },
#undef X
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

void scene_file_set_rung(scene_file *file, const char *name)
{
    static const char first[] = "quality.visibility";
    uint32_t count;
    const int n = find_name(name);
    const tp_param *rows = tp_params(&count);
    const uint32_t at = (uint32_t)(tp_param_find(first, sizeof first - 1) - rows);

    file->scene.quality.visibility = kinds[n][0];
    file->scene.quality.shading = kinds[n][1];
    file->scene.quality.rate = kinds[n][2];
    memcpy(file->scene.quality.effect, effects[n], sizeof effects[n]);
    for (uint32_t i = 0; i < 3 + TP_EFFECTS; i++)   /* the rows follow one another */
        file->set_at[at + i] = SET_BY_COMMAND;
}
