/* SPDX-License-Identifier: MIT */
/* The table of parameters: every row written and read back, and invalid texts of every
 * kind. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "base/base.h"
#include "world/text.h"

static const tp_param *row_of(const char *name)
{
    const tp_param *const row = tp_param_find(name, strlen(name));
    if (row == NULL)
        fail_msg("there is no row %s", name);
    return row;
}

static int32_t number_at(const tp_scene *scene, const tp_param *row)
{
    int32_t number;
    memcpy(&number, (const char *)scene + row->offset, sizeof number);
    return number;
}

static void the_rows_cover_the_scene_exactly(void **state)
{
    (void)state;
    static unsigned char rows_of[sizeof(tp_scene)];
    memset(rows_of, 0, sizeof rows_of);
    uint32_t count;
    const tp_param *const rows = tp_params(&count);
    for (uint32_t i = 0; i < count; i++) {
        const size_t bytes = tp_param_is_text(&rows[i]) ? TP_NAME_BYTES : sizeof(int32_t);
        assert_true(rows[i].offset + bytes <= sizeof rows_of);
        for (size_t k = 0; k < bytes; k++)
            rows_of[rows[i].offset + k]++;
    }
    for (size_t at = 0; at < sizeof rows_of; at++) {
        const bool own = at >= offsetof(tp_scene, own);     /* a program's own module */
        if (rows_of[at] != !own)
            fail_msg("byte %zu of the scene belongs to %d rows", at, rows_of[at]);
    }
}

static void every_row_is_found_by_its_name_alone(void **state)
{
    (void)state;
    uint32_t count;
    const tp_param *const rows = tp_params(&count);
    for (uint32_t i = 0; i < count; i++) {
        const char *const name = rows[i].name;
        const size_t bytes = strlen(name);
        assert_ptr_equal(tp_param_find(name, bytes), &rows[i]);
        char longer[64];
        snprintf(longer, sizeof longer, "%sz", name);
        assert_null(tp_param_find(longer, bytes + 1));
        assert_ptr_equal(tp_param_find(longer, bytes), &rows[i]);
    }
}

static void names_without_a_row_are_not_found(void **state)
{
    (void)state;
    static const char *const names[] = { "",
                                         ".",
                                         "wave",
                                         "wave0",
                                         "wave0.",
                                         "wave16.length",
                                         "wave00.length",
                                         "Wave0.length",
                                         "wave0.steepnes",
                                         " camera.x",
                                         "camera.x ",
                                         "camera",
                                         "x" };
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        assert_null(tp_param_find(names[i], strlen(names[i])));
    assert_null(tp_param_find("camera.x\0", 9));
}

static void every_row_explains_itself(void **state)
{
    (void)state;
    uint32_t count;
    const tp_param *const rows = tp_params(&count);
    for (uint32_t i = 0; i < count; i++) {
        const tp_param *const row = &rows[i];
        assert_in_range(strlen(row->help), 5, 70);
        assert_null(strchr(row->help, '\n'));
        assert_non_null(strchr(row->name, '.'));
        assert_true(row->low <= row->normal && row->normal <= row->high);
        assert_true(tp_param_is_text(row) || row->low < row->high);
        assert_true(strlen(row->text) < TP_NAME_BYTES);
    }
}

static void check_number(const tp_param *row, int32_t number)
{
    tp_scene scene;
    tp_scene_level(&scene);
    char text[64], again[64];
    const size_t length = tp_param_number_text(row, number, text, sizeof text);
    assert_int_equal(length, strlen(text));
    tp_error err;
    if (tp_param_set(&scene, row, text, length, &err) != TP_OK)
        fail_msg("%s refuses %s", row->name, text);
    assert_int_equal(number_at(&scene, row), number);
    assert_int_equal(tp_param_text(&scene, row, again, sizeof again), length);
    assert_string_equal(again, text);
}

static void every_number_goes_there_and_back(void **state)
{
    (void)state;
    uint32_t count;
    const tp_param *const rows = tp_params(&count);
    for (uint32_t i = 0; i < count; i++)
        if (!tp_param_is_text(&rows[i])) {
            check_number(&rows[i], rows[i].low);
            check_number(&rows[i], rows[i].high);
            check_number(&rows[i], rows[i].normal);
            check_number(&rows[i], rows[i].low - rows[i].low / 3 + rows[i].high / 3);
        }
}

