/* SPDX-License-Identifier: MIT */
/* Tapes: every input written and read back, refusals and their messages, random bytes. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/random.h"
#include "world/text.h"

enum { FIELDS = sizeof(tp_input) / sizeof(int32_t) };

static uint64_t chance;

/* -- write and read back ------------------------------------------------------------- */

/* An entry with any bits in any field, short numbers and 0 included. */
static tp_tape_entry any_entry(void)
{
    tp_tape_entry entry = { .tick = random_next(&chance) >> random_below(&chance, 64) };
    int32_t number[FIELDS];
    for (int i = 0; i < FIELDS; i++)
        number[i] = random_below(&chance, 3) ? random_number(&chance) : 0;
    memcpy(&entry.input, number, sizeof number);
    entry.input.drops &= 1023;
    return entry;
}

static void every_input_comes_back_bit_for_bit(void **state)
{
    (void)state;
    for (int n = 0; n < 20000; n++) {
        const tp_tape_entry entry = any_entry();
        tp_tape_entry back;
        char text[TP_TAPE_LINE];
        const size_t bytes = tp_tape_write(&entry, text, sizeof text);
        if (bytes == 0)
            continue;
        assert_int_equal(bytes, strlen(text));
        memset(&back, 0xa5, sizeof back);
        assert_int_equal(tp_tape_read(&back, text, bytes, NULL), TP_OK);
        assert_memory_equal(&entry, &back, sizeof back);
    }
}

/* Each field alone, with numbers at its ends. */
static void every_field_has_its_own_name(void **state)
{
    (void)state;
    static const int32_t numbers[] = { 1, -1, 65536, INT32_MAX, INT32_MIN, 1024 };
    for (size_t k = 0; k < FIELDS; k++)
        for (size_t j = 0; j < sizeof numbers / sizeof numbers[0]; j++) {
            tp_tape_entry entry = { .tick = 7 }, back;
            char text[TP_TAPE_LINE];
            memcpy((char *)&entry.input + 4 * k, &numbers[j], 4);
            if (entry.input.drops < 0 || entry.input.drops > 1024)
                continue;
            const size_t bytes = tp_tape_write(&entry, text, sizeof text);
            assert_int_equal(tp_tape_read(&back, text, bytes, NULL), TP_OK);
            assert_memory_equal(&entry, &back, sizeof back);
            assert_null(strchr(strchr(text, ' ') + 1, ' '));
        }
}

static void lines_look_as_documented(void **state)
{
    (void)state;
    const tp_tape_entry walk = { 120, { .forward = TP_FX(0.05), .turn = -1200 } };
    const tp_tape_entry rain = { 121, { .drops = 1 } };
    const tp_tape_entry none = { 122, { .drops = 0 } };
    const tp_tape_entry pokes = { 123, { .push[0] = { TP_FX(0.25), TP_FX(1.5), TP_FX(-2) },
                                         .push[1] = { TP_FX(0.25), 0, TP_FX(3) },
                                         .push[7] = { TP_FX(-0.5), TP_FX(1), 0 } } };
    char text[TP_TAPE_LINE] = "left";

    tp_tape_write(&walk, text, sizeof text);
    assert_string_equal(text, "120 ahead=0.05 turn=-1200");
    tp_tape_write(&rain, text, sizeof text);
    assert_string_equal(text, "121 drops=1");
    tp_tape_write(&pokes, text, sizeof text);
    assert_string_equal(text, "123 poke=0.25 poke_x=1.5 poke_z=-2 poke2=0.25 poke2_z=3"
                              " poke8=-0.5 poke8_x=1");
    assert_int_equal(tp_tape_write(&none, text, sizeof text), 0);
    assert_string_equal(text, "");
}

