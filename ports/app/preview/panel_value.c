/* SPDX-License-Identifier: MIT */
/* A row of the panel.  Changes of a value go to the host as text; a drag is one change,
 * regardless of its number of steps. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "panel_parts.h"
#include "panel_ui.h"

#define TIP_S 0.5

static void put(panel *p, uint32_t row, const char *text)
{
    p->host->set(p->host->user, row, text, false);
}

static void set_changed_value(panel *p, uint32_t row, const char *text, const char *before)
{
    if (strcmp(text, before) == 0)
        return;
    p->host->set(p->host->user, row, text, true);
    p->sliding = (int)row;
}

/* Ends a drag after release: sets the last value once more as the final one. */
static void end_sliding(panel *p)
{
    char text[PANEL_TEXT];
    const uint32_t row = (uint32_t)p->sliding;
    if (p->sliding < 0 || ui_any_active())
        return;
    p->host->get(p->host->user, row, text);
    put(p, row, text);
    p->sliding = -1;
}

/* -- text and numbers ---------------------------------------------------------------- */

/* A text field.  Sets the typed text when the field is left, if the text has changed. */
static void show_field(panel *p, uint32_t row, const char *text, float wide)
{
    char typed[PANEL_TEXT];
    snprintf(typed, sizeof typed, "%s", text);
    ui_field("##v", NULL, typed, sizeof typed, wide);
    if (ui_left() && strcmp(typed, text) != 0)
        put(p, row, typed);
}

/* Dear ImGui moves the focus in the following frame, and starts over if asked again: ask
 * in every 4th frame only. */
void panel_request_focus(panel *p)
{
    if (p->asked++ % 4 == 0)
        ui_focus_next();
}

static void begin_typing(panel *p, uint32_t row)
{
    p->typing = (int)row;
    p->typing_new = p->typing_seen = p->keys.typing = true;
    p->asked = 0;
}

/* A field for a typed number.  The first frame draws nothing: slider and field share an
 * ID, and the slider has to release it. */
static void type_number(panel *p, uint32_t row, const char *text, float wide)
{
    p->typing_seen = true;
    if (p->typing_new && p->asked == 0) {
        p->asked = 4;
        ui_take(wide, ui_high());
        return;
    }
    if (p->typing_new)
        panel_request_focus(p);
    show_field(p, row, text, wide);
    if (ui_active())
        p->typing_new = false;
    else if (!p->typing_new)
        p->typing_seen = false;
}

/* Draws a slider's bar, and over the bar the value and its unit. */
static void write_value(const panel_row *row, const char *text, float share)
{
    const SDL_FRect at = ui_last();
    const float gap = ui_px(5), edge = ui_px(2), unit = ui_wide(row->unit);
    const float full = SDL_floorf((at.w - edge) * share);
    ui_box(at.x, at.y, full, at.h, ui_active() ? UI_HELD : UI_FULL);
    ui_box(at.x + full, at.y, edge, at.h, UI_EDGE);
    ui_box(at.x + full, at.y + at.h - 2 * edge, edge, 2 * edge, UI_SEA);
    ui_write_framed(at.x + gap, at.y, UI_TEXT, text);
    if (row->unit[0] && ui_wide(text) + unit + 3 * gap <= at.w)
        ui_write_framed(at.x + at.w - gap - unit, at.y, UI_DIM, row->unit);
}

/* A slider of positions.  While the slider is held its position is kept, because
 * keyboard steps may be smaller than the resolution of the resulting numbers. */
static void slide(panel *p, uint32_t row, const char *text, float wide)
{
    char made[PANEL_TEXT];
    const panel_row *const r = &p->host->row[row];
    const double value = strtod(text, NULL);
    const panel_span span = panel_span_choose(r, value);
    int place = p->sliding == (int)row ? p->place : panel_place(&span, value);
    if (ui_slide("##v", &place, span.steps, wide)) {
        panel_number(&span, place, made);
        set_changed_value(p, row, made, text);
        p->place = place;
    }
    p->keys.on_number |= ui_focused();
    if (ui_focused() && ui_enter())
        begin_typing(p, row);
    write_value(r, text, (float)place / (float)span.steps);
}

/* A number: a slider, or a text field after Ctrl+click, right click or Enter. */
static void show_number(panel *p, uint32_t row, const char *text, float wide)
{
    const SDL_FPoint at = ui_position();
    if (ui_points(at.x, at.y, wide, ui_high())
        && (ui_pressed(1) || (ui_pressed(0) && ui_ctrl())))
        begin_typing(p, row);
    if (p->typing == (int)row)
        type_number(p, row, text, wide);
    else
        slide(p, row, text, wide);
}

/* -- the other kinds ----------------------------------------------------------------- */

static void show_switch(panel *p, uint32_t row, const char *text)
{
    bool on = strcmp(text, "on") == 0;
    if (ui_check("##v", &on))
        put(p, row, on ? "on" : "off");
}

