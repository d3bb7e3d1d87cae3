/* SPDX-License-Identifier: MIT */
/* The words of the list of keys. */
#ifndef SDL2_HELP_WORDS_H
#define SDL2_HELP_WORDS_H
#include "../host/actions.h"

#define HELP_KEYS 80            /* bytes of some keys, of a name, with their ends */
#define HELP_NAME 40

/* Adds keys as a map writes them: "PgUp" for PageUp, arrows of letters.h for Up ... Right,
 * "Shift" once for both of them. */
void help_add_keys(char out[HELP_KEYS], const char *keys);

/* Without its group: "left" for light_left of group light. */
void help_short_name(const action_row *row, char out[HELP_NAME]);
#endif
