/* SPDX-License-Identifier: MIT */
/* The upper part of the panel: the list of scenes, and buttons for actions. */
#include <stdio.h>
#include <string.h>
#include "app/session/actions.h"
#include "panel_parts.h"
#include "panel_ui.h"

void panel_line(uint32_t colour, const char *text)
{
    char cut[PANEL_TEXT];
    const int fits = SDL_max((int)(ui_room() / ui_letter()), 2);
    const int all = (int)strlen(text);
    snprintf(cut, sizeof cut, "%.*s%s", all > fits ? fits - 2 : all, text,
             all > fits ? ".." : "");
    ui_text(colour, cut);
    if (all > fits && ui_hovered())
        ui_tip(text);
}

/* -- buttons ------------------------------------------------------------------------- */

static const struct { int what; const char *name, *name_on; } buttons[] = {
    { ACT_PAUSE, "pause", "go on" }, { ACT_STEP, "step", "step" },
    { ACT_RESTART, "restart", "restart" }, { ACT_UNDO, "undo", "undo" },
    { ACT_REDO, "redo", "redo" }, { ACT_SAVE, "save", "save" },
    { ACT_FILM, "film", "end film" }, { ACT_TAPE, "tape", "end tape" },
    { ACT_SHOT, "picture", "picture" },
};

static void tell(const panel *p, int what)
{
    char text[2 * PANEL_TEXT];
    const char *const to = what == ACT_SAVE && p->host->saved_as ? p->host->saved_as : "";
    snprintf(text, sizeof text, "%s%s%s", actions[what].help, to[0] ? "\n" : "", to);
    ui_tip(text);
}

/* The button's name is at the left; its key is dim at the right, if there is room. */
void panel_button(panel *p, int what, const char *name, float wide)
{
    const panel_host *const h = p->host;
    const char *const key = h->keys(h->user, what);
    const float gap = ui_px(5), key_wide = ui_wide(key);
    ui_push_id(what);
    const bool pressed = ui_button("##act", wide, h->is_on(h->user, what));
    const SDL_FRect at = ui_last();
    ui_write_framed(at.x + gap, at.y, UI_TEXT, name);
    if (ui_wide(name) + key_wide + 3 * gap <= at.w)
        ui_write_framed(at.x + at.w - gap - key_wide, at.y, UI_DIM, key);
    if (ui_hovered())
        tell(p, what);
    ui_pop_id();
    if (pressed)
        h->act(h->user, what);
}

static void show_buttons(panel *p)
{
    const float room = ui_room(), gap = ui_gap();
    const int columns = room >= 39 * ui_letter() ? 3 : 2;
    const float wide = SDL_floorf((room - gap * (float)(columns - 1)) / (float)columns);
    for (int i = 0; i < (int)SDL_arraysize(buttons); i++) {
        const bool on = p->host->is_on(p->host->user, buttons[i].what);
        if (i % columns != 0)
            ui_beside(gap);
        panel_button(p, buttons[i].what, on ? buttons[i].name_on : buttons[i].name, wide);
    }
}

/* -- scenes -------------------------------------------------------------------------- */

static void show_scenes(panel *p)
{
    const panel_host *const h = p->host;
    const bool known = h->scene < h->scene_count;
    const char *const name = known ? h->scenes[h->scene] : h->name;
    const char *const about = known ? h->shows[h->scene] : h->about;
    if (ui_list("##scene", name ? name : "", ui_room())) {
        for (uint32_t i = 0; i < h->scene_count; i++) {
            ui_push_id((int)i);
            if (ui_choice(h->scenes[i], i == h->scene))
                p->to_open = i;
            if (ui_hovered() && h->shows[i])
                ui_tip(h->shows[i]);
            ui_pop_id();
        }
        ui_list_end();
    }
    panel_line(UI_DIM, about ? about : "");
}

void panel_top(panel *p)
{
    show_scenes(p);
    show_buttons(p);
    panel_line(UI_EDITED, p->host->message ? p->host->message : "");
}
