/* SPDX-License-Identifier: MIT */
/* The panel's rows in their groups, and the search.  Groups unused by the scene are
 * folded at the end, also in search results.  The split is updated only when a scene is
 * opened or the search text changes: rows must not move while the person works. */
#include <stdio.h>
#include <string.h>
#include "panel_parts.h"
#include "panel_ui.h"

/* Shows a group's header with a number at its right end. */
static bool show_head(const char *name, uint32_t number, bool forced)
{
    char text[16] = "";
    const bool open = ui_head(name, forced);
    const SDL_FRect at = ui_last();
    if (number > 0)
        snprintf(text, sizeof text, "%u", (unsigned)number);
    ui_write_framed(at.x + at.w - ui_wide(text) - ui_px(10), at.y, UI_DIM, text);
    return open;
}

static panel_find best_match(const panel *p, const panel_group *g)
{
    panel_find best = PANEL_LOST;
    for (uint32_t i = g->first; i < g->first + g->count; i++)
        best = SDL_max(best, panel_found(&p->host->row[i], p->wanted));
    return best;
}

/* Counts rows found by the search, in groups unused (idle) or used by the scene. */
static uint32_t count_found(const panel *p, bool idle)
{
    uint32_t n = 0;
    for (uint32_t k = 0; k < p->groups; k++) {
        const panel_group *const g = &p->group[k];
        for (uint32_t i = g->first; g->idle == idle && i < g->first + g->count; i++)
            n += panel_found(&p->host->row[i], p->wanted) != PANEL_LOST;
    }
    return n;
}

static bool is_searched(const panel *p)
{
    return p->wanted[0] != '\0';
}

/* Shows a group, rows found by name before rows found by help.  A search has its own IDs,
 * so groups opened by a search are folded again after the search. */
static void show_group(panel *p, const panel_group *g)
{
    ui_push_id(is_searched(p));
    if (show_head(g->name, g->changed, is_searched(p))) {
        ui_indent(true);
        for (panel_find by = PANEL_BY_NAME; by > PANEL_LOST; by--)
            for (uint32_t i = g->first; i < g->first + g->count; i++)
                if (panel_found(&p->host->row[i], p->wanted) == by)
                    panel_row_show(p, i);
        ui_indent(false);
    }
    ui_pop_id();
}

/* Shows groups found by name first, then groups found by help text alone. */
static void show_matches(panel *p, bool idle)
{
    for (panel_find by = PANEL_BY_NAME; by > PANEL_LOST; by--)
        for (uint32_t i = 0; i < p->groups; i++)
            if (p->group[i].idle == idle && best_match(p, &p->group[i]) == by)
                show_group(p, &p->group[i]);
}

/* Shows the search result.  If only unused groups match, they are shown unfolded. */
static void show_found(panel *p)
{
    const uint32_t here = count_found(p, false), more = count_found(p, true);
    show_matches(p, false);
    if (here == 0 && more == 0) {
        panel_line(UI_DIM, "no name or help has these words");
    } else if (here == 0) {
        show_matches(p, true);
        panel_line(UI_DIM, "not in this scene; its values add it");
    } else if (more > 0 && show_head("more, not in this scene", more, false)) {
        ui_indent(true);
        show_matches(p, true);
        ui_indent(false);
    }
}

static void show_groups(panel *p, bool idle)
{
    for (uint32_t i = 0; i < p->groups; i++)
        if (p->group[i].idle == idle)
            show_group(p, &p->group[i]);
}

static void show_all(panel *p)
{
    uint32_t idle = 0;
    for (uint32_t i = 0; i < p->groups; i++)
        idle += p->group[i].idle;
    show_groups(p, false);
    if (idle > 0 && show_head("not in this scene", idle, false)) {
        ui_indent(true);
        show_groups(p, true);
        ui_indent(false);
    }
}

/* Updates the split into used and unused groups after a change of scene or search text.
 * Otherwise counts one group per frame. */
static void count_groups(panel *p)
{
    if (p->scene != p->host->scene || strcmp(p->counted_for, p->wanted) != 0)
        for (uint32_t i = 0; i < p->groups; i++)
            panel_group_count(p->host, &p->group[i], true);
    p->scene = p->host->scene;
    memcpy(p->counted_for, p->wanted, sizeof p->counted_for);
    if (p->groups > 0)
        panel_group_count(p->host, &p->group[p->counted++ % p->groups], false);
}

static void show_search(panel *p)
{
    const float clear = p->wanted[0] ? ui_high() + ui_px(1) : 0;
    if (p->keys.searching)
        panel_request_focus(p);
    ui_field("##search", "search names and help", p->wanted, sizeof p->wanted,
             ui_room() - clear);
    if (ui_active() && p->keys.writes)
        p->keys.searching = false;
    if (clear > 0) {
        ui_beside(ui_px(1));
        if (ui_button("x##clear", ui_high(), false))
            p->wanted[0] = '\0';
    }
}

void panel_list(panel *p)
{
    count_groups(p);
    show_search(p);
    ui_scroll("##rows");
    if (is_searched(p))
        show_found(p);
    else
        show_all(p);
    ui_scroll_end();
}