static void every_text_goes_there_and_back(void **state)
{
    (void)state;
    static const char *const texts[] = { "", "a", "long ship.obj", "../b\xc3\xb8t.obj" };
    uint32_t count;
    const tp_param *const rows = tp_params(&count);
    for (uint32_t i = 0; i < count; i++)
        for (size_t k = 0;
             tp_param_is_text(&rows[i]) && k < sizeof texts / sizeof texts[0]; k++) {
            tp_scene scene;
            char text[TP_NAME_BYTES];
            memset(&scene, 'x', sizeof scene);
            assert_int_equal(
                tp_param_set(&scene, &rows[i], texts[k], strlen(texts[k]), NULL), TP_OK);
            assert_int_equal(tp_param_text(&scene, &rows[i], text, sizeof text),
                             strlen(texts[k]));
            assert_string_equal(text, texts[k]);
        }
}

static void the_default_scene_is_the_defaults_of_the_rows(void **state)
{
    (void)state;
    tp_scene scene, other;
    memset(&scene, 0x5a, sizeof scene);
    memset(&other, 0xa5, sizeof other);
    tp_scene_level(&scene);
    tp_scene_level(&other);
    assert_memory_equal(&scene, &other, sizeof scene);
    uint32_t count;
    const tp_param *const rows = tp_params(&count);
    for (uint32_t i = 0; i < count; i++)
        if (tp_param_is_text(&rows[i]))
            assert_string_equal((const char *)&scene + rows[i].offset, rows[i].text);
        else
            assert_int_equal(number_at(&scene, &rows[i]), rows[i].normal);
}

/* Checks one step beyond either end, as text. */
static void check_excess(const tp_param *row, int32_t number)
{
    tp_scene scene, before;
    tp_error err;
    char text[64];
    tp_scene_level(&scene);
    before = scene;
    const size_t length = tp_param_number_text(row, number, text, sizeof text);
    assert_int_equal(tp_param_set(&scene, row, text, length, &err), TP_E_RANGE);
    assert_int_equal(err.code, TP_E_RANGE);
    assert_int_equal(err.a, row->low);
    assert_int_equal(err.b, row->high);
    assert_string_equal(err.word, text);
    assert_memory_equal(&scene, &before, sizeof scene);
}

static void numbers_just_beyond_their_range_are_refused(void **state)
{
    (void)state;
    uint32_t count;
    const tp_param *const rows = tp_params(&count);
    for (uint32_t i = 0; i < count; i++)
        if (rows[i].kind == TP_PARAM_FX || rows[i].kind == TP_PARAM_INT) {
            check_excess(&rows[i], rows[i].low - 1);
            check_excess(&rows[i], rows[i].high + 1);
        }
}

static void the_ends_of_a_range_are_fit_to_be_shown(void **state)
{
    (void)state;
    tp_scene scene;
    tp_error err;
    char low[16], high[16];
    const tp_param *const row = row_of("wave0.steepness");
    tp_scene_level(&scene);
    assert_int_equal(tp_param_set(&scene, row, " 3 ", 3, &err), TP_E_RANGE);
    tp_param_number_text(row, err.a, low, sizeof low);
    tp_param_number_text(row, err.b, high, sizeof high);
    assert_string_equal(err.word, "3");
    assert_string_equal(low, "0");
    assert_string_equal(high, "1");
}

