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
} control;

void     control_event(control *c, const SDL_Event *event, uint64_t now);

/* The camera's movement of the next tick; takes the drag. */
tp_input control_input(control *c);
bool     control_moves(const tp_input *input);
#endif
