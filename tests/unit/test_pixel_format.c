/* SPDX-License-Identifier: MIT */
/* Names, sizes and palette of the formats, and reading pixels. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "pixel/pixel.h"

static void every_format_is_found_by_its_name(void **state)
{
    (void)state;
    for (int f = 0; f < TP_FORMAT_COUNT; f++) {
        const char *const name = tp_format_name((tp_format)f);
        assert_int_equal(tp_format_find(name, (uint32_t)strlen(name)), f);
    }
    assert_int_equal(tp_format_find("rgb565be and more", 8), TP_FORMAT_RGB565BE);
    assert_int_equal(tp_format_find("rgb565be", 6), TP_FORMAT_RGB565);
}

static void other_names_are_none(void **state)
{
    (void)state;
    static const char *const others[] = { "",    "rgb", "rgb56", "RGB565",
                                          "p88", "i1 ", "565" };
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        assert_int_equal(tp_format_find(others[i], (uint32_t)strlen(others[i])), -1);
    assert_string_equal(tp_format_name(TP_FORMAT_COUNT), "");
    assert_int_equal(tp_format_bits(TP_FORMAT_COUNT), 0);
}

static void rows_are_rounded_up_to_bytes(void **state)
{
    (void)state;
    assert_int_equal(tp_format_row_bytes(TP_FORMAT_XRGB8888, 640), 2560);
    assert_int_equal(tp_format_row_bytes(TP_FORMAT_RGB565, 3), 6);
    assert_int_equal(tp_format_row_bytes(TP_FORMAT_RGB565BE, 3), 6);
    assert_int_equal(tp_format_row_bytes(TP_FORMAT_P8, 3), 3);
    assert_int_equal(tp_format_row_bytes(TP_FORMAT_L8, 4096), 4096);
    assert_int_equal(tp_format_row_bytes(TP_FORMAT_I1, 8), 1);
    assert_int_equal(tp_format_row_bytes(TP_FORMAT_I1, 9), 2);
    assert_int_equal(tp_format_row_bytes(TP_FORMAT_I1, 0), 0);
    assert_int_equal(tp_format_row_bytes(TP_FORMAT_I1, -1), 0);
}

static void the_palette_is_a_cube_and_four_greys(void **state)
{
    (void)state;
    const uint32_t *const palette = tp_palette;
    for (uint32_t r = 0; r < 6; r++)
        for (uint32_t g = 0; g < 7; g++)
            for (uint32_t b = 0; b < 6; b++)
                assert_int_equal(palette[(r * 7 + g) * 6 + b],
                                 (r * 255 / 5) << 16 | (g * 255 + 3) / 6 << 8
                                     | b * 255 / 5);
    for (uint32_t i = 252; i < 256; i++)
        assert_int_equal(palette[i], (i - 251) * 51 * 0x010101);
    for (int i = 0; i < 256; i++)
        for (int k = 0; k < i; k++)
            assert_int_not_equal(palette[i], palette[k]);
}

static void pixels_of_565_repeat_their_high_bits(void **state)
{
    (void)state;
    const uint16_t row[] = { 0x0000, 0xffff, 0xf800, 0x07e0, 0x001f, 0x8410 };
    const uint32_t want[] = { 0, 0xffffff, 0xff0000, 0x00ff00, 0x0000ff, 0x848284 };
    for (int x = 0; x < 6; x++) {
        const uint8_t bytes[2] = { (uint8_t)(row[x] >> 8), (uint8_t)row[x] };
        assert_int_equal(tp_pixel_read(TP_FORMAT_RGB565, row, x), want[x]);
        assert_int_equal(tp_pixel_read(TP_FORMAT_RGB565BE, bytes, 0), want[x]);
    }
}

static void pixels_of_the_other_formats_are_read(void **state)
{
    (void)state;
    const uint32_t words[] = { 0xff123456, 0x00fedcba };
    assert_int_equal(tp_pixel_read(TP_FORMAT_XRGB8888, words, 0), 0x123456);
    assert_int_equal(tp_pixel_read(TP_FORMAT_XRGB8888, words, 1), 0xfedcba);
    const uint8_t bytes[] = { 0xa0, 0x7f };
    assert_int_equal(tp_pixel_read(TP_FORMAT_P8, bytes, 0), tp_palette[0xa0]);
    assert_int_equal(tp_pixel_read(TP_FORMAT_L8, bytes, 1), 0x7f7f7f);
    for (int x = 0; x < 16; x++) {
        const uint32_t bit = 0xa07fu >> (15 - x) & 1;
        assert_int_equal(tp_pixel_read(TP_FORMAT_I1, bytes, x), bit ? 0xffffff : 0);
    }
    assert_int_equal(tp_pixel_read(TP_FORMAT_COUNT, bytes, 0), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format_is_found_by_its_name),
        cmocka_unit_test(other_names_are_none),
        cmocka_unit_test(rows_are_rounded_up_to_bytes),
        cmocka_unit_test(the_palette_is_a_cube_and_four_greys),
        cmocka_unit_test(pixels_of_565_repeat_their_high_bits),
        cmocka_unit_test(pixels_of_the_other_formats_are_read),
    };
    return cmocka_run_group_tests_name("pixel format", tests, NULL, NULL);
}
