/* SPDX-License-Identifier: MIT */
/* Undo and redo: in their order, drags as one, the oldest forgotten. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/host/edits.h"
#include "../unit/measure.h"

static edits e;
static uint64_t chance;

static int set_up(void **state)
{
    (void)state;
    memset(&e, 0, sizeof e);
    return 0;
}

static void assert_edit(const edit *got, uint32_t row, const char *before,
                        const char *after)
{
    assert_non_null(got);
    assert_int_equal(got->row, row);
    assert_string_equal(got->before, before);
    assert_string_equal(got->after, after);
}

static void there_is_nothing_to_undo_at_first(void **state)
{
    (void)state;
    assert_null(edits_undo(&e));
    assert_null(edits_redo(&e));
    edits_part(&e);
    edits_named(&e, true, true);
    assert_int_equal(e.count, 0);
}

static void edits_are_undone_from_the_last_and_made_again_from_the_first(void **state)
{
    (void)state;
    edits_add(&e, 3, "1", "2", false);
    edits_add(&e, 3, "2", "4", false);
    edits_add(&e, 7, "on", "off", false);
    assert_edit(edits_undo(&e), 7, "on", "off");
    assert_edit(edits_undo(&e), 3, "2", "4");
    assert_edit(edits_redo(&e), 3, "2", "4");
    assert_edit(edits_undo(&e), 3, "2", "4");
    assert_edit(edits_undo(&e), 3, "1", "2");
    assert_null(edits_undo(&e));
    assert_edit(edits_redo(&e), 3, "1", "2");
    assert_edit(edits_redo(&e), 3, "2", "4");
    assert_edit(edits_redo(&e), 7, "on", "off");
    assert_null(edits_redo(&e));
}

static void what_was_undone_ends_with_a_new_edit(void **state)
{
    (void)state;
    edits_add(&e, 1, "1", "2", false);
    edits_add(&e, 1, "2", "3", false);
    edits_undo(&e);
    edits_add(&e, 2, "a", "b", false);
    assert_null(edits_redo(&e));
    assert_edit(edits_undo(&e), 2, "a", "b");
    assert_edit(edits_undo(&e), 1, "1", "2");
    assert_null(edits_undo(&e));
}

static void a_drag_is_one_edit(void **state)
{
    (void)state;
    edits_add(&e, 5, "1", "1.1", true);
    edits_add(&e, 5, "1.1", "1.2", true);
    edits_add(&e, 5, "1.2", "1.3", false);
    edits_add(&e, 5, "1.3", "2", true);     /* the next one */
    edits_part(&e);
    edits_add(&e, 5, "2", "3", true);
    assert_int_equal(e.count, 3);
    assert_edit(edits_undo(&e), 5, "2", "3");
    assert_edit(edits_undo(&e), 5, "1.3", "2");
    assert_edit(edits_undo(&e), 5, "1", "1.3");
}

static void a_drag_ends_with_another_row_and_with_undo(void **state)
{
    (void)state;
    edits_add(&e, 5, "1", "2", true);
    edits_add(&e, 6, "7", "8", true);
    edits_add(&e, 5, "2", "3", true);
    assert_int_equal(e.count, 3);
    assert_edit(edits_undo(&e), 5, "2", "3");
    edits_redo(&e);
    edits_add(&e, 5, "3", "4", true);
    assert_edit(edits_undo(&e), 5, "3", "4");
    edits_add(&e, 5, "3", "9", true);       /* not on with the one before */
    assert_edit(edits_undo(&e), 5, "3", "9");
    assert_edit(edits_undo(&e), 5, "2", "3");
}

static void what_ends_where_it_began_is_none(void **state)
{
    (void)state;
    edits_add(&e, 1, "0", "1", false);
    edits_named(&e, false, true);
    edits_add(&e, 5, "1", "1", false);
    edits_named(&e, true, false);           /* of none */
    edits_add(&e, 5, "1", "2", true);
    edits_add(&e, 5, "2", "1", false);
    edits_add(&e, 5, "1", "2", true);
    edits_add(&e, 5, "2", "1", true);
    edits_part(&e);
    edits_add(&e, 5, "1", "2", true);
    edits_add(&e, 5, "2", "1", true);
    edits_add(&e, 6, "a", "b", false);
    assert_int_equal(e.count, 2);
    edits_undo(&e);
    const edit *first = edits_undo(&e);
    assert_edit(first, 1, "0", "1");
    assert_false(first->named[0]);
    assert_true(first->named[1]);
}

