/* SPDX-License-Identifier: MIT */
/* Keys and mouse: what the person at the window wants. */
#ifndef SDL2_CONTROL_H
#define SDL2_CONTROL_H
#include <SDL.h>
#include <stdbool.h>
#include "tidepool/scene.h"

typedef struct {
    bool     quit, pause;       /* pause: state, not event */
    bool     shot, exposed;     /* events: the loop takes them back */
    int      drag_x, drag_y;    /* pixels dragged since the last tick */
    bool     resized;
    uint64_t resized_at;        /* us, of the last change of a row of them */
    int      width, height;     /* of the window, once resized */
    bool     poke;              /* event: the right button ... */
    int      poke_x, poke_y;    /* ... at this pixel */
    int      drops, slower;     /* events since the last tick */
} control;

void     control_event(control *c, const SDL_Event *event, uint64_t now);

/* What is wished for the next tick, but for pokes; takes the drag and the events. */
tp_input control_input(control *c);
#endif
