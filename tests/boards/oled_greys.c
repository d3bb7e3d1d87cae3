/* SPDX-License-Identifier: MIT */
/* Converts a picture to the display of an OLED with 16 greys, drawn like its emulator does:
 * the upper four bits of each pixel, spread over the whole range, in squares of 4 x 4.
 *
 *     oled_greys PICTURE.png >SCREEN.ppm */
#include <stdio.h>
#include <stdlib.h>
#include "app/files/picture.h"

enum { SIDE = 4, STEP = 255 / 15 };

int main(int argc, char **argv)
{
    uint32_t w, h;

    if (argc != 2) {
        fprintf(stderr, "usage: oled_greys PICTURE.png\n");
        return 2;
    }
    uint32_t *pixels = picture_read_png(argv[1], "oled_greys", &w, &h);
    if (!pixels)
        return 3;
    printf("P6\n%u %u\n255\n", w * SIDE, h * SIDE);
    for (uint32_t y = 0; y < h * SIDE; y++)
        for (uint32_t x = 0; x < w * SIDE; x++) {
            const uint32_t pixel = pixels[y / SIDE * w + x / SIDE];
            const int grey = (int)((pixel & 0xff) >> 4) * STEP;
            putchar(grey);
            putchar(grey);
            putchar(grey);
        }
    free(pixels);
    return ferror(stdout) || fflush(stdout) ? 3 : 0;
}
