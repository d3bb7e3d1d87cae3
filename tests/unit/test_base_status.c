/* SPDX-License-Identifier: MIT */
/* Errors: their sentences, their words, and buffers of any size. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "base/base.h"

static void every_status_has_a_sentence(void **state)
{
    (void)state;
    for (int code = 0; code < TP_STATUS_COUNT; code++)
        assert_true(strlen(tp_status_text((tp_status)code)) > 1);
    assert_string_equal(tp_status_text(TP_OK), "ok");
    assert_string_equal(tp_status_text(TP_STATUS_COUNT), "unknown status");
    assert_string_equal(tp_status_text((tp_status)-1), "unknown status");
}

static void a_failure_records_check_place_and_numbers(void **state)
{
    (void)state;
    tp_error err;
    memset(&err, 0xa5, sizeof err);
    const int line = __LINE__ + 1;
    assert_int_equal(TP_FAIL(&err, TP_E_OBJ_VERTEX, 41, 9, 3), TP_E_OBJ_VERTEX);
    assert_int_equal(err.code, TP_E_OBJ_VERTEX);
    assert_non_null(strstr(err.file, "test_base_status.c"));
    assert_int_equal(err.line, line);
    assert_int_equal(err.where, 41);
    assert_int_equal(err.a, 9);
    assert_int_equal(err.b, 3);
    assert_string_equal(err.word, "");
}

static void a_failure_without_a_record_still_returns_its_code(void **state)
{
    (void)state;
    assert_int_equal(TP_FAIL(NULL, TP_E_ARG, 0, 0, 0), TP_E_ARG);
    tp_error_set_word(NULL, "word", 4);
}

static void the_sentence_holds_numbers_and_word(void **state)
{
    (void)state;
    tp_error err;
    char text[80];
    TP_FAIL(&err, TP_E_OBJ_VERTEX, 41, INT32_MIN, INT32_MAX);
    assert_int_equal(tp_error_text(&err, text, sizeof text), 42);
    assert_string_equal(text, "face uses vertex -2147483648 of 2147483647");
    TP_FAIL(&err, TP_E_OBJ_MISSING, 1, 3, 0);
    tp_error_set_word(&err, "vt%a", 2);
    tp_error_text(&err, text, sizeof text);
    assert_string_equal(text, "vt needs 3 numbers, found 0");
}

static void a_word_is_not_taken_for_a_sentence(void **state)
{
    (void)state;
    tp_error err;
    char text[80];
    TP_FAIL(&err, TP_E_NUMBER, 1, 7, 8);
    tp_error_set_word(&err, "%a%s%", 5);
    tp_error_text(&err, text, sizeof text);
    assert_string_equal(text, "expected a number, found %a%s%");
}

static void a_sentence_is_cut_to_its_buffer(void **state)
{
    (void)state;
    tp_error err;
    TP_FAIL(&err, TP_E_ARG, 0, 0, 0);
    const char whole[] = "argument out of range";
    for (size_t bytes = 0; bytes < sizeof whole + 4; bytes++) {
        char text[sizeof whole + 8];
        memset(text, '#', sizeof text);
        assert_int_equal(tp_error_text(&err, text, bytes), sizeof whole - 1);
        assert_int_equal(text[bytes], '#');
        if (bytes > 0) {
            const size_t kept = bytes < sizeof whole ? bytes - 1 : sizeof whole - 1;
            assert_int_equal(strlen(text), kept);
            assert_memory_equal(text, whole, kept);
        }
    }
}

static void a_long_or_dirty_word_is_made_safe(void **state)
{
    (void)state;
    tp_error err;
    char word[100];
    memset(word, 'w', sizeof word);
    TP_FAIL(&err, TP_E_NAME, 0, 0, 0);
    tp_error_set_word(&err, word, sizeof word);
    assert_int_equal(strlen(err.word), sizeof err.word - 1);
    tp_error_set_word(&err, "a\033[2J\n\0z\x7f", 9);
    assert_string_equal(err.word, "a?[2J??z?");
    tp_error_set_word(&err, "", 0);
    assert_string_equal(err.word, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_status_has_a_sentence),
        cmocka_unit_test(a_failure_records_check_place_and_numbers),
        cmocka_unit_test(a_failure_without_a_record_still_returns_its_code),
        cmocka_unit_test(the_sentence_holds_numbers_and_word),
        cmocka_unit_test(a_word_is_not_taken_for_a_sentence),
        cmocka_unit_test(a_sentence_is_cut_to_its_buffer),
        cmocka_unit_test(a_long_or_dirty_word_is_made_safe),
    };
    return cmocka_run_group_tests_name("base status", tests, NULL, NULL);
}
