/* SPDX-License-Identifier: MIT */
/* Five buttons as input: up lets a drop fall, select pokes the pool where the picture's
 * middle looks, left and right steer the sphere of drops, or turn the camera where there
 * is none, down turns the light.
 *
 * Lines are low while a button is pressed, and act when they rise: a line that reads low
 * until it is first driven does no harm.  Read them once a picture: what bounces has come
 * to rest by the next. */
#ifndef BOARD_BUTTONS_H
#define BOARD_BUTTONS_H
#include "tidepool/world.h"

enum { BUTTON_UP = 1, BUTTON_DOWN = 2, BUTTON_LEFT = 4, BUTTON_RIGHT = 8,
       BUTTON_SELECT = 16 };

typedef struct { uint32_t lines; } buttons;     /* as last read; begin with a reading */

/* Adds to *input what has been let go since. */
void buttons_read(buttons *b, uint32_t lines, const tp_world *world,
                  const tp_scene *scene, tp_input *input);
#endif
