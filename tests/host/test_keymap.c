/* SPDX-License-Identifier: MIT */
/* Keys and their actions, and a person's keys file. */
#define _POSIX_C_SOURCE 200809L
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "../../ports/app/files/log.h"       /* before cmocka's macro `fail` */
#include <cmocka.h>
#include "../../ports/app/preview/keymap.h"
#include "tests/lib/messages.h"

static keymap map;
static char folder[] = "/tmp/test-keymap-XXXXXX", path[64], said[600];

static int fresh(void **state)
{
    (void)state;
    keymap_default(&map);
    return 0;
}

static action pressed(SDL_Scancode code, unsigned mod)
{
    const SDL_Keysym key = { .scancode = code, .mod = (uint16_t)mod };
    return keymap_action(&map, &key);
}

static bool held(action of, SDL_Scancode code, unsigned mod)
{
    uint8_t down[SDL_NUM_SCANCODES] = { 0 };
    down[code] = 1;
    return keymap_held(&map, of, down, (SDL_Keymod)mod);
}

/* Reads a keys file with this text; messages go to `said`. */
static int read_words(const char *words)
{
    FILE *to = fopen(path, "w");
    assert_non_null(to);
    fputs(words, to);
    fclose(to);
    messages m = messages_begin();
    const int code = keymap_read(&map, path);
    messages_end(&m, said, sizeof said);
    return code;
}

static void refuses(const char *words, const char *line, const char *why)
{
    const keymap before = map;
    char place[80];
    assert_int_equal(read_words(words), EXIT_INPUT);
    snprintf(place, sizeof place, "%s:%s: ", path, line);
    if (!strstr(said, place) || !strstr(said, why))
        fail_msg("'%s' says: %s", words, said);
    assert_memory_equal(&map, &before, sizeof map);
}

/* -- the list ---------------------------------------------------------------------- */

static void every_action_has_a_key_that_asks_for_it(void **state)
{
    (void)state;
    for (int of = 0; of < ACTIONS; of++)
        for (int i = 0; i < KEYS_OF_ACTION; i++) {
            const keymap_key *key = &map.key[of][i];
            const unsigned mod = (key->ctrl ? KMOD_LCTRL : 0u)
                               | (key->shift ? KMOD_LSHIFT : 0u);
            if (i == 0 && !key->code)
                fail_msg("%s has no key: %s", actions[of].name, actions[of].keys);
            if (key->code)
                assert_int_equal(pressed(key->code, mod), of);
        }
}

static void help_shows_the_lists_own_words(void **state)
{
    (void)state;
    for (int of = 0; of < ACTIONS; of++)
        assert_string_equal(map.text[of], actions[of].keys);
}

static void modifiers_tell_actions_apart(void **state)
{
    (void)state;
    assert_int_equal(pressed(SDL_SCANCODE_S, 0), ACT_BACKWARD);
    assert_int_equal(pressed(SDL_SCANCODE_S, KMOD_RCTRL), ACT_SAVE);
    assert_int_equal(pressed(SDL_SCANCODE_N, KMOD_NUM | KMOD_CAPS), ACT_NEXT_SCENE);
    assert_int_equal(pressed(SDL_SCANCODE_N, KMOD_RSHIFT), ACT_LAST_SCENE);
    assert_int_equal(pressed(SDL_SCANCODE_W, KMOD_LCTRL), ACTIONS);
    assert_int_equal(pressed(SDL_SCANCODE_F4, KMOD_LALT), ACTIONS);
    assert_int_equal(pressed(SDL_SCANCODE_UNKNOWN, 0), ACTIONS);
    assert_int_equal(pressed(SDL_SCANCODE_UNKNOWN, KMOD_LSHIFT), ACTIONS);
}

static void with_shift_a_key_still_asks(void **state)
{
    (void)state;
    assert_int_equal(pressed(SDL_SCANCODE_PERIOD, KMOD_LSHIFT), ACT_STEP);
    assert_int_equal(pressed(SDL_SCANCODE_EQUALS, KMOD_LSHIFT | KMOD_LCTRL), ACT_LARGER);
    assert_int_equal(pressed(SDL_SCANCODE_F8, KMOD_LSHIFT), ACT_AGAINST);
}

static void held_keys_are_held_with_shift_and_not_with_ctrl(void **state)
{
    (void)state;
    assert_true(held(ACT_FORWARD, SDL_SCANCODE_W, 0));
    assert_true(held(ACT_FORWARD, SDL_SCANCODE_W, KMOD_LSHIFT));
    assert_false(held(ACT_BACKWARD, SDL_SCANCODE_S, KMOD_LCTRL));
    assert_false(held(ACT_BACKWARD, SDL_SCANCODE_W, 0));
    assert_true(held(ACT_RUN, SDL_SCANCODE_RSHIFT, KMOD_RSHIFT));
    assert_false(held(ACT_DROP, SDL_SCANCODE_UNKNOWN, 0));
}

/* -- a person's file --------------------------------------------------------------- */

