/* SPDX-License-Identifier: MIT */
/* Mouse, wheel, held keys and window events: the person's input between two ticks.  Keys
 * with a single effect go to view_actions.c. */
#ifndef TP_APP_PREVIEW_USER_INPUT_H
#define TP_APP_PREVIEW_USER_INPUT_H
#include <SDL.h>
#include <stdbool.h>
#include "gamepad.h"
#include "keymap.h"
#include "tidepool/world.h"

#define USER_INPUT_PLACES 64       /* positions of the right button between two ticks */

typedef struct {
    int  x, y;                  /* pixel of the window */
    bool stir;                  /* true: moved with the button down; false: pressed */
} user_input_place;

typedef struct {
    bool     quit, exposed;     /* events; the loop resets them */
    bool     hidden;            /* state: minimised */
    bool     captured;          /* state: the mouse turns the camera without a button */
    bool     turning, stirring; /* states: a button pressed on the picture is held */
    int      drag_x, drag_y;    /* px since the last tick */
    int      wheel;             /* notches since the last tick; + is away from the person */
    user_input_place place[USER_INPUT_PLACES];    /* events in their order */
    int      places;            /* count; if full, the last place is overwritten */
    bool     resized;
    uint64_t resized_at;        /* us; the last resize event of a series */
    char     dropped[4096];     /* path of a file dropped on the window, "" if none */
} user_input;

/* Returns true if the window may need drawing. */
bool user_input_event(user_input *c, const SDL_Event *event, uint64_t now);

/* Captures or releases the mouse.  A captured mouse turns the camera. */
void user_input_capture(user_input *c, bool on);

/* Returns the input of one tick: held keys, and drags, reset by the call.  `typing`:
 * keys go to a text field. */
tp_input user_input_read(user_input *c, const keymap *keys, const pad *stick, bool typing);
#endif
