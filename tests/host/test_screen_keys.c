/* SPDX-License-Identifier: MIT */
/* Bytes of a terminal as keys. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/interact/input_merge.h"
#include "../../ports/app/fullscreen/terminal_keys.h"

static terminal_keys k;

static int fresh(void **state)
{
    (void)state;
    memset(&k, 0, sizeof k);
    return 0;
}

static void type(const char *text)
{
    terminal_keys_add_bytes(&k, (const uint8_t *)text, strlen(text));
}

/* Returns the ticks until the key is no longer held. */
static int ticks_ahead(void)
{
    int n = 0;
    while (n < 100 && terminal_keys_input(&k).forward)
        n++;
    return n;
}

static void letters_move_and_capitals_run(void **state)
{
    (void)state;
    type("wd");
    tp_input input = terminal_keys_input(&k);
    assert_int_equal(input.forward, INPUT_WALK);
    assert_int_equal(input.strafe, INPUT_WALK);
    assert_int_equal(input.up, 0);
    type("SAQ");
    input = terminal_keys_input(&k);
    assert_int_equal(input.forward, -INPUT_RUN);
    assert_int_equal(input.strafe, -INPUT_RUN);
    assert_int_equal(input.up, -INPUT_RUN);
}

static void a_tap_ends_before_a_hold_does(void **state)
{
    (void)state;
    type("w");
    assert_int_equal(ticks_ahead(), 16);
    type("w");
    for (int i = 0; i < 15; i++)
        assert_true(terminal_keys_input(&k).forward);
    for (int i = 0; i < 40; i++) {          /* repeats, two ticks apart */
        type("w");
        assert_true(terminal_keys_input(&k).forward);
        assert_true(terminal_keys_input(&k).forward);
    }
    assert_true(ticks_ahead() <= 5);
}

static void arrows_turn_however_they_are_sent(void **state)
{
    static const char *const right[] = { "\033[C", "\033OC" };
    (void)state;
    for (int i = 0; i < 2; i++) {
        memset(&k, 0, sizeof k);
        for (const char *c = right[i]; *c; c++)         /* a slow line: byte by byte */
            terminal_keys_add_bytes(&k, (const uint8_t *)c, 1);
        assert_int_equal(terminal_keys_input(&k).turn, INPUT_TURN);
    }
    type("\033[B\033[5~");
    const tp_input input = terminal_keys_input(&k);
    assert_int_equal(input.tilt, -INPUT_TURN);
    assert_int_equal(input.light_tilt, INPUT_LIGHT);
    assert_false(k.quit);
}

static void brackets_turn_the_light(void **state)
{
    (void)state;
    type("]");
    assert_int_equal(terminal_keys_input(&k).light_turn, INPUT_LIGHT);
    type("[");
    assert_int_equal(terminal_keys_input(&k).light_turn, -INPUT_LIGHT);
}

static void events_come_once(void **state)
{
    (void)state;
    type("ff,");
    tp_input input = terminal_keys_input(&k);
    assert_int_equal(input.drops, 2);
    assert_int_equal(input.slowdown, 1);
    input = terminal_keys_input(&k);
    assert_int_equal(input.drops, 0);
    assert_int_equal(input.slowdown, 0);
    type(" ");
    assert_true(k.pause);
    type(" ");
    assert_false(k.pause);
    type("\003");
    assert_true(k.interrupt);
}

static void esc_quits_and_sequences_do_not(void **state)
{
    (void)state;
    type("\033[[A\033[24~\033[1;5C\033[3~");            /* F1, F12, Ctrl-right, Delete */
    terminal_keys_flush(&k);
    assert_false(k.quit);
    assert_int_equal(terminal_keys_input(&k).turn, 0);
    type("\033[");                                      /* cut off: ignored */
    terminal_keys_flush(&k);
    assert_false(k.quit);
    type("C");
    assert_int_equal(terminal_keys_input(&k).turn, 0);
    type("\033");
    assert_false(k.quit);
    terminal_keys_flush(&k);
    assert_true(k.quit);
}

static void any_bytes_leave_it_usable(void **state)
{
    uint32_t seed = 99;
    (void)state;
    for (int i = 0; i < 200000; i++) {
        seed = seed * 1664525u + 1013904223u;
        const uint8_t byte = (uint8_t)(seed >> 24);
        terminal_keys_add_bytes(&k, &byte, 1);
        assert_true(k.escapes < sizeof k.escape);
    }
    terminal_keys_flush(&k);
    memset(k.held, 0, sizeof k.held);
    type("w");
    assert_true(terminal_keys_input(&k).forward > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(letters_move_and_capitals_run, fresh),
        cmocka_unit_test_setup(a_tap_ends_before_a_hold_does, fresh),
        cmocka_unit_test_setup(arrows_turn_however_they_are_sent, fresh),
        cmocka_unit_test_setup(brackets_turn_the_light, fresh),
        cmocka_unit_test_setup(events_come_once, fresh),
        cmocka_unit_test_setup(esc_quits_and_sequences_do_not, fresh),
        cmocka_unit_test_setup(any_bytes_leave_it_usable, fresh),
    };
    return cmocka_run_group_tests_name("screen keys", tests, NULL, NULL);
}
