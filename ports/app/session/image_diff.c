/* SPDX-License-Identifier: MIT */
/* Differences of pictures in integers up to the final logarithm.  The sum of squares of the
 * largest picture is below 2^42: every machine computes the same number. */
#include "image_diff.h"
#include <math.h>
#include <string.h>

/* Returns the sum of the squares of three channels, each square below 2^16. */
static inline uint32_t squared_difference(uint32_t a, uint32_t b)
{
    const int red = (int)(a >> 16 & 255) - (int)(b >> 16 & 255);
    const int green = (int)(a >> 8 & 255) - (int)(b >> 8 & 255);
    const int blue = (int)(a & 255) - (int)(b & 255);

    return (uint32_t)(red * red + green * green + blue * blue);
}

double image_diff_psnr(const uint32_t *a, const uint32_t *b, size_t pixels)
{
    uint64_t sum = 0;

    for (size_t i = 0; i < pixels; i++)
        sum += squared_difference(a[i], b[i]);
    if (sum == 0)
        return 100;
    return fmin(99, 10 * log10(255.0 * 255 * 3 * (double)pixels / (double)sum));
}

static uint32_t *pixel_row(picture *p, uint32_t y)
{
    return (uint32_t *)(void *)(p->rows + y * p->row_bytes);
}

/* Draws the line black and white, visible on every picture. */
void image_diff_split(picture *to, const uint32_t *a, const uint32_t *b)
{
    const uint32_t middle = to->width / 2;

    for (uint32_t y = 0; y < to->height; y++) {
        const size_t at = (size_t)y * to->width;
        uint32_t *row = pixel_row(to, y);
        memcpy(row, a + at, middle * sizeof *row);
        memcpy(row + middle, b + at + middle, (to->width - middle) * sizeof *row);
        row[middle - 1] = 0;
        row[middle] = 0xffffff;
    }
}

static inline uint32_t amplify_difference(uint32_t a, uint32_t b)
{
    const int level = 128 + 8 * ((int)(a & 255) - (int)(b & 255));
    return (uint32_t)(level < 0 ? 0 : level > 255 ? 255 : level);
}

void image_diff_draw(picture *to, const uint32_t *a, const uint32_t *b)
{
    for (uint32_t y = 0; y < to->height; y++, a += to->width, b += to->width) {
        uint32_t *row = pixel_row(to, y);
        for (uint32_t x = 0; x < to->width; x++)
            row[x] = amplify_difference(a[x] >> 16, b[x] >> 16) << 16
                     | amplify_difference(a[x] >> 8, b[x] >> 8) << 8
                     | amplify_difference(a[x], b[x]);
    }
}
