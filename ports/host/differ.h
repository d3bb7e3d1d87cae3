/* SPDX-License-Identifier: MIT */
/* How two pictures of one size differ: a number, and two ways to see it.  Both are
 * 0x00RRGGBB row by row; what is shown is xrgb8888 of the same size. */
#ifndef HOST_DIFFER_H
#define HOST_DIFFER_H
#include "picture.h"

/* Peak signal to noise over all channels, dB: 10 log10(255^2 / mean square).  Up to 99;
 * 100: the same bits. */
double differ_psnr(const uint32_t *a, const uint32_t *b, size_t pixels);

/* Left half of a, right half of b; the pixels at either side of the middle are a line. */
void   differ_split(picture *to, const uint32_t *a, const uint32_t *b);

/* 8 times a less b, about 128, in each channel. */
void   differ_show(picture *to, const uint32_t *a, const uint32_t *b);
#endif
