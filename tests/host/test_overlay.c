/* SPDX-License-Identifier: MIT */
/* Text over the picture, with a stub of the font that records positions. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/app/preview/key_help_words.h"
#include "../../ports/app/preview/overlay.h"

#define MOST  1200
#define AMBER 0xffd479u

typedef struct {
    SDL_Rect at;
    uint32_t colour;
    char     text[160];             /* "": a fill */
    int      scale;
} mark;

static mark marks[MOST];
static int count, outside;
static SDL_Rect clip;
static bool clipped;
static char joined[20000];          /* all texts, with a blank between */
static keymap keys;
static font *const some = (font *)(void *)marks;   /* any pointer but NULL */

/* -- recording letters --------------------------------------------------------------- */

static void note(SDL_Rect at, uint32_t colour, const char *text, int scale)
{
    SDL_Rect seen;
    assert_in_range(count, 0, MOST - 1);
    assert_true(clipped);
    if (SDL_IntersectRect(&at, &clip, &seen) != SDL_TRUE
        || memcmp(&seen, &at, sizeof at) != 0)
        outside++;
    marks[count] = (mark){ .at = at, .colour = colour, .scale = scale };
    snprintf(marks[count++].text, 160, "%s", text);
}

int font_cell_count(const char *text)
{
    return (int)strlen(text);
}

void font_draw(font *l, int x, int y, int scale, uint32_t colour, const char *text)
{
    (void)l;
    if (!text[0])
        return;
    assert_in_range(scale, 1, FONT_SCALES);
    /* The first row and the last column of a cell are empty. */
    note((SDL_Rect){ x, y + scale, (int)strlen(text) * FONT_WIDE * scale - scale,
                     (FONT_HIGH - 1) * scale }, colour, text, scale);
    strcat(strcat(joined, joined[0] ? " " : ""), text);
}

void font_fill(font *l, int x, int y, int wide, int high, uint32_t colour,
               uint8_t alpha)
{
    (void)l;
    (void)alpha;
    if (wide > 0 && high > 0)
        note((SDL_Rect){ x, y, wide, high }, colour, "", 0);
}

void font_draw_background(font *l, int x, int y, int wide, int high, uint8_t alpha)
{
    font_fill(l, x, y, wide, high, 0, alpha);
}

void font_set_clip(font *l, const SDL_Rect *within)
{
    (void)l;
    clipped = within != NULL;
    clip = within ? *within : clip;
}

/* -- helpers ------------------------------------------------------------------------- */

static int fresh(void **state)
{
    (void)state;
    count = outside = 0;
    joined[0] = 0;
    keymap_default(&keys);
    return 0;
}

static void help(SDL_Rect where, int scale)
{
    count = outside = 0;
    joined[0] = 0;
    overlay_help(some, &where, scale, &keys);
    assert_false(clipped);
    assert_memory_equal(&clip, &where, sizeof clip);
}

static void no_two_texts_overlap(void)
{
    for (int a = 0; a < count; a++)
        for (int b = 0; b < a; b++)
            if (marks[a].text[0] && marks[b].text[0]
                && SDL_HasIntersection(&marks[a].at, &marks[b].at))
                fail_msg("'%s' lies on '%s'", marks[a].text, marks[b].text);
}

/* True if a word of keys is shown in the colour of keys. */
static bool key_shown(const char *word)
{
    const size_t n = strlen(word);
    for (int i = 0; i < count; i++)
        for (const char *at = marks[i].text; marks[i].colour == AMBER; at++) {
            at = strstr(at, word);
            if (!at)
                break;
            if ((at == marks[i].text || at[-1] == ' ') && (!at[n] || at[n] == ' '))
                return true;
        }
    return false;
}

