/* SPDX-License-Identifier: MIT */
/* Tapes: inputs by tick as lines of text, for bit-exact replays.
 *
 *     tape 1 three-swells
 *     120 ahead=0.05 turn=-1200
 *     121 drops=1
 *     122 poke=0.3 poke_x=1.5 poke_z=-2 poke2=0.3 poke2_x=-1.5
 *
 * The head names the format and the scene.  A line holds a tick and the members of
 * tp_input with a value other than 0, by name.  Height and position of push[0] are poke,
 * poke_x and poke_z; push[1] to push[7] use poke2 ... poke8_z.  Ticks increase.  Q16.16
 * numbers are written with enough digits to read back the same bits. */
#ifndef TP_WORLD_TAPE_H
#define TP_WORLD_TAPE_H
#include <stddef.h>
#include <stdint.h>
#include "tidepool/world.h"

#define TP_TAPE_LINE 1024       /* longest line in bytes, line end included */

typedef struct {
    uint64_t tick;              /* tick before the step with this input; 0: first step */
    tp_input input;
} tp_tape_entry;

/* Writes the line of an entry, terminated, without line end, cut to `bytes`.  Returns the
 * whole length of the line.  Returns 0 if no input is set; such an entry needs no line. */
size_t tp_tape_write(const tp_tape_entry *entry, char *text, size_t bytes);

/* Reads a line of `bytes` bytes without line end: a tick, then name=number in any order,
 * each name at most once, separated by white space.  On failure err->word is the wrong
 * word and *entry does not change.  A line with a tick only is an entry without input. */
tp_status tp_tape_read(tp_tape_entry *entry, const char *text, size_t bytes,
                       tp_error *err);

/* Writes the head line "tape 1 SCENE", terminated and cut like tp_tape_write.  A scene's
 * name is any text without control characters, not empty, without white space at its
 * ends. */
size_t tp_tape_head_write(const char *scene, char *text, size_t bytes);

/* Reads the scene's name from a head line into `scene` of `room` bytes.  TP_E_LONG:
 * `room` is too small. */
tp_status tp_tape_head_read(char *scene, size_t room, const char *text, size_t bytes,
                            tp_error *err);
#endif
