/* SPDX-License-Identifier: MIT */
/* The list of keys over the picture.  The full form has whole sentences, in as many
 * columns and as large letters as fit.  If no full form fits, the short form has names
 * alone, with related keys such as W A S D in one row: it fits 320x240. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include "key_help_words.h"
#include "overlay.h"

#define LINES      200
#define COLUMNS    4
#define GUTTER     3                /* most cells between columns */
#define NARROW     51               /* cells of the notes below the names */

static const uint32_t amber = 0xffd479, white = 0xe8eef4, blue = 0x7fc8ff;
static const uint32_t grey = 0x9fb0c0;

/* MORE: continues the text of the line above. */
typedef enum { HEADING, ROW, MORE, EMPTY } line_kind;

typedef struct {
    line_kind kind;
    char      keys[KEY_HELP_KEYS], text[72];
} key_help_line;

typedef struct {
    bool full;              /* sentences; false: names */
    int  wrap;              /* most cells of a sentence's line */
    int  columns, gutter;
    int  scale, pitch;      /* line pitch, px */
    bool air, whole;        /* air: empty lines between groups; whole: no group is split */
} key_help_form;

typedef struct {
    key_help_form form;
    key_help_line line[LINES];
    int  count;
    int  column[COLUMNS + 1];       /* first line of each column, then the end */
    int  keys[COLUMNS], wide[COLUMNS];      /* cells: of a column's keys, of the column */
    int  across, rows;      /* total width in cells, total height in lines */
    int  body;              /* lines of the highest column */
} key_help_sheet;

/* -- lines --------------------------------------------------------------------------- */

static key_help_line *add_line(key_help_sheet *s, line_kind kind)
{
    static key_help_line spare;
    key_help_line *l = s->count < LINES ? &s->line[s->count++] : &spare;
    *l = (key_help_line){ .kind = kind };
    return l;
}

/* Adds a sentence, broken into lines of at most form.wrap cells. */
static void add_sentence(key_help_sheet *s, const char *keys, const char *text)
{
    key_help_line *l = add_line(s, ROW);
    snprintf(l->keys, sizeof l->keys, "%s", keys);
    for (size_t wrap = (size_t)s->form.wrap; strlen(text) > wrap;) {
        size_t cut = wrap;
        while (cut > 0 && text[cut] != ' ')
            cut--;
        cut = cut ? cut : wrap;
        snprintf(l->text, sizeof l->text, "%.*s", (int)cut, text);
        text += cut + (text[cut] == ' ');
        l = add_line(s, MORE);
    }
    snprintf(l->text, sizeof l->text, "%s", text);
}

static void add_full(key_help_sheet *s, const keymap *m, int of)
{
    char keys[KEY_HELP_KEYS] = "";
    key_help_add_keys(keys, m->text[of]);
    add_sentence(s, keys[0] ? keys : "-", actions[of].help);
}

/* Adds one row of the short form for the action `of` and its related actions.  Returns
 * the number of actions in the row. */
static int add_short(key_help_sheet *s, const keymap *m, int of)
{
    static const struct { action first; int count; const char *name; } together[] = {
        { ACT_FORWARD, 6, "move" }, { ACT_NORTH, 4, "sphere" }, { ACT_POKE1, 6, "poke" },
        { ACT_SAIL, 4, "sail" }, { ACT_SLOWER, 2, "speed" }, { ACT_STEP, 2, "step" },
    };
    char keys[KEY_HELP_KEYS] = "", name[KEY_HELP_NAME];
    int count = 1;
    key_help_short_name(&actions[of], name);
    for (size_t i = 0; i < sizeof together / sizeof *together; i++)
        if (of == (int)together[i].first) {
            for (int k = 0; k < together[i].count; k++)
                key_help_add_keys(keys, m->text[of + k]);
            if (strlen(keys) < 12) {
                count = together[i].count;
                snprintf(name, sizeof name, "%s", together[i].name);
            }
        }
    if (count == 1) {
        keys[0] = 0;
        key_help_add_keys(keys, m->text[of]);
    }
    key_help_line *l = add_line(s, ROW);
    snprintf(l->keys, sizeof l->keys, "%s", keys[0] ? keys : "-");
    snprintf(l->text, sizeof l->text, "%s", name);
    return count;
}

