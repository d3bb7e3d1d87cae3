/* SPDX-License-Identifier: MIT */
/* Measures of the difference of two pictures of the same size, 0x00RRGGBB row by row. */
#ifndef TP_CHARTS_PICTURE_H
#define TP_CHARTS_PICTURE_H
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { SSIM_SIDE = 11 };        /* side of the window, px */

/* Peak signal-to-noise ratio over all channels, dB: 10 log10(255^2 / mean square error);
 * infinite for equal pictures. */
static inline double picture_psnr(const uint32_t *a, const uint32_t *b, size_t pixels)
{
    double sum = 0;

    for (size_t i = 0; i < pixels; i++)
        for (int shift = 0; shift < 24; shift += 8) {
            const int off = (int)(a[i] >> shift & 255) - (int)(b[i] >> shift & 255);
            sum += off * off;
        }
    return 10 * log10(255.0 * 255 * 3 * (double)pixels / sum);
}

/* Luma by ITU-R BT.601, 0..255. */
static inline double picture_luma(uint32_t p)
{
    return 0.299 * (p >> 16 & 255) + 0.587 * (p >> 8 & 255) + 0.114 * (p & 255);
}

/* Weighted sums over a window of the pixels a and b, their squares and their product. */
typedef struct {
    double a, b, aa, bb, ab;
} ssim_sums;

static inline ssim_sums ssim_look(const uint32_t *a, const uint32_t *b, uint32_t width,
                                  const double weight[SSIM_SIDE])
{
    ssim_sums s = { 0, 0, 0, 0, 0 };

    for (uint32_t j = 0; j < SSIM_SIDE; j++)
        for (uint32_t i = 0; i < SSIM_SIDE; i++) {
            const double w = weight[i] * weight[j];
            const double p = picture_luma(a[j * width + i]);
            const double q = picture_luma(b[j * width + i]);
            s.a += w * p;
            s.b += w * q;
            s.aa += w * p * p;
            s.bb += w * q * q;
            s.ab += w * p * q;
        }
    return s;
}

/* Structural similarity of luma (Wang, Bovik, Sheikh and Simoncelli 2004): a Gaussian
 * window of 11x11, sigma 1.5, K1 = 0.01, K2 = 0.03, the mean over all windows inside the
 * picture; 1 for equal pictures. */
static inline double picture_ssim(const uint32_t *a, const uint32_t *b, uint32_t width,
                                  uint32_t height)
{
    const double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
    double weight[SSIM_SIDE], whole = 0, sum = 0;
    size_t windows = 0;

    for (int i = 0; i < SSIM_SIDE; i++) {
        const double off = i - SSIM_SIDE / 2;
        weight[i] = exp(-off * off / (2 * 1.5 * 1.5));
        whole += weight[i];
    }
    for (int i = 0; i < SSIM_SIDE; i++)
        weight[i] /= whole;
    for (uint32_t y = 0; y + SSIM_SIDE <= height; y++)
        for (uint32_t x = 0; x + SSIM_SIDE <= width; x++) {
            const size_t at = (size_t)y * width + x;
            const ssim_sums s = ssim_look(a + at, b + at, width, weight);
            const double aa = s.aa - s.a * s.a, bb = s.bb - s.b * s.b;
            sum += (2 * s.a * s.b + c1) * (2 * (s.ab - s.a * s.b) + c2)
                 / ((s.a * s.a + s.b * s.b + c1) * (aa + bb + c2));
            windows++;
        }
    return sum / (double)windows;
}

/* -- border of sky and water --------------------------------------------------------- */

/* Kind of surface of a pixel. */
typedef enum { SHOWS_SKY, SHOWS_WATER, SHOWS_OTHER } picture_shows;

/* Row where a column's sky ends at water; -1: the sky ends at another surface, or never. */
static inline int32_t picture_border(const uint8_t *shows, uint32_t width,
                                     uint32_t height, uint32_t x)
{
    uint32_t y = 0;

    while (y < height && shows[(size_t)y * width + x] == SHOWS_SKY)
        y++;
    return y > 0 && y < height && shows[(size_t)y * width + x] == SHOWS_WATER
         ? (int32_t)y : -1;
}

/* Largest and mean shift of the border, in rows, over columns with a border in both
 * pictures; 0 if there are none. */
typedef struct {
    double most, mean;
} border_shift;

static inline border_shift picture_shift(const uint8_t *a, const uint8_t *b,
                                         uint32_t width, uint32_t height)
{
    border_shift shift = { 0, 0 };
    uint32_t columns = 0;

    for (uint32_t x = 0; x < width; x++) {
        const int32_t p = picture_border(a, width, height, x);
        const int32_t q = picture_border(b, width, height, x);
        if (p < 0 || q < 0)
            continue;
        shift.most = fmax(shift.most, abs(p - q));
        shift.mean += abs(p - q);
        columns++;
    }
    shift.mean /= columns ? columns : 1;
    return shift;
}
#endif