static void bad_texts_change_nothing_and_are_named(void **state)
{
    (void)state;
    static const struct { const char *name, *text; tp_status status; } bad[] = {
        { "wave0.steepness", "",              TP_E_NUMBER },
        { "wave0.steepness", "0.5x",          TP_E_NUMBER },
        { "wave0.steepness", "0.5 m",         TP_E_NUMBER },
        { "wave0.steepness", "half",          TP_E_NUMBER },
        { "wave0.steepness", "0,5",           TP_E_NUMBER },
        { "wave0.steepness", "1e",            TP_E_NUMBER },
        { "wave0.steepness", "nan",           TP_E_NUMBER },
        { "wave0.steepness", "-0.1",          TP_E_RANGE },
        { "wave0.steepness", "1e400000000",   TP_E_RANGE },
        { "camera.heading",  "36000",         TP_E_RANGE },
        { "grid.vertices",   "",              TP_E_NUMBER },
        { "grid.vertices",   "+",             TP_E_NUMBER },
        { "grid.vertices",   "-",             TP_E_NUMBER },
        { "grid.vertices",   "100.5",         TP_E_NUMBER },
        { "grid.vertices",   "0x10",          TP_E_NUMBER },
        { "grid.vertices",   "-1",            TP_E_RANGE },
        { "grid.vertices",   "-100",          TP_E_RANGE },
        { "grid.vertices",   "65537",         TP_E_RANGE },
        { "grid.vertices",   "4294967396",    TP_E_RANGE },
        { "grid.vertices",   "18446744073709551716", TP_E_RANGE },
        { "tank.sea",        "",              TP_E_CHOICE },
        { "tank.sea",        "maybe",         TP_E_CHOICE },
        { "tank.sea",        "off|on",        TP_E_CHOICE },
        { "tank.sea",        "2",             TP_E_CHOICE },
        { "water.filter",    "",              TP_E_CHOICE },
        { "water.filter",    "linea",         TP_E_CHOICE },
        { "water.filter",    "linear2",       TP_E_CHOICE },
        { "water.filter",    "nearest|linear", TP_E_CHOICE },
        { "water.colour",    "",              TP_E_COLOUR },
        { "water.colour",    "204060",        TP_E_COLOUR },
        { "water.colour",    "#20406",        TP_E_COLOUR },
        { "water.colour",    "#2040600",      TP_E_COLOUR },
        { "water.colour",    "#20406g",       TP_E_COLOUR },
        { "water.colour",    "blue",          TP_E_COLOUR },
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        tp_scene scene, before;
        tp_error err;
        tp_scene_level(&scene);
        before = scene;
        const tp_status status = tp_param_set(&scene, row_of(bad[i].name), bad[i].text,
                                              strlen(bad[i].text), &err);
        if (status != bad[i].status)
            fail_msg("%s = %s: %s", bad[i].name, bad[i].text, tp_status_text(status));
        assert_int_equal(err.code, status);
        assert_string_equal(err.word, bad[i].text);
        assert_memory_equal(&scene, &before, sizeof scene);
        assert_int_equal(tp_param_set(&scene, row_of(bad[i].name), bad[i].text,
                                      strlen(bad[i].text), NULL), status);
    }
}

static void names_too_long_or_dirty_are_refused(void **state)
{
    (void)state;
    tp_scene scene, before;
    tp_error err;
    char name[TP_NAME_BYTES];
    const tp_param *const row = row_of("boat.mesh");
    memset(name, 'n', sizeof name);
    tp_scene_level(&scene);
    assert_int_equal(tp_param_set(&scene, row, name, TP_NAME_BYTES - 1, &err), TP_OK);
    assert_int_equal(strlen(scene.boat.mesh), TP_NAME_BYTES - 1);
    before = scene;
    assert_int_equal(tp_param_set(&scene, row, name, TP_NAME_BYTES, &err), TP_E_LONG);
    assert_int_equal(err.a, TP_NAME_BYTES - 1);
    assert_int_equal(tp_param_set(&scene, row, "a\0b", 3, &err), TP_E_TEXT);
    assert_string_equal(err.word, "a?b");
    assert_int_equal(tp_param_set(&scene, row, "a\tb", 3, &err), TP_E_TEXT);
    assert_memory_equal(&scene, &before, sizeof scene);
}

static void texts_are_understood_in_their_usual_forms(void **state)
{
    (void)state;
    static const struct { const char *name, *text; int32_t want; } good[] = {
        { "wave3.length",  " 12.5\r\n",  TP_FX(12.5) },
        { "wave3.length",  "\t2e2 ",     TP_FX(200) },
        { "grid.vertices", "+100",       100 },
        { "grid.vertices", "0000000000000002", 2 },
        { "tank.sea",      "on",         1 },
        { "tank.sea",      " off ",      0 },
        { "tank.sea",      "yes",        1 },
        { "tank.sea",      "no",         0 },
        { "tank.sea",      "true",       1 },
        { "tank.sea",      "false",      0 },
        { "tank.sea",      "1",          1 },
        { "tank.sea",      "0",          0 },
        { "water.filter",  "nearest",    TP_FILTER_NEAREST },
        { "water.filter",  "linear",     TP_FILTER_LINEAR },
        { "water.colour",  "#20aFf0",    0x20aff0 },
    };
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        tp_scene scene;
        const tp_param *const row = row_of(good[i].name);
        tp_scene_level(&scene);
        assert_int_equal(
            tp_param_set(&scene, row, good[i].text, strlen(good[i].text), NULL), TP_OK);
        assert_int_equal(number_at(&scene, row), good[i].want);
    }
}

