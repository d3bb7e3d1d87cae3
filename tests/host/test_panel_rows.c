/* SPDX-License-Identifier: MIT */
/* Rows of the panel without a window: groups, search, labels, numbers of sliders. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/app/preview/panel_rows.h"
#include "world/text.h"

static panel_row row_of(const tp_param *p)
{
    const double one = p->kind == TP_PARAM_FX ? 65536 : 1;
    return (panel_row){ p->name, p->unit, p->help,
                        p->kind == TP_PARAM_INT ? PANEL_COUNT : PANEL_NUMBER,
                        p->low / one, p->high / one, NULL };
}

static bool is_number(const tp_param *p)
{
    return p->kind == TP_PARAM_FX || p->kind == TP_PARAM_INT;
}

/* -- sliders --------------------------------------------------------------------- */

static void every_place_is_a_value_that_the_table_takes(void **state)
{
    (void)state;
    static tp_scene scene;
    uint32_t count;
    const tp_param *p = tp_params(&count);
    tp_scene_level(&scene);
    for (uint32_t i = 0; i < count; i++, p++) {
        if (!is_number(p))
            continue;
        const panel_row row = row_of(p);
        const panel_span span = panel_span_choose(&row, 0);
        for (int place = 0; place <= span.steps; place++) {
            char text[PANEL_TEXT];
            tp_error err;
            panel_number(&span, place, text);
            if (tp_param_set(&scene, p, text, strlen(text), &err) != TP_OK)
                fail_msg("%s refuses %s", p->name, text);
        }
    }
}

/* Position to value and back gives the same position, up to a few steps of rounding. */
static void values_stand_at_their_places(void **state)
{
    (void)state;
    uint32_t count;
    const tp_param *p = tp_params(&count);
    for (uint32_t i = 0; i < count; i++, p++) {
        if (!is_number(p))
            continue;
        const panel_row row = row_of(p);
        const panel_span span = panel_span_choose(&row, 0);
        assert_int_equal(panel_place(&span, span.low), 0);
        assert_int_equal(panel_place(&span, span.high), span.steps);
        double before = -1e9;
        for (int place = 0; place <= span.steps; place++) {
            char text[PANEL_TEXT];
            panel_number(&span, place, text);
            const double value = strtod(text, NULL);
            if (value < before)
                fail_msg("%s falls at %s", p->name, text);
            if (!span.whole && abs(panel_place(&span, value) - place) > 3)
                fail_msg("%s: %s is at %d, not at %d", p->name, text,
                         panel_place(&span, value), place);
            before = value;
        }
    }
}

static void a_place_in(const char *name, double value, int place, const char *want)
{
    char text[PANEL_TEXT];
    const panel_row row = row_of(tp_param_find(name, strlen(name)));
    const panel_span span = panel_span_choose(&row, value);
    panel_number(&span, place < 0 ? panel_place(&span, value) : place, text);
    assert_string_equal(text, want);
}

static void numbers_are_told_as_finely_as_they_are_worth(void **state)
{
    (void)state;
    a_place_in("wave0.steepness", 0.25, -1, "0.25");
    a_place_in("camera.x", 0, -1, "0");
    a_place_in("camera.x", 0, 1000, "8000");
    a_place_in("wave0.exponent", 3, -1, "3");
    a_place_in("wave0.exponent", 0, 7, "8");
    a_place_in("drops.radius", 0.002, 0, "0.002");
}

static void a_heading_has_the_turn_it_lies_in(void **state)
{
    (void)state;
    const panel_row row = row_of(tp_param_find("camera.heading", 14));
    const panel_span near = panel_span_choose(&row, 30),
                     far = panel_span_choose(&row, 1000);
    assert_true(near.low == -180 && near.high == 180 && near.fine == 0);
    assert_true(far.low == 900 && far.high == 1260);
}

/* -- words ----------------------------------------------------------------------- */

static const panel_row steep = { "wave0.crest_steepness", "", "sharpness of the crests",
                                 PANEL_NUMBER, 0, 1, "0.25" };

