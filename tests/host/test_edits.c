/* SPDX-License-Identifier: MIT */
/* Undo and redo: order, a drag as one edit, the oldest edits dropped. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#undef fail                     /* cmocka's, without arguments */
#include "../../ports/app/session/undo.h"
#include "tests/lib/measure.h"

static undo_edits e;
static uint64_t chance;

static int set_up(void **state)
{
    (void)state;
    memset(&e, 0, sizeof e);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    undo_edits_clear(&e);
    assert_int_equal(e.bytes, 0);
    return 0;
}

static undo_edit edit_of(uint32_t row, const char *before, const char *after)
{
    undo_edit new = { .row = row };
    snprintf(new.before.value.text, sizeof new.before.value.text, "%s", before);
    snprintf(new.after.value.text, sizeof new.after.value.text, "%s", after);
    return new;
}

static void add(uint32_t row, const char *before, const char *after, bool going)
{
    const undo_edit new = edit_of(row, before, after);
    undo_edits_add(&e, &new, going);
}

static void assert_edit(const undo_edit *got, uint32_t row, const char *before,
                        const char *after)
{
    assert_non_null(got);
    assert_int_equal(got->row, row);
    assert_string_equal(got->before.value.text, before);
    assert_string_equal(got->after.value.text, after);
}

static void there_is_nothing_to_undo_at_first(void **state)
{
    (void)state;
    assert_null(undo_edits_step_back(&e));
    assert_null(undo_edits_step_forward(&e));
    undo_edits_split(&e);
    assert_int_equal(e.count, 0);
}

static void edits_are_undone_from_the_last_and_made_again_from_the_first(void **state)
{
    (void)state;
    add(3, "1", "2", false);
    add(3, "2", "4", false);
    add(7, "on", "off", false);
    assert_edit(undo_edits_step_back(&e), 7, "on", "off");
    assert_edit(undo_edits_step_back(&e), 3, "2", "4");
    assert_edit(undo_edits_step_forward(&e), 3, "2", "4");
    assert_edit(undo_edits_step_back(&e), 3, "2", "4");
    assert_edit(undo_edits_step_back(&e), 3, "1", "2");
    assert_null(undo_edits_step_back(&e));
    assert_edit(undo_edits_step_forward(&e), 3, "1", "2");
    assert_edit(undo_edits_step_forward(&e), 3, "2", "4");
    assert_edit(undo_edits_step_forward(&e), 7, "on", "off");
    assert_null(undo_edits_step_forward(&e));
}

static void what_was_undone_ends_with_a_new_edit(void **state)
{
    (void)state;
    add(1, "1", "2", false);
    add(1, "2", "3", false);
    undo_edits_step_back(&e);
    add(2, "a", "b", false);
    assert_null(undo_edits_step_forward(&e));
    assert_edit(undo_edits_step_back(&e), 2, "a", "b");
    assert_edit(undo_edits_step_back(&e), 1, "1", "2");
    assert_null(undo_edits_step_back(&e));
}

static void a_drag_is_one_edit(void **state)
{
    (void)state;
    add(5, "1", "1.1", true);
    add(5, "1.1", "1.2", true);
    add(5, "1.2", "1.3", false);
    add(5, "1.3", "2", true);     /* the next edit */
    undo_edits_split(&e);
    add(5, "2", "3", true);
    assert_int_equal(e.count, 3);
    assert_edit(undo_edits_step_back(&e), 5, "2", "3");
    assert_edit(undo_edits_step_back(&e), 5, "1.3", "2");
    assert_edit(undo_edits_step_back(&e), 5, "1", "1.3");
}

static void a_drag_ends_with_another_row_and_with_undo(void **state)
{
    (void)state;
    add(5, "1", "2", true);
    add(6, "7", "8", true);
    add(5, "2", "3", true);
    assert_int_equal(e.count, 3);
    assert_edit(undo_edits_step_back(&e), 5, "2", "3");
    undo_edits_step_forward(&e);
    add(5, "3", "4", true);
    assert_edit(undo_edits_step_back(&e), 5, "3", "4");
    add(5, "3", "9", true);       /* not part of the edit before */
    assert_edit(undo_edits_step_back(&e), 5, "3", "9");
    assert_edit(undo_edits_step_back(&e), 5, "2", "3");
}

static void what_ends_where_it_began_is_none(void **state)
{
    (void)state;
    add(1, "0", "1", false);
    add(5, "1", "1", false);
    add(5, "1", "2", true);
    add(5, "2", "1", false);
    add(5, "1", "2", true);
    add(5, "2", "1", true);
    undo_edits_split(&e);
    add(5, "1", "2", true);
    add(5, "2", "1", true);
    add(6, "a", "b", false);
    assert_int_equal(e.count, 2);
    undo_edits_step_back(&e);
    assert_edit(undo_edits_step_back(&e), 1, "0", "1");
}

/* The same text set from another folder names another file. */
static void who_set_it_is_part_of_a_value(void **state)
{
    (void)state;
    undo_edit new = edit_of(3, "a.png", "a.png");
    new.before.value.set_at = 14;
    new.after.value.set_at = SET_BY_COMMAND;
    undo_edits_add(&e, &new, false);
    const undo_edit *got = undo_edits_step_back(&e);
    assert_int_equal(got->before.value.set_at, 14);
    assert_int_equal(got->after.value.set_at, SET_BY_COMMAND);
}

