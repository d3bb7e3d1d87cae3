/* SPDX-License-Identifier: MIT */
/* Boards: their budgets, the plans for them, and both as text. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "interact/boards.h"
#include "interact/plan_text.h"
#include "tests/lib/scenes.h"

static void the_table_has_a_row_of_each_name(void **state)
{
    static const char *const names[] = {
#define X(name) #name,
        TP_BOARD_LIST(X)
#undef X
    };

    (void)state;
    for (int i = 0; i < TP_BOARDS - 1; i++) {
        tp_scene scene = scene_plain();
        scene.quality.board = i + 1;
        assert_string_equal(boards[i].name, names[i]);
        assert_ptr_equal(board_find(names[i]), &boards[i]);
        assert_ptr_equal(board_of_scene(&scene), &boards[i]);
        assert_non_null(strstr(BOARD_NAMES, names[i]));
        assert_true(boards[i].speed > 1000000 && boards[i].ram > 0 && boards[i].flash > 0);
    }
    assert_null(board_find("stm32f4"));
    assert_null(board_find(""));
}

static void numbers_out_of_range_are_no_board(void **state)
{
    static const int32_t numbers[] = { INT32_MIN, -1, 0, TP_BOARDS, INT32_MAX };

    (void)state;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        tp_scene scene = scene_plain();
        scene.quality.board = numbers[i];
        assert_null(board_of_scene(&scene));
    }
}

/* 129 M instructions a second: 60 ticks of 1 M leave 69 M; a tenth of a second has 6.9. */
static void a_budget_is_what_ticks_leave(void **state)
{
    const plan_board *b = board_find("stm32f405");
    board_frame frame = { b, BOARD_FRAME_US, 1000000 };

    (void)state;
    assert_int_equal(board_frame_budget(&frame), 6900000);
    frame.tick = 0;
    assert_int_equal(board_frame_budget(&frame), 12900000);
    frame.tick = 3000000;
    assert_int_equal(board_frame_budget(&frame), 0);
}

static void a_scene_names_the_time_of_a_frame(void **state)
{
    tp_scene scene = scene_plain();

    (void)state;
    scene.quality.board = TP_BOARD_rp2350;
    assert_int_equal(board_frame_of_scene(&scene).frame_us, BOARD_FRAME_US);
    scene.quality.frame_ms = TP_FX(12.5);
    assert_int_equal(board_frame_of_scene(&scene).frame_us, 12500);
    assert_int_equal(board_frame_of_scene(&scene).tick, 0);
}

/* The plan keeps the budget or says that it does not, and a longer frame is more exact. */
static void plans_keep_the_budget_or_say_so(void **state)
{
    tp_scene scene = scene_plain();
    uint64_t square = UINT64_MAX;
    uint32_t kept = 0;

    (void)state;
    memset(&scene.quality.visibility, 0,
           sizeof scene.quality - offsetof(tp_scene_quality, visibility));
    for (uint32_t us = 1000; us < 4000000; us *= 2) {
        const board_frame frame = { board_find("stm32f405"), us, 100000 };
        bool real_time;
        const tp_plan plan = board_plan_make(&frame, &scene, NULL, 320, 240, &real_time);
        assert_int_equal(real_time, plan.price.cost <= board_frame_budget(&frame));
        assert_true(plan.open >> TP_KIND_mirror_size & 1);
        if (real_time) {
            assert_true(plan.price.square <= square);
            square = plan.price.square;
        }
        kept += real_time;
    }
    assert_true(kept > 3 && square == 0);       /* and in the end it is exact */
}

static void a_refused_scene_has_no_plan(void **state)
{
    const board_frame frame = { board_find("stm32f405"), BOARD_FRAME_US, 0 };
    const tp_scene scene = scene_plain();
    bool real_time = true;

    (void)state;
    const tp_plan plan = board_plan_make(&frame, &scene, NULL, 8, 8, &real_time);
    assert_int_equal(plan.open, 0);
    assert_false(real_time);
}

/* -- text ------------------------------------------------------------------------------ */

static void prices_have_two_decimals(void **state)
{
    static const struct { uint64_t cost, square; const char *text; } rows[] = {
        { 0, 0, "0.00 M, off 0.00" }, { 4999, 65536, "0.00 M, off 1.00" },
        { 12345678, 65536 * 9, "12.35 M, off 3.00" },
        { 1000000000000u, 65536 / 4, "1000000.00 M, off 0.50" },
    };
    char text[64];

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        plan_text to = { text, sizeof text, 0 };
        plan_text_add_price(&to, (tp_set_price){ rows[i].cost, rows[i].square });
        assert_string_equal(text, rows[i].text);
    }
}

static void changes_are_settings(void **state)
{
    const tp_scene scene = scene_plain();
    const tp_rung_set from = { .of = { 0 } };
    tp_rung_set with = from;
    char text[128];
    plan_text whole = { text, sizeof text, 0 };

    (void)state;
    with.of[TP_KIND_foam] = 1;
    with.of[TP_KIND_mirror_size] = 1;
    plan_text_add_changes(&whole, &scene, &from, &with, true);
    assert_string_equal(text, "quality.foam=fast mirror.size=quarter");
    plan_text part = { text, sizeof text, 0 };
    plan_text_add_changes(&part, &scene, &from, &with, false);
    assert_string_equal(text, "foam=fast mirror.size=quarter");
}

static void a_text_is_cut_at_its_end(void **state)
{
    char text[8];
    plan_text to = { text, sizeof text, 0 };

    (void)state;
    memset(text, 'x', sizeof text);
    plan_text_add(&to, "0123");
    plan_text_add(&to, "456789");
    assert_string_equal(text, "0123456");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_has_a_row_of_each_name),
        cmocka_unit_test(numbers_out_of_range_are_no_board),
        cmocka_unit_test(a_budget_is_what_ticks_leave),
        cmocka_unit_test(a_scene_names_the_time_of_a_frame),
        cmocka_unit_test(plans_keep_the_budget_or_say_so),
        cmocka_unit_test(a_refused_scene_has_no_plan),
        cmocka_unit_test(prices_have_two_decimals),
        cmocka_unit_test(changes_are_settings),
        cmocka_unit_test(a_text_is_cut_at_its_end),
    };
    return cmocka_run_group_tests_name("interact/boards", tests, NULL, NULL);
}
