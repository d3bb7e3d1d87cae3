/* SPDX-License-Identifier: MIT */
/* Routing of keys and clicks to the panel or to the picture, and key events in order.
 *
 * The picture has the keyboard until the person calls the panel: by its search, by Tab
 * or by a click into a field.  Esc returns the keyboard.  Dear ImGui samples the key
 * states once per frame and does not see their order: it would miss a key pressed and
 * released between two frames.  Therefore key events wait in a queue, and each frame
 * takes as many events as Dear ImGui can tell apart. */
#ifndef TP_APP_PREVIEW_PANEL_KEYS_H
#define TP_APP_PREVIEW_PANEL_KEYS_H
#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { PANEL_KEYS = 64 };

typedef struct {
    bool      here;             /* the panel has the focus: arrows, Tab, Enter move in it */
    bool      leave;            /* Esc, or a click outside: release the keyboard */
    bool      searching;        /* the focus is requested for the search, not yet there */
    bool      typing;           /* the same for a number's field, or a number is edited */

    /* Set at every frame: */
    bool      writes;           /* a text field is being edited */
    bool      open;             /* a list or colour picker is open */
    bool      on_number;        /* the focus is on a slider */
    bool      over;             /* the panel takes all mouse events */
    SDL_Rect  where;

    SDL_Event event[PANEL_KEYS];
    uint32_t  events, waited;   /* frames that the first event has waited */
    bool      taken;            /* the panel took the last key press, so the letter of that
                                 * press is the panel's too */
    bool      held;             /* a mouse button pressed in the panel */
    bool      up, down;         /* this frame got a key release, a press */
} panel_keys;

/* True if a key or mouse event belongs to the panel alone. */
bool panel_keys_event(panel_keys *k, const SDL_Event *event);

/* True if letters go to the panel. */
bool panel_keys_types(const panel_keys *k);

/* Returns the keyboard to the picture.  Drops queued events, except key releases. */
void panel_keys_leave(panel_keys *k);

/* panel_keys_begin starts a frame; panel_keys_next gives its key and text events in
 * order, false at the end. */
void panel_keys_begin(panel_keys *k);
bool panel_keys_next(panel_keys *k, SDL_Event *event);

#ifdef __cplusplus
}
#endif
#endif