static void the_text_given_need_not_be_terminated(void **state)
{
    (void)state;
    tp_scene scene;
    tp_scene_level(&scene);
    assert_int_equal(tp_param_set(&scene, row_of("camera.x"), "12345", 2, NULL), TP_OK);
    assert_int_equal(scene.camera.x, TP_FX(12));
    assert_int_equal(tp_param_set(&scene, row_of("boat.mesh"), "  a b.obj!", 9, NULL),
                     TP_OK);
    assert_string_equal(scene.boat.mesh, "a b.obj");
}

static void texts_are_cut_to_their_buffer(void **state)
{
    (void)state;
    tp_scene scene;
    tp_scene_level(&scene);
    char text[16] = "########";
    const tp_param *const row = row_of("water.colour");
    scene.water.colour = 0x204060;
    assert_int_equal(tp_param_text(&scene, row, text, 4), 7);
    assert_string_equal(text, "#20");
    assert_int_equal(tp_param_text(&scene, row, text, 0), 7);
    assert_string_equal(text, "#20");
}

static void fields_have_the_rows_that_name_them(void **state)
{
    (void)state;
    tp_scene scene;
    assert_int_equal(row_of("wave15.phase")->offset, (char *)&scene.wave[15].phase
                                                     - (char *)&scene);
    assert_int_equal(row_of("boat.beam")->offset,
                     (char *)&scene.boat.beam - (char *)&scene);
    assert_int_equal(row_of("camera.near")->normal, TP_FX(0.25));
    assert_int_equal(row_of("water.gravity")->normal, TP_FX(9.81));
    assert_string_equal(row_of("water.filter")->unit, "nearest|linear");
}

static void a_scene_is_set_by_name_and_text(void **state)
{
    (void)state;
    tp_scene scene;
    tp_error err = { 0 };
    tp_scene_level(&scene);
    assert_int_equal(tp_scene_set(&scene, "wave0.steepness", " 0.5 ", &err), TP_OK);
    assert_int_equal(scene.wave[0].steepness, TP_FX(0.5));
    assert_int_equal(tp_scene_set(&scene, "floor.map", "bay.png", NULL), TP_OK);
    assert_string_equal(scene.floor.map, "bay.png");

    const tp_scene before = scene;
    assert_int_equal(tp_scene_set(&scene, "wave0.steep", "0.5", &err), TP_E_NAME);
    assert_string_equal(err.word, "wave0.steep");
    assert_int_equal(tp_scene_set(&scene, "wave0.steepness", "steep", &err), TP_E_NUMBER);
    assert_string_equal(err.word, "steep");
    assert_int_equal(tp_scene_set(NULL, "wave0.steepness", "0", &err), TP_E_NULL);
    assert_string_equal(err.word, "scene");
    assert_int_equal(tp_scene_set(&scene, NULL, "0", &err), TP_E_NULL);
    assert_string_equal(err.word, "name");
    assert_int_equal(tp_scene_set(&scene, "wave0.steepness", NULL, &err), TP_E_NULL);
    assert_string_equal(err.word, "value");
    assert_memory_equal(&scene, &before, sizeof scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_rows_cover_the_scene_exactly),
        cmocka_unit_test(every_row_is_found_by_its_name_alone),
        cmocka_unit_test(names_without_a_row_are_not_found),
        cmocka_unit_test(every_row_explains_itself),
        cmocka_unit_test(every_number_goes_there_and_back),
        cmocka_unit_test(every_text_goes_there_and_back),
        cmocka_unit_test(the_default_scene_is_the_defaults_of_the_rows),
        cmocka_unit_test(numbers_just_beyond_their_range_are_refused),
        cmocka_unit_test(the_ends_of_a_range_are_fit_to_be_shown),
        cmocka_unit_test(bad_texts_change_nothing_and_are_named),
        cmocka_unit_test(a_scene_is_set_by_name_and_text),
        cmocka_unit_test(names_too_long_or_dirty_are_refused),
        cmocka_unit_test(texts_are_understood_in_their_usual_forms),
        cmocka_unit_test(the_text_given_need_not_be_terminated),
        cmocka_unit_test(texts_are_cut_to_their_buffer),
        cmocka_unit_test(fields_have_the_rows_that_name_them),
    };
    return cmocka_run_group_tests_name("world/params", tests, NULL, NULL);
}
