/* SPDX-License-Identifier: MIT */
/* The difference of two pictures of the same size: as a number, and as two kinds of
 * picture.  Both inputs are 0x00RRGGBB, row by row; the result is xrgb8888 of the same
 * size. */
#ifndef TP_APP_SESSION_IMAGE_DIFF_H
#define TP_APP_SESSION_IMAGE_DIFF_H
#include "app/files/picture.h"

/* Returns the peak signal to noise ratio over all channels, dB: 10 log10(255^2 / mean
 * square).  At most 99; 100: the same bits. */
double image_diff_psnr(const uint32_t *a, const uint32_t *b, size_t pixels);

/* Shows the left half of a and the right half of b; the two pixels in the middle are a
 * line. */
void   image_diff_split(picture *to, const uint32_t *a, const uint32_t *b);

/* Shows 128 + 8 (a - b) in each channel, clamped to 0..255. */
void   image_diff_draw(picture *to, const uint32_t *a, const uint32_t *b);
#endif