static void a_drag_has_the_lines_of_all_its_steps(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 4; i++) {
        undo_edit new = edit_of(7, "1", i == 3 ? "9" : "2");
        new.line = 10 + i;
        new.line_end = 11 + i;
        undo_edits_add(&e, &new, i < 3);
    }
    const undo_edit *got = undo_edits_step_back(&e);
    assert_int_equal(got->line, 10);
    assert_int_equal(got->line_end, 14);
}

/* -- worlds -------------------------------------------------------------------------- */

#define WORLD_BYTES 4096

static const tp_world *world(int number)
{
    static uint64_t block[WORLD_BYTES / 8];
    memset(block, number, sizeof block);
    return (const void *)block;
}

/* Adds an edit from world `from` to world `to`. */
static void add_worlds(uint32_t row, int from, int to, bool going)
{
    undo_edit new = edit_of(row, from ? "a" : "b", "c");
    new.before.world = e.open ? NULL : undo_edits_world(&e, world(from), WORLD_BYTES);
    new.after.world = undo_edits_world(&e, world(to), WORLD_BYTES);
    undo_edits_add(&e, &new, going);
}

static void edits_share_the_world_between_them(void **state)
{
    (void)state;
    for (int i = 0; i < 5; i++)
        add_worlds(1, i, i + 1, false);
    assert_int_equal(e.bytes, 6 * WORLD_BYTES);
    for (int i = 4; i >= 0; i--) {
        const undo_edit *got = undo_edits_step_back(&e);
        assert_memory_equal(got->before.world->world, world(i), WORLD_BYTES);
        assert_memory_equal(got->after.world->world, world(i + 1), WORLD_BYTES);
    }
    add_worlds(2, 77, 78, false);               /* drops the undone edits */
    assert_int_equal(e.count, 1);
    assert_int_equal(e.bytes, 2 * WORLD_BYTES);
    undo_edits_forget_worlds(&e);
    assert_int_equal(e.bytes, 0);
    assert_null(undo_edits_step_back(&e)->before.world);
}

static void a_drag_keeps_the_worlds_at_its_ends(void **state)
{
    (void)state;
    for (int i = 1; i < 9; i++)
        add_worlds(1, i, i + 1, i < 8);
    assert_int_equal(e.bytes, 2 * WORLD_BYTES);
    const undo_edit *got = undo_edits_step_back(&e);
    assert_memory_equal(got->before.world->world, world(1), WORLD_BYTES);
    assert_memory_equal(got->after.world->world, world(9), WORLD_BYTES);
}

/* Each world has a fifth of the allowed bytes. */
static void the_worlds_of_the_oldest_edits_go_first(void **state)
{
    (void)state;
    const size_t bytes = UNDO_EDITS_BYTES / 5;
    uint64_t *large = calloc(1, bytes);
    for (uint64_t i = 1; i < 9; i++) {
        undo_edit new = edit_of(1, "a", "b");
        large[0] = i;
        new.before.world = undo_edits_world(&e, (const void *)large, bytes);
        large[0] = i + 1;
        new.after.world = undo_edits_world(&e, (const void *)large, bytes);
        undo_edits_add(&e, &new, false);
        assert_in_range(e.bytes, bytes, UNDO_EDITS_BYTES);
    }
    for (int i = 8; i > 0; i--) {
        const undo_edit *got = undo_edits_step_back(&e);
        assert_true(i < 5 || (got->before.world && got->after.world));
        assert_true(i > 4 || !got->before.world);
    }
    assert_null(undo_edits_world(&e, (const void *)large, UNDO_EDITS_BYTES + 1u));
    free(large);
}

/* Compares with a simple model: a number that is changed and restored as text. */
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
            add(random_below(&chance, 2), was, now, what == 0);
        } else if (what < 7) {
            const bool undo = random_below(&chance, 5) < 3;
            const undo_edit *got =
                undo ? undo_edits_step_back(&e) : undo_edits_step_forward(&e);
            const undo_side *from = !got ? NULL : undo ? &got->after : &got->before;
            const undo_side *to = !got ? NULL : undo ? &got->before : &got->after;
            if (got) {
                assert_string_equal(now, from->value.text);
                snprintf(now, sizeof now, "%.15s", to->value.text);
            }
        } else {
            undo_edits_split(&e);
        }
        assert_in_range(e.count, 0, UNDO_EDITS);
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
        add(4, before, after, false);
    }
    for (int n = 999; n >= 1000 - UNDO_EDITS; n--) {
        snprintf(before, sizeof before, "%d", n);
        assert_string_equal(undo_edits_step_back(&e)->before.value.text, before);
    }
    assert_null(undo_edits_step_back(&e));
    undo_edits_clear(&e);
    assert_null(undo_edits_step_forward(&e));
}

#define HELD(test) cmocka_unit_test_setup_teardown(test, set_up, tear_down)

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        HELD(there_is_nothing_to_undo_at_first),
        HELD(edits_are_undone_from_the_last_and_made_again_from_the_first),
        HELD(what_was_undone_ends_with_a_new_edit),
        HELD(a_drag_is_one_edit),
        HELD(a_drag_ends_with_another_row_and_with_undo),
        HELD(what_ends_where_it_began_is_none),
        HELD(who_set_it_is_part_of_a_value),
        HELD(a_drag_has_the_lines_of_all_its_steps),
        HELD(edits_share_the_world_between_them),
        HELD(a_drag_keeps_the_worlds_at_its_ends),
        HELD(the_worlds_of_the_oldest_edits_go_first),
        HELD(any_row_of_them_leads_back_and_forth),
        HELD(the_oldest_are_forgotten),
    };
    return cmocka_run_group_tests_name("edits", tests, NULL, NULL);
}