/* Writes the lines of all groups, in the order of their first actions. */
static void write_lines(key_help_sheet *s, const keymap *m)
{
    s->count = 0;
    for (int of = 0; of < ACTIONS; of++) {
        bool before = false;
        for (int i = 0; i < of; i++)
            before = before || strcmp(actions[i].group, actions[of].group) == 0;
        if (before)
            continue;
        if (s->form.air && of > 0)
            add_line(s, EMPTY);
        snprintf(add_line(s, HEADING)->text, 72, "%s", actions[of].group);
        for (int i = of; i < ACTIONS;)
            if (strcmp(actions[i].group, actions[of].group) != 0)
                i++;
            else if (s->form.full)
                add_full(s, m, i++);
            else
                i += add_short(s, m, i);
    }
    if (!s->form.full)
        return;
    if (s->form.air)
        add_line(s, EMPTY);
    snprintf(add_line(s, HEADING)->text, 72, "mouse and gamepad");
    for (size_t i = 0; i < action_note_count; i++)
        add_sentence(s, action_notes[i].keys, action_notes[i].help);
}

/* -- columns ------------------------------------------------------------------------- */

/* Returns the number of lines to keep together from `i` on: a whole group, or a heading
 * with its first row, or a sentence. */
static int bundle(const key_help_sheet *s, int i)
{
    int n = 1;
    if (s->line[i].kind == HEADING && i + n < s->count)
        n++;
    while (i + n < s->count
           && (s->line[i + n].kind == MORE
               || (s->form.whole && s->line[i + n].kind == ROW)))
        n++;
    return n;
}

/* Splits the lines into columns of at most `limit` lines.  Returns the number of
 * columns, or more than COLUMNS if they do not fit. */
static int place(key_help_sheet *s, int limit)
{
    int columns = 0, used = limit;
    for (int i = 0, n; i < s->count; i += n) {
        n = bundle(s, i);
        const bool empty = s->line[i].kind == EMPTY;
        if (used + n + (empty ? bundle(s, i + 1) : 0) > limit) {
            if (columns == COLUMNS || n > limit)
                return COLUMNS + 1;
            s->column[columns++] = i + empty;   /* no empty line at the top */
            used = -empty;
        }
        used += n;
    }
    for (int c = columns; c <= COLUMNS; c++)
        s->column[c] = s->count;
    return columns;
}

static int longest(int a, const char *text)
{
    return SDL_max(a, font_cell_count(text));
}

static void measure_column(key_help_sheet *s, int c)
{
    int keys = 0, wide = 0;
    for (int i = s->column[c]; i < s->column[c + 1]; i++)
        keys = longest(keys, s->line[i].keys);
    keys = s->form.full ? keys : SDL_min(keys, 6);
    for (int i = s->column[c]; i < s->column[c + 1]; i++) {
        const key_help_line *l = &s->line[i];
        const int before = SDL_max(keys, font_cell_count(l->keys)) + 1;
        wide = SDL_max(wide, (l->kind == HEADING ? 0 : before) + font_cell_count(l->text));
    }
    s->keys[c] = keys;
    s->wide[c] = wide;
}

/* The notes on mouse and gamepad below the short form, as running text.  Draws if `l` is
 * given, at x, y.  Returns the number of lines. */
static int flow(const key_help_sheet *s, font *l, int x, int y)
{
    int row = 0, at = 0;
    for (size_t i = 0; i < action_note_count; i++) {
        char text[160], *rest = text, *word;
        int left = 1;
        for (const char *k = action_notes[i].keys; *k; k++)
            left += *k == ' ';
        snprintf(text, sizeof text, "%s %s", action_notes[i].keys, action_notes[i].help);
        while ((word = SDL_strtokr(rest, " ", &rest)) != NULL) {
            const int n = font_cell_count(word);
            if (at + n > s->across && at > 0) {
                row++;
                at = 0;
            }
            if (l)
                font_draw(l, x + at * FONT_WIDE * s->form.scale,
                             y + row * s->form.pitch, s->form.scale,
                             left > 0 ? amber : white, word);
            left--;
            at += n + 1;
        }
        at++;
    }
    return row + 1;
}

/* True if the form fits into `cells` x `lines`; computes its columns. */
static bool fits(key_help_sheet *s, int cells, int lines)
{
    s->body = s->count / s->form.columns;
    while (place(s, s->body) > s->form.columns)
        s->body++;
    s->across = s->form.gutter * (s->form.columns - 1);
    for (int c = 0; c < s->form.columns; c++) {
        measure_column(s, c);
        s->across += s->wide[c];
    }
    if (!s->form.full)
        s->across = SDL_max(s->across, SDL_min(cells, NARROW));
    const int more = s->form.full ? 2 : flow(s, NULL, 0, 0);
    s->rows = s->body + more;
    return s->across <= cells && s->rows <= lines;
}

/* px around the list */
static int form_margin(const key_help_form *f)
{
    return (f->full ? 6 : 3) * f->scale;
}

static bool fits_rectangle(key_help_sheet *s, const SDL_Rect *where)
{
    const int margin = 2 * form_margin(&s->form);
    return fits(s, (where->w - margin) / (FONT_WIDE * s->form.scale),
                (where->h - margin) / s->form.pitch);
}

/* -- choice of the form -------------------------------------------------------------- */