static void show_colour(panel *p, uint32_t row, const char *text, float wide)
{
    char made[PANEL_TEXT];
    uint32_t rgb = panel_colour(text);
    const float digits = 7 * ui_letter() + ui_px(11) + ui_gap();
    const float swatch = SDL_clamp(wide - digits, ui_px(8), 2 * ui_high());
    if (ui_swatch("##swatch", rgb, swatch))
        ui_pick_open();
    if (ui_pick(&rgb)) {
        snprintf(made, sizeof made, "#%06x", (unsigned)rgb);
        set_changed_value(p, row, made, text);
    }
    ui_beside(ui_gap());
    show_field(p, row, text, wide - swatch - ui_gap());
}

static void show_choice(panel *p, uint32_t row, const char *text, float wide)
{
    char word[PANEL_TEXT];
    if (!ui_list("##v", text, wide))
        return;
    for (uint32_t i = 0; panel_word(p->host->row[row].unit, i, word); i++)
        if (ui_choice(word, strcmp(word, text) == 0))
            put(p, row, word);
    ui_list_end();
}

/* A file name: typed, or selected from the list of pictures. */
static void show_picture(panel *p, uint32_t row, const char *text, float wide)
{
    const panel_host *const h = p->host;
    show_field(p, row, text, wide - ui_high() - ui_px(1));
    ui_beside(ui_px(1));
    if (!ui_list("##of", NULL, 0))
        return;
    if (ui_choice("none", text[0] == '\0'))
        put(p, row, "");
    for (uint32_t i = 0; i < h->picture_count; i++)
        if (ui_choice(h->pictures[i], strcmp(h->pictures[i], text) == 0))
            put(p, row, h->pictures[i]);
    ui_list_end();
}

static void show_value(panel *p, uint32_t row, const char *text, float wide)
{
    switch (p->host->row[row].kind) {
    case PANEL_NUMBER:
    case PANEL_COUNT:   show_number(p, row, text, wide);  break;
    case PANEL_SWITCH:  show_switch(p, row, text);        break;
    case PANEL_COLOUR:  show_colour(p, row, text, wide);  break;
    case PANEL_CHOICE:  show_choice(p, row, text, wide);  break;
    case PANEL_PICTURE: show_picture(p, row, text, wide); break;
    case PANEL_MESH:
    case PANEL_WORDS:   show_field(p, row, text, wide);   break;
    }
}

/* -- the row ------------------------------------------------------------------------- */

/* A reset button at the end of a row, shown if the value differs from the file's or the
 * default. */
static void show_reset(panel *p, uint32_t row, bool filed)
{
    const float side = ui_high();
    if (ui_button("##reset", side, false))
        p->host->reset(p->host->user, row);
    const SDL_FRect at = ui_last();
    if (ui_hovered())
        ui_tip(filed ? "reset to the default" : "reset to the file's value");
    ui_write_framed(at.x + SDL_floorf((side - ui_letter()) / 2), at.y,
                    filed ? UI_DIM : UI_EDITED, "<");
}

/* The help of a row, shown after mouse or focus have stayed on the row for TIP_S. */
static void show_tip(panel *p, uint32_t row, SDL_FPoint at, float wide)
{
    char text[512];
    const bool mouse = ui_points(at.x, at.y, wide, ui_high());
    const bool focus = p->keys.here && ui_focused() && ui_moves();
    if ((!mouse && !focus) || ui_any_active() || ui_is_open())
        return;
    p->tip_new = (int)row;
    if (p->tip != p->tip_new || ui_time() - p->tip_since < TIP_S)
        return;
    panel_tip(&p->host->row[row], text, sizeof text);
    ui_tip(text);
}

/* Draws a row.  A row out of view only reserves its height; rows just above and below
 * the view are drawn, as targets for the arrow keys. */
void panel_row_show(panel *p, uint32_t row)
{
    char label[PANEL_NAME], text[PANEL_TEXT];
    const panel_host *const h = p->host;
    const SDL_FPoint at = ui_position();
    const float room = ui_room(), high = ui_high(), gap = ui_gap();
    const float names = SDL_floorf(SDL_min(room * 0.4f, 19 * ui_letter()));
    const float wide = SDL_max(room - names - 2 * gap - high, 4 * ui_letter());
    if (!ui_in_sight(at.y, 3 * high)) {
        ui_take(room, high);
        return;
    }
    const bool normal = h->is_normal(h->user, row), filed = h->is_filed(h->user, row);
    h->get(h->user, row, text);
    panel_label(&h->row[row], (uint32_t)(names / ui_letter()), label);
    ui_write_framed(at.x, at.y, !filed ? UI_EDITED : normal ? UI_DIM : UI_TEXT, label);
    ui_push_id((int)row);
    ui_begin();
    ui_go(at.x + names + gap, at.y);
    show_value(p, row, text, wide);
    show_tip(p, row, at, room);
    if (!normal || !filed) {
        ui_beside(gap);
        ui_go(at.x + room - high, at.y);
        show_reset(p, row, filed);
    }
    ui_end();
    ui_pop_id();
}

void panel_rows_begin(panel *p)
{
    p->typing_seen = p->keys.on_number = false;
    p->tip_new = -1;
}

/* Ends typing if the number is no longer edited or its row has disappeared. */
void panel_rows_end(panel *p)
{
    if (!p->typing_seen)
        p->typing = -1;
    p->keys.typing = p->typing >= 0;
    if (p->tip != p->tip_new)
        p->tip_since = ui_time();
    p->tip = p->tip_new;
    end_sliding(p);
}
