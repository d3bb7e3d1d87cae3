/* SPDX-License-Identifier: MIT */
#include "old_name_note.h"
#include <stdio.h>
#include "app/files/log.h"

const old_name *old_name_note_add(old_name_note *note, const char *name, size_t bytes,
                                  uint32_t line)
{
    const old_name *old = old_name_find(name, bytes);
    if (old && note->count++ == 0) {
        note->first = old;
        note->line = line;
    }
    return old;
}

void old_name_note_print(const old_name_note *note, const char *place, const char *file)
{
    char line[16] = "", more[48] = "";
    if (note->count == 0)
        return;
    if (note->line)
        snprintf(line, sizeof line, ":%u", (unsigned)note->line);
    if (note->count > 1)
        snprintf(more, sizeof more, " (and %u more old name%s)", (unsigned)note->count - 1,
                 note->count > 2 ? "s" : "");
    log_line("%s%s: %s is now called %s%s; old names are read until version " OLD_NAMES_END
             "%s%s%s", place, line, note->first->old, note->first->now, more,
             file ? "; `tidepool check " : "", file ? file : "",
             file ? " --write` rewrites them" : "");
}
