/* SPDX-License-Identifier: MIT */
/* Whose a key or a click is, the panel's or the picture's, and keys in their order.
 *
 * The keyboard is the picture's until a person asks for the panel: by its search, by Tab
 * or by a click into a field.  Esc gives it back.  Dear ImGui sees which keys are down
 * and not in what order they came: one that goes down and up between two pictures would
 * never have been.  So they wait here, and each picture takes as many as it can tell
 * apart. */
#ifndef SDL2_PANEL_KEYS_H
#define SDL2_PANEL_KEYS_H
#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { PANEL_KEYS = 64 };

typedef struct {
    bool      here;             /* arrows, Tab, Enter move about in the panel */
    bool      leave;            /* Esc, or a click beside it: to be given back */
    bool      searching;        /* the search is asked for and not there yet */
    bool      typing;           /* so is the field of a number, or it is typed in */

    /* Told at every picture. */
    bool      writes;           /* a field takes letters */
    bool      open;             /* a list or a colour has dropped down */
    bool      on_number;        /* the keyboard's place is a slider */
    bool      over;             /* the mouse is the panel's wherever it is */
    SDL_Rect  where;

    SDL_Event event[PANEL_KEYS];
    uint32_t  events, waited;   /* pictures since the first could be told */
    bool      taken;            /* the last key that went down */
    bool      held;             /* a mouse button that went down here */
    bool      up, down;         /* went in this picture */
} panel_keys;

/* Whether an event of keys or the mouse is the panel's and nobody else's. */
bool keys_event(panel_keys *k, const SDL_Event *event);

/* Whether letters are the panel's. */
bool keys_types(const panel_keys *k);

/* The keyboard is the picture's again: what waits is forgotten, but keys that go up. */
void keys_leave(panel_keys *k);

/* The keys and letters for this picture, one after the other; false: that was all. */
void keys_begin(panel_keys *k);
bool keys_next(panel_keys *k, SDL_Event *event);

#ifdef __cplusplus
}
#endif
#endif