/* Finds a layout for the written lines: the fewest columns first, then the largest line
 * pitch, then unsplit groups. */
static bool try_columns(key_help_sheet *s, const SDL_Rect *where, int high, int least)
{
    for (int columns = 1; columns <= COLUMNS; columns++)
        for (int pitch = high; pitch >= least; pitch--)
            for (int whole = 1; whole >= 0; whole--) {
                s->form.columns = columns;
                s->form.pitch = pitch * s->form.scale;
                s->form.whole = whole;
                if (fits_rectangle(s, where))
                    return true;
            }
    return false;
}

/* Tries the full form at one scale: long lines first, then lines with air. */
static bool try_full(key_help_sheet *s, const keymap *m, const SDL_Rect *where, int scale)
{
    static const int wraps[] = { 71, 44, 36, 30 };
    for (size_t w = 0; w < sizeof wraps / sizeof *wraps; w++)
        for (int air = 1; air >= 0; air--) {
            s->form = (key_help_form){ .full = true, .wrap = wraps[w], .gutter = GUTTER,
                              .scale = scale, .air = air };
            write_lines(s, m);
            if (try_columns(s, where, FONT_HIGH + 2, FONT_HIGH))
                return true;
        }
    return false;
}

static bool try_names(key_help_sheet *s, const keymap *m, const SDL_Rect *where, int scale)
{
    for (int gutter = GUTTER; gutter > 0; gutter--) {
        s->form = (key_help_form){ .gutter = gutter, .scale = scale };
        write_lines(s, m);
        if (try_columns(s, where, FONT_HIGH, FONT_HIGH - 1))
            return true;
    }
    return false;
}

/* Order of preference: letters of at least the wanted scale; then sentences before
 * names; then larger letters. */
static void search(key_help_sheet *s, const keymap *m, const SDL_Rect *where, int scale)
{
    for (int k = FONT_SCALES; k >= scale; k--)
        if (try_full(s, m, where, k))
            return;
    for (int k = FONT_SCALES; k >= scale; k--)
        if (try_names(s, m, where, k))
            return;
    for (int k = scale - 1; k >= 1; k--)
        if (try_full(s, m, where, k) || try_names(s, m, where, k))
            return;
    s->form =
        (key_help_form){ .columns = 3, .gutter = 1, .scale = 1, .pitch = FONT_HIGH - 1 };
    write_lines(s, m);
    fits_rectangle(s, where);               /* the lines that fit */
}

static void draw_column(const key_help_sheet *s, font *l, int c, int x, int y)
{
    const int cell = FONT_WIDE * s->form.scale;
    for (int i = s->column[c]; i < s->column[c + 1]; i++, y += s->form.pitch) {
        const key_help_line *of = &s->line[i];
        const int keys = SDL_max(s->keys[c], font_cell_count(of->keys)) + 1;
        font_draw(l, x, y, s->form.scale, amber, of->keys);
        font_draw(l, x + (of->kind == HEADING ? 0 : keys * cell), y, s->form.scale,
                  of->kind == HEADING ? blue : white, of->text);
    }
}

/* Returns the sheet for a rectangle and a scale of letters.  The last sheet is kept, since
 * the search takes milliseconds. */
static const key_help_sheet *chosen(const keymap *m, const SDL_Rect *where, int scale)
{
    static key_help_sheet last;
    static keymap keys;
    static int wide, high, shown_scale;
    if (!shown_scale || wide != where->w || high != where->h || shown_scale != scale
        || memcmp(&keys, m, sizeof keys) != 0) {
        search(&last, m, where, scale);
        keys = *m;
        wide = where->w;
        high = where->h;
        shown_scale = scale;
    }
    return &last;
}

void overlay_help(font *l, const SDL_Rect *where, int scale, const keymap *keys)
{
    const key_help_sheet *s = chosen(keys, where, SDL_clamp(scale, 1, FONT_SCALES));
    const key_help_form *f = &s->form;
    const int cell = FONT_WIDE * f->scale, margin = form_margin(f);
    const int wide = s->across * cell + 2 * margin, high = s->rows * f->pitch + 2 * margin;
    int x = where->x + SDL_max((where->w - wide) / 2, 0) + margin;
    int y = where->y + SDL_max((where->h - high) / 2, 0) + margin;
    font_set_clip(l, where);
    font_draw_background(l, x - margin, y - margin, wide, high, 216);
    for (int c = 0, at = x; c < f->columns; c++) {
        draw_column(s, l, c, at, y);
        at += (s->wide[c] + f->gutter) * cell;
    }
    y += s->body * f->pitch;
    if (f->full)
        font_draw(l, x, y + f->pitch, f->scale, grey,
                  "~/.config/tidepool/keys.ini changes keys:  drop = Return");
    else
        flow(s, l, x, y);
    font_set_clip(l, NULL);
}
