/* SPDX-License-Identifier: MIT */
/* The panel's rows in their groups, and the search.  What the scene has not stands folded
 * at the end; where it was when the scene was opened, for nothing should move under a
 * person's hands. */
#include <stdio.h>
#include "panel_parts.h"
#include "panel_pen.h"

/* A number at its right end. */
static bool show_head(const char *name, uint32_t number, bool forced)
{
    char text[16] = "";
    const bool open = pen_head(name, forced);
    const SDL_FRect at = pen_last();
    if (number > 0)
        snprintf(text, sizeof text, "%u", (unsigned)number);
    pen_write_in(at.x + at.w - pen_wide(text) - pen_px(10), at.y, PEN_DIM, text);
    return open;
}

static bool finds_any(const panel *p, const panel_group *g)
{
    for (uint32_t i = g->first; i < g->first + g->count; i++)
        if (panel_found(&p->host->row[i], p->wanted))
            return true;
    return false;
}

/* Those that were found are others than the same when nothing is searched for, and what
 * was folded stays so. */
static void show_group(panel *p, const panel_group *g)
{
    const bool wants = p->wanted[0] != '\0';
    if (wants && !finds_any(p, g))
        return;
    pen_in(wants);
    if (show_head(g->name, g->changed, wants)) {
        pen_indent(true);
        for (uint32_t i = g->first; i < g->first + g->count; i++)
            if (panel_found(&p->host->row[i], p->wanted))
                panel_row_show(p, i);
        pen_indent(false);
    }
    pen_out();
}

static void show_groups(panel *p)
{
    uint32_t idle = 0;
    const bool wants = p->wanted[0] != '\0';
    for (uint32_t i = 0; i < p->groups; i++) {
        idle += p->group[i].idle;
        if (wants || !p->group[i].idle)
            show_group(p, &p->group[i]);
    }
    if (wants || idle == 0 || !show_head("not in this scene", idle, false))
        return;
    pen_indent(true);
    for (uint32_t i = 0; i < p->groups; i++)
        if (p->group[i].idle)
            show_group(p, &p->group[i]);
    pen_indent(false);
}

/* Another scene has other idle groups; else one group a picture is counted. */
static void count_groups(panel *p)
{
    if (p->scene != p->host->scene)
        for (uint32_t i = 0; i < p->groups; i++)
            panel_group_count(p->host, &p->group[i], true);
    p->scene = p->host->scene;
    if (p->groups > 0)
        panel_group_count(p->host, &p->group[p->counted++ % p->groups], false);
}

static void show_search(panel *p)
{
    const float clear = p->wanted[0] ? pen_high() + pen_px(1) : 0;
    if (p->keys.searching)
        panel_ask(p);
    pen_field("##search", "search names and help", p->wanted, sizeof p->wanted,
              pen_room() - clear);
    if (pen_active() && p->keys.writes)
        p->keys.searching = false;
    if (clear > 0) {
        pen_beside(pen_px(1));
        if (pen_button("x##clear", pen_high(), false))
            p->wanted[0] = '\0';
    }
}

void panel_list(panel *p)
{
    count_groups(p);
    show_search(p);
    pen_scroll("##rows");
    show_groups(p);
    pen_scroll_end();
}