static void every_key_is_shown(void)
{
    for (int of = 0; of < ACTIONS; of++) {
        char text[KEY_HELP_KEYS] = "";
        key_help_add_keys(text, keys.text[of]);
        for (char *rest = text, *word; (word = SDL_strtokr(rest, " ", &rest)) != NULL;)
            if (!key_shown(word))
                fail_msg("%s of %s is not shown", word, actions[of].name);
    }
    for (size_t i = 0; i < action_note_count; i++)
        if (!strstr(joined, action_notes[i].help))
            fail_msg("'%s' is not shown", action_notes[i].help);
}

/* -- help ---------------------------------------------------------------------------- */

static void help_fits_pictures_of_every_size(void **state)
{
    static const int sizes[][2] = { { 320, 240 }, { 400, 240 }, { 480, 360 }, { 640, 480 },
                                    { 800, 600 }, { 1024, 600 }, { 1280, 720 },
                                    { 1920, 1080 }, { 3840, 2160 }, { 400, 1000 } };
    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (int scale = 1; scale <= 4; scale++) {
            help((SDL_Rect){ 7, 11, sizes[i][0], sizes[i][1] }, scale);
            if (outside)
                fail_msg("%d marks outside of %dx%d", outside, sizes[i][0], sizes[i][1]);
            no_two_texts_overlap();
            every_key_is_shown();
        }
}

static void a_large_picture_shows_whole_sentences(void **state)
{
    static const int sizes[][2] = { { 640, 480 }, { 1280, 720 }, { 1920, 1080 } };
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        help((SDL_Rect){ 0, 0, sizes[i][0], sizes[i][1] }, 1);
        for (int of = 0; of < ACTIONS; of++) {
            char line[200] = "";
            key_help_add_keys(line, keys.text[of]);
            strcat(strcat(line, " "), actions[of].help);
            if (!strstr(joined, line))
                fail_msg("no line '%s'", line);
        }
    }
}

static void a_small_picture_shows_names(void **state)
{
    static const char *const rows[] = { "W S A D E Q move", "1 2 3 4 5 6 poke",
                                        "\1 \2 \3 \4 sphere", "PgDn down", "Shift run",
                                        "Esc Ctrl+Q quit", "Shift+N last", "[ ] speed" };
    (void)state;
    help((SDL_Rect){ 0, 0, 320, 240 }, 1);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (!strstr(joined, rows[i]))
            fail_msg("no '%s' in %s", rows[i], joined);
}

static void letters_are_as_large_as_wished_and_larger_where_there_is_room(void **state)
{
    (void)state;
    help((SDL_Rect){ 0, 0, 640, 480 }, 1);
    assert_int_equal(marks[count - 1].scale, 1);
    help((SDL_Rect){ 0, 0, 640, 480 }, 2);
    assert_int_equal(marks[count - 1].scale, 2);
    help((SDL_Rect){ 0, 0, 1920, 1080 }, 1);
    assert_int_equal(marks[count - 1].scale, 2);
    help((SDL_Rect){ 0, 0, 320, 240 }, 8);
    assert_int_equal(marks[count - 1].scale, 1);
}

static void other_keys_are_shown_as_they_are(void **state)
{
    (void)state;
    help((SDL_Rect){ 0, 0, 640, 480 }, 1);
    assert_null(strstr(joined, "Return "));
    strcpy(keys.text[ACT_DROP], "Return Ctrl+Up");
    strcpy(keys.text[ACT_FILM], "");
    strcpy(keys.text[ACT_FORWARD], "KeypadEnter");
    help((SDL_Rect){ 0, 0, 640, 480 }, 1);
    assert_non_null(strstr(joined, "Return Ctrl+\1 release a drop"));
    assert_non_null(strstr(joined, "- record a film"));
    help((SDL_Rect){ 0, 0, 400, 300 }, 1);
    assert_non_null(strstr(joined, "KeypadEnter forward"));
    assert_non_null(strstr(joined, "- film"));
    every_key_is_shown();
}

