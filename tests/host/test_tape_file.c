/* SPDX-License-Identifier: MIT */
/* Tapes written and read again: steps, looks and sets in order, and lines cut off when
 * the preview goes back in time. */
#define _XOPEN_SOURCE 700
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "app/scene/tape_file.h"

static char folder[] = "/tmp/tidepool-deck-XXXXXX", tape[64];

static void assert_tape(const char *text)
{
    char found[4096] = "";
    FILE *file = fopen(tape, "rb");
    assert_non_null(file);
    assert_true(fread(found, 1, sizeof found - 1, file) < sizeof found - 1);
    fclose(file);
    assert_string_equal(found, text);
}

static void spill(const char *text)
{
    FILE *file = fopen(tape, "wb");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static const tp_input turn = { .turn = 900 }, drop = { .drops = 1 }, nothing;

/* Lines are in the file at once. */
static void what_is_recorded_is_on_the_tape(void **state)
{
    (void)state;
    tape_file d;
    const tp_input both = { .turn = 900, .forward = 65536, .drops = 1 };
    assert_int_equal(tape_file_record(&d, tape, "pond"), 0);
    assert_tape("tape 2 pond\n");
    tape_file_add_input(&d, 0, &nothing);
    tape_file_add_look(&d, 0, &drop);
    tape_file_add_input(&d, 1, &drop);
    tape_file_add_look(&d, 120, &both);
    tape_file_add_setting(&d, 120, "wave0.amplitude=0.8");
    tape_file_add_setting(&d, 120, "scene.title=a = b");
    tape_file_add_input(&d, 120, &both);
    assert_tape("tape 2 pond\n1 drops=1\n120 look ahead=1 turn=900\n"
                "120 set wave0.amplitude=0.8\n120 set scene.title=a = b\n"
                "120 ahead=1 turn=900 drops=1\n");
    assert_int_equal(tape_file_close(&d), 0);
}

static void what_is_on_the_tape_is_read(void **state)
{
    (void)state;
    tape_file d;
    spill("tape 2 pond\n# a\n1 drops=1\n120 look turn=900\n120\tset \t scene.title=a = b "
          " \n"
          "120 look\n120 turn=900\n18446744073709551615 set camera.x=1\n");
    assert_int_equal(tape_file_read(&d, tape, "pond"), 0);
    assert_null(tape_file_next(&d, 0));
    const tape_file_entry *entry = tape_file_next(&d, 1);
    assert_int_equal(entry->kind, TAPE_FILE_STEP);
    assert_int_equal(entry->input.drops, 1);
    assert_int_equal(entry->line, 3);
    assert_null(tape_file_next(&d, 1));
    assert_null(tape_file_next(&d, 119));
    entry = tape_file_next(&d, 120);
    assert_int_equal(entry->kind, TAPE_FILE_LOOK);
    assert_int_equal(entry->input.turn, 900);
    entry = tape_file_next(&d, 120);
    assert_int_equal(entry->kind, TAPE_FILE_SET);
    assert_string_equal(entry->setting, "scene.title=a = b");
    assert_int_equal(entry->line, 5);
    assert_int_equal(tape_file_next(&d, 120)->kind, TAPE_FILE_LOOK);
    assert_int_equal(tape_file_next(&d, 120)->kind, TAPE_FILE_STEP);
    assert_null(tape_file_next(&d, 120));
    assert_false(tape_file_has_ended(&d, 121));
    assert_false(tape_file_has_ended(&d, UINT64_MAX));
    assert_string_equal(tape_file_next(&d, UINT64_MAX)->setting, "camera.x=1");
    assert_int_equal(tape_file_close(&d), 0);
}

static void a_tape_is_over_after_its_last_line(void **state)
{
    (void)state;
    tape_file d;
    spill("tape 2 pond\n");
    assert_int_equal(tape_file_read(&d, tape, "pond"), 0);
    assert_true(tape_file_has_ended(&d, 0));
    assert_int_equal(tape_file_close(&d), 0);
    spill("tape 2 pond\n7 look turn=1\n");
    assert_int_equal(tape_file_read(&d, tape, "pond"), 0);
    assert_false(tape_file_has_ended(&d, 7));
    assert_true(tape_file_has_ended(&d, 8));
    assert_int_equal(tape_file_close(&d), 0);
}

static void going_back_takes_lines_off(void **state)
{
    (void)state;
    tape_file d;
    assert_int_equal(tape_file_record(&d, tape, "pond"), 0);
    for (uint64_t tick = 0; tick < 100; tick++) {
        if (tick % 10 == 5)
            tape_file_add_setting(&d, tick, "camera.x=4");
        d.picture++;                    /* of the following step */
        tape_file_add_input(&d, tick, tick % 2 ? &turn : &nothing);
    }
    tape_file_cut(&d, 100);
    tape_file_cut(&d, 200);
    tape_file_cut(&d, d.picture = 5);
    assert_tape("tape 2 pond\n1 turn=900\n3 turn=900\n5 set camera.x=4\n");
    tape_file_cut(&d, d.picture = 4);
    assert_tape("tape 2 pond\n1 turn=900\n3 turn=900\n");
    tape_file_add_look(&d, 4, &turn);
    tape_file_cut(&d, 4);
    assert_tape("tape 2 pond\n1 turn=900\n3 turn=900\n4 look turn=900\n");
    tape_file_cut(&d, 3);
    d.picture = 7;
    tape_file_add_input(&d, 6, &drop);
    assert_tape("tape 2 pond\n1 turn=900\n6 drops=1\n");
    tape_file_cut(&d, 0);
    assert_tape("tape 2 pond\n");
    tape_file_add_input(&d, 2, &drop);
    assert_int_equal(tape_file_close(&d), 0);
    assert_tape("tape 2 pond\n2 drops=1\n");
}

/* Drops lines from the middle, at the end, and all; later lines follow. */
static void lines_can_be_dropped(void **state)
{
    (void)state;
    tape_file d;
    assert_int_equal(tape_file_record(&d, tape, "pond"), 0);
    tape_file_add_setting(&d, 3, "camera.x=4");
    tape_file_add_setting(&d, 3, "camera.y=5000");
    tape_file_add_look(&d, 3, &turn);
    tape_file_add_input(&d, 4, &drop);
    tape_file_drop(&d, 0, 0);
    tape_file_drop(&d, 2, 9);                        /* more than there are */
    tape_file_drop(&d, 1, 2);
    assert_tape("tape 2 pond\n3 set camera.x=4\n3 look turn=900\n4 drops=1\n");
    tape_file_add_input(&d, 5, &turn);
    tape_file_drop(&d, 0, 2);
    assert_tape("tape 2 pond\n4 drops=1\n5 turn=900\n");
    d.picture = 1;
    tape_file_add_input(&d, 6, &turn);
    tape_file_cut(&d, 0);
    assert_tape("tape 2 pond\n4 drops=1\n5 turn=900\n");
    tape_file_drop(&d, 1, 2);
    tape_file_add_setting(&d, 7, "camera.x=1");
    tape_file_drop(&d, 0, 1);
    assert_int_equal(tape_file_close(&d), 0);
    assert_tape("tape 2 pond\n7 set camera.x=1\n");
}

static void a_deck_without_a_tape_takes_all(void **state)
{
    (void)state;
    tape_file d = { 0 };
    tape_file_add_input(&d, 1, &turn);
    tape_file_add_look(&d, 1, &turn);
    tape_file_add_setting(&d, 1, "camera.x=4");
    tape_file_cut(&d, 0);
    assert_null(tape_file_next(&d, 1));
    assert_true(tape_file_has_ended(&d, 0));
    assert_int_equal(tape_file_close(&d), 0);
}

/* A full disk, and a file that cannot be cut. */
static void what_could_not_be_written_is_said(void **state)
{
    (void)state;
    tape_file d;
    if (access("/dev/full", W_OK) == 0) {
        assert_int_equal(tape_file_record(&d, "/dev/full", "pond"), 0);
        tape_file_add_input(&d, 1, &turn);
        assert_int_equal(tape_file_close(&d), 3);
    }
    assert_int_equal(tape_file_record(&d, "/dev/null", "pond"), 0);
    d.picture = 1;
    tape_file_add_input(&d, 1, &turn);
    tape_file_cut(&d, 0);
    assert_int_equal(tape_file_close(&d), 3);
    assert_int_equal(tape_file_record(&d, folder, "pond"), 3);
    assert_int_equal(tape_file_close(&d), 0);
}

static int begin(void **state)
{
    (void)state;
    if (!mkdtemp(folder))
        return -1;
    snprintf(tape, sizeof tape, "%s/a.tape", folder);
    return 0;
}

static int end(void **state)
{
    (void)state;
    return remove(tape) | rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_recorded_is_on_the_tape),
        cmocka_unit_test(what_is_on_the_tape_is_read),
        cmocka_unit_test(a_tape_is_over_after_its_last_line),
        cmocka_unit_test(going_back_takes_lines_off),
        cmocka_unit_test(lines_can_be_dropped),
        cmocka_unit_test(a_deck_without_a_tape_takes_all),
        cmocka_unit_test(what_could_not_be_written_is_said),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
