/* SPDX-License-Identifier: MIT */
/* Pictures that scenes read as numbers; see the header. */
#include "maps.h"

/* Round hill: 65536 at the middle, 0 from `radius` pixels on. */
static int hill(int dx, int dy, int radius)
{
    int64_t square = (int64_t)dx * dx + (int64_t)dy * dy, most = (int64_t)radius * radius;
    int64_t rest = square < most ? (most - square) * 256 / most : 0;
    return (int)(rest * rest);
}

/* The floor rises from the south-west to a beach in the north-east, with a bank before the
 * beach; noise of a few pixels makes the contours irregular. */
void paint_shoal(canvas *to)
{
    for (int i = 0; i < to->w * to->h; i++) {
        int x = i % to->w, y = i / to->w;
        int along = (x + 2 * (to->h - 1 - y)) * 256 / 3;    /* 0 .. 256 x 255 */
        int rough = (fractal(x, y, to->w, to->h, 4, 4, 3, 91) - 32768) / 8;
        int bank = hill(x - 96, y - 120, 56) / 5;
        int height = along * 15 / 16 + rough + bank;
        int grey = clamp_int(height / 256, 0, 255);
        to->pixel[i] = rgb(grey, grey, grey);
    }
}

/* A breakwater across the middle, five pixels thick, with a gap of six. */
void paint_harbour(canvas *to)
{
    for (int i = 0; i < to->w * to->h; i++) {
        int x = i % to->w, y = i / to->w;
        int mole = y >= to->h * 2 / 5 && y < to->h * 2 / 5 + 5;
        int gap = x >= to->w / 2 - 3 && x < to->w / 2 + 3;
        int grey = mole && !gap ? 0 : 255;
        to->pixel[i] = rgb(grey, grey, grey);
    }
}
