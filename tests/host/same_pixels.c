/* SPDX-License-Identifier: MIT */
/* same_pixels A.png B.png: exits with 0 if both have the same pixels. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/picture.h"

int main(int argc, char **argv)
{
    uint32_t w[2], h[2], *pixels[2];

    if (argc != 3)
        return 2;
    for (int i = 0; i < 2; i++) {
        pixels[i] = picture_read_png(argv[i + 1], "the command line", &w[i], &h[i]);
        if (!pixels[i])
            return 3;
    }
    int same = w[0] == w[1] && h[0] == h[1]
            && memcmp(pixels[0], pixels[1], sizeof(uint32_t) * w[0] * h[0]) == 0;
    if (!same)
        printf("%s and %s differ\n", argv[1], argv[2]);
    free(pixels[0]);
    free(pixels[1]);
    return !same;
}
