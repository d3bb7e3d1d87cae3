/* SPDX-License-Identifier: MIT */
/* One warning for all old names of rows in one file, or on one command line. */
#ifndef TP_APP_SCENE_OLD_NAME_NOTE_H
#define TP_APP_SCENE_OLD_NAME_NOTE_H
#include <stddef.h>
#include <stdint.h>
#include "interact/old_names.h"

/* Starts as all 0. */
typedef struct {
    const old_name *first;      /* NULL: no old name was read */
    uint32_t line, count;       /* line of the first one; number of old names */
} old_name_note;

/* Counts a name if the name is old.  Returns its entry, or NULL. */
const old_name *old_name_note_add(old_name_note *note, const char *name, size_t bytes,
                                  uint32_t line);

/* Prints the warning, if any old name was counted.  place: a file, or the origin of the
 * names such as "--set".  file: the scene file that `tidepool check` can rewrite, or
 * NULL. */
void old_name_note_print(const old_name_note *note, const char *place, const char *file);
#endif
