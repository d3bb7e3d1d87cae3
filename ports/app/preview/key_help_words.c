/* SPDX-License-Identifier: MIT */
/* Short forms of key names and action names for the help. */
#include "key_help_words.h"
#include <SDL.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Writes the short form of a key name: PgUp for PageUp, an arrow for Up. */
static void short_key(const char *word, char *out, size_t room)
{
    static const struct { const char *name, *as; } shorter[] = {
        { "Up", "\1" }, { "Down", "\2" }, { "Left", "\3" }, { "Right", "\4" },
        { "LeftShift", "Shift" }, { "RightShift", "Shift" }, { "LeftCtrl", "Ctrl" },
        { "PageUp", "PgUp" }, { "PageDown", "PgDn" }, { "Backspace", "Bksp" },
        { "Escape", "Esc" },
    };
    const char *last = strrchr(word, '+');
    const char *name = last && last > word && last[1] ? last + 1 : word;
    const char *as = name;
    for (size_t i = 0; i < sizeof shorter / sizeof *shorter; i++)
        if (strcmp(name, shorter[i].name) == 0)
            as = shorter[i].as;
    snprintf(out, room, "%.*s%s", (int)(name - word), word, as);
}

void key_help_add_keys(char out[KEY_HELP_KEYS], const char *keys)
{
    char all[64], word[64];
    snprintf(all, sizeof all, "%s", keys);
    for (char *rest = all, *key; (key = SDL_strtokr(rest, " ", &rest)) != NULL;) {
        const size_t used = strlen(out), last = strcspn(out, " ");
        short_key(key, word, sizeof word);
        const bool again = used == last && strcmp(out, word) == 0;
        if (!again && used + strlen(word) + 2 < KEY_HELP_KEYS)
            snprintf(out + used, KEY_HELP_KEYS - used, "%s%s", used ? " " : "", word);
    }
}

void key_help_short_name(const action_row *row, char out[KEY_HELP_NAME])
{
    const size_t n = strlen(row->group), all = strlen(row->name);
    const char *name = row->name;
    size_t length = all;
    if (all > n && strncmp(name, row->group, n) == 0 && name[n] == '_') {
        name += n + 1;
        length -= n + 1;
    } else if (all > n && strcmp(name + all - n, row->group) == 0
               && name[all - n - 1] == '_') {
        length -= n + 1;
    }
    snprintf(out, KEY_HELP_NAME, "%.*s", (int)length, name);
    for (char *c = out; *c; c++)
        *c = *c == '_' ? ' ' : *c;
}
