/* SPDX-License-Identifier: MIT */
/* Mouse, wheel, held keys and the window's own events: what the person at the window
 * wants between two ticks.  Keys that ask once go to view_act.c. */
#ifndef SDL2_CONTROL_H
#define SDL2_CONTROL_H
#include <SDL.h>
#include <stdbool.h>
#include "keymap.h"
#include "pad.h"
#include "tidepool/world.h"

#define CONTROL_PLACES 64       /* of the right button, between two ticks */

typedef struct {
    int  x, y;                  /* pixel of the window */
    bool stir;                  /* moved with the button, else it went down */
} control_place;

typedef struct {
    bool     quit, exposed;     /* events: the loop takes them back */
    bool     hidden;            /* state: minimised */
    bool     captured;          /* state: the mouse turns the camera without a button */
    bool     turning, stirring; /* states: a button that went down on the picture is held */
    int      drag_x, drag_y;    /* pixels, since the last tick */
    int      wheel;             /* notches, likewise; + is away from the person */
    control_place place[CONTROL_PLACES];    /* events, in their order ... */
    int      places;            /* ... so many; of more the last one counts */
    bool     resized;
    uint64_t resized_at;        /* us, of the last change of a row of them */
    char     dropped[4096];     /* a file that was dropped on the window, "" none */
} control;

/* True: something may look otherwise now. */
bool control_event(control *c, const SDL_Event *event, uint64_t now);

/* The mouse turns the camera until it is let go again. */
void control_capture(control *c, bool on);

/* What is held now, for one tick; takes the drags.  `typing`: keys are a text field's. */
tp_input control_input(control *c, const keymap *keys, const pad *stick, bool typing);
#endif
