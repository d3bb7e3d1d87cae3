/* SPDX-License-Identifier: MIT */
/* The comparison with golden frames fails whenever it must: if a frame, a list or a
 * reference picture is missing, changed or exchanged. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "tests/lib/golden.h"

#define FOLDER "build/golden/harness"
#define WRECK  "build/golden/harness-wreck"

enum { WIDTH = 32, HEIGHT = 16 };

static uint32_t pixels[2][WIDTH * HEIGHT];

/* Returns the correct frame 0 or 1 of a small picture. */
static picture frame(int i)
{
    return (picture){ TP_FORMAT_XRGB8888, WIDTH, HEIGHT, WIDTH * sizeof(uint32_t),
                      (uint8_t *)pixels[i] };
}

static bool right(int i)
{
    picture p = frame(i);
    return golden_compare(FOLDER, WRECK, &p, (uint32_t)i, "frame");
}

static void forget_wreck(void)
{
    remove(WRECK "/frame-expected.png");
    remove(WRECK "/frame-actual.png");
    remove(WRECK "/frame-difference.png");
}

static bool left(const char *path)
{
    struct stat s;
    return stat(path, &s) == 0;
}

/* Before each test: makes two different frames and correct references. */
static int set_up(void **state)
{
    (void)state;
    mkdir("build/golden", 0777);
    mkdir(FOLDER, 0777);
    mkdir(WRECK, 0777);
    forget_wreck();
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        pixels[0][i] = i * 2654435761u >> 8;
        pixels[1][i] = (i + 1) * 2246822519u >> 8;
    }
    for (int i = 0; i < 2; i++) {
        picture p = frame(i);
        golden_write(FOLDER, &p, (uint32_t)i, i == 0);
    }
    return 0;
}

static void equal_frames_pass_and_leave_nothing(void **state)
{
    (void)state;
    assert_true(right(0));
    assert_true(right(1));
    assert_false(left(WRECK "/frame-actual.png"));
}

static void a_flipped_pixel_fails_and_leaves_three_pictures(void **state)
{
    (void)state;
    pixels[0][77] ^= 1;
    assert_false(right(0));
    assert_true(right(1));
    assert_true(left(WRECK "/frame-expected.png"));
    assert_true(left(WRECK "/frame-actual.png"));
    assert_true(left(WRECK "/frame-difference.png"));
}

static void the_difference_shows_the_flipped_pixel_alone(void **state)
{
    (void)state;
    uint32_t w, h;
    pixels[0][77] ^= 1;
    assert_false(right(0));
    uint32_t *shown = picture_read_png(WRECK "/frame-difference.png", "test", &w, &h);
    assert_non_null(shown);
    assert_int_equal(w * h, WIDTH * HEIGHT);
    for (uint32_t i = 0; i < w * h; i++)
        assert_int_equal((shown[i] & 0xffffff) != 0, i == 77);
    free(shown);
}

static void exchanged_frames_fail(void **state)
{
    (void)state;
    uint32_t first[WIDTH * HEIGHT];
    memcpy(first, pixels[0], sizeof first);
    memcpy(pixels[0], pixels[1], sizeof first);
    memcpy(pixels[1], first, sizeof first);
    assert_false(right(0));
    assert_false(right(1));
}

static void exchanged_reference_pictures_fail(void **state)
{
    (void)state;
    rename(FOLDER "/xrgb8888-0000.png", FOLDER "/other.png");
    rename(FOLDER "/xrgb8888-0001.png", FOLDER "/xrgb8888-0000.png");
    rename(FOLDER "/other.png", FOLDER "/xrgb8888-0001.png");
    assert_false(right(0));
    assert_false(right(1));
}

static void a_missing_list_fails(void **state)
{
    (void)state;
    assert_int_equal(remove(FOLDER "/xrgb8888.crc"), 0);
    assert_false(right(0));
    assert_true(left(WRECK "/frame-actual.png"));
}

static void a_missing_reference_picture_fails(void **state)
{
    (void)state;
    assert_int_equal(remove(FOLDER "/xrgb8888-0000.png"), 0);
    assert_false(right(0));
    assert_true(right(1));
}

static void a_frame_beyond_the_list_fails(void **state)
{
    (void)state;
    picture p = frame(0);
    assert_false(golden_compare(FOLDER, WRECK, &p, 2, "frame"));
}

static void a_changed_list_fails(void **state)
{
    (void)state;
    FILE *list = fopen(FOLDER "/xrgb8888.crc", "w");
    assert_non_null(list);
    fputs("frame 0000 crc32 00000000\nframe 0001 crc32 00000000\n", list);
    fclose(list);
    assert_false(right(0));
    assert_false(right(1));
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, set_up)
    const struct CMUnitTest tests[] = {
        TEST(equal_frames_pass_and_leave_nothing),
        TEST(a_flipped_pixel_fails_and_leaves_three_pictures),
        TEST(the_difference_shows_the_flipped_pixel_alone),
        TEST(exchanged_frames_fail),
        TEST(exchanged_reference_pictures_fail),
        TEST(a_missing_list_fails),
        TEST(a_missing_reference_picture_fails),
        TEST(a_frame_beyond_the_list_fails),
        TEST(a_changed_list_fails),
    };
    return cmocka_run_group_tests_name("golden harness", tests, NULL, NULL);
}
