/* SPDX-License-Identifier: MIT */
/* Words of the list of keys. */
#ifndef TP_APP_PREVIEW_KEY_HELP_WORDS_H
#define TP_APP_PREVIEW_KEY_HELP_WORDS_H
#include "app/session/actions.h"

#define KEY_HELP_KEYS 80            /* bytes with the terminating 0: list of keys; name */
#define KEY_HELP_NAME 40

/* Appends keys in the notation of a keymap, shortened: "PgUp" for PageUp, arrows of
 * font.h for Up ... Right, a single "Shift" for both Shift keys. */
void key_help_add_keys(char out[KEY_HELP_KEYS], const char *keys);

/* Writes the name without its group: "left" for light_left of group light. */
void key_help_short_name(const action_row *row, char out[KEY_HELP_NAME]);
#endif
