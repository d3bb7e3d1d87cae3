/* SPDX-License-Identifier: MIT */
#include "frame_governor.h"
#include <stdio.h>
#include "app/files/log.h"
#include "plan_sheet.h"

void frame_governor_begin(frame_governor *g, loaded_scene *s)
{
    const tp_scene *scene = &s->file.scene;
    const bool on = scene->quality.board == TP_BOARD_none;
    const uint32_t limit = (uint32_t)((int64_t)scene->quality.frame_ms * 1000 >> 16);

    plan_sheet_make_walk(&g->walk, s);
    tp_governor_init(&g->governor, &g->walk, on ? limit : 0);
    g->scene = s;
    if (on && limit > 0 && g->walk.count < 2)
        log_line("%s: no cheaper rung, quality.frame_ms cannot be held", s->file.name);
}

bool frame_governor_is_active(const frame_governor *g)
{
    return g->governor.limit > 0 && g->governor.steps > 1;
}

/* Writes ms as "33" or "2.5". */
static void ms_text(char text[24], uint32_t us)
{
    if (us >= 10000)
        snprintf(text, 24, "%u", (unsigned)(us + 500) / 1000);
    else
        snprintf(text, 24, "%u.%u", (unsigned)us / 1000, (unsigned)us / 100 % 10);
}

/* Prints "frame 40: 12 ms over 10: step 3 of 17: quality.light=fast". */
static void report_step(const frame_governor *g, uint32_t number, int step)
{
    const tp_governor *governor = &g->governor;
    const uint32_t from = (uint32_t)((int)governor->at - step);
    char took[24], limit[24], rows[640];

    ms_text(took, governor->mean);
    ms_text(limit, governor->limit);
    plan_write_changes(&g->scene->file.scene, &g->walk.set[from],
                       &g->walk.set[governor->at], rows, sizeof rows);
    log_line("frame %u: %s ms %s %s: step %u of %u: %s", (unsigned)number, took,
             step > 0 ? "over" : "within", limit, (unsigned)governor->at,
             (unsigned)governor->steps - 1, rows);
}

void frame_governor_add_time(frame_governor *g, uint32_t number, uint64_t us)
{
    const int step = tp_governor_add_frame_time(&g->governor,
                                                us < UINT32_MAX ? (uint32_t)us : UINT32_MAX);

    if (!step)
        return;
    report_step(g, number, step);
    (void)frame_renderer_set_rungs(&g->scene->renderer, &g->walk.set[g->governor.at]);
}
