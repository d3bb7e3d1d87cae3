/* SPDX-License-Identifier: MIT */
/* Keys of the actions: defaults from the list of actions, or the person's own file.
 *
 *     ; ~/.config/tidepool/keys.ini
 *     drop = Return
 *     pause = Space P
 *     film =                     ; no key
 *
 * A faulty file is refused with the line number.  A key assigned to two actions is a
 * fault. */
#ifndef TP_APP_PREVIEW_KEYMAP_H
#define TP_APP_PREVIEW_KEYMAP_H
#include <SDL.h>
#include <stdbool.h>
#include "app/session/actions.h"

#define KEYS_OF_ACTION 4

typedef struct {
    SDL_Scancode code;
    bool         ctrl, shift;
} keymap_key;

typedef struct {
    keymap_key key[ACTIONS][KEYS_OF_ACTION];    /* code 0: none */
    char       text[ACTIONS][64];               /* the keys as text for the help */
} keymap;

void keymap_default(keymap *m);

/* Reads a keys file.  `name` NULL: $XDG_CONFIG_HOME/tidepool/keys.ini, if present.
 * Returns an exit code; on failure the reason has been said and the map is unchanged. */
int  keymap_read(keymap *m, const char *name);

/* Returns the action of a pressed key with its modifiers, or ACTIONS if there is none. */
action keymap_action(const keymap *m, const SDL_Keysym *key);

/* True if a key of a held action is down.  Always false while Ctrl is down. */
bool keymap_held(const keymap *m, action of, const uint8_t *down, SDL_Keymod mod);
#endif
