/* SPDX-License-Identifier: MIT */
/* The font, drawn by SDL's software renderer into memory; no display is needed. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/app/preview/font.h"

#define WIDE 200
#define HIGH 64
#define FIELD 0x204060u             /* background */

static SDL_Surface *surface;
static SDL_Renderer *renderer;
static font *l;

static int begin(void **state)
{
    (void)state;
    surface = SDL_CreateRGBSurfaceWithFormat(0, WIDE, HIGH, 32, SDL_PIXELFORMAT_XRGB8888);
    renderer = surface ? SDL_CreateSoftwareRenderer(surface) : NULL;
    l = renderer ? font_open(renderer) : NULL;
    return l ? 0 : -1;
}

static int end(void **state)
{
    (void)state;
    font_close(l);
    SDL_DestroyRenderer(renderer);
    SDL_FreeSurface(surface);
    return 0;
}

static void wipe(void)
{
    SDL_SetRenderDrawColor(renderer, FIELD >> 16, FIELD >> 8 & 255, FIELD & 255, 255);
    SDL_RenderClear(renderer);
}

static uint32_t pixel(int x, int y)
{
    const uint8_t *row = (const uint8_t *)surface->pixels + y * surface->pitch;
    uint32_t value;
    memcpy(&value, row + 4 * x, 4);
    return value & 0xffffff;
}

/* Reads the pixels of a letter drawn at 20, 10 as bits, one row of the cell per byte.
 * Expects one colour and nothing outside of the cell. */
static void drawn(char letter, int scale, uint8_t rows[FONT_HIGH])
{
    const char text[] = { letter, 0 };
    wipe();
    font_draw(l, 20, 10, scale, 0xffe0c0, text);
    SDL_RenderFlush(renderer);
    memset(rows, 0, FONT_HIGH);
    for (int y = 0; y < HIGH; y++)
        for (int x = 0; x < WIDE; x++) {
            const int column = (x - 20) / scale, row = (y - 10) / scale;
            const bool in = x >= 20 && y >= 10 && column < FONT_WIDE
                         && row < FONT_HIGH;
            if (pixel(x, y) == FIELD) {
                if (in && (rows[row] >> column & 1))
                    fail_msg("'%c' is ragged at scale %d", letter, scale);
                continue;
            }
            if (!in || column == FONT_WIDE - 1 || row == 0)
                fail_msg("'%c' at scale %d draws at %d, %d", letter, scale, x, y);
            assert_int_equal(pixel(x, y), 0xffe0c0);
            if ((x - 20) % scale == 0 && (y - 10) % scale == 0)
                rows[row] |= (uint8_t)(1u << column);
            else if (!(rows[row] >> column & 1))
                fail_msg("'%c' is ragged at scale %d", letter, scale);
        }
}

static void every_letter_is_there_and_like_no_other(void **state)
{
    uint8_t rows[128][FONT_HIGH], none[FONT_HIGH] = { 0 };
    (void)state;
    for (int c = ' '; c < 127; c++) {
        drawn((char)c, 1, rows[c]);
        if ((memcmp(rows[c], none, sizeof none) == 0) != (c == ' '))
            fail_msg("'%c' is empty, or the blank is not", c);
        for (int other = ' '; other < c; other++)
            if (memcmp(rows[c], rows[other], FONT_HIGH) == 0)
                fail_msg("'%c' looks like '%c'", c, other);
    }
}

static void letters_read_from_left_to_right(void **state)
{
    static const char *const looks[FONT_HIGH] = {
        ".....  .....", "####.  .....", "#...#  .....", "#...#  .####", "####.  #...#",
        "#.#..  #...#", "#..#.  #...#", "#...#  .####", ".....  ....#", ".....  .###.",
    };
    uint8_t rows[2][FONT_HIGH];
    (void)state;
    drawn('R', 1, rows[0]);
    drawn('g', 1, rows[1]);
    for (int y = 0; y < FONT_HIGH; y++)
        for (int x = 0; x < 5; x++) {
            assert_int_equal(rows[0][y] >> x & 1, looks[y][x] == '#');
            assert_int_equal(rows[1][y] >> x & 1, looks[y][x + 7] == '#');
        }
}

