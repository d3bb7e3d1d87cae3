/* SPDX-License-Identifier: MIT */
/* Pictures of every format to PNG and back, films, and names of the host: parts of the
 * program best tested as functions. */
#define _POSIX_C_SOURCE 200809L
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>
#include <png.h>
#include "../../ports/app/files/film.h"
#include "../../ports/app/files/did_you_mean.h"
#include "../../ports/app/files/path.h"
#include "../../ports/app/files/picture.h"
#include "../../ports/app/files/timing.h"
#include "pixel/pixel.h"
#include "tests/lib/random.h"

#define WIDTH  53       /* odd; i1 rows end inside a byte */
#define HEIGHT 21

static uint32_t seed;

/* Random pixels, with the last bits of the row's padding used too. */
static picture random_picture(tp_format format)
{
    picture p = { .format = format, .width = WIDTH, .height = HEIGHT };
    p.row_bytes = tp_format_row_bytes(format, WIDTH);
    p.rows = malloc(p.row_bytes * HEIGHT);
    assert_non_null(p.rows);
    for (size_t i = 0; i < p.row_bytes * HEIGHT; i++)
        p.rows[i] = (uint8_t)random_xorshift(&seed);
    return p;
}

/* A unique name; the test removes the file. */
static void temporary_name(char name[64], const char *suffix)
{
    snprintf(name, 64, "test-picture-%08x%s", (unsigned)random_xorshift(&seed), suffix);
}

static void png_keeps_every_colour_of_every_format(void **state)
{
    (void)state;
    for (int format = 0; format < TP_FORMAT_COUNT; format++) {
        char name[64];
        uint32_t w = 0, h = 0, row[WIDTH];
        picture p = random_picture((tp_format)format);
        temporary_name(name, ".png");
        assert_int_equal(picture_write_png(&p, name), 0);
        uint32_t *read = picture_read_png(name, "the test", &w, &h);
        remove(name);
        assert_non_null(read);
        assert_int_equal(w, WIDTH);
        assert_int_equal(h, HEIGHT);
        for (uint32_t y = 0; y < HEIGHT; y++) {
            picture_expand_row(&p, y, row);
            for (uint32_t x = 0; x < WIDTH; x++)
                assert_int_equal(read[y * WIDTH + x], (row[x] & 0xffffff) | 0xff000000u);
        }
        free(read);
        free(p.rows);
    }
}

/* A PNG cut at any byte or with any byte changed: refused or read without a crash, and a
 * read picture has the size given in the file. */
static void png_of_any_bytes_is_safe(void **state)
{
    (void)state;
    char name[64];
    uint8_t bytes[8192];
    picture p = random_picture(TP_FORMAT_I1);
    temporary_name(name, ".png");
    assert_int_equal(picture_write_png(&p, name), 0);
    free(p.rows);
    FILE *file = fopen(name, "rb");
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    assert_in_range(size, 60, sizeof bytes - 1);
    fflush(stderr);
    const int messages = dup(STDERR_FILENO);    /* thousands of messages: hidden */
    assert_non_null(freopen("/dev/null", "w", stderr));
    unsigned refused = 0;
    for (size_t i = 0; i < 2 * size; i++) {
        uint32_t w, h;
        const bool cut = i < size;
        const uint8_t kept = bytes[i % size];
        bytes[i % size] ^= cut ? 0 : (uint8_t)(1 + random_xorshift(&seed) % 255);
        file = fopen(name, "wb");
        fwrite(bytes, 1, cut ? i : size, file);
        fclose(file);
        bytes[i % size] = kept;
        uint32_t *read = picture_read_png(name, "the test", &w, &h);
        if (read)
            assert_true(w >= 1 && w <= 4096 && h >= 1 && h <= 4096);
        refused += !read;
        free(read);
    }
    remove(name);
    fflush(stderr);
    dup2(messages, STDERR_FILENO);
    close(messages);
    assert_true(refused >= size);       /* every cut file */
}

/* White is 235, black 16, greys have no tint; red, green, blue are BT.601's. */
/* Writes a picture of w x 3 samples of `bits`, with one channel or three equal channels. */
static void write_greys(const char *name, const uint16_t *grey, uint32_t w, int bits,
                        bool colour)
{
    FILE *file = fopen(name, "wb");
    assert_non_null(file);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, w, 3, bits, colour ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY,
                 PNG_INTERLACE_ADAM7, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    uint8_t rows[3][6 * WIDTH], *row[3] = { rows[0], rows[1], rows[2] };
    for (uint32_t i = 0; i < 3 * w; i++) {
        uint8_t *to = row[i / w] + i % w * (colour ? 3 : 1) * (unsigned)bits / 8;
        for (int k = 0; k < (colour ? 3 : 1); k++) {
            *to++ = (uint8_t)(grey[i] >> 8);
            if (bits == 16)
                *to++ = (uint8_t)grey[i];
        }
    }
    png_write_image(png, row);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    assert_int_equal(fclose(file), 0);
}

/* 16 bits are read unchanged, 8 bits times 257; three equal channels give their grey
 * within a few of 65536, by the weights of luminance. */