static void a_file_moves_keys(void **state)
{
    (void)state;
    assert_int_equal(read_words("; mine\ndrop = Return\npause = space P\nfilm =\n"
                                "run = RightShift\nsail = shift+w\n"), EXIT_DONE);
    assert_string_equal(said, "");
    assert_int_equal(pressed(SDL_SCANCODE_RETURN, 0), ACT_DROP);
    assert_int_equal(pressed(SDL_SCANCODE_SPACE, 0), ACT_PAUSE);
    assert_int_equal(pressed(SDL_SCANCODE_P, 0), ACT_PAUSE);
    assert_int_equal(pressed(SDL_SCANCODE_F9, 0), ACTIONS);
    assert_string_equal(map.text[ACT_PAUSE], "Space P");
    assert_string_equal(map.text[ACT_FILM], "");
    assert_false(held(ACT_RUN, SDL_SCANCODE_LSHIFT, KMOD_LSHIFT));
    assert_false(held(ACT_FORWARD, SDL_SCANCODE_W, KMOD_RSHIFT));
    assert_true(held(ACT_SAIL, SDL_SCANCODE_W, KMOD_RSHIFT));
}

static void a_semicolon_has_a_word(void **state)
{
    (void)state;
    assert_int_equal(read_words("drop = Semicolon ; not Space\n"), EXIT_DONE);
    assert_int_equal(pressed(SDL_SCANCODE_SEMICOLON, 0), ACT_DROP);
    assert_int_equal(pressed(SDL_SCANCODE_SPACE, 0), ACTIONS);
}

static void two_actions_change_their_keys(void **state)
{
    (void)state;
    assert_int_equal(read_words("slower = ]\nfaster = [\n"), EXIT_DONE);
    assert_int_equal(pressed(SDL_SCANCODE_LEFTBRACKET, 0), ACT_FASTER);
}

static void more_keys_than_the_text_holds_are_whole_words(void **state)
{
    (void)state;
    assert_int_equal(read_words("drop = Ctrl+Shift+KeypadEnter Ctrl+Shift+KeypadClear "
                                "Ctrl+Shift+Keypad*\n"), EXIT_DONE);
    assert_string_equal(map.text[ACT_DROP],
                        "Ctrl+Shift+KeypadEnter Ctrl+Shift+KeypadClear");
}

static void what_is_wrong_is_named_with_its_line(void **state)
{
    (void)state;
    refuses("drop = Return\npuase = P\n", "2", "no action is called puase; did you mean "
            "pause?");
    refuses("qqqqqqqqqq = P\n", "1", "no action is called qqqqqqqqqq\n");
    refuses("\ndrop = Retrun\n", "2", "no key is called Retrun; did you mean Return?");
    refuses("drop = Ctrl+\n", "1", "no key is called Ctrl+");
    refuses("drop = P\n", "1", "P is the key of pause already");
    refuses("drop = Ctrl+F4\nfilm = Ctrl+F4\n", "2", "Ctrl+F4 is the key of drop already");
    refuses("drop = F13 F14 F15 F16 F17\n", "1", "at most 4 keys");
    refuses("[water]\ndrop = Return\n", "2", "no sections");
    refuses("drop\n", "1", "name = value");
}

static void a_named_file_has_to_be_there(void **state)
{
    (void)state;
    unlink(path);
    assert_int_equal(keymap_read(&map, path), EXIT_INPUT);
}

static void the_usual_file_may_be_missing(void **state)
{
    char inner[96];
    (void)state;
    setenv("XDG_CONFIG_HOME", folder, 1);
    assert_int_equal(keymap_read(&map, NULL), EXIT_DONE);
    snprintf(inner, sizeof inner, "%s/tidepool", folder);
    assert_int_equal(mkdir(inner, 0700), 0);
    snprintf(inner, sizeof inner, "%s/tidepool/keys.ini", folder);
    FILE *to = fopen(inner, "w");
    assert_non_null(to);
    fputs("drop = Return\n", to);
    fclose(to);
    assert_int_equal(keymap_read(&map, NULL), EXIT_DONE);
    assert_int_equal(pressed(SDL_SCANCODE_RETURN, 0), ACT_DROP);
    unlink(inner);
    snprintf(inner, sizeof inner, "%s/tidepool", folder);
    rmdir(inner);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(every_action_has_a_key_that_asks_for_it, fresh),
        cmocka_unit_test_setup(help_shows_the_lists_own_words, fresh),
        cmocka_unit_test_setup(modifiers_tell_actions_apart, fresh),
        cmocka_unit_test_setup(with_shift_a_key_still_asks, fresh),
        cmocka_unit_test_setup(held_keys_are_held_with_shift_and_not_with_ctrl, fresh),
        cmocka_unit_test_setup(a_file_moves_keys, fresh),
        cmocka_unit_test_setup(a_semicolon_has_a_word, fresh),
        cmocka_unit_test_setup(two_actions_change_their_keys, fresh),
        cmocka_unit_test_setup(more_keys_than_the_text_holds_are_whole_words, fresh),
        cmocka_unit_test_setup(what_is_wrong_is_named_with_its_line, fresh),
        cmocka_unit_test_setup(a_named_file_has_to_be_there, fresh),
        cmocka_unit_test_setup(the_usual_file_may_be_missing, fresh),
    };
    if (!mkdtemp(folder))
        return 1;
    snprintf(path, sizeof path, "%s/keys.ini", folder);
    const int failed = cmocka_run_group_tests_name("keymap", tests, NULL, NULL);
    unlink(path);
    rmdir(folder);
    return failed;
}
