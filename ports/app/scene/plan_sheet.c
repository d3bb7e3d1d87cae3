/* SPDX-License-Identifier: MIT */
#include "plan_sheet.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "world/text.h"

const char *const plan_kind[TP_KINDS] = { "visibility", "shading", "rate" };

const char *const plan_why[] = {
    [TP_WHY_CHOSEN] = "chosen", [TP_WHY_NAMED] = "set by the scene",
    [TP_WHY_OTHER_NAMED] = "the scene sets another", [TP_WHY_ERROR] = "over the budget",
    [TP_WHY_COST] = "no cheaper", [TP_WHY_UNKNOWN] = "no measured cost yet",
    [TP_WHY_UNFIT] = "not for this scene",
};

static void name_rungs(tp_scene *scene, tp_rungs rungs)
{
    scene->quality.visibility = (int32_t)rungs.visibility;
    scene->quality.shading = (int32_t)rungs.shading;
    scene->quality.rate = (int32_t)rungs.rate;
}

static tp_rungs with(tp_rungs rungs, int kind, int rung)
{
    switch (kind) {
    case 0:  rungs.visibility = (tp_visibility)(rung + 1); break;
    case 1:  rungs.shading = (tp_shading)(rung + 1); break;
    default: rungs.rate = (tp_rate)(rung + 1); break;
    }
    return rungs;
}

int plan_rung(tp_rungs rungs, int kind)
{
    const int rung[TP_KINDS] = { (int)rungs.visibility, (int)rungs.shading,
                                 (int)rungs.rate };
    return rung[kind] - 1;
}

plan_sheet plan_sheet_make(const loaded_scene *s)
{
    const tp_assets *named = &s->assets.names;
    tp_config config = s->renderer.config;
    tp_scene scene = s->file.scene;
    plan_sheet p = { .report = tp_plan_make(&scene, named, config.width, config.height) };

    config.program = &tp_program_all;
    config.assets = named;
    for (int k = 0; k < TP_KINDS; k++)
        for (int i = 0; i < p.report.rung_count[k]; i++) {
            name_rungs(&scene, with(p.report.rungs, k, i));
            p.bytes[k][i] =
                tp_frame_bytes(&config, &scene) + tp_frame_scratch_bytes(&config, &scene);
        }
    return p;
}

const char *plan_number(tp_fx x, char text[24])
{
    const int64_t hundredths = ((int64_t)x * 100 + 0x8000) >> 16;
    snprintf(text, 24, "%" PRId64 ".%02d", hundredths / 100, (int)(hundredths % 100));
    return text;
}

void plan_word(int kind, int rung, char word[32])
{
    const tp_param *row;
    char name[32];

    snprintf(name, sizeof name, "quality.%s", plan_kind[kind]);
    row = tp_param_find(name, strlen(name));
    tp_param_number_text(row, rung + 1, word, 32);
}