/* All fields with their longest numbers. */
static void no_line_is_longer_than_the_header_says(void **state)
{
    (void)state;
    tp_tape_entry entry = { .tick = UINT64_MAX };
    char text[TP_TAPE_LINE], cut[64];
    int32_t number[FIELDS];

    for (int i = 0; i < FIELDS; i++)
        number[i] = INT32_MIN + 1;              /* -32767.99998 */
    memcpy(&entry.input, number, sizeof number);
    const size_t bytes = tp_tape_write(&entry, text, sizeof text);
    printf("    longest line       %10d bytes of %d\n", (int)bytes, TP_TAPE_LINE);
    assert_in_range(bytes, 700, TP_TAPE_LINE - 1);
    assert_int_equal(tp_tape_write(&entry, cut, sizeof cut), bytes);
    assert_int_equal(strlen(cut), sizeof cut - 1);
    assert_memory_equal(cut, text, sizeof cut - 1);
    assert_int_equal(tp_tape_write(&entry, NULL, 0), bytes);
}

/* A line from the time when a tick took a single poke. */
static void one_poke_is_told_by_the_names_that_it_always_had(void **state)
{
    (void)state;
    const char *const line = "40 poke=0.3 poke_x=1.5 poke_z=-8 slower=1";
    const tp_tape_entry want = {
        40, { .slowdown = 1, .push[0] = { TP_FX(0.3), TP_FX(1.5), TP_FX(-8) } }
    };
    tp_tape_entry entry;
    assert_int_equal(tp_tape_read(&entry, line, strlen(line), NULL), TP_OK);
    assert_memory_equal(&entry, &want, sizeof want);
}

static void order_and_blanks_are_free(void **state)
{
    (void)state;
    const char *const line = "\t 9   up=-0.5\tslower=+1  drops=1024 ahead=0 \r";
    tp_tape_entry entry;
    assert_int_equal(tp_tape_read(&entry, line, strlen(line), NULL), TP_OK);
    assert_int_equal(entry.tick, 9);
    assert_int_equal(entry.input.up, TP_FX(-0.5));
    assert_int_equal(entry.input.slowdown, 1);
    assert_int_equal(entry.input.drops, 1024);
    assert_int_equal(tp_tape_read(&entry, "10", 2, NULL), TP_OK);
    assert_int_equal(entry.tick, 10);
    assert_int_equal(entry.input.up, 0);
}

/* -- refusals ------------------------------------------------------------------------ */

static const struct {
    const char *line, *says;
} bad[] = {
    { "", "expected a tick, found nothing" },
    { "   ", "expected a tick, found nothing" },
    { "ahead=1", "expected a tick, found ahead=1" },
    { "-1 ahead=1", "expected a tick, found -1" },
    { "+1 ahead=1", "expected a tick, found +1" },
    { "1.5 ahead=1", "expected a tick, found 1.5" },
    { "18446744073709551616 up=1", "18446744073709551616 is outside its range" },
    { "1 speed=1", "no input is called speed" },
    { "1 ahea=1", "no input is called ahea" },
    { "1 aheads=1", "no input is called aheads" },
    { "1 Ahead=1", "no input is called Ahead" },
    { "1 poke1=1", "no input is called poke1" },
    { "1 poke9=1", "no input is called poke9" },
    { "1 poke02=1", "no input is called poke02" },
    { "1 poke2_y=1", "no input is called poke2_y" },
    { "1 poke_2x=1", "no input is called poke_2x" },
    { "1 poke3=1 poke2=1 poke3=1", "poke3 occurs twice in the line" },
    { "1 poke4=32768", "poke4=32768 is outside its range" },
    { "1 ahead", "expected NAME=NUMBER, found ahead" },
    { "1 =5", "expected NAME=NUMBER, found =5" },
    { "1 ahead = 5", "expected NAME=NUMBER, found ahead" },
    { "1 ahead=", "expected a number, found nothing" },
    { "1 ahead=x", "expected a number, found x" },
    { "1 ahead=1=2", "expected a number, found 1=2" },
    { "1 ahead=0.5m", "expected a number, found 0.5m" },
    { "1 turn=0.5", "expected a number, found 0.5" },
    { "1 turn=-", "expected a number, found -" },
    { "1 turn=--1", "expected a number, found --1" },
    { "1 turn=1e3", "expected a number, found 1e3" },
    { "1 ahead=32768", "ahead=32768 is outside its range" },
    { "1 ahead=-32769", "ahead=-32769 is outside its range" },
    { "1 turn=2147483648", "turn=2147483648 is outside its range" },
    { "1 turn=-2147483649", "turn=-2147483649 is outside its range" },
    { "1 turn=99999999999999999999", "turn=99999999999999999999 is outside its range" },
    { "1 drops=-1", "drops=-1 is outside its range" },
    { "1 drops=1025", "drops=1025 is outside its range" },
    { "1 up=1 up=2", "up occurs twice in the line" },
    { "1 drops=0 up=1 drops=0", "drops occurs twice in the line" },
    { "1 a\x1b[31m=1", "no input is called a?[31m" },
};

