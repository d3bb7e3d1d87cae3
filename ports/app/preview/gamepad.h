/* SPDX-License-Identifier: MIT */
/* A gamepad by SDL: sticks and triggers as held input, buttons as actions. window_open()
 * starts SDL's gamepad system; a gamepad may be plugged in and out while the window is
 * open. */
#ifndef TP_APP_PREVIEW_GAMEPAD_H
#define TP_APP_PREVIEW_GAMEPAD_H
#include <SDL.h>
#include "app/session/actions.h"
#include "tidepool/world.h"

typedef struct {
    SDL_GameController *pad;    /* the first gamepad; NULL: none */
} pad;

/* Handles plugging in and out.  Returns the action of a pressed button, else ACTIONS. */
action pad_event(pad *p, const SDL_Event *event);

/* Adds the sticks' input for the next tick to *input. */
void   pad_input(const pad *p, tp_input *input);
void   pad_close(pad *p);
#endif
