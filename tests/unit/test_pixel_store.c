/* SPDX-License-Identifier: MIT */
/* Stored pixels: nearest levels, means of the dither, and runs without seams. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "tests/lib/measure.h"
#include "pixel/pixel.h"

enum { FLAT_COLOURS = 20000, WIDTH = 40 };

static uint64_t seed;

static uint32_t part_of(uint32_t colour, int part)  /* 0 blue, 1 green, 2 red */
{
    return colour >> 8 * part & 0xff;
}

/* All 2^24 colours compared with levels by division: the nearest level, ends map to
 * ends. */
static void rgb565_takes_the_nearest_levels(void **state)
{
    (void)state;
    uint16_t of_5[256], of_6[256];
    for (int c = 0; c < 256; c++) {
        of_5[c] = (uint16_t)((c * 31 + 127) / 255);
        of_6[c] = (uint16_t)((c * 63 + 127) / 255);
    }
    for (uint32_t high = 0; high < 1u << 16; high++) {
        uint32_t colours[256];
        uint16_t native[256];
        uint8_t big[512];
        for (uint32_t low = 0; low < 256; low++)
            colours[low] = high << 8 | low;
        tp_program_all.store[TP_FORMAT_RGB565](native, 0, 0, 0, colours, 256);
        tp_program_all.store[TP_FORMAT_RGB565BE](big, 0, 0, 0, colours, 256);
        const unsigned red_green =
            (unsigned)(of_5[high >> 8] << 11 | of_6[high & 255] << 5);
        for (unsigned low = 0; low < 256; low++) {
            const unsigned want = red_green | of_5[low];
            if (native[low] != want
                || (unsigned)(big[2 * low] << 8 | big[2 * low + 1]) != want)
                fail_msg("%06x is stored as %04x", (unsigned)colours[low], native[low]);
        }
    }
}

/* The two-pixels-per-word variant: every level of every channel, beside other values. */
static void pairs_of_pixels_are_two_pixels(void **state)
{
    (void)state;
    const tp_rgb565_kept kept = tp_rgb565_load_constants();

    for (uint32_t i = 0; i < 1 << 16; i++) {
        const uint32_t a = i * 2654435761u >> 8, b = i * 0x010101u & 0xffffff;
        assert_int_equal(tp_rgb565_pack_pair(&kept, a, b),
                         tp_rgb565(b) << 16 | tp_rgb565(a));
        assert_int_equal(tp_rgb565_pack_pair(&kept, b, a),
                         tp_rgb565(a) << 16 | tp_rgb565(b));
    }
}

static void formats_without_dither_read_back_what_they_can_hold(void **state)
{
    (void)state;
    static const tp_format exact[] = { TP_FORMAT_RGB565, TP_FORMAT_RGB565BE };
    for (uint32_t pixel = 0; pixel < 1u << 16; pixel++) {
        const uint16_t native = (uint16_t)pixel;
        const uint32_t colour = tp_pixel_read(TP_FORMAT_RGB565, &native, 0);
        for (int i = 0; i < 2; i++) {
            uint16_t row[1];
            tp_program_all.store[exact[i]](row, 0, 0, 0, &colour, 1);
            assert_int_equal(tp_pixel_read(exact[i], row, 0), colour);
        }
    }
    const uint32_t colours[] = { 0, 0xffffff, 0x123456, 0xfedcba };
    uint32_t row[4];
    tp_program_all.store[TP_FORMAT_XRGB8888](row, 0, 0, 0, colours, 4);
    assert_memory_equal(row, colours, sizeof row);
}

/* The 64 pixels of the tile at (x, y) of a flat picture. */
static void store_tile(tp_format format, uint32_t colour, int x, int y, uint32_t tile[64])
{
    uint32_t flat[8];
    for (int i = 0; i < 8; i++)
        flat[i] = colour;
    for (int row = 0; row < 8; row++) {
        uint32_t pixels[8];
        tp_program_all.store[format](pixels, 0, x, y + row, flat, 8);
        for (int i = 0; i < 8; i++)
            tile[8 * row + i] = tp_pixel_read(format, pixels, i);
    }
}

static double mean_of(const uint32_t tile[64], int part)
{
    double sum = 0;
    for (int i = 0; i < 64; i++)
        sum += part_of(tile[i], part);
    return sum / 64;
}

/* Half a 64th of a level of 51; half a unit more for green, whose levels are rounded. */
static void p8_keeps_the_mean_of_flat_colours(void **state)
{
    (void)state;
    measure red_blue = { .what = "p8 red, blue", .unit = "of 255" };
    measure green = { .what = "p8 green", .unit = "of 255" };
    uint64_t random = seed;
    for (int i = 0; i < FLAT_COLOURS; i++) {
        const uint32_t colour = i < 256 ? (uint32_t)i * 0x010101
                                        : (uint32_t)random_next(&random) & 0xffffff;
        uint32_t tile[64];
        store_tile(TP_FORMAT_P8, colour, 8 * (i % 5), 8 * (i % 7), tile);
        measure_add(&red_blue, mean_of(tile, 0) - part_of(colour, 0), colour, 0, 0);
        measure_add(&green, mean_of(tile, 1) - part_of(colour, 1), colour, 1, 0);
        measure_add(&red_blue, mean_of(tile, 2) - part_of(colour, 2), colour, 2, 0);
    }
    measure_print(&red_blue);
    measure_print(&green);
    assert_true(red_blue.worst <= 51.0 / 128);
    assert_true(green.worst <= 42.5 / 128 + 0.5);
}