/* Draws as much as there is room for; the clip cuts the rest. */
static void tiny_pictures_and_endless_keys_do_no_harm(void **state)
{
    (void)state;
    for (int of = 0; of < ACTIONS; of++) {
        memset(keys.text[of], 'x', sizeof keys.text[of] - 1);
        keys.text[of][sizeof keys.text[of] - 1] = 0;
    }
    for (int wide = 1; wide < 400; wide += 57)
        for (int high = 1; high < 300; high += 43)
            help((SDL_Rect){ 3, 5, wide, high }, 3);
    keymap_default(&keys);
    help((SDL_Rect){ 3, 5, 16, 16 }, 1);
}

/* -- figures ------------------------------------------------------------------------- */

static panel_performance told = { .limit_ms = 16.7f, .median_ms = 9.4f, .shown_per_s = 60,
                              .latency_ms = 18, .state = "tick 12" };
static panel_compare compare = { "split", "exact", 41.27, "the reference draws: 40%" };

static void show(SDL_Rect where, int scale)
{
    count = outside = 0;
    joined[0] = 0;
    overlay_performance(some, &where, scale, &told, &compare);
    assert_false(clipped);
    assert_int_equal(outside, 0);
    no_two_texts_overlap();
}

static const SDL_Rect usual = { 10, 10, 640, 480 };

static void set_history(uint32_t pictures)
{
    told.pictures = pictures;
    for (int i = 0; i < PANEL_HISTORY; i++)
        told.history[i] = i < 120 ? 8.0f : i < 239 ? 20.0f : 500.0f;
}

/* Finds the fills of one px width from left to right: the graph's bars. */
static int bars(const mark *at[PANEL_HISTORY])
{
    int n = 0;
    for (int i = 0; i < count; i++)
        if (!marks[i].text[0] && marks[i].at.w == 1) {
            assert_in_range(n, 0, PANEL_HISTORY - 1);
            at[n++] = &marks[i];
        }
    return n;
}

static void the_graph_has_a_bar_for_each_picture(void **state)
{
    const mark *bar[PANEL_HISTORY];
    (void)state;
    set_history(PANEL_HISTORY);
    told.part_count = told.stage_count = 0;
    show(usual, 1);
    assert_int_equal(bars(bar), PANEL_HISTORY);
    for (int i = 1; i < PANEL_HISTORY; i++) {
        assert_int_equal(bar[i]->at.x, bar[i - 1]->at.x + 1);
        assert_int_equal(bar[i]->at.y + bar[i]->at.h, bar[0]->at.y + bar[0]->at.h);
    }
    const mark *line = bar[PANEL_HISTORY - 1] + 1;      /* drawn next: the limit, 16.7 ms */
    assert_int_equal(line->at.w, PANEL_HISTORY);
    assert_true(bar[0]->at.y > line->at.y);
    assert_true(bar[200]->at.y < line->at.y);
    assert_int_not_equal(bar[0]->colour, bar[200]->colour);
    assert_int_not_equal(bar[200]->colour, bar[239]->colour);
    assert_non_null(strstr(joined, "16.7"));
}

static void the_first_pictures_stand_at_the_right(void **state)
{
    const mark *bar[PANEL_HISTORY];
    (void)state;
    set_history(3);
    show(usual, 1);
    assert_int_equal(bars(bar), 3);
    const mark *line = bar[2] + 1;
    assert_int_equal(bar[2]->at.x + 1, line->at.x + line->at.w);
    assert_true(bar[0]->at.y < line->at.y);             /* 20 ms, 20 ms, 500 ms */
    assert_true(bar[2]->at.y < bar[1]->at.y);
    assert_int_equal(bar[0]->at.y, bar[1]->at.y);
}

