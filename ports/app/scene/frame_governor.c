/* SPDX-License-Identifier: MIT */
/* Runs the governor; prints a message for each step. */
#include "frame_governor.h"
#include <stdio.h>
#include "app/files/log.h"
#include "frame/tools.h"

void frame_governor_begin(frame_governor *g, const loaded_scene *s)
{
    const tp_scene *scene = &s->file.scene;
    const tp_config *config = &s->renderer.config;
    const tp_ladder ladder = tp_ladder_make(scene, &s->assets.names, config->width,
                                          config->height);
    const uint32_t limit = (uint32_t)((int64_t)scene->quality.frame_ms * 1000 >> 16);

    tp_governor_init(&g->governor, &ladder, limit);
    g->frame = s->renderer.frame;
    if (limit > 0 && ladder.count < 2)
        log_line("%s: no cheaper rung, quality.frame_ms cannot be held", s->file.name);
}

static uint32_t rung_value(unsigned kind, tp_rungs r)
{
    const uint32_t value[TP_KINDS] = { (uint32_t)r.visibility, (uint32_t)r.shading,
                                       (uint32_t)r.rate };
    return value[kind];
}

const char *frame_governor_rung_name(unsigned kind, tp_rungs rungs)
{
    static const char *const words[TP_KINDS][TP_KIND_RUNGS + 1] = {
        { "auto", "triangles", "rows", "projected grid", "flat grid" },
        { "auto", "exact shading", "quick shading" },
        { "auto", "full rate", "half-rate layers", "half-rate colour" },
    };
    const char *word = words[kind][rung_value(kind, rungs)];
    return word ? word : "?";
}

/* Writes ms as "33" or "2.5". */
static void ms_text(char text[24], uint32_t us)
{
    if (us >= 10000)
        snprintf(text, 24, "%u", (unsigned)(us + 500) / 1000);
    else
        snprintf(text, 24, "%u.%u", (unsigned)us / 1000, (unsigned)us / 100 % 10);
}

void frame_governor_add_time(frame_governor *g, uint32_t number, uint64_t us)
{
    const tp_rungs from = tp_governor_rungs(&g->governor);
    const int step = tp_governor_add_frame_time(&g->governor, us < UINT32_MAX ? (uint32_t)us
                                                                    : UINT32_MAX);
    const tp_rungs to = tp_governor_rungs(&g->governor);
    char took[24], limit[24];
    unsigned kind = 0;

    if (!step)
        return;
    while (kind + 1 < TP_KINDS && rung_value(kind, from) == rung_value(kind, to))
        kind++;
    ms_text(took, g->governor.mean);
    ms_text(limit, g->governor.limit);
    log_line("frame %u: %s ms %s %s: %s", (unsigned)number, took,
             step > 0 ? "over" : "within", limit, frame_governor_rung_name(kind, to));
    tp_frame_set_rungs(g->frame, &to);
}
