/* SPDX-License-Identifier: MIT */
/* Keys from a terminal: bytes, without events for key releases. */
#ifndef TP_APP_FULLSCREEN_TERMINAL_KEYS_H
#define TP_APP_FULLSCREEN_TERMINAL_KEYS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/world.h"

/* Opposite keys are neighbours: they differ in the lowest bit. */
enum { KEY_AHEAD, KEY_BACK, KEY_LEFT, KEY_RIGHT, KEY_DOWN, KEY_UP, KEY_TURN_LEFT,
       KEY_TURN_RIGHT, KEY_TILT_UP, KEY_TILT_DOWN, KEY_LIGHT_LEFT, KEY_LIGHT_RIGHT,
       KEY_LIGHT_UP, KEY_LIGHT_DOWN, KEY_STEER_FAR, KEY_STEER_NEAR, KEY_STEER_LEFT,
       KEY_STEER_RIGHT, KEYS };

typedef struct {
    uint8_t held[KEYS];         /* ticks for which the key still counts as held */
    bool    run;                /* the last letter was a capital */
    bool    quit, interrupt;    /* Esc; Ctrl-C */
    bool    pause;              /* a state, not an event */
    int     drops, slower;      /* since the last tick: number of drops to release; slower
                                 * minus faster key presses */
    bool    within;             /* inside an escape sequence, or just after an Esc */
    uint8_t escape[8], escapes; /* bytes of the sequence after the Esc */
} terminal_keys;

/* Handles bytes in order.  An Esc at the end may be the Esc key or the start of a
 * sequence: call terminal_keys_flush after a pause without further bytes; then it
 * counts as the key. */
void terminal_keys_add_bytes(terminal_keys *k, const uint8_t *bytes, size_t count);
void terminal_keys_flush(terminal_keys *k);

/* Returns the input of the next tick, and counts the held keys down by a tick. */
tp_input terminal_keys_input(terminal_keys *k);
#endif
