/* SPDX-License-Identifier: MIT */
/* Which keys ask for which actions: the list's, or a person's own file.
 *
 *     ; ~/.config/tidepool/keys.ini
 *     drop = Return
 *     pause = Space P
 *     film =                     ; no key
 *
 * A file that is wrong is refused with its line; a key that two actions would have is
 * refused too. */
#ifndef SDL2_KEYMAP_H
#define SDL2_KEYMAP_H
#include <SDL.h>
#include <stdbool.h>
#include "../host/actions.h"

#define KEYS_OF_ACTION 4

typedef struct {
    SDL_Scancode code;
    bool         ctrl, shift;
} keymap_key;

typedef struct {
    keymap_key key[ACTIONS][KEYS_OF_ACTION];    /* code 0: none */
    char       text[ACTIONS][64];               /* as the help shows them */
} keymap;

void keymap_default(keymap *m);

/* `name` NULL: $XDG_CONFIG_HOME/tidepool/keys.ini if there is one.  An exit code, having
 * said why; the map is then as it was. */
int  keymap_read(keymap *m, const char *name);

/* The action of a key that was pressed, with its modifiers, or ACTIONS. */
action keymap_action(const keymap *m, const SDL_Keysym *key);

/* Whether a key of a held action is down.  Ctrl lets none be. */
bool keymap_held(const keymap *m, action of, const uint8_t *down, SDL_Keymod mod);
#endif
