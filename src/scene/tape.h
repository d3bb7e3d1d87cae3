/* SPDX-License-Identifier: MIT */
/* Tapes: inputs by tick as lines of text, for replays bit for bit.
 *
 *     tape 1 three-swells
 *     120 ahead=0.05 turn=-1200
 *     121 drops=1
 *     122 poke=0.3 poke_x=1.5 poke_z=-2 poke2=0.3 poke2_x=-1.5
 *
 * The head names the form and the scene; a line holds a tick and what of tp_input is not
 * 0, by its names; the height and place of push[0] are poke, poke_x and poke_z, those of
 * push[1] to push[7] poke2 ... poke8_z.  Ticks rise.  Numbers of the API's 16.16 are
 * written so that they read back to the same bits. */
#ifndef TP_SCENE_TAPE_H
#define TP_SCENE_TAPE_H
#include <stddef.h>
#include <stdint.h>
#include "tidepool/world.h"

#define TP_TAPE_LINE 1024       /* no line is longer, its end included */

typedef struct {
    uint64_t tick;              /* before whose step the input is given: 0 is the first */
    tp_input input;
} tp_tape_entry;

/* The line of an entry without line end, terminated, cut to `bytes`; returns its whole
 * length; 0 if nothing of the input is set, and then no line needs to be written. */
size_t tp_tape_write(const tp_tape_entry *entry, char *text, size_t bytes);

/* Reads a line of `bytes` bytes (no line end): a tick, then name=number in any order,
 * each name once.  White space separates.  err->word is what is wrong with it; *entry is
 * then not changed.  A tick alone is an entry without input. */
tp_status tp_tape_read(tp_tape_entry *entry, const char *text, size_t bytes,
                       tp_error *err);

/* The head line "tape 1 SCENE", likewise.  A scene's name is any text without control
 * characters that is not empty and neither begins nor ends with a blank. */
size_t tp_tape_head_write(const char *scene, char *text, size_t bytes);

/* The scene's name into `scene`, which holds `room` bytes; E_LONG if it is too small. */
tp_status tp_tape_head_read(char *scene, size_t room, const char *text, size_t bytes,
                            tp_error *err);
#endif