static double luma_of(uint32_t colour)
{
    return (77.0 * part_of(colour, 2) + 150.0 * part_of(colour, 1)
            + 29.0 * part_of(colour, 0)) / 256;
}

static void l8_keeps_the_mean_of_flat_colours(void **state)
{
    (void)state;
    measure m = { .what = "l8", .unit = "of 255" };
    uint64_t random = seed;
    for (int i = 0; i < FLAT_COLOURS; i++) {
        const uint32_t colour = (uint32_t)random_next(&random) & 0xffffff;
        uint32_t tile[64];
        store_tile(TP_FORMAT_L8, colour, 8 * (i % 5), 8 * (i % 7), tile);
        measure_add(&m, mean_of(tile, 0) - luma_of(colour), colour, 0, 0);
        for (int k = 0; k < 64; k++)
            assert_true(fabs(tile[k] % 256 - luma_of(colour)) < 1);
    }
    measure_print(&m);
    assert_true(m.worst <= 1.0 / 128);
    for (uint32_t grey = 0; grey < 256; grey++) {
        uint32_t tile[64];
        store_tile(TP_FORMAT_L8, grey * 0x010101, 0, 0, tile);
        for (int k = 0; k < 64; k++)
            assert_int_equal(tile[k], grey * 0x010101);
    }
}

static void i1_is_white_in_proportion(void **state)
{
    (void)state;
    measure m = { .what = "i1", .unit = "of 64 dots" };
    uint64_t random = seed;
    for (int i = 0; i < FLAT_COLOURS; i++) {
        const uint32_t colour = i < 256 ? (uint32_t)i * 0x010101
                                        : (uint32_t)random_next(&random) & 0xffffff;
        uint32_t tile[64];
        store_tile(TP_FORMAT_I1, colour, 8 * (i % 5), 8 * (i % 7), tile);
        measure_add(&m, (mean_of(tile, 0) - luma_of(colour)) * 64 / 255, colour, 0, 0);
    }
    measure_print(&m);
    assert_true(m.worst <= 0.5);
}

/* Any 64 neighbours hold every rank, for any start of the tile. */
static void the_mean_is_kept_wherever_the_tile_lies(void **state)
{
    (void)state;
    for (int x = 0; x < 8; x++)
        for (int y = 0; y < 8; y++) {
            uint32_t tile[64];
            store_tile(TP_FORMAT_I1, 0x808080, x, y, tile);
            assert_true(mean_of(tile, 0) == 127.5);
        }
}

static void black_and_white_have_no_dots(void **state)
{
    (void)state;
    for (int f = 0; f < TP_FORMAT_COUNT; f++)
        for (uint32_t white = 0; white <= 0xffffff; white += 0xffffff) {
            uint32_t tile[64];
            store_tile((tp_format)f, white, 0, 0, tile);
            for (int i = 0; i < 64; i++)
                assert_int_equal(tile[i], white);
        }
}

/* Rank by Bayer's rule: the pixel of a quarter continues as 4 rank + 0, 2, 3 or 1. */
static unsigned bayer_rank(unsigned x, unsigned y)
{
    static const unsigned quarter[2][2] = { { 0, 2 }, { 3, 1 } };
    return 16 * quarter[y & 1][x & 1] + 4 * quarter[y >> 1 & 1][x >> 1 & 1]
         + quarter[y >> 2][x >> 2];
}

/* As grey rises, the dot of each rank in turn becomes white. */
static void dots_appear_in_the_order_of_bayer(void **state)
{
    (void)state;
    for (unsigned dots = 1; dots <= 64; dots++) {
        const uint32_t grey = dots * 255 / 64;
        uint32_t tile[64];
        store_tile(TP_FORMAT_I1, grey * 0x010101, 0, 0, tile);
        for (unsigned i = 0; i < 64; i++)
            assert_int_equal(tile[i] != 0, bayer_rank(i % 8, i / 8) < dots);
    }
}

/* Asserts: pixels [first, end) of `row` equal those of `run`; all other pixels and the
 * bytes behind the row equal those of `rest`. */