static void capitals_stand_on_one_line_and_tails_hang_below(void **state)
{
    uint8_t rows[FONT_HIGH];
    (void)state;
    for (int c = ' '; c < 127; c++) {
        drawn((char)c, 1, rows);
        const bool below = rows[8] || rows[9];
        if (below != (strchr("gjpqy,;_|", c) != NULL))
            fail_msg("'%c' %s the line", c, below ? "hangs below" : "ends above");
        if (c >= 'A' && c <= 'Z' && (!rows[1] || !rows[7]))
            fail_msg("'%c' is not seven high", c);
    }
}

static void larger_letters_are_the_same_of_larger_pixels(void **state)
{
    uint8_t one[FONT_HIGH], more[FONT_HIGH];
    (void)state;
    for (int c = ' '; c < 127; c++) {
        drawn((char)c, 1, one);
        for (int scale = 2; scale <= 5; scale++) {
            drawn((char)c, scale, more);
            assert_memory_equal(one, more, sizeof one);
        }
    }
}

static void other_bytes_show_that_something_was_there(void **state)
{
    uint8_t unknown[FONT_HIGH], rows[FONT_HIGH];
    (void)state;
    drawn('?', 1, unknown);
    drawn('\t', 1, rows);
    assert_memory_equal(rows, unknown, sizeof rows);
    drawn('\xc3', 1, rows);
    assert_memory_equal(rows, unknown, sizeof rows);
    drawn('\xa4', 1, rows);
    assert_int_equal(rows[1], 0);
    assert_int_equal(font_cell_count("See \xc3\xa4\xe2\x82\xac!"), 7);
    for (char c = FONT_UP; c <= FONT_RIGHT; c++) {
        drawn(c, 1, rows);
        assert_memory_not_equal(rows, unknown, sizeof rows);
    }
}

static void boxes_darken_and_fills_cover(void **state)
{
    (void)state;
    wipe();
    font_draw_background(l, 10, 10, 20, 10, 128);
    font_fill(l, 40, 10, 5, 5, 0x123456, 255);
    font_fill(l, 60, 10, 0, 5, 0x123456, 255);
    font_fill(l, 60, 10, 5, -5, 0x123456, 255);
    SDL_RenderFlush(renderer);
    assert_int_equal(pixel(9, 10), FIELD);
    assert_in_range(pixel(10, 10) & 255, 0x38, 0x44);
    assert_int_equal(pixel(29, 19), pixel(10, 10));
    assert_int_equal(pixel(30, 19), FIELD);
    assert_int_equal(pixel(44, 14), 0x123456);
    assert_int_equal(pixel(60, 10), FIELD);
    assert_int_equal(pixel(60, 8), FIELD);
}

static void what_is_half_transparent_lies_between(void **state)
{
    (void)state;
    wipe();
    font_draw(l, 20, 10, 1, 0x80ffffff, "|");
    SDL_RenderFlush(renderer);
    assert_in_range(pixel(22, 12) >> 16, 0x88, 0x98);
}

static void lost_sheets_are_made_again(void **state)
{
    uint8_t before[FONT_HIGH], after[FONT_HIGH];
    (void)state;
    drawn('g', 2, before);
    font_reload(l);
    drawn('g', 2, after);
    assert_memory_equal(before, after, sizeof after);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_letter_is_there_and_like_no_other),
        cmocka_unit_test(letters_read_from_left_to_right),
        cmocka_unit_test(capitals_stand_on_one_line_and_tails_hang_below),
        cmocka_unit_test(larger_letters_are_the_same_of_larger_pixels),
        cmocka_unit_test(other_bytes_show_that_something_was_there),
        cmocka_unit_test(boxes_darken_and_fills_cover),
        cmocka_unit_test(what_is_half_transparent_lies_between),
        cmocka_unit_test(lost_sheets_are_made_again),
    };
    return cmocka_run_group_tests_name("letters", tests, begin, end);
}
