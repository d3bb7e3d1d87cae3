/* SPDX-License-Identifier: MIT */
/* Keys as a terminal sends them: bytes, without a word of when a key goes up. */
#ifndef SCREEN_KEYS_H
#define SCREEN_KEYS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/world.h"

/* Opposites side by side. */
enum { KEY_AHEAD, KEY_BACK, KEY_LEFT, KEY_RIGHT, KEY_DOWN, KEY_UP, KEY_TURN_LEFT,
       KEY_TURN_RIGHT, KEY_TILT_UP, KEY_TILT_DOWN, KEY_LIGHT_LEFT, KEY_LIGHT_RIGHT,
       KEY_LIGHT_UP, KEY_LIGHT_DOWN, KEY_STEER_FAR, KEY_STEER_NEAR, KEY_STEER_LEFT,
       KEY_STEER_RIGHT, KEYS };

typedef struct {
    uint8_t held[KEYS];         /* ticks for which it still counts as held */
    bool    run;                /* the last letter was a capital */
    bool    quit, interrupt;    /* Esc; Ctrl-C */
    bool    pause;              /* a state, not an event */
    int     drops, slower;      /* since the last tick */
    bool    within;             /* a sequence, or an Esc so far */
    uint8_t escape[8], escapes; /* its bytes after the Esc */
} keys;

/* Bytes as they came.  An Esc that is the last of them may be a key or begin a sequence:
 * keys_rest, once nothing has followed for a while, says that it was a key. */
void keys_bytes(keys *k, const uint8_t *bytes, size_t count);
void keys_rest(keys *k);

/* What is wished for the next tick; a tick passes for what is held. */
tp_input keys_input(keys *k);
#endif
