/* SPDX-License-Identifier: MIT */
/* Drawing and widget functions of the panel, in C; panel.cpp implements them with Dear
 * ImGui.  Lengths are in px of the window, colours 0xRRGGBB.  Widgets are placed one
 * below the other; each is as high as a line of letters with its frame.  `id` is unique
 * between pen_push_id and pen_pop_id. */
#ifndef SDL2_PANEL_PEN_H
#define SDL2_PANEL_PEN_H
#include <SDL.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    PEN_BACK = 0x15191e, PEN_FRAME = 0x242b33, PEN_OVER = 0x2f3943, PEN_DOWN = 0x3a4a56,
    PEN_HEAD = 0x1d232a, PEN_LINE = 0x343d46, PEN_TEXT = 0xd6dde2, PEN_DIM = 0x86939e,
    PEN_SEA = 0x48b0be, PEN_FULL = 0x284c57, PEN_HELD = 0x326674, PEN_EDGE = 0x387c8a,
    PEN_EDITED = 0xe8b060, PEN_OVERDUE = 0xd86858
};

/* -- lengths and positions ------------------------------------------------------- */

float pen_px(float at_one);             /* px at scale 1 to px at the current scale */
float pen_letter(void);                 /* width of a letter (monospaced font) */
float pen_letter_high(void);
float pen_wide(const char *text);
float pen_high(void);                   /* height of a widget */
float pen_gap(void);                    /* gap between widgets */
float pen_room(void);                   /* width left in the line */
SDL_FPoint pen_position(void);                /* position of the next widget */
void  pen_go(float x, float y);
bool  pen_in_sight(float y, float margin);      /* y: top; margin: px out of view */

void  pen_push_id(int id);
void  pen_pop_id(void);
void  pen_indent(bool in);
void  pen_begin(void);                  /* begins a group: its widgets count as one */
void  pen_end(void);
void  pen_beside(float gap);            /* puts the next widget to the right */
void  pen_take(float wide, float high); /* reserves room for the following drawing calls */

/* -- drawing --------------------------------------------------------------------- */

void  pen_box(float x, float y, float wide, float high, uint32_t colour);
void  pen_write(float x, float y, uint32_t colour, const char *text);
void pen_write_framed(float x, float y, uint32_t colour,
                      const char *text);                /* in a frame */
void  pen_say(uint32_t colour, const char *text);       /* a widget of text */
void  pen_say_wrapped(uint32_t colour, const char *text);
void  pen_tip(const char *text);        /* tooltip of the last widget, beside the panel */

/* -- state of the last widget, mouse, keyboard ----------------------------------- */

SDL_FRect pen_last(void);
bool  pen_hovered(void);
bool  pen_focused(void);                /* has the keyboard focus */
bool  pen_active(void);                 /* is held by the mouse, or edited */
bool  pen_left(void);                   /* editing ended in this frame */
bool  pen_any_active(void);
bool  pen_is_open(void);                /* a drop-down list or colour picker is open */
bool  pen_points(float x, float y, float wide, float high);     /* true: mouse inside */
bool  pen_pressed(int button);          /* 0 left, 1 right */
bool  pen_enter(void);
bool  pen_ctrl(void);
bool  pen_moves(void);                  /* the keyboard focus is shown */
double pen_time(void);                  /* s */

/* -- widgets --------------------------------------------------------------------- */

bool  pen_button(const char *id, float wide, bool lit);
bool  pen_check(const char *id, bool *on);
bool  pen_swatch(const char *id, uint32_t rgb, float wide);     /* true: pressed */
bool  pen_slide(const char *id, int *place, int steps, float wide);
void  pen_focus_next(void);             /* sets the focus to the next widget */
bool  pen_field(const char *id, const char *hint, char *text, size_t bytes, float wide);
bool  pen_head(const char *name, bool forced);          /* group header; true: expanded */

bool  pen_list(const char *id, const char *shown, float wide);  /* shown NULL: an arrow */
bool  pen_choice(const char *text, bool chosen);
void  pen_list_end(void);

/* A colour square, as a drop-down picker.  Returns true if the colour has changed. */
void  pen_pick_open(void);
bool  pen_pick(uint32_t *rgb);

bool  pen_tabs(void);
bool  pen_tab(const char *name, bool now);              /* now: select this tab */
void  pen_tab_end(void);
void  pen_tabs_end(void);
void  pen_scroll(const char *id);       /* scroll area of all remaining height */
void  pen_scroll_end(void);

#ifdef __cplusplus
}
#endif
#endif