static void greys_of_every_kind_are_read(void **state)
{
    (void)state;
    char name[64];
    temporary_name(name, ".png");
    for (int kind = 0; kind < 4; kind++) {
        const int bits = kind & 1 ? 16 : 8;
        uint16_t grey[3 * WIDTH];
        uint32_t w = 0, h = 0;
        for (int i = 0; i < 3 * WIDTH; i++) {
            const uint32_t word = random_xorshift(&seed);
            grey[i] = (uint16_t)(bits == 16 ? word : (word & 255) * 257);
        }
        write_greys(name, grey, WIDTH, bits, kind & 2);
        uint16_t *read = picture_read_grey(name, "a test", &w, &h);
        assert_non_null(read);
        assert_true(w == WIDTH && h == 3);
        for (int i = 0; i < 3 * WIDTH; i++)
            assert_true(abs(read[i] - grey[i]) <= (kind & 2 ? 4 : 0));
        free(read);
    }
    remove(name);
}

static void film_has_the_colours_of_bt601(void **state)
{
    (void)state;
    static const struct { uint32_t rgb; uint8_t y, u, v; } known[] = {
        { 0xffffff, 235, 128, 128 }, { 0x000000, 16, 128, 128 },
        { 0x808080, 126, 128, 128 }, { 0xff0000, 81, 90, 240 },
        { 0x00ff00, 145, 54, 34 },   { 0x0000ff, 41, 240, 110 },
    };
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        char name[64], line[128];
        uint32_t pixels[3 * 3];
        uint8_t frame[6 + 9 + 4 + 4 + 1];
        film f;
        for (int i = 0; i < 9; i++)
            pixels[i] = known[k].rgb;
        const picture p = { TP_FORMAT_XRGB8888, 3, 3, 12, (uint8_t *)pixels };
        temporary_name(name, ".y4m");
        assert_int_equal(film_open(&f, name, 3, 3, 1), 0);
        assert_int_equal(film_add(&f, &p), 0);
        assert_int_equal(film_close(&f), 0);
        FILE *file = fopen(name, "rb");
        remove(name);
        assert_non_null(file);
        assert_non_null(fgets(line, sizeof line, file));
        assert_int_equal(fread(frame, 1, sizeof frame, file), sizeof frame - 1);
        fclose(file);
        assert_memory_equal(frame, "FRAME\n", 6);
        for (int i = 0; i < 9; i++)
            assert_int_equal(frame[6 + i], known[k].y);
        for (int i = 0; i < 4; i++) {
            assert_int_equal(frame[15 + i], known[k].u);
            assert_int_equal(frame[19 + i], known[k].v);
        }
    }
}

static void crc_does_not_see_the_unused_bits_of_a_row(void **state)
{
    (void)state;
    picture p = random_picture(TP_FORMAT_I1);
    const uint32_t before = picture_crc(&p);
    p.rows[p.row_bytes - 1] ^= 1;               /* column 55 of 53 */
    assert_int_equal(picture_crc(&p), before);
    p.rows[p.row_bytes - 1] ^= 8;               /* column 52 */
    assert_int_not_equal(picture_crc(&p), before);
    free(p.rows);
}

static void nearest_name_is_the_one_that_was_meant(void **state)
{
    (void)state;
    did_you_mean n = did_you_mean_make("wave0.steepnes");
    did_you_mean_offer(&n, "wave0.amplitude");
    assert_null(n.name);
    did_you_mean_offer(&n, "wave1.steepness");
    did_you_mean_offer(&n, "wave0.steepness");
    did_you_mean_offer(&n, "wave2.steepness");
    assert_string_equal(n.name, "wave0.steepness");
    assert_int_equal(n.distance, 1);
}

static void names_are_relative_to_the_file_that_holds_them(void **state)
{
    (void)state;
    static const char *const known[][3] = {
        { "scenes/a.ini", "../boats/b.obj", "scenes/../boats/b.obj" },
        { "a.ini", "b.obj", "b.obj" },
        { "scenes/a.ini", "/boats/b.obj", "/boats/b.obj" },
        { "/a.ini", "b.obj", "/b.obj" },
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        char *path = path_beside(known[i][0], known[i][1]);
        assert_string_equal(path, known[i][2]);
        free(path);
    }
}

static void median_is_the_middle_of_all_times(void **state)
{
    (void)state;
    timings t = { 0 };
    assert_int_equal(timings_median(&t), 0);
    for (uint32_t i = 0; i < 999; i++)
        timings_add(&t, (i * 7 % 999) * 10);
    assert_int_equal(timings_median(&t), 4990);
    timings_add(&t, 1000000);
    assert_int_equal(timings_median(&t), 4995);
    timings_free(&t);
}

int main(void)
{
    const char *given = getenv("TP_SEED");
    seed = given ? (uint32_t)strtoul(given, NULL, 0) : 20260101u;
    seed += !seed;                              /* 0 would stay 0 */
    printf("TP_SEED=%u\n", (unsigned)seed);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(png_keeps_every_colour_of_every_format),
        cmocka_unit_test(greys_of_every_kind_are_read),
        cmocka_unit_test(film_has_the_colours_of_bt601),
        cmocka_unit_test(crc_does_not_see_the_unused_bits_of_a_row),
        cmocka_unit_test(nearest_name_is_the_one_that_was_meant),
        cmocka_unit_test(names_are_relative_to_the_file_that_holds_them),
        cmocka_unit_test(median_is_the_middle_of_all_times),
        cmocka_unit_test(png_of_any_bytes_is_safe),
    };
    return cmocka_run_group_tests_name("picture", tests, NULL, NULL);
}