static void times_are_listed_and_compared(void **state)
{
    (void)state;
    set_history(0);
    told.parts[0] = (panel_time){ "water moves", 812, 0.1f };
    told.parts[1] = (panel_time){ "pixels", 7302, 0.8f };
    told.part_count = 2;
    told.stages[0] = (panel_time){ "a stage with a name that is far too long", 3000, 7 };
    told.stage_count = 1;
    show(usual, 1);
    assert_non_null(strstr(joined, "9.4 ms  60/s  key to picture 18 ms"));
    assert_non_null(strstr(joined, "water moves            0.81 ms"));
    assert_non_null(strstr(joined, "a stage with a name    3.00 ms"));
    assert_non_null(strstr(joined, "split: exact, PSNR 41.27 dB the reference draws: 40%"));
    compare.psnr = 100;
    show(usual, 1);
    assert_non_null(strstr(joined, "exact, the same bits"));
    compare.psnr = -1;
    show(usual, 1);
    assert_null(strstr(joined, "dB"));
    compare.off = "off";
    show(usual, 1);
    assert_null(strstr(joined, "exact"));
    compare = (panel_compare){ "split", "exact", 41.27, "" };
}

static void figures_fit_small_pictures_too(void **state)
{
    (void)state;
    set_history(PANEL_HISTORY);
    told.part_count = told.stage_count = PANEL_TIMES;
    for (int i = 0; i < PANEL_TIMES; i++)
        told.parts[i] = told.stages[i] = (panel_time){ "part", 100, 0.01f };
    for (int scale = 1; scale <= 4; scale++) {
        show((SDL_Rect){ 5, 5, 320, 240 }, scale);
        show((SDL_Rect){ 5, 5, 640, 480 }, scale);
        show((SDL_Rect){ 5, 5, 1280, 720 }, scale);
    }
    assert_int_equal(marks[count - 1].scale + marks[count - 2].scale, 4);
}

/* -- messages ------------------------------------------------------------------------ */

static void message(SDL_Rect where, const char *text, uint8_t alpha)
{
    count = outside = 0;
    joined[0] = 0;
    overlay_message(some, &where, 1, text, alpha);
    assert_false(clipped);
    assert_int_equal(outside, 0);
    no_two_texts_overlap();
}

static void the_newest_message_is_lowest(void **state)
{
    (void)state;
    message(usual, "first\nsecond", 255);
    assert_string_equal(joined, "first second");
    assert_true(marks[1].at.y < marks[3].at.y);
    assert_in_range(marks[3].at.y, 470, 490);
    assert_int_equal(marks[1].colour >> 24, 0);
    message(usual, "first", 55);
    assert_int_equal(marks[1].colour >> 24, 200);
    message(usual, "", 255);
    assert_int_equal(count, 0);
}

static void long_messages_break_between_words(void **state)
{
    const char *const text = "tidepool view: no window of that size can be opened on this "
                             "display, whatever anybody says of it";
    (void)state;
    message((SDL_Rect){ 0, 0, 160, 120 }, text, 255);
    assert_string_equal(joined, text);
    assert_true(count >= 8);
    message((SDL_Rect){ 0, 0, 160, 120 }, "/home/somebody/a-path-that-has-no-blanks.png",
            255);
    assert_int_equal(count, 4);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, fresh)
    const struct CMUnitTest tests[] = {
        TEST(help_fits_pictures_of_every_size),
        TEST(a_large_picture_shows_whole_sentences),
        TEST(a_small_picture_shows_names),
        TEST(letters_are_as_large_as_wished_and_larger_where_there_is_room),
        TEST(other_keys_are_shown_as_they_are),
        TEST(tiny_pictures_and_endless_keys_do_no_harm),
        TEST(the_graph_has_a_bar_for_each_picture),
        TEST(the_first_pictures_stand_at_the_right),
        TEST(times_are_listed_and_compared),
        TEST(figures_fit_small_pictures_too),
        TEST(the_newest_message_is_lowest),
        TEST(long_messages_break_between_words),
    };
    return cmocka_run_group_tests_name("overlay", tests, NULL, NULL);
}
