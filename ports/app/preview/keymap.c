/* SPDX-License-Identifier: MIT */
/* Keys and their names.  A key is named by SDL's name of its place on the keyboard
 * (scancode), without blanks: LeftShift, KeypadEnter. */
#define _POSIX_C_SOURCE 200809L
#include "keymap.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "app/files/did_you_mean.h"
#include "app/files/ini_read.h"
#include "app/files/log.h"
#include "app/files/path.h"

#define NAME_BYTES 40           /* bytes of a name; SDL's longest is "Keypad Hexadecimal" */
#define WORD_BYTES (NAME_BYTES + 12)
#define WRONG_BYTES 160

/* -- names of keys ------------------------------------------------------------------- */

/* Writes the name of a scancode, "" if SDL has no name for the scancode. */
static void key_name(SDL_Scancode code, char name[NAME_BYTES])
{
    size_t n = 0;
    for (const char *c = SDL_GetScancodeName(code); *c && n + 1 < NAME_BYTES; c++)
        if (*c != ' ')
            name[n++] = *c;
    name[n] = 0;
}

/* Returns the scancode of a name.  An INI file cannot hold the name ";", since a
 * semicolon begins a comment: "Semicolon" stands for it. */
static SDL_Scancode parse_key(const char *word)
{
    char name[NAME_BYTES];
    if (strcasecmp(word, "Semicolon") == 0)
        return SDL_SCANCODE_SEMICOLON;
    for (int i = 1; i < SDL_NUM_SCANCODES && *word; i++) {
        key_name((SDL_Scancode)i, name);
        if (strcasecmp(word, name) == 0)
            return (SDL_Scancode)i;
    }
    return SDL_SCANCODE_UNKNOWN;
}

static void key_word(const keymap_key *key, char word[WORD_BYTES])
{
    char name[NAME_BYTES];
    key_name(key->code, name);
    snprintf(word, WORD_BYTES, "%s%s%s", key->ctrl ? "Ctrl+" : "",
             key->shift ? "Shift+" : "", name);
}

/* True if `*word` begins with `prefix` and has more text, in any case of letters; moves
 * `*word` behind the prefix. */
static bool skip(const char **word, const char *prefix)
{
    const size_t n = strlen(prefix);
    if (strncasecmp(*word, prefix, n) != 0 || !(*word)[n])
        return false;
    *word += n;
    return true;
}

/* Parses "Ctrl+Shift+Name".  Result code 0: no such key; *rest is then the unknown name. */
static keymap_key key_read(const char *word, const char **rest)
{
    keymap_key key = { SDL_SCANCODE_UNKNOWN, false, false };
    for (;;)
        if (skip(&word, "Ctrl+"))
            key.ctrl = true;
        else if (skip(&word, "Shift+"))
            key.shift = true;
        else
            break;
    key.code = parse_key(word);
    *rest = word;
    return key;
}

/* -- an action's keys ---------------------------------------------------------------- */

/* Writes m->text[of]: the names of the keys, cut to whole names if the room ends. */
static void write_text(keymap *m, action of)
{
    size_t used = 0;
    char word[WORD_BYTES];
    m->text[of][0] = 0;
    for (int i = 0; i < KEYS_OF_ACTION && m->key[of][i].code; i++) {
        key_word(&m->key[of][i], word);
        if (used + strlen(word) + 2 > sizeof m->text[of])
            return;
        used += (size_t)snprintf(m->text[of] + used, sizeof m->text[of] - used, "%s%s",
                                 used ? " " : "", word);
    }
}

/* Writes an error text for an unknown key name, with the nearest known name. */
static void refuse_key(const char *word, char wrong[WRONG_BYTES])
{
    char name[NAME_BYTES], best_name[NAME_BYTES] = "";
    did_you_mean best = did_you_mean_make(word);
    for (int i = 1; i < SDL_NUM_SCANCODES; i++) {
        const unsigned before = best.distance;
        key_name((SDL_Scancode)i, name);
        if (name[0])
            did_you_mean_offer(&best, name);
        if (best.distance < before)
            memcpy(best_name, name, sizeof best_name);
    }
    snprintf(wrong, WRONG_BYTES, best_name[0] ? "no key is called %s; did you mean %s?"
                                              : "no key is called %s", word, best_name);
}

/* Sets an action's keys from text.  `wrong`: the error text, "" if none. */
static void put_keys(keymap *m, action of, const char *text, char wrong[WRONG_BYTES])
{
    char word[WORD_BYTES];
    int n = 0;
    wrong[0] = 0;
    memset(m->key[of], 0, sizeof m->key[of]);
    for (text += strspn(text, " \t"); *text && !wrong[0]; text += strspn(text, " \t")) {
        const size_t length = strcspn(text, " \t");
        const char *rest = word;
        snprintf(word, sizeof word, "%.*s", (int)SDL_min(length, sizeof word), text);
        text += length;
        const keymap_key key = key_read(word, &rest);
        if (!key.code)
            refuse_key(rest, wrong);
        else if (n == KEYS_OF_ACTION)
            snprintf(wrong, WRONG_BYTES, "an action has at most %d keys", KEYS_OF_ACTION);
        else
            m->key[of][n++] = key;
    }
    write_text(m, of);
}

void keymap_default(keymap *m)
{
    char wrong[WRONG_BYTES];
    memset(m, 0, sizeof *m);
    for (int of = 0; of < ACTIONS; of++)
        put_keys(m, (action)of, actions[of].keys, wrong);
}

