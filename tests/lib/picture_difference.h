/* SPDX-License-Identifier: MIT */
/* Differences of two pictures of words 0x00RRGGBB, in levels of 255. */
#ifndef TP_TESTS_LIB_PICTURE_DIFFERENCE_H
#define TP_TESTS_LIB_PICTURE_DIFFERENCE_H
#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* Returns the sum of the squared differences of all channels. */
static inline uint64_t picture_square_sum(const uint32_t *a, const uint32_t *b,
                                          size_t pixels)
{
    uint64_t sum = 0;

    for (size_t i = 0; i < pixels; i++)
        for (int k = 0; k < 24; k += 8) {
            const int32_t d = (int32_t)(a[i] >> k & 255) - (int32_t)(b[i] >> k & 255);
            sum += (uint64_t)(d * d);
        }
    return sum;
}

/* Returns the root mean square of the differences of all channels. */
static inline double picture_rms(const uint32_t *a, const uint32_t *b, size_t pixels)
{
    return sqrt((double)picture_square_sum(a, b, pixels) / 3 / (double)pixels);
}

#endif
