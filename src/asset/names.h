/* SPDX-License-Identifier: MIT */
/* A set of names in memory counted beforehand: materials, libraries, images.  Each name has
 * a tag; the same text with two tags counts as two names. */
#ifndef TP_ASSET_NAMES_H
#define TP_ASSET_NAMES_H
#include "asset/reader.h"
#include "asset/word.h"
#include "base/arena.h"

#define TP_NO_NAME UINT32_MAX

/* Allocates room for `most` names of `room` bytes in total, terminators included. */
void tp_names_layout(tp_obj_names *names, tp_arena *arena, uint32_t most, uint32_t room);

/* Empties the set. */
void tp_names_clear(tp_obj_names *names);

/* Returns the number of the name, or TP_NO_NAME.  `seed` must be the same for the
 * life of the set. */
uint32_t tp_names_find(const tp_obj_names *names, tp_word word, uint32_t tag,
                       uint64_t seed);

/* Returns the number of the name like tp_names_find, but adds a missing name, as found in
 * `line`.  Returns TP_NO_NAME if there is no room. */
uint32_t tp_names_add(tp_obj_names *names, tp_word word, uint32_t tag, uint32_t line,
                      uint64_t seed);

static inline const char *tp_names_text(const tp_obj_names *names, uint32_t i)
{
    return names->text + names->start[i];
}
#endif
