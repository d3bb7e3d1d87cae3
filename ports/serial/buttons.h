/* SPDX-License-Identifier: MIT */
/* Five buttons as input.  Up releases a drop, select pushes the pool at the point in the
 * picture's middle, left and right move the sphere of drops, or turn the camera if the
 * scene has no drops, down turns the light.
 *
 * Lines are low while a button is pressed, and buttons act on release (rising edge): a
 * line that reads low until it is first driven has no effect.  Read the lines once a
 * picture: contact bounce has ended by the next reading. */
#ifndef TP_SERIAL_BUTTONS_H
#define TP_SERIAL_BUTTONS_H
#include "tidepool/world.h"

enum { BUTTON_UP = 1, BUTTON_DOWN = 2, BUTTON_LEFT = 4, BUTTON_RIGHT = 8,
       BUTTON_SELECT = 16 };

typedef struct { uint32_t lines; } buttons;     /* last reading; start with one */

/* Adds the actions of buttons released since the last reading to *input. */
void buttons_read(buttons *b, uint32_t lines, const tp_world *world,
                  const tp_scene *scene, tp_input *input);
#endif