static void bad_lines_say_what_was_expected(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        tp_tape_entry entry = { .tick = 77, .input.up = 5 };
        tp_error err;
        char says[128];
        const size_t bytes = strlen(bad[i].line);
        const tp_status status = tp_tape_read(&entry, bad[i].line, bytes, &err);
        assert_int_not_equal(status, TP_OK);
        assert_int_equal(err.code, status);
        tp_error_text(&err, says, sizeof says);
        assert_string_equal(says, bad[i].says);
        assert_int_equal(entry.tick, 77);
        assert_int_equal(entry.input.up, 5);
        assert_int_equal(tp_tape_read(&entry, bad[i].line, bytes, NULL), status);
    }
}

static void the_ends_of_the_ranges_are_read(void **state)
{
    (void)state;
    const char *const line = "18446744073709551615 turn=-2147483648 tilt=2147483647 "
                             "up=-32768 ahead=32767.99998";
    tp_tape_entry entry;
    assert_int_equal(tp_tape_read(&entry, line, strlen(line), NULL), TP_OK);
    assert_true(entry.tick == UINT64_MAX);
    assert_int_equal(entry.input.turn, INT32_MIN);
    assert_int_equal(entry.input.tilt, INT32_MAX);
    assert_int_equal(entry.input.up, TP_FX_MIN);
    assert_int_equal(entry.input.forward, TP_FX_MAX);
}

/* -- the head ------------------------------------------------------------------------ */

static void heads_come_back(void **state)
{
    (void)state;
    static const char *const scenes[] = {
        "three-swells", "a", "my scenes/rain drops.ini", "../x=1", "\xc3\xa9t\xc3\xa9",
    };
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        char text[TP_TAPE_LINE], scene[TP_NAME_BYTES];
        const size_t bytes = tp_tape_head_write(scenes[i], text, sizeof text);
        assert_int_equal(bytes, strlen(text));
        assert_int_equal(tp_tape_head_read(scene, sizeof scene, text, bytes, NULL),
                         TP_OK);
        assert_string_equal(scene, scenes[i]);
    }
    char text[32];
    tp_tape_head_write("rain", text, sizeof text);
    assert_string_equal(text, "tape 2 rain");
}

