/* SPDX-License-Identifier: MIT */
/* What the panel's parts ask of Dear ImGui, in C: panel.cpp answers.  Lengths are pixels
 * of the window, colours 0xRRGGBB.  Things stand one below the other, each as high as a
 * line of letters and its frame; `id` tells them apart within pen_in and pen_out. */
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

/* -- lengths and places ---------------------------------------------------------- */

float pen_px(float at_one);             /* at scale 1 */
float pen_letter(void);                 /* width; all are as wide */
float pen_letter_high(void);
float pen_wide(const char *text);
float pen_high(void);                   /* of a thing */
float pen_gap(void);                    /* between things */
float pen_room(void);                   /* width to the right end */
SDL_FPoint pen_at(void);                /* where the next thing goes */
void  pen_go(float x, float y);
bool  pen_in_sight(float y, float margin);      /* a thing whose top is at y */

void  pen_in(int id);
void  pen_out(void);
void  pen_indent(bool in);
void  pen_begin(void);                  /* things that count as one, in a row */
void  pen_end(void);
void  pen_beside(float gap);            /* the next thing stands beside the last one */
void  pen_take(float wide, float high); /* room for what is drawn by the following */

/* -- ink ------------------------------------------------------------------------- */

void  pen_box(float x, float y, float wide, float high, uint32_t colour);
void  pen_write(float x, float y, uint32_t colour, const char *text);
void  pen_write_in(float x, float y, uint32_t colour, const char *text);  /* of a frame */
void  pen_say(uint32_t colour, const char *text);       /* things too */
void  pen_say_wrapped(uint32_t colour, const char *text);
void  pen_tip(const char *text);        /* of the last thing, beside the panel */

/* -- the last thing, mouse and keyboard ------------------------------------------ */

SDL_FRect pen_last(void);
bool  pen_hovered(void);
bool  pen_focused(void);                /* the keyboard's place is there */
bool  pen_active(void);                 /* held, or typed in */
bool  pen_left(void);                   /* no more, since this picture */
bool  pen_any_active(void);
bool  pen_is_open(void);                /* a list or a colour */
bool  pen_points(float x, float y, float wide, float high);     /* the mouse, there */
bool  pen_pressed(int button);          /* 0 left, 1 right */
bool  pen_enter(void);
bool  pen_ctrl(void);
bool  pen_moves(void);                  /* the keyboard's place is shown */
double pen_time(void);                  /* s */

/* -- things ---------------------------------------------------------------------- */

bool  pen_button(const char *id, float wide, bool lit);
bool  pen_check(const char *id, bool *on);
bool  pen_swatch(const char *id, uint32_t rgb, float wide);     /* true: pressed */
bool  pen_slide(const char *id, int *place, int steps, float wide);
void  pen_focus_next(void);             /* the keyboard goes to the next thing */
bool  pen_field(const char *id, const char *hint, char *text, size_t bytes, float wide);
bool  pen_head(const char *name, bool forced);          /* of a group: open */

bool  pen_list(const char *id, const char *shown, float wide);  /* NULL: an arrow */
bool  pen_choice(const char *text, bool chosen);
void  pen_list_end(void);

/* A square of colours that drops down; true: moved. */
void  pen_pick_open(void);
bool  pen_pick(uint32_t *rgb);

bool  pen_tabs(void);
bool  pen_tab(const char *name, bool now);              /* now: brought to the front */
void  pen_tab_end(void);
void  pen_tabs_end(void);
void  pen_scroll(const char *id);       /* what is left of the room, moved by the wheel */
void  pen_scroll_end(void);

#ifdef __cplusplus
}
#endif
#endif
