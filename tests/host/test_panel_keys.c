/* SPDX-License-Identifier: MIT */
/* Routing of keys to the panel or to the picture, and the order of the panel's keys. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/app/preview/panel_keys.h"

/* A key without a letter is given by its scancode. */
static bool key(panel_keys *k, uint32_t type, SDL_Keycode sym, uint16_t mod)
{
    SDL_Event e = { .type = type };
    e.key.keysym = (SDL_Keysym){ .sym = sym, .mod = mod };
    if (sym & SDLK_SCANCODE_MASK)
        e.key.keysym.scancode = (SDL_Scancode)(sym & ~SDLK_SCANCODE_MASK);
    return panel_keys_event(k, &e);
}

static bool down(panel_keys *k, SDL_Keycode sym)
{
    return key(k, SDL_KEYDOWN, sym, 0);
}

static bool text(panel_keys *k, const char *letters)
{
    SDL_Event e = { .type = SDL_TEXTINPUT };
    strcpy(e.text.text, letters);
    return panel_keys_event(k, &e);
}

/* Returns the events of one frame: the first letter of a key's name, capital for a
 * press; typed letters in quotes. */
static const char *heard(panel_keys *k)
{
    static char said[2 * PANEL_KEYS + 1];
    SDL_Event e;
    size_t n = 0;
    panel_keys_begin(k);
    while (panel_keys_next(k, &e)) {
        const bool is_text = e.type == SDL_TEXTINPUT;
        const char first = is_text ? e.text.text[0] : SDL_GetKeyName(e.key.keysym.sym)[0];
        if (is_text)
            said[n++] = '"';
        said[n++] = e.type == SDL_KEYUP ? (char)SDL_tolower(first) : first;
    }
    said[n] = '\0';
    return said;
}

static void at_first_every_key_is_the_pictures(void **state)
{
    (void)state;
    panel_keys k = { 0 };
    assert_false(down(&k, SDLK_w) || down(&k, SDLK_SPACE) || down(&k, SDLK_UP)
                 || down(&k, SDLK_ESCAPE) || down(&k, SDLK_RETURN) || text(&k, "w"));
    assert_int_equal(k.events, 0);
}

static void tab_brings_the_keyboard_and_escape_takes_it_back(void **state)
{
    (void)state;
    panel_keys k = { 0 };
    assert_true(down(&k, SDLK_TAB));
    assert_true(k.here);
    assert_string_equal(heard(&k), "D");            /* as arrow down */
    assert_true(down(&k, SDLK_UP));
    heard(&k);
    assert_false(down(&k, SDLK_w));                 /* no motion in the panel */
    assert_true(down(&k, SDLK_ESCAPE));
    assert_true(k.leave);
    assert_false(down(&k, SDLK_UP) || text(&k, "w"));       /* from then on */
    key(&k, SDL_KEYUP, SDLK_UP, 0);
    panel_keys_leave(&k);
    assert_false(k.here);
    assert_string_equal(heard(&k), "u");
}

static void escape_closes_what_is_open_first(void **state)
{
    (void)state;
    panel_keys k = { .open = true };
    assert_true(down(&k, SDLK_ESCAPE));
    assert_false(k.leave);
    assert_string_equal(heard(&k), "E");
}

static void a_field_takes_all_but_functions_and_saving(void **state)
{
    (void)state;
    panel_keys k = { .writes = true };
    assert_true(down(&k, SDLK_w) && down(&k, SDLK_SPACE) && down(&k, SDLK_BACKSPACE));
    assert_true(key(&k, SDL_KEYDOWN, SDLK_c, KMOD_LCTRL));
    assert_true(key(&k, SDL_KEYDOWN, SDLK_z, KMOD_LCTRL));
    assert_false(key(&k, SDL_KEYDOWN, SDLK_s, KMOD_LCTRL));
    assert_false(key(&k, SDL_KEYDOWN, SDLK_q, KMOD_RCTRL));
    assert_false(down(&k, SDLK_F1) || down(&k, SDLK_F12) || down(&k, SDLK_LCTRL));
}