static void bad_heads_say_what_was_expected(void **state)
{
    (void)state;
    static const struct { const char *line, *says; } heads[] = {
        { "", "expected \"tape 2 SCENE\", found nothing" },
        { "tape", "expected \"tape 2 SCENE\", found tape" },
        { "tape 2", "expected \"tape 2 SCENE\", found tape 2" },
        { "tape 2  \r", "expected \"tape 2 SCENE\", found tape 2  ?" },
        { "tape two rain", "expected \"tape 2 SCENE\", found tape two rain" },
        { "tape 1 rain", "a tape of format 1; this version draws other pictures and "
                         "replays format 2 only" },
        { "tape 3 rain", "a tape of format 3; this version draws other pictures and "
                         "replays format 2 only" },
        { "tap 1 rain", "expected \"tape 2 SCENE\", found tap 1 rain" },
        { "120 drops=1", "expected \"tape 2 SCENE\", found 120 drops=1" },
        { "tape 2 ra\x01in", "control character in ra?in" },
        { "tape 2 12345678", "longer than 7 bytes" },
    };
    for (size_t i = 0; i < sizeof heads / sizeof heads[0]; i++) {
        tp_error err;
        char says[128], scene[8];
        assert_int_not_equal(tp_tape_head_read(scene, sizeof scene, heads[i].line,
                                               strlen(heads[i].line), &err), TP_OK);
        tp_error_text(&err, says, sizeof says);
        assert_string_equal(says, heads[i].says);
    }
    char scene[8];
    assert_int_equal(tp_tape_head_read(scene, sizeof scene, "tape 2 1234567\n", 15, NULL),
                     TP_OK);
    assert_string_equal(scene, "1234567");
}

/* -- random bytes -------------------------------------------------------------------- */

/* Lines from the letters of the format and some other letters, in a block of exact size,
 * so that the sanitizer sees any access beyond.  Accepted lines are written and read
 * again. */
static void random_bytes_are_refused_or_read(void **state)
{
    (void)state;
    static const char *const pieces[] = {
        "0",     "1",           "65535",   "-",       "+",         ".",        "e",
        "=",     " ",           " ",       " ",       "\t",        "ahead=",   "up=",
        "turn=", "drops=",      "slower=", "poke_x=", "poke7_z=",  "tape",     "\x80",
        "\n",    "99999999999", "5e-3",    "12 ",     "7 turn=1 ", " up=0.25",
    };
    int good = 0;

    for (int n = 0; n < 60000; n++) {
        char   text[256];
        size_t bytes = 0;
        for (int k = chance_int(&chance, 0, 8); k > 0; k--) {
            const char *const piece =
                pieces[random_below(&chance, sizeof pieces / sizeof pieces[0])];
            memcpy(text + bytes, piece, strlen(piece));
            bytes += strlen(piece);
        }
        if (n % 4 == 0)
            for (size_t i = 0; i < bytes; i++)
                text[i] = (char)random_next(&chance);
        char *const exact = malloc(bytes + 1);
        memcpy(exact + 1, text, bytes);
        tp_tape_entry entry, back;
        tp_error err;
        char line[TP_TAPE_LINE], scene[16];
        if (tp_tape_read(&entry, exact + 1, bytes, &err) == TP_OK) {
            good++;
            const size_t length = tp_tape_write(&entry, line, sizeof line);
            if (length > 0) {
                assert_int_equal(tp_tape_read(&back, line, length, NULL), TP_OK);
                assert_memory_equal(&entry, &back, sizeof back);
            }
        } else {
            assert_true(strlen(err.word) > 0);
        }
        tp_tape_head_read(scene, sizeof scene, exact + 1, bytes, &err);
        free(exact);
    }
    printf("    good among random  %10d lines of 60000\n", good);
    assert_true(good > 1000);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_input_comes_back_bit_for_bit),
        cmocka_unit_test(every_field_has_its_own_name),
        cmocka_unit_test(lines_look_as_documented),
        cmocka_unit_test(no_line_is_longer_than_the_header_says),
        cmocka_unit_test(one_poke_is_told_by_the_names_that_it_always_had),
        cmocka_unit_test(order_and_blanks_are_free),
        cmocka_unit_test(bad_lines_say_what_was_expected),
        cmocka_unit_test(the_ends_of_the_ranges_are_read),
        cmocka_unit_test(heads_come_back),
        cmocka_unit_test(bad_heads_say_what_was_expected),
        cmocka_unit_test(random_bytes_are_refused_or_read),
    };
    return cmocka_run_group_tests_name("world/tape", tests, NULL, NULL);
}
