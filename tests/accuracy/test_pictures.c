/* SPDX-License-Identifier: MIT */
/* Checks the measures of picture difference in tests/charts/picture.h against closed
 * forms. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/charts/picture.h"

enum { WIDTH = 24, HEIGHT = 20, COUNT = WIDTH * HEIGHT };

#define NEAR(a, b) assert_true(fabs((a) - (b)) < 1e-9)

static uint32_t grey(uint32_t of)
{
    return of << 16 | of << 8 | of;
}

/* Fills a picture with a fixed pattern of greys up to 200. */
static void fill(uint32_t *p)
{
    for (uint32_t i = 0; i < COUNT; i++)
        p[i] = grey(i * 2654435761u >> 7 & 127) + grey(i % 73);
}

static void the_same_picture_is_like_itself(void **state)
{
    uint32_t a[COUNT];

    (void)state;
    fill(a);
    NEAR(picture_ssim(a, a, WIDTH, HEIGHT), 1);
    assert_true(isinf(picture_psnr(a, a, COUNT)));
}

static void psnr_of_a_shift_is_that_of_its_levels(void **state)
{
    uint32_t a[COUNT], b[COUNT];

    (void)state;
    fill(a);
    for (int i = 0; i < COUNT; i++)
        b[i] = a[i] + grey(5);
    NEAR(picture_psnr(a, b, COUNT), 20 * log10(255 / 5.0));
    for (int i = 0; i < COUNT; i++)
        b[i] = a[i] + 0x000300;                 /* one channel of three differs */
    NEAR(picture_psnr(a, b, COUNT), 10 * log10(255 * 255 * 3 / 9.0));
}

/* For pictures of one grey only the means count: SSIM = (2 a b + C1) / (a^2 + b^2 + C1). */
static void ssim_of_even_pictures_is_that_of_their_means(void **state)
{
    const double c1 = 2.55 * 2.55;
    uint32_t a[COUNT], b[COUNT];

    (void)state;
    for (int i = 0; i < COUNT; i++) {
        a[i] = grey(100);
        b[i] = grey(120);
    }
    NEAR(picture_ssim(a, b, WIDTH, HEIGHT),
         (2 * 100.0 * 120 + c1) / (100.0 * 100 + 120.0 * 120 + c1));
}

/* A picture with k = half the contrast about an equal mean: SSIM = (2 k s + C2) / ((1 +
 * k^2) s + C2). s is the variance of the weighted window; on a chequerboard s is equal for
 * all windows, only the sign of the small part of the mean differs. */
static void ssim_of_less_contrast_follows_its_variances(void **state)
{
    const double c1 = 2.55 * 2.55, c2 = 7.65 * 7.65;
    double alternate = 0, whole = 0;
    uint32_t a[COUNT], b[COUNT];

    (void)state;
    for (int i = 0; i < COUNT; i++) {
        const int sign = (i / WIDTH + i % WIDTH) % 2 ? 1 : -1;
        a[i] = grey((uint32_t)(100 + 40 * sign));
        b[i] = grey((uint32_t)(100 + 20 * sign));
    }
    for (int i = -5; i <= 5; i++) {
        alternate += (i % 2 ? -1 : 1) * exp(-i * i / 4.5);
        whole += exp(-i * i / 4.5);
    }
    const double part = alternate * alternate / whole / whole;  /* mean of the signs */
    const double s = 1600 * (1 - part * part), k = 0.5;
    double want = 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        const double p = 100 + 40 * sign * part, q = 100 + 20 * sign * part;
        want += (2 * p * q + c1) / (p * p + q * q + c1) / 2;
    }
    want *= (2 * k * s + c2) / ((1 + k * k) * s + c2);
    NEAR(picture_ssim(a, b, WIDTH, HEIGHT), want);
}

static void borders_are_told_apart_by_rows(void **state)
{
    uint8_t a[COUNT], b[COUNT];

    (void)state;
    for (uint32_t i = 0; i < COUNT; i++) {
        const uint32_t x = i % WIDTH, y = i / WIDTH;
        a[i] = y < 8 ? SHOWS_SKY : SHOWS_WATER;
        b[i] = y < 8 + (x == 3 ? 4 : x == 5) ? SHOWS_SKY : SHOWS_WATER;
        if (x == 9)             /* a mast: no border of water in this column */
            b[i] = SHOWS_OTHER;
        if (x == 10)            /* a column without sky */
            a[i] = SHOWS_WATER;
    }
    const border_shift shift = picture_shift(a, b, WIDTH, HEIGHT);
    NEAR(shift.most, 4);
    NEAR(shift.mean, 5.0 / (WIDTH - 2));
    NEAR(picture_shift(a, a, WIDTH, HEIGHT).most, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_picture_is_like_itself),
        cmocka_unit_test(psnr_of_a_shift_is_that_of_its_levels),
        cmocka_unit_test(ssim_of_even_pictures_is_that_of_their_means),
        cmocka_unit_test(ssim_of_less_contrast_follows_its_variances),
        cmocka_unit_test(borders_are_told_apart_by_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