static void keys_that_go_up_are_everybodys(void **state)
{
    (void)state;
    panel_keys k = { .writes = true };
    assert_true(down(&k, SDLK_BACKSPACE));
    assert_false(key(&k, SDL_KEYUP, SDLK_BACKSPACE, 0));
}

static void a_key_is_down_for_a_picture_at_least(void **state)
{
    (void)state;
    panel_keys k = { .here = true };
    for (int i = 0; i < 2; i++) {
        down(&k, SDLK_LEFT);
        key(&k, SDL_KEYUP, SDLK_LEFT, 0);
    }
    assert_string_equal(heard(&k), "L");
    assert_string_equal(heard(&k), "l");
    assert_string_equal(heard(&k), "L");
    assert_string_equal(heard(&k), "l");
    assert_string_equal(heard(&k), "");
}

/* Typed at once: Enter, a number, Enter. */
static void letters_wait_for_their_field(void **state)
{
    (void)state;
    panel_keys k = { .here = true, .on_number = true };
    assert_true(down(&k, SDLK_RETURN));
    assert_true(down(&k, SDLK_7) && text(&k, "7"));
    assert_true(down(&k, SDLK_RETURN));
    assert_string_equal(heard(&k), "R");
    k.typing = true;
    assert_string_equal(heard(&k), "");
    assert_string_equal(heard(&k), "");
    k.writes = true;
    assert_string_equal(heard(&k), "\"7R");
}

static void letters_do_not_wait_for_ever(void **state)
{
    (void)state;
    panel_keys k = { .searching = true };
    int pictures = 0;
    assert_true(text(&k, "x"));
    while (heard(&k)[0] == '\0' && pictures < 100)
        pictures++;
    assert_in_range(pictures, 2, 20);
}

static void the_slash_that_searches_is_no_letter(void **state)
{
    (void)state;
    panel_keys k = { 0 };
    assert_false(down(&k, SDLK_SLASH));
    k.searching = k.here = true;                    /* the key opened the search */
    assert_true(text(&k, "/"));
    assert_true(text(&k, "w"));
    k.writes = true;
    assert_string_equal(heard(&k), "\"w");
}

static void enter_presses_what_is_no_number(void **state)
{
    (void)state;
    panel_keys k = { .here = true };
    down(&k, SDLK_RETURN);
    assert_string_equal(heard(&k), "S");            /* Space */
    key(&k, SDL_KEYUP, SDLK_RETURN, 0);
    assert_string_equal(heard(&k), "sr");           /* both possible codes */
    down(&k, SDLK_DOWN);
    key(&k, SDL_KEYUP, SDLK_DOWN, 0);
    down(&k, SDLK_RETURN);                          /* at once, but given in order */
    heard(&k);
    k.on_number = true;
    heard(&k);
    assert_string_equal(heard(&k), "R");
}

static void a_full_queue_takes_no_more(void **state)
{
    (void)state;
    panel_keys k = { .writes = true };
    for (int i = 0; i < 2 * PANEL_KEYS; i++)
        assert_true(text(&k, "a"));
    assert_int_equal(k.events, PANEL_KEYS);
    assert_int_equal(strlen(heard(&k)), 2 * PANEL_KEYS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(at_first_every_key_is_the_pictures),
        cmocka_unit_test(tab_brings_the_keyboard_and_escape_takes_it_back),
        cmocka_unit_test(escape_closes_what_is_open_first),
        cmocka_unit_test(a_field_takes_all_but_functions_and_saving),
        cmocka_unit_test(keys_that_go_up_are_everybodys),
        cmocka_unit_test(a_key_is_down_for_a_picture_at_least),
        cmocka_unit_test(letters_wait_for_their_field),
        cmocka_unit_test(letters_do_not_wait_for_ever),
        cmocka_unit_test(the_slash_that_searches_is_no_letter),
        cmocka_unit_test(enter_presses_what_is_no_number),
        cmocka_unit_test(a_full_queue_takes_no_more),
    };
    return cmocka_run_group_tests_name("panel keys", tests, NULL, NULL);
}
