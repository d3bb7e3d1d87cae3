/* SPDX-License-Identifier: MIT */
/* picture_rms A.png B.png [A.png B.png]...: prints, of the mean of all pairs, the rms of the
 * differences, of 255, and the mean PSNR in dB; 99 dB: equal pictures. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "app/files/picture.h"
#include "tests/lib/picture_difference.h"

int main(int argc, char **argv)
{
    const int pairs = (argc - 1) / 2;
    double squares = 0, db = 0;

    if (argc < 3 || argc % 2 == 0)
        return 2;
    for (int i = 0; i < pairs; i++) {
        uint32_t w[2], h[2], *pixels[2];
        for (int k = 0; k < 2; k++) {
            pixels[k] = picture_read_png(argv[2 * i + k + 1], "the command line", &w[k],
                                         &h[k]);
            if (!pixels[k])
                return 3;
        }
        if (w[0] != w[1] || h[0] != h[1])
            return 1;
        const double rms = picture_rms(pixels[0], pixels[1], (size_t)w[0] * h[0]);
        squares += rms * rms / pairs;
        db += (rms > 0 ? 20 * log10(255 / rms) : 99) / pairs;
        free(pixels[0]);
        free(pixels[1]);
    }
    printf("%.2f %.1f\n", sqrt(squares), db);
    return 0;
}
