/* SPDX-License-Identifier: MIT */
/* Drawing and widget functions of the panel, in C; panel.cpp implements them with Dear
 * ImGui.  Lengths are in px of the window, colours 0xRRGGBB.  Widgets are placed one
 * below the other; each is as high as a line of letters with its frame.  `id` is unique
 * between ui_push_id and ui_pop_id. */
#ifndef TP_APP_PREVIEW_PANEL_UI_H
#define TP_APP_PREVIEW_PANEL_UI_H
#include <SDL.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    UI_BACK = 0x15191e, UI_FRAME = 0x242b33, UI_OVER = 0x2f3943, UI_DOWN = 0x3a4a56,
    UI_HEAD = 0x1d232a, UI_LINE = 0x343d46, UI_TEXT = 0xd6dde2, UI_DIM = 0x86939e,
    UI_SEA = 0x48b0be, UI_FULL = 0x284c57, UI_HELD = 0x326674, UI_EDGE = 0x387c8a,
    UI_EDITED = 0xe8b060, UI_OVERDUE = 0xd86858
};

/* -- lengths and positions ----------------------------------------------------------- */

float ui_px(float at_one);             /* px at scale 1 to px at the current scale */
float ui_letter(void);                 /* width of a letter (monospaced font) */
float ui_letter_high(void);
float ui_wide(const char *text);
float ui_high(void);                   /* height of a widget */
float ui_gap(void);                    /* gap between widgets */
float ui_room(void);                   /* width left in the line */
SDL_FPoint ui_position(void);                /* position of the next widget */
void  ui_go(float x, float y);
/* True if a widget with its top at y is in view, or at most `margin` px above or below. */
bool  ui_in_sight(float y, float margin);

void  ui_push_id(int id);
void  ui_pop_id(void);
void  ui_indent(bool in);
void  ui_begin(void);                  /* begins a group: its widgets count as one */
void  ui_end(void);
void  ui_beside(float gap);            /* puts the next widget to the right */
void  ui_take(float wide, float high); /* reserves room for the following drawing calls */

/* -- drawing ------------------------------------------------------------------------- */

void  ui_box(float x, float y, float wide, float high, uint32_t colour);
void  ui_write(float x, float y, uint32_t colour, const char *text);
void ui_write_framed(float x, float y, uint32_t colour,
                      const char *text);                /* in a frame */
void  ui_text(uint32_t colour, const char *text);       /* a widget of text */
void  ui_text_wrapped(uint32_t colour, const char *text);
void  ui_tip(const char *text);        /* tooltip of the last widget, beside the panel */

/* -- state of the last widget, mouse, keyboard --------------------------------------- */

SDL_FRect ui_last(void);
bool  ui_hovered(void);
bool  ui_focused(void);                /* has the keyboard focus */
bool  ui_active(void);                 /* is held by the mouse, or edited */
bool  ui_left(void);                   /* editing ended in this frame */
bool  ui_any_active(void);
bool  ui_is_open(void);                /* a drop-down list or colour picker is open */
bool  ui_points(float x, float y, float wide, float high);     /* true: mouse inside */
bool  ui_pressed(int button);          /* 0 left, 1 right */
bool  ui_enter(void);
bool  ui_ctrl(void);
bool  ui_moves(void);                  /* the keyboard focus is shown */
double ui_time(void);                  /* s */

/* -- widgets ------------------------------------------------------------------------- */

bool  ui_button(const char *id, float wide, bool lit);
bool  ui_check(const char *id, bool *on);
bool  ui_swatch(const char *id, uint32_t rgb, float wide);     /* true: pressed */
bool  ui_slide(const char *id, int *place, int steps, float wide);
void  ui_focus_next(void);             /* sets the focus to the next widget */
bool  ui_field(const char *id, const char *hint, char *text, size_t bytes, float wide);
bool  ui_head(const char *name, bool forced);          /* group header; true: expanded */

bool  ui_list(const char *id, const char *shown, float wide);  /* shown NULL: an arrow */
bool  ui_choice(const char *text, bool chosen);
void  ui_list_end(void);

/* A colour square, as a drop-down picker.  Returns true if the colour has changed. */
void  ui_pick_open(void);
bool  ui_pick(uint32_t *rgb);

bool  ui_tabs(void);
bool  ui_tab(const char *name, bool now);              /* now: select this tab */
void  ui_tab_end(void);
void  ui_tabs_end(void);
void  ui_scroll(const char *id);       /* scroll area of all remaining height */
void  ui_scroll_end(void);

#ifdef __cplusplus
}
#endif
#endif
