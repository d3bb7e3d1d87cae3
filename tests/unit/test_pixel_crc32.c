/* SPDX-License-Identifier: MIT */
/* The checksum of bytes and of pixels. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "tests/lib/measure.h"
#include "pixel/pixel.h"

static uint64_t seed;

static void known_answers_are_met(void **state)
{
    (void)state;
    assert_int_equal(tp_crc32(0, "123456789", 9), 0xcbf43926);
    assert_int_equal(tp_crc32(0, "", 0), 0);
    assert_int_equal(tp_crc32(0, "a", 1), 0xe8b7be43);
    assert_int_equal(tp_crc32(0, "\0\0\0\0", 4), 0x2144df1c);
    assert_int_equal(tp_crc32(0, "The quick brown fox jumps over the lazy dog", 43),
                     0x414fa339);
}

static void a_sum_in_pieces_is_the_sum_of_the_whole(void **state)
{
    (void)state;
    uint64_t random = seed;
    uint8_t data[300];
    for (size_t i = 0; i < sizeof data; i++)
        data[i] = (uint8_t)random_next(&random);
    const uint32_t whole = tp_crc32(0, data, sizeof data);
    for (size_t cut = 0; cut <= sizeof data; cut++)
        assert_int_equal(tp_crc32(tp_crc32(0, data, cut), data + cut, sizeof data - cut),
                         whole);
}

/* For any format the sum is that of the pixels read as four bytes, low byte first. */
static void the_sum_of_pixels_is_the_sum_of_their_colours(void **state)
{
    (void)state;
    enum { WIDTH = 61 };
    uint64_t random = seed;
    uint32_t row[WIDTH];
    for (int i = 0; i < WIDTH; i++)
        row[i] = (uint32_t)random_next(&random);
    for (int f = 0; f < TP_FORMAT_COUNT; f++) {
        uint8_t bytes[WIDTH * 4];
        for (int x = 0; x < WIDTH; x++) {
            const uint32_t colour = tp_pixel_read((tp_format)f, row, x);
            for (int part = 0; part < 4; part++)
                bytes[4 * x + part] = (uint8_t)(colour >> 8 * part);
        }
        assert_int_equal(tp_crc32_pixels(0, (tp_format)f, row, WIDTH),
                         tp_crc32(0, bytes, sizeof bytes));
        assert_int_equal(tp_crc32_pixels(0x12345678, (tp_format)f, row, WIDTH),
                         tp_crc32(0x12345678, bytes, sizeof bytes));
        assert_int_equal(tp_crc32_pixels(7, (tp_format)f, row, 0), 7);
    }
}

static void both_byte_orders_of_565_have_one_sum(void **state)
{
    (void)state;
    uint64_t random = seed;
    uint16_t native[100];
    uint8_t big[200];
    for (int x = 0; x < 100; x++) {
        native[x] = (uint16_t)random_next(&random);
        big[2 * x] = (uint8_t)(native[x] >> 8);
        big[2 * x + 1] = (uint8_t)native[x];
    }
    assert_int_equal(tp_crc32_pixels(0, TP_FORMAT_RGB565, native, 100),
                     tp_crc32_pixels(0, TP_FORMAT_RGB565BE, big, 100));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_answers_are_met),
        cmocka_unit_test(a_sum_in_pieces_is_the_sum_of_the_whole),
        cmocka_unit_test(the_sum_of_pixels_is_the_sum_of_their_colours),
        cmocka_unit_test(both_byte_orders_of_565_have_one_sum),
    };
    seed = random_seed();
    return cmocka_run_group_tests_name("pixel crc32", tests, NULL, NULL);
}