static void search_finds_words_of_name_and_help(void **state)
{
    (void)state;
    static const char *const found[] = {
        "", "  ", "wave", "WAVE0", "wave0.crest", "steep", "crest steep", "sharp",
        "steep SHARP", "0 crests",
    };
    static const char *const lost[] = { "wave1", "sharpness x", "wave sky" };
    for (size_t i = 0; i < sizeof found / sizeof *found; i++)
        assert_int_not_equal(panel_found(&steep, found[i]), PANEL_LOST);
    for (size_t i = 0; i < sizeof lost / sizeof *lost; i++)
        assert_int_equal(panel_found(&steep, lost[i]), PANEL_LOST);
    assert_int_equal(panel_found(&steep, "wave steep"), PANEL_BY_NAME);
    assert_int_equal(panel_found(&steep, "wave sharp"), PANEL_BY_HELP);
}

static void labels_are_cut_with_dots(void **state)
{
    (void)state;
    char text[PANEL_NAME];
    panel_label(&steep, 31, text);
    assert_string_equal(text, "crest steepness");
    panel_label(&steep, 8, text);
    assert_string_equal(text, "crest ..");
    panel_label(&steep, 0, text);
    assert_string_equal(text, "");
}

static void choices_are_parted(void **state)
{
    (void)state;
    char text[PANEL_TEXT];
    assert_true(panel_word("auto|exact|quick", 0, text));
    assert_string_equal(text, "auto");
    assert_true(panel_word("auto|exact|quick", 2, text));
    assert_string_equal(text, "quick");
    assert_false(panel_word("auto|exact|quick", 3, text));
}

static void colours_are_read(void **state)
{
    (void)state;
    assert_int_equal(panel_colour("#fF0180"), 0xff0180);
    assert_int_equal(panel_colour("#ff018"), 0);
    assert_int_equal(panel_colour("ff01800"), 0);
}

static void a_tip_tells_all(void **state)
{
    (void)state;
    char text[256];
    panel_tip(&steep, text, sizeof text);
    assert_string_equal(text, "wave0.crest_steepness\nsharpness of the crests\n0 to 1\n"
                              "default 0.25");
    panel_tip(&steep, text, 10);
    assert_string_equal(text, "wave0.cre");
}

/* -- groups ---------------------------------------------------------------------- */

static const panel_row four[] = {
    { "wave0.amplitude", "m", "", PANEL_NUMBER, 0, 16, "0" },
    { "wave0.length", "m", "", PANEL_NUMBER, 0, 16, "10" },
    { "camera.x", "m", "", PANEL_NUMBER, -8, 8, "0" },
    { "tank.kind", "none|glass", "", PANEL_CHOICE, 0, 1, "none" },
};
static uint32_t changed = 99;

static void get(void *user, uint32_t row, char text[PANEL_TEXT])
{
    (void)user;
    snprintf(text, PANEL_TEXT, "%s", row == changed ? "1" : four[row].normal);
}

static bool is_normal(void *user, uint32_t row)
{
    (void)user;
    return row != changed;
}

static void what_is_not_in_the_scene_is_idle(void **state)
{
    (void)state;
    const panel_host host = { .row = four, .rows = 4, .get = get,
                              .is_normal = is_normal };
    panel_group g[PANEL_GROUPS];
    assert_int_equal(panel_groups_collect(&host, g), 3);
    assert_string_equal(g[1].name, "camera");
    assert_int_equal(g[1].first, 2);
    for (int i = 0; i < 3; i++)
        panel_group_count(&host, &g[i], true);
    assert_true(g[0].idle && !g[1].idle && g[2].idle);
    changed = 1;
    panel_group_count(&host, &g[0], false);
    assert_true(g[0].idle && g[0].changed == 1);
    panel_group_count(&host, &g[0], true);
    assert_false(g[0].idle);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_place_is_a_value_that_the_table_takes),
        cmocka_unit_test(values_stand_at_their_places),
        cmocka_unit_test(numbers_are_told_as_finely_as_they_are_worth),
        cmocka_unit_test(a_heading_has_the_turn_it_lies_in),
        cmocka_unit_test(search_finds_words_of_name_and_help),
        cmocka_unit_test(labels_are_cut_with_dots),
        cmocka_unit_test(choices_are_parted),
        cmocka_unit_test(colours_are_read),
        cmocka_unit_test(a_tip_tells_all),
        cmocka_unit_test(what_is_not_in_the_scene_is_idle),
    };
    return cmocka_run_group_tests_name("panel rows", tests, NULL, NULL);
}
