/* SPDX-License-Identifier: MIT */
/* The panel's tab of figures: times of the last frames, the state, the quality plan,
 * memory. */
#include <stdio.h>
#include <string.h>
#include "app/session/actions.h"
#include "panel_parts.h"
#include "panel_ui.h"

/* -- the graph ----------------------------------------------------------------------- */

static float highest(const panel_performance *f, uint32_t n)
{
    float top = f->limit_ms * 1.5f;
    for (uint32_t i = PANEL_HISTORY - n; i < PANEL_HISTORY; i++)
        top = SDL_max(top, f->history[i]);
    return SDL_max(top, 0.001f);
}

/* Graph of frame times: the newest at the right; a line marks the limit. */
static void show_graph(const panel_performance *f)
{
    char text[32];
    const SDL_FPoint at = ui_position();
    const float wide = ui_room(), high = ui_px(60);
    const uint32_t n = SDL_min(f->pictures, (uint32_t)PANEL_HISTORY);
    const float top = highest(f, n);
    const float step = SDL_max(1.0f, SDL_floorf(wide / PANEL_HISTORY));
    ui_box(at.x, at.y, wide, high, UI_FRAME);
    for (uint32_t i = 0; i < n && (float)(i + 1) * step <= wide; i++) {
        const float ms = f->history[PANEL_HISTORY - 1 - i];
        const float tall = SDL_ceilf(SDL_max(ms, 0.0f) / top * high);
        ui_box(at.x + wide - (float)(i + 1) * step, at.y + high - tall, step, tall,
               ms > f->limit_ms ? UI_OVERDUE : UI_SEA);
    }
    const float y = SDL_floorf(at.y + high - f->limit_ms / top * high);
    ui_box(at.x, y, wide, 1, UI_EDITED);
    snprintf(text, sizeof text, "%.1f ms", (double)f->limit_ms);
    ui_write(at.x + ui_px(3), y - ui_letter_high(), UI_DIM, text);
    ui_take(wide, high);
}

/* -- tables -------------------------------------------------------------------------- */

/* Name at the left, time at the right, and behind both a bar for the share. */
static void show_time(const panel_time *t)
{
    char text[32], name[PANEL_NAME];
    const SDL_FPoint at = ui_position();
    const float wide = ui_room(), high = ui_letter_high() + ui_px(2);
    const float share = SDL_clamp(t->share, 0.0f, 1.0f);
    snprintf(text, sizeof text, "%.0f us %3.0f%%", (double)t->mean, (double)share * 100);
    const float end = ui_wide(text);
    const int fits = SDL_max((int)((wide - end) / ui_letter()) - 1, 0);
    snprintf(name, sizeof name, "%.*s", fits, t->name);
    ui_box(at.x, at.y, SDL_ceilf(share * wide), high, UI_FULL);
    ui_write(at.x + ui_px(3), at.y, UI_TEXT, name);
    ui_write(at.x + wide - end, at.y, UI_DIM, text);
    ui_take(wide, high);
}

static void show_times(const panel_time *time, uint32_t count)
{
    for (uint32_t i = 0; i < SDL_min(count, (uint32_t)PANEL_TIMES); i++)
        show_time(&time[i]);
}

/* Columns separated by tabs; the last column takes the remaining width. */
static void show_columns(char *line)
{
    const float left = ui_position().x;
    for (int column = 0; line; column++) {
        char *const tab = strchr(line, '\t');
        if (tab)
            *tab = '\0';
        if (column > 0) {
            const SDL_FRect last = ui_last();
            ui_beside(0);
            const float at = left + (float)(11 * column - 1) * ui_letter();
            ui_go(SDL_max(last.x + last.w, at) + ui_letter(), last.y);
        }
        panel_line(column == 0 ? UI_DIM : UI_TEXT, line);
        line = tab ? tab + 1 : NULL;
    }
}

static void show_lines(const char *lines)
{
    while (lines && *lines) {
        char line[256];
        const size_t bytes = strcspn(lines, "\n");
        snprintf(line, sizeof line, "%.*s", (int)bytes, lines);
        show_columns(line);
        lines += bytes + (lines[bytes] == '\n');
    }
}

/* -- all figures --------------------------------------------------------------------- */

static void show_compare(panel *p, const panel_compare *c)
{
    char text[64];
    const float half = SDL_floorf((ui_room() - ui_gap()) / 2);
    panel_button(p, ACT_COMPARE, c->off, half);
    ui_beside(ui_gap());
    panel_button(p, ACT_AGAINST, c->against, half);
    if (c->psnr > 99)
        snprintf(text, sizeof text, "the same bits");
    else if (c->psnr >= 0)
        snprintf(text, sizeof text, "PSNR %.1f dB", c->psnr);
    else
        snprintf(text, sizeof text, "PSNR --");
    ui_text(UI_TEXT, text);
    if (c->note && c->note[0])
        panel_line(UI_DIM, c->note);
}

static void section(const char *name)
{
    ui_take(1, ui_px(2));
    panel_line(UI_SEA, name);
}

void panel_performance_show(panel *p)
{
    const panel_performance *const f = p->host->performance;
    char text[96];
    ui_scroll("##figures");
    snprintf(text, sizeof text, "%.1f ms   %.0f/s   latency %.0f ms",
             (double)f->median_ms, (double)f->shown_per_s, (double)f->latency_ms);
    panel_line(UI_TEXT, text);
    show_graph(f);
    if (f->state && f->state[0])
        ui_text_wrapped(UI_DIM, f->state);
    if (p->host->compare) {
        section("compared with another method");
        show_compare(p, p->host->compare);
    }
    section("a picture's time");
    show_times(f->parts, f->part_count);
    section("stages of its pixels");
    show_times(f->stages, f->stage_count);
    if (f->stage_count == 0)
        ui_text(UI_DIM, "not measured");
    section("quality plan");
    show_lines(f->plan);
    section("memory");
    show_lines(f->ram);
    ui_scroll_end();
}