/* -- the keys file ------------------------------------------------------------------- */

typedef struct {
    keymap      map;
    const char *path;
    uint32_t    line[ACTIONS];      /* line of the action in the file; 0: default keys */
} keys_file;

static bool refuse_action(const keys_file *file, uint32_t line, const char *name)
{
    did_you_mean best = did_you_mean_make(name);
    for (int of = 0; of < ACTIONS; of++)
        did_you_mean_offer(&best, actions[of].name);
    if (best.name)
        log_line("%s:%u: no action is called %s; did you mean %s?", file->path,
                 (unsigned)line, name, best.name);
    else
        log_line("%s:%u: no action is called %s", file->path, (unsigned)line, name);
    return false;
}

static bool take(void *user, uint32_t line, const char *section, const char *name,
                 const char *value)
{
    keys_file *file = user;
    char wrong[WRONG_BYTES];
    int of = 0;
    if (section[0]) {
        log_line("%s:%u: a file of keys has no sections, such as [%s]", file->path,
                 (unsigned)line, section);
        return false;
    }
    while (of < ACTIONS && strcmp(actions[of].name, name) != 0)
        of++;
    if (of == ACTIONS)
        return refuse_action(file, line, name);
    file->line[of] = line;
    put_keys(&file->map, (action)of, value, wrong);
    if (wrong[0])
        log_line("%s:%u: %s", file->path, (unsigned)line, wrong);
    return !wrong[0];
}

/* Returns a key assigned to both actions, or NULL. */
static const keymap_key *shared(const keymap *m, int one, int other)
{
    for (int i = 0; i < KEYS_OF_ACTION; i++)
        for (int k = 0; k < KEYS_OF_ACTION; k++) {
            const keymap_key *a = &m->key[one][i], *b = &m->key[other][k];
            if (a->code && a->code == b->code && a->ctrl == b->ctrl
                && a->shift == b->shift)
                return a;
        }
    return NULL;
}

/* Refuses a key with two actions.  Runs after the whole file is read, since a later line
 * may free a key. */
static int refuse_shared(const keys_file *file)
{
    char word[WORD_BYTES];
    for (int a = 0; a < ACTIONS; a++)
        for (int b = a + 1; b < ACTIONS; b++) {
            const keymap_key *key = shared(&file->map, a, b);
            const int later = file->line[b] >= file->line[a] ? b : a;
            if (!key)
                continue;
            key_word(key, word);
            return log_fail(EXIT_INPUT, "%s:%u: %s is the key of %s already", file->path,
                            (unsigned)file->line[later], word,
                            actions[later == a ? b : a].name);
        }
    return EXIT_DONE;
}

/* Returns the path of the person's file, to be freed by the caller; NULL if there is
 * none. */
static char *usual_file(void)
{
    const char *config = getenv("XDG_CONFIG_HOME"), *home = getenv("HOME");
    char *folder = NULL, *path = NULL;
    if (config && config[0] == '/')
        folder = path_copy(config, strlen(config));
    else if (home && home[0])
        folder = path_join(home, ".config", "");
    if (folder)
        path = path_join(folder, "tidepool/keys.ini", "");
    free(folder);
    if (path && !path_is_file(path)) {
        free(path);
        path = NULL;
    }
    return path;
}

int keymap_read(keymap *m, const char *name)
{
    char *usual = name ? NULL : usual_file();
    keys_file file = { .map = *m, .path = name ? name : usual };
    if (!file.path)
        return EXIT_DONE;
    int code = ini_read(file.path, take, &file);
    if (!code)
        code = refuse_shared(&file);
    if (!code)
        *m = file.map;
    free(usual);
    return code;
}

/* -- pressed keys -------------------------------------------------------------------- */

static action exactly(const keymap *m, SDL_Scancode code, bool ctrl, bool shift)
{
    for (int of = 0; of < ACTIONS; of++)
        for (int i = 0; i < KEYS_OF_ACTION; i++) {
            const keymap_key *key = &m->key[of][i];
            if (key->code == code && key->ctrl == ctrl && key->shift == shift)
                return (action)of;
        }
    return ACTIONS;
}

/* Returns the action of a key.  Without an action of its own for Shift, Shift+key has
 * the action of the key alone: Shift held for running does not block other keys. */
static action asked(const keymap *m, SDL_Scancode code, bool ctrl, bool shift)
{
    const action of = code ? exactly(m, code, ctrl, shift) : ACTIONS;
    return code && of == ACTIONS && shift ? exactly(m, code, ctrl, false) : of;
}

action keymap_action(const keymap *m, const SDL_Keysym *key)
{
    if (key->mod & (KMOD_ALT | KMOD_GUI))
        return ACTIONS;                         /* shortcuts of the desktop */
    return asked(m, key->scancode, key->mod & KMOD_CTRL, key->mod & KMOD_SHIFT);
}

bool keymap_held(const keymap *m, action of, const uint8_t *down, SDL_Keymod mod)
{
    if (mod & KMOD_CTRL)
        return false;
    for (int i = 0; i < KEYS_OF_ACTION; i++) {
        const SDL_Scancode code = m->key[of][i].code;
        if (code && down[code] && asked(m, code, false, mod & KMOD_SHIFT) == of)
            return true;
    }
    return false;
}
