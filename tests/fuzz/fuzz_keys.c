/* SPDX-License-Identifier: MIT */
/* Fuzzes key files as read by `view --keys`. A rejected file changes no key. In an accepted
 * file no key has two actions, and the help's text reads back as the same keys. */
#include "fuzz.h"
#include "app/preview/keymap.h"

static size_t count_keys(const keymap *m, int of)
{
    size_t count = 0;
    for (int i = 0; i < KEYS_OF_ACTION; i++)
        count += m->key[of][i].code != 0;
    return count;
}

static size_t count_words(const char *text)
{
    size_t count = *text != 0;
    for (; *text; text++)
        count += *text == ' ';
    return count;
}

/* Requires each key to have its assigned action. */
static void press_all(const keymap *m)
{
    for (int of = 0; of < ACTIONS; of++)
        for (int i = 0; i < KEYS_OF_ACTION; i++) {
            const keymap_key *key = &m->key[of][i];
            const SDL_Keysym pressed = {
                .scancode = key->code,
                .mod = (Uint16)((key->ctrl ? KMOD_LCTRL : 0)
                                | (key->shift ? KMOD_LSHIFT : 0)),
            };
            if (key->code)
                REQUIRE(keymap_action(m, &pressed) == (action)of);
        }
}

/* Writes the keys as a file; a semicolon alone would begin a comment. Returns false if a
 * text is too short for all of its keys. */
static bool write_all(const keymap *m, FILE *to)
{
    bool whole = true;
    for (int of = 0; of < ACTIONS; of++) {
        whole = whole && count_words(m->text[of]) == count_keys(m, of);
        fprintf(to, "%s =", actions[of].name);
        for (const char *c = m->text[of]; *c; c++)
            if (*c == ';')
                fputs("Semicolon", to);
            else
                fprintf(to, "%s%c", c == m->text[of] ? " " : "", *c);
        fputc('\n', to);
    }
    fclose(to);
    return whole;
}

static void read_back(const keymap *m)
{
    static keymap again;
    char *text;
    size_t bytes;
    keymap_default(&again);
    if (write_all(m, open_memstream(&text, &bytes))) {
        REQUIRE(keymap_read(&again, fuzz_file(1, text, bytes)) == EXIT_DONE);
        REQUIRE(memcmp(again.key, m->key, sizeof m->key) == 0);
    }
    free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static keymap usual, map;
    if (!usual.text[0][0])
        keymap_default(&usual);
    map = usual;
    const char *path = fuzz_file(0, data, size);
    if (keymap_read(&map, path)) {
        fuzz_refused(path, fuzz_lines(data, size));
        REQUIRE(memcmp(&map, &usual, sizeof map) == 0);
        return 0;
    }
    press_all(&map);
    read_back(&map);
    return 0;
}
