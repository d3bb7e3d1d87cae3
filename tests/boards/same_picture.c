/* SPDX-License-Identifier: MIT */
/* Compares a screen's picture with the expected picture.
 *
 *     same_picture A B [565 [centred]]
 *
 * A and B are PNG files, or PPM files with 8 bits a channel, the dump format of emulators.
 * Prints the number of different pixels and the first of them; exits with 1 if there is a
 * difference or the sizes differ. The digits are the numbers of significant (upper) bits of
 * red, green and blue: a screen with 16 bits a pixel appears with lower bits 0 in some
 * emulators, and with the upper bits repeated in others. A centred B lies in the middle of
 * A; all other pixels of A must be black. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/picture.h"

/* Reads a PPM as 0x00RRGGBB, one value a pixel; the caller frees the result. Returns NULL
 * if the file is no such PPM. */
static uint32_t *read_ppm(FILE *file, uint32_t *w, uint32_t *h)
{
    unsigned most = 0;

    if (fscanf(file, "P6 %u %u %u", w, h, &most) != 3 || most != 255 || getc(file) == EOF
        || *w - 1 > 4095 || *h - 1 > 4095)
        return NULL;
    size_t pixels = (size_t)*w * *h;
    uint32_t *to = malloc(pixels * sizeof *to);
    for (size_t i = 0; to && i < pixels; i++) {
        uint8_t rgb[3];
        if (fread(rgb, 1, 3, file) != 3) {
            free(to);
            return NULL;
        }
        to[i] = (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
    }
    return to;
}

static uint32_t *read_picture(const char *name, uint32_t *w, uint32_t *h)
{
    size_t length = strlen(name);

    if (length > 4 && strcmp(name + length - 4, ".png") == 0)
        return picture_read_png(name, "the command line", w, h);
    FILE *file = fopen(name, "rb");
    uint32_t *pixels = file ? read_ppm(file, w, h) : NULL;
    if (!pixels)
        fprintf(stderr, "%s: not there, or no PPM of 8 bits a channel\n", name);
    if (file)
        fclose(file);
    return pixels;
}

/* Mask of the significant bits of 0x00RRGGBB from three digits 1..8; 0: invalid digits. */
static uint32_t mask_of(const char *digits)
{
    uint32_t mask = 0;

    if (strlen(digits) != 3 || strspn(digits, "12345678") != 3)
        return 0;
    for (int i = 0; i < 3; i++)
        mask = mask << 8 | (0xff00U >> (digits[i] - '0') & 0xff);
    return mask;
}

/* `from` in the middle of w by h pixels with black around; the caller frees the result.
 * Frees `from`. */
static uint32_t *centre(uint32_t *from, uint32_t *from_w, uint32_t *from_h, uint32_t w,
                        uint32_t h)
{
    bool fits = *from_w <= w && *from_h <= h;
    uint32_t *to = fits ? calloc((size_t)w * h, sizeof *to) : NULL;
    uint32_t left = (w - *from_w) / 2, top = (h - *from_h) / 2;

    if (!to)
        return from;
    for (uint32_t y = 0; y < *from_h; y++)
        memcpy(to + (size_t)(top + y) * w + left, from + (size_t)y * *from_w,
               *from_w * sizeof *to);
    *from_w = w;
    *from_h = h;
    free(from);
    return to;
}

static int compare(char **names, uint32_t *const *pixels, uint32_t w, uint32_t h,
                   uint32_t mask)
{
    uint32_t differ = 0, first = 0;

    for (uint32_t i = w * h; i-- > 0; )
        if ((pixels[0][i] ^ pixels[1][i]) & mask) {
            differ++;
            first = i;
        }
    printf("%s against %s: %u of %u pixels differ\n", names[0], names[1], differ, w * h);
    if (differ)
        printf("first at %u, %u: %06x against %06x\n", first % w, first / w,
               pixels[0][first] & 0xffffff, pixels[1][first] & 0xffffff);
    return differ > 0;
}

int main(int argc, char **argv)
{
    uint32_t w[2], h[2], *pixels[2];
    uint32_t mask = mask_of(argc > 3 ? argv[3] : "888");
    int code = 1;

    if (argc < 3 || argc > 5 || !mask || (argc == 5 && strcmp(argv[4], "centred"))) {
        fprintf(stderr, "usage: same_picture A B [565 [centred]]\n");
        return 2;
    }
    for (int i = 0; i < 2; i++) {
        pixels[i] = read_picture(argv[i + 1], &w[i], &h[i]);
        if (!pixels[i])
            return 3;
    }
    if (argc == 5)
        pixels[1] = centre(pixels[1], &w[1], &h[1], w[0], h[0]);
    if (w[0] == w[1] && h[0] == h[1])
        code = compare(argv + 1, pixels, w[0], h[0], mask);
    else
        printf("%ux%u against %ux%u\n", w[0], h[0], w[1], h[1]);
    free(pixels[0]);
    free(pixels[1]);
    return code;
}
