/* SPDX-License-Identifier: MIT */
/* Writes a screen's RGB565 pixels in the form summed by `tidepool render --hash`:
 * 0x00RRGGBB, low byte first, each channel's high bits repeated in its low bits. */
#ifndef STAND_IN_SHOWN_H
#define STAND_IN_SHOWN_H
#include <stdint.h>
#include <stdio.h>

static inline void shown_write(uint16_t pixel)
{
    const int r = pixel >> 11, g = pixel >> 5 & 63, b = pixel & 31;

    putchar(b << 3 | b >> 2);
    putchar(g << 2 | g >> 4);
    putchar(r << 3 | r >> 2);
    putchar(0);
}
#endif