static void check_run(tp_format format, const uint32_t row[WIDTH],
                      const uint32_t run[WIDTH], const uint32_t rest[WIDTH], int first,
                      int end)
{
    for (int x = 0; x < WIDTH; x++) {
        const uint32_t *const from = x >= first && x < end ? run : rest;
        if (tp_pixel_read(format, row, x) != tp_pixel_read(format, from, x))
            fail_msg("%s: a run %d..%d spoils pixel %d", tp_format_name(format), first,
                     end, x);
    }
    const size_t used = tp_format_row_bytes(format, WIDTH);
    assert_memory_equal((const uint8_t *)row + used, (const uint8_t *)rest + used,
                        WIDTH * sizeof *row - used);
}

/* Runs of every position and length into a row of random bytes, compared with one long
 * run. */
static void runs_leave_no_seam_and_touch_no_other_pixel(void **state)
{
    (void)state;
    uint64_t random = seed;
    uint32_t colours[WIDTH], before[WIDTH];
    for (int i = 0; i < WIDTH; i++) {
        colours[i] = (uint32_t)random_next(&random) & 0xffffff;
        before[i] = (uint32_t)random_next(&random) & 0xffffff;
    }
    for (int f = 0; f < TP_FORMAT_COUNT; f++) {
        uint32_t whole[WIDTH] = { 0 };
        tp_program_all.store[f](whole, 0, 100, 33, colours, WIDTH);
        for (int first = 0; first < WIDTH; first++)
            for (int end = first; end <= WIDTH; end++) {
                uint32_t row[WIDTH];
                memcpy(row, before, sizeof row);
                tp_program_all.store[f](row, first, 100 + first, 33, colours + first,
                                        end - first);
                check_run((tp_format)f, row, whole, before, first, end);
            }
    }
}

/* A tile's row begins at its own pixel 0, for any x in the picture. */
static void a_strip_has_the_dither_of_the_picture(void **state)
{
    (void)state;
    uint32_t colours[64];
    for (int i = 0; i < 64; i++)
        colours[i] = 0x5a8ac3;
    for (int f = 0; f < TP_FORMAT_COUNT; f++)
        for (int x = 0; x < 16; x++) {
            uint32_t picture[64] = { 0 }, strip[64] = { 0 };
            tp_program_all.store[f](picture, 0, 0, 5, colours, 64);
            tp_program_all.store[f](strip, 0, x, 5, colours, 32);
            for (int i = 0; i < 32; i++)
                assert_int_equal(tp_pixel_read((tp_format)f, strip, i),
                                 tp_pixel_read((tp_format)f, picture, x + i));
        }
}

/* A single table look-up gives the tone and its level. */
static void a_toned_pixel_is_that_of_the_toned_colour(void **state)
{
    (void)state;
    tp_rgb565_tone_map tone_map;
    uint8_t tone[256];
    for (uint32_t i = 0; i < 256; i++) {
        tone[i] = (uint8_t)random_next(&seed);
        tp_rgb565_tone_map_set(&tone_map, i, tone[i]);
    }
    for (int count = 0; count < 40; count++) {
        uint32_t colours[40], exposed[40];
        uint16_t got[40] = { 0 }, wanted[40] = { 0 };
        for (int i = 0; i < 40; i++) {
            const uint32_t c = colours[i] = (uint32_t)(count * 40 + i) * 2654435761u >> 8;
            exposed[i] = (uint32_t)tone[c >> 16] << 16 | (uint32_t)tone[c >> 8 & 255] << 8
                       | tone[c & 255];
        }
        tp_store_rgb565_tone_mapped(&tone_map, got, colours, count);
        tp_store_rgb565(wanted, 0, 0, 0, exposed, count);
        assert_memory_equal(got, wanted, sizeof got);
        uint8_t bytes[81] = { 0 }, wanted_bytes[81] = { 0 };
        tp_store_rgb565be_tone_mapped(&tone_map, bytes + count % 2, colours, count);
        tp_program_all.store[TP_FORMAT_RGB565BE](wanted_bytes + count % 2, 0, 0, 0, exposed,
                                                 count);
        assert_memory_equal(bytes, wanted_bytes, sizeof bytes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rgb565_takes_the_nearest_levels),
        cmocka_unit_test(pairs_of_pixels_are_two_pixels),
        cmocka_unit_test(a_toned_pixel_is_that_of_the_toned_colour),
        cmocka_unit_test(formats_without_dither_read_back_what_they_can_hold),
        cmocka_unit_test(p8_keeps_the_mean_of_flat_colours),
        cmocka_unit_test(l8_keeps_the_mean_of_flat_colours),
        cmocka_unit_test(i1_is_white_in_proportion),
        cmocka_unit_test(the_mean_is_kept_wherever_the_tile_lies),
        cmocka_unit_test(black_and_white_have_no_dots),
        cmocka_unit_test(dots_appear_in_the_order_of_bayer),
        cmocka_unit_test(runs_leave_no_seam_and_touch_no_other_pixel),
        cmocka_unit_test(a_strip_has_the_dither_of_the_picture),
    };
    seed = random_seed();
    return cmocka_run_group_tests_name("pixel store", tests, NULL, NULL);
}
