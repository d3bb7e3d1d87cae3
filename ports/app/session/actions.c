/* SPDX-License-Identifier: MIT */
/* The list of actions as a table. */
#include "actions.h"

const action_row actions[ACTIONS] = {
#define X(id, group, name, keys, held, help) { group, name, keys, help, held },
    ACTION_LIST(X)
#undef X
};

const action_note action_notes[] = {
    { "left drag",     "turn and tilt the camera" },
    { "right click",   "poke the water" },
    { "right drag",    "stir the water" },
    { "wheel",         "nearer, farther (in orbit, from above)" },
    { "drop a file",   "open the scene" },
    { "left stick",    "move; right stick: turn; triggers: down, up" },
    { "pad A B X Y",   "drop, pause, orbit, boat's deck" },
    { "pad shoulders", "slower, faster; Start: help; Back: panel" },
};

const size_t action_note_count = sizeof action_notes / sizeof *action_notes;
