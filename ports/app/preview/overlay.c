/* SPDX-License-Identifier: MIT */
/* Figures and messages over the picture: a graph of the last frame times, the time of
 * each part of a frame, the difference from the compared picture. */
#include "overlay.h"
#include <stdio.h>
#include <string.h>

#define GRAPH_HIGH 44               /* px at scale 1 */
#define MARGIN     4
#define CELLS      40               /* letters in a line of figures, as wide as the graph */
#define NAME       20
#define STAGES     10               /* stages shown, most expensive first */
#define TEXT_BYTES 160

static const uint32_t amber = 0xffd479, white = 0xe8eef4, blue = 0x7fc8ff;
static const uint32_t green = 0x6fcf97, red = 0xff6b5e, grey = 0xb4c2ce;

/* A box of figures while its lines are written. */
typedef struct {
    font    *to;
    int      x, y, scale;
    int      low;                   /* lower end; lines that end below are dropped */
} overlay_sheet;

/* Takes the next `high` px.  Returns false if the box is full. */
static bool takes(overlay_sheet *s, int high, int *y)
{
    if (s->y + high * s->scale > s->low)
        return false;
    *y = s->y;
    s->y += high * s->scale;
    return true;
}

/* Copies one line, cut to `cells` letters.  Returns the rest of the text. */
static const char *cut_line(const char *text, int cells, char line[TEXT_BYTES])
{
    const size_t most = (size_t)SDL_clamp(cells, 1, TEXT_BYTES - 1);
    const size_t length = strcspn(text, "\n");
    size_t cut = SDL_min(length, most);
    if (length > most)                          /* break at a blank, if any */
        for (size_t i = most; i > most / 2 && cut == most; i--)
            cut = text[i] == ' ' ? i : cut;
    snprintf(line, TEXT_BYTES, "%.*s", (int)cut, text);
    text += cut;
    return *text == '\n' || *text == ' ' ? text + 1 : text;
}

static void write_text(overlay_sheet *s, uint32_t colour, const char *text)
{
    int y;
    char line[TEXT_BYTES];
    while (*text && takes(s, FONT_HIGH, &y)) {
        text = cut_line(text, CELLS, line);
        if (s->to)
            font_draw(s->to, s->x, y, s->scale, colour, line);
    }
}

/* Name, time, and a bar for the share of the total. */
static void write_time(overlay_sheet *s, uint32_t colour, const panel_time *t)
{
    enum { BAR = NAME + 11 };
    int y;
    char line[CELLS + 1];
    snprintf(line, sizeof line, "%-*.*s %6.2f ms", NAME, NAME, t->name,
             (double)t->mean / 1000);
    if (!takes(s, FONT_HIGH, &y) || !s->to)
        return;
    const int room = (CELLS - BAR) * FONT_WIDE * s->scale;
    const float share = SDL_clamp(t->share, 0.0f, 1.0f);
    font_draw(s->to, s->x, y, s->scale, white, line);
    font_fill(s->to, s->x + BAR * FONT_WIDE * s->scale, y + 2 * s->scale,
              SDL_max((int)(share * (float)room), s->scale), 6 * s->scale, colour, 255);
}

/* -- the graph ----------------------------------------------------------------------- */

static uint32_t duration_colour(float ms, float limit)
{
    return ms <= limit ? green : ms <= 2 * limit ? amber : red;
}

/* Graph of frame times: the newest at the right, the top at twice the limit. */
static void write_graph(overlay_sheet *s, const panel_performance *f)
{
    int y;
    char text[16];
    if (!takes(s, GRAPH_HIGH + 2, &y) || !s->to)
        return;
    const int high = GRAPH_HIGH * s->scale, line = y + high / 2;
    const int count = (int)SDL_min(f->pictures, (uint32_t)PANEL_HISTORY);
    font_fill(s->to, s->x, y, PANEL_HISTORY * s->scale, high, 0x000000, 96);
    for (int i = PANEL_HISTORY - count; i < PANEL_HISTORY; i++) {
        const float ms = f->history[i];
        const float part = SDL_clamp(ms / (2 * f->limit_ms), 0.0f, 1.0f);
        const int bar = SDL_max((int)(part * (float)high), s->scale);
        font_fill(s->to, s->x + i * s->scale, y + high - bar, s->scale, bar,
                  duration_colour(ms, f->limit_ms), 255);
    }
    font_fill(s->to, s->x, line, PANEL_HISTORY * s->scale, s->scale, white, 144);
    snprintf(text, sizeof text, "%.1f", (double)f->limit_ms);
    font_draw(s->to, s->x + s->scale, line - FONT_HIGH * s->scale, s->scale, white,
                 text);
}

