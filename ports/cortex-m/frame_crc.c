/* SPDX-License-Identifier: MIT */
/* CRC of a picture with rows in pieces.  A CRC is a remainder of polynomials over GF(2):
 * crc(A B) is crc(A) x^(8 bytes of B) + crc(B).  Each piece of a row therefore counts
 * separately, times a power of x for the pixels after it. */
#include "frame_crc.h"
#include "pixel/pixel.h"

#define ONE   0x80000000u       /* x^0: bits are in reversed order */
#define BYTE  0x00800000u       /* x^8 */
#define POLYNOMIAL 0xedb88320u

enum { PIXEL_BYTES = 4 };       /* bytes per pixel in tp_crc32_pixels */

static uint32_t times(uint32_t a, uint32_t b)
{
    uint32_t product = 0;

    for (; a; a <<= 1) {
        product ^= a & ONE ? b : 0;
        b = b >> 1 ^ (b & 1 ? POLYNOMIAL : 0);
    }
    return product;
}

static uint32_t power(uint32_t base, uint32_t n)
{
    uint32_t result = ONE;

    for (; n; n >>= 1, base = times(base, base)) {
        if (n & 1)
            result = times(result, base);
    }
    return result;
}

uint32_t frame_crc_add_tile(uint32_t sum, const tp_config *config, const tp_tile *tile)
{
    const uint8_t *row = tile->pixels;

    for (uint32_t y = tile->y0; y < tile->y1; y++, row += tile->stride) {
        const uint32_t after = (config->height - y) * config->width - tile->x1;
        const uint32_t crc = tp_crc32_pixels(0, config->format, row,
                                             (int)(tile->x1 - tile->x0));
        sum ^= times(power(BYTE, PIXEL_BYTES * after), crc);
    }
    return sum;
}