static void who_set_it_is_kept_of_a_drags_ends(void **state)
{
    (void)state;
    edits_add(&e, 5, "1", "2", true);
    edits_named(&e, false, true);
    edits_add(&e, 5, "2", "3", true);
    edits_named(&e, true, true);
    edits_add(&e, 6, "2", "3", false);
    edits_named(&e, true, false);
    const edit *other = edits_undo(&e);
    assert_true(other->named[0] && !other->named[1]);
    const edit *drag = edits_undo(&e);
    assert_true(!drag->named[0] && drag->named[1]);
}

static void long_texts_are_cut(void **state)
{
    (void)state;
    char text[1000];
    memset(text, 'x', sizeof text - 1);
    text[sizeof text - 1] = '\0';
    edits_add(&e, 1, text, "b", false);
    edits_add(&e, 1, "a", text, false);
    assert_int_equal(strlen(edits_undo(&e)->after), TP_NAME_BYTES + 63);
    assert_int_equal(strlen(edits_undo(&e)->before), TP_NAME_BYTES + 63);
}

/* Against a value that is changed and brought back: a text of a number that rises. */
static void any_row_of_them_leads_back_and_forth(void **state)
{
    (void)state;
    char now[16] = "0", was[16];
    uint32_t number = 0;

    for (int n = 0; n < 20000; n++) {
        const uint32_t what = random_below(&chance, 8);
        if (what < 4) {
            snprintf(was, sizeof was, "%s", now);
            snprintf(now, sizeof now, "%u", (unsigned)++number);
            edits_add(&e, random_below(&chance, 2), was, now, what == 0);
        } else if (what < 7) {
            const bool undo = random_below(&chance, 5) < 3;
            const edit *got = undo ? edits_undo(&e) : edits_redo(&e);
            if (got) {
                assert_string_equal(now, undo ? got->after : got->before);
                snprintf(now, sizeof now, "%.15s", undo ? got->before : got->after);
            }
        } else {
            edits_part(&e);
        }
        assert_in_range(e.count, 0, EDITS);
        assert_in_range(e.undone, 0, e.count);
    }
}

static void the_oldest_are_forgotten(void **state)
{
    (void)state;
    char before[16], after[16];

    for (int n = 0; n < 1000; n++) {
        snprintf(before, sizeof before, "%d", n);
        snprintf(after, sizeof after, "%d", n + 1);
        edits_add(&e, 4, before, after, false);
    }
    for (int n = 999; n >= 1000 - EDITS; n--) {
        snprintf(before, sizeof before, "%d", n);
        assert_string_equal(edits_undo(&e)->before, before);
    }
    assert_null(edits_undo(&e));
    edits_clear(&e);
    assert_null(edits_redo(&e));
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(there_is_nothing_to_undo_at_first, set_up),
        cmocka_unit_test_setup(
            edits_are_undone_from_the_last_and_made_again_from_the_first, set_up),
        cmocka_unit_test_setup(what_was_undone_ends_with_a_new_edit, set_up),
        cmocka_unit_test_setup(a_drag_is_one_edit, set_up),
        cmocka_unit_test_setup(a_drag_ends_with_another_row_and_with_undo, set_up),
        cmocka_unit_test_setup(what_ends_where_it_began_is_none, set_up),
        cmocka_unit_test_setup(who_set_it_is_kept_of_a_drags_ends, set_up),
        cmocka_unit_test_setup(long_texts_are_cut, set_up),
        cmocka_unit_test_setup(any_row_of_them_leads_back_and_forth, set_up),
        cmocka_unit_test_setup(the_oldest_are_forgotten, set_up),
    };
    return cmocka_run_group_tests_name("edits", tests, NULL, NULL);
}
