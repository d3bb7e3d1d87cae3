/* SPDX-License-Identifier: MIT */
/* A gamepad by SDL: sticks and triggers as held wishes, buttons as actions.  window_open()
 * begins SDL's gamepads; one may come and go while the window is open. */
#ifndef SDL2_PAD_H
#define SDL2_PAD_H
#include <SDL.h>
#include "../host/actions.h"
#include "tidepool/world.h"

typedef struct {
    SDL_GameController *pad;    /* the first one that is there; NULL: none */
} pad;

/* Plugged in, unplugged; a button that asks for something: its action, else ACTIONS. */
action pad_event(pad *p, const SDL_Event *event);

/* What its sticks wish for the next tick, added to *input. */
void   pad_input(const pad *p, tp_input *input);
void   pad_close(pad *p);
#endif
