/* SPDX-License-Identifier: MIT */
/* The panel's tab of figures: times of the last frames, the state, the quality plan,
 * memory. */
#include <stdio.h>
#include <string.h>
#include "../host/actions.h"
#include "panel_parts.h"
#include "panel_pen.h"

/* -- the graph ------------------------------------------------------------------- */

static float highest(const panel_figures *f, uint32_t n)
{
    float top = f->limit_ms * 1.5f;
    for (uint32_t i = PANEL_HISTORY - n; i < PANEL_HISTORY; i++)
        top = SDL_max(top, f->history[i]);
    return SDL_max(top, 0.001f);
}

/* Graph of frame times: the newest at the right; a line marks the limit. */
static void show_graph(const panel_figures *f)
{
    char text[32];
    const SDL_FPoint at = pen_position();
    const float wide = pen_room(), high = pen_px(60);
    const uint32_t n = SDL_min(f->pictures, (uint32_t)PANEL_HISTORY);
    const float top = highest(f, n);
    const float step = SDL_max(1.0f, SDL_floorf(wide / PANEL_HISTORY));
    pen_box(at.x, at.y, wide, high, PEN_FRAME);
    for (uint32_t i = 0; i < n && (float)(i + 1) * step <= wide; i++) {
        const float ms = f->history[PANEL_HISTORY - 1 - i];
        const float tall = SDL_ceilf(SDL_max(ms, 0.0f) / top * high);
        pen_box(at.x + wide - (float)(i + 1) * step, at.y + high - tall, step, tall,
                ms > f->limit_ms ? PEN_OVERDUE : PEN_SEA);
    }
    const float y = SDL_floorf(at.y + high - f->limit_ms / top * high);
    pen_box(at.x, y, wide, 1, PEN_EDITED);
    snprintf(text, sizeof text, "%.1f ms", (double)f->limit_ms);
    pen_write(at.x + pen_px(3), y - pen_letter_high(), PEN_DIM, text);
    pen_take(wide, high);
}

/* -- tables ---------------------------------------------------------------------- */

/* Name at the left, time at the right, and behind both a bar for the share. */
static void show_time(const panel_time *t)
{
    char text[32], name[PANEL_NAME];
    const SDL_FPoint at = pen_position();
    const float wide = pen_room(), high = pen_letter_high() + pen_px(2);
    const float share = SDL_clamp(t->share, 0.0f, 1.0f);
    snprintf(text, sizeof text, "%.0f us %3.0f%%", (double)t->mean, (double)share * 100);
    const float end = pen_wide(text);
    const int fits = SDL_max((int)((wide - end) / pen_letter()) - 1, 0);
    snprintf(name, sizeof name, "%.*s", fits, t->name);
    pen_box(at.x, at.y, SDL_ceilf(share * wide), high, PEN_FULL);
    pen_write(at.x + pen_px(3), at.y, PEN_TEXT, name);
    pen_write(at.x + wide - end, at.y, PEN_DIM, text);
    pen_take(wide, high);
}

static void show_times(const panel_time *time, uint32_t count)
{
    for (uint32_t i = 0; i < SDL_min(count, (uint32_t)PANEL_TIMES); i++)
        show_time(&time[i]);
}

/* Columns separated by tabs; the last column takes the remaining width. */
static void show_columns(char *line)
{
    const float left = pen_position().x;
    for (int column = 0; line; column++) {
        char *const tab = strchr(line, '\t');
        if (tab)
            *tab = '\0';
        if (column > 0) {
            const SDL_FRect last = pen_last();
            pen_beside(0);
            const float at = left + (float)(11 * column - 1) * pen_letter();
            pen_go(SDL_max(last.x + last.w, at) + pen_letter(), last.y);
        }
        panel_line(column == 0 ? PEN_DIM : PEN_TEXT, line);
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

/* -- all figures ----------------------------------------------------------------- */

static void show_compare(panel *p, const panel_compare *c)
{
    char text[64];
    const float half = SDL_floorf((pen_room() - pen_gap()) / 2);
    panel_button(p, ACT_COMPARE, c->off, half);
    pen_beside(pen_gap());
    panel_button(p, ACT_AGAINST, c->against, half);
    if (c->psnr > 99)
        snprintf(text, sizeof text, "the same bits");
    else if (c->psnr >= 0)
        snprintf(text, sizeof text, "PSNR %.1f dB", c->psnr);
    else
        snprintf(text, sizeof text, "PSNR --");
    pen_say(PEN_TEXT, text);
    if (c->note && c->note[0])
        panel_line(PEN_DIM, c->note);
}

static void section(const char *name)
{
    pen_take(1, pen_px(2));
    panel_line(PEN_SEA, name);
}

void panel_figures_show(panel *p)
{
    const panel_figures *const f = p->host->figures;
    char text[96];
    pen_scroll("##figures");
    snprintf(text, sizeof text, "%.1f ms   %.0f/s   latency %.0f ms",
             (double)f->median_ms, (double)f->shown_per_s, (double)f->latency_ms);
    panel_line(PEN_TEXT, text);
    show_graph(f);
    if (f->state && f->state[0])
        pen_say_wrapped(PEN_DIM, f->state);
    if (p->host->compare) {
        section("compared with another method");
        show_compare(p, p->host->compare);
    }
    section("a picture's time");
    show_times(f->parts, f->part_count);
    section("stages of its pixels");
    show_times(f->stages, f->stage_count);
    if (f->stage_count == 0)
        pen_say(PEN_DIM, "not measured");
    section("quality plan");
    show_lines(f->plan);
    section("memory");
    show_lines(f->ram);
    pen_scroll_end();
}