/* -- the comparison ------------------------------------------------------------------ */

static void write_compare(overlay_sheet *s, const panel_compare *c)
{
    char text[TEXT_BYTES];
    if (!c || !c->off || strcmp(c->off, "off") == 0)
        return;
    if (c->psnr < 0)
        snprintf(text, sizeof text, "%s: %s", c->off, c->against);
    else if (c->psnr > 99)
        snprintf(text, sizeof text, "%s: %s, the same bits", c->off, c->against);
    else
        snprintf(text, sizeof text, "%s: %s, PSNR %.2f dB", c->off, c->against, c->psnr);
    write_text(s, amber, text);
    if (c->note && c->note[0])
        write_text(s, grey, c->note);
}

static void write_all(overlay_sheet *s, const panel_performance *f, const panel_compare *c)
{
    char text[TEXT_BYTES];
    snprintf(text, sizeof text, "%.1f ms  %.0f/s  key to picture %.0f ms",
             (double)f->median_ms, (double)f->shown_per_s, (double)f->latency_ms);
    write_text(s, white, text);
    write_graph(s, f);
    write_compare(s, c);
    if (f->state && f->state[0])
        write_text(s, grey, f->state);
    if (f->part_count)
        write_text(s, blue, "a picture");
    for (uint32_t i = 0; i < f->part_count && i < PANEL_TIMES; i++)
        write_time(s, green, &f->parts[i]);
    if (f->stage_count)
        write_text(s, blue, "its pixels, the most costly stages");
    for (uint32_t i = 0; i < f->stage_count && i < STAGES; i++)
        write_time(s, amber, &f->stages[i]);
}

void overlay_performance(font *l, const SDL_Rect *where, int scale,
                         const panel_performance *f, const panel_compare *c)
{
    const int wide = PANEL_HISTORY + 2 * MARGIN;
    int size = SDL_clamp(scale, 1, FONT_SCALES);
    while (size > 1 && wide * size > where->w)
        size--;
    const int margin = MARGIN * size;
    overlay_sheet s = { NULL, where->x + margin, where->y + margin, size,
                        where->y + where->h - margin };
    const int top = s.y;
    write_all(&s, f, c);                     /* dry run: measures the height */
    font_set_clip(l, where);
    font_draw_background(l, where->x, where->y, wide * size, s.y - top + 2 * margin, 192);
    s.to = l;
    s.y = top;
    write_all(&s, f, c);
    font_set_clip(l, NULL);
}

/* -- messages ------------------------------------------------------------------------ */

void overlay_message(font *l, const SDL_Rect *where, int scale, const char *text,
                     uint8_t alpha)
{
    const int size = SDL_clamp(scale, 1, FONT_SCALES), margin = MARGIN * size;
    const int pitch = (FONT_HIGH + 2) * size;
    const int cells = (where->w - 4 * margin) / (FONT_WIDE * size);
    char line[TEXT_BYTES];
    int lines = 0;
    for (const char *rest = text; *rest; lines++)
        rest = cut_line(rest, cells, line);
    int y = where->y + where->h - margin - lines * pitch;
    font_set_clip(l, where);
    for (; *text; y += pitch) {
        text = cut_line(text, cells, line);
        font_draw_background(l, where->x + margin, y,
                             (font_cell_count(line) + 2) * FONT_WIDE * size, pitch,
                             (uint8_t)(alpha * 200 / 255));
        font_draw(l, where->x + margin + FONT_WIDE * size, y + size, size,
                  white | (255u - alpha) << 24, line);
    }
    font_set_clip(l, NULL);
}
