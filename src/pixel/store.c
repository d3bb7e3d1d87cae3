/* SPDX-License-Identifier: MIT */
/* Conversion of final colours to stored pixels: one tight loop per format.
 *
 * Formats of few colours are dithered by Bayer's ordered 8x8 pattern, fixed to the picture.
 * The rank k = 0..63 of a pixel becomes a threshold in the middle of the k-th of 64 equal
 * parts of a level.  Over a tile of one flat colour the mean is then the colour to half a
 * 64th of a level, and both ends of the range stay free of dots.  Source: B. E. Bayer, An
 * optimum method for two-level rendition of continuous-tone pictures, ICC 1973. */
#include "base/base.h"
#include "pixel/rgb565.h"

static const uint8_t bayer[8][8] = {
    {  0, 32,  8, 40,  2, 34, 10, 42 },
    { 48, 16, 56, 24, 50, 18, 58, 26 },
    { 12, 44,  4, 36, 14, 46,  6, 38 },
    { 60, 28, 52, 20, 62, 30, 54, 22 },
    {  3, 35, 11, 43,  1, 33,  9, 41 },
    { 51, 19, 59, 27, 49, 17, 57, 25 },
    { 15, 47,  7, 39, 13, 45,  5, 37 },
    { 63, 31, 55, 23, 61, 29, 53, 21 },
};

/* Luma of BT.601 in 8.8: weights 77, 150, 29 of 256; white is 255 * 256. */
static inline uint32_t luma_q8(uint32_t colour)
{
    return (colour >> 16 & 0xff) * 77 + (colour >> 8 & 0xff) * 150 + (colour & 0xff) * 29;
}

/* Returns the palette index in the colour cube.  A channel c times 257 is 0..65535.  This
 * value times the number of steps of the axis, plus a threshold of 512..65024, has the
 * level in its high half.  c = 255 still reaches the last level because 6 < 512. */
static inline uint32_t dither_to_palette(uint32_t colour, uint32_t rank)
{
    const uint32_t threshold = rank * 1024 + 512;
    const uint32_t r = ((colour >> 16 & 0xff) * (257 * 5) + threshold) >> 16;
    const uint32_t g = ((colour >> 8 & 0xff) * (257 * 6) + threshold) >> 16;
    const uint32_t b = ((colour & 0xff) * (257 * 5) + threshold) >> 16;
    return (r * 7 + g) * 6 + b;
}

void tp_store_xrgb8888(void *row, int x_in_row, int x, int y, const uint32_t *colours,
                       int count)
{
    TP_ASSERT((uintptr_t)row % 4 == 0 && x_in_row >= 0 && count >= 0);
    (void)x;
    (void)y;
    memcpy((uint32_t *)row + x_in_row, colours, (size_t)count * sizeof *colours);
}

#if TP_DSP
TP_ALWAYS_INLINE void put_pair(uint8_t *to, uint32_t pair, int be)
{
    if (be)
        pair = (pair & 0x00ff00ff) << 8 | (pair >> 8 & 0x00ff00ff);
    __builtin_memcpy(to, &pair, sizeof pair);
}
#endif

/* Stores two pixels at a time on cores with packed arithmetic; elsewhere compilers
 * make faster code of the plain loop.  `be`: swap the bytes of each pixel, for
 * big-endian displays. */
TP_ALWAYS_INLINE void store_rgb565(uint8_t *to, const uint32_t *colours, int count,
                                   int be)
{
    int i = 0;
#if TP_DSP
    const tp_rgb565_kept kept = tp_rgb565_load_constants();
    for (; i + 3 < count; i += 4) {
        const uint32_t *c = colours + i;
        put_pair(to + 2 * i, tp_rgb565_pair(&kept, c[0], c[1]), be);
        put_pair(to + 2 * i + 4, tp_rgb565_pair(&kept, c[2], c[3]), be);
    }
#endif
    for (; i < count; i++) {
        const uint32_t pixel = tp_rgb565(colours[i]);
        if (be) {
            to[2 * i] = (uint8_t)(pixel >> 8);
            to[2 * i + 1] = (uint8_t)pixel;
        } else {
            ((uint16_t *)(void *)to)[i] = (uint16_t)pixel;
        }
    }
}

void tp_store_rgb565(void *row, int x_in_row, int x, int y, const uint32_t *colours,
                     int count)
{
    TP_ASSERT((uintptr_t)row % 2 == 0 && x_in_row >= 0 && count >= 0);
    (void)x;
    (void)y;
    store_rgb565((uint8_t *)row + 2 * x_in_row, colours, count, 0);
}

TP_ALWAYS_INLINE uint32_t tone_map_rgb565(const tp_rgb565_tone_map *t, uint32_t c)
{
    return (uint32_t)t->five[c >> 16 & 0xff] << 11 | (uint32_t)t->six[c >> 8 & 0xff] << 5
         | t->five[c & 0xff];
}

void tp_store_rgb565_tone_mapped(const tp_rgb565_tone_map *t, uint16_t *to,
                                 const uint32_t *colours, int count)
{
    TP_ASSERT((uintptr_t)to % 2 == 0);
    int i = 0;

#if TP_DSP
    for (; i + 3 < count; i += 4) {
        const uint32_t *c = colours + i;
        put_pair((uint8_t *)(to + i),
                 tone_map_rgb565(t, c[0]) | tone_map_rgb565(t, c[1]) << 16, 0);
        put_pair((uint8_t *)(to + i + 2),
                 tone_map_rgb565(t, c[2]) | tone_map_rgb565(t, c[3]) << 16, 0);
    }
#endif
    for (; i < count; i++)
        to[i] = (uint16_t)tone_map_rgb565(t, colours[i]);
}

void tp_store_rgb565be(void *row, int x_in_row, int x, int y, const uint32_t *colours,
                       int count)
{
    (void)x;
    (void)y;
    store_rgb565((uint8_t *)row + 2 * x_in_row, colours, count, 1);
}

void tp_store_p8(void *row, int x_in_row, int x, int y, const uint32_t *colours,
                 int count)
{
    const uint8_t *ranks = bayer[y & 7];
    uint8_t *to = (uint8_t *)row + x_in_row;

    for (int i = 0; i < count; i++)
        to[i] = (uint8_t)dither_to_palette(colours[i], ranks[(x + i) & 7]);
}

/* Dithers the fraction of the luma: 255 * 256 + 4 * 63 + 2 stays below 2^16. */
void tp_store_l8(void *row, int x_in_row, int x, int y, const uint32_t *colours,
                 int count)
{
    const uint8_t *ranks = bayer[y & 7];
    uint8_t *to = (uint8_t *)row + x_in_row;

    for (int i = 0; i < count; i++)
        to[i] = (uint8_t)((luma_q8(colours[i]) + ranks[(x + i) & 7] * 4u + 2) >> 8);
}

/* Returns 1 if the luma, 0..64 * 1020, is above the threshold 510, 1530, ... 64770. */
static inline uint32_t is_dithered_white(uint32_t colour, uint32_t rank)
{
    return (rank * 1020 + 510 - luma_q8(colour)) >> 31;
}

/* Stores whole bytes where possible.  The first and the last byte may also hold pixels of
 * other tiles, which keep their bits. */
void tp_store_i1(void *row, int x_in_row, int x, int y, const uint32_t *colours,
                 int count)
{
    TP_ASSERT(x_in_row >= 0 && count >= 0);
    const uint8_t *ranks = bayer[y & 7];

    while (count > 0) {
        const int skip = x_in_row & 7, room = 8 - skip;
        const int n = count < room ? count : room;
        uint32_t bits = 0;
        for (int i = 0; i < n; i++)
            bits = bits << 1 | is_dithered_white(colours[i], ranks[(x + i) & 7]);
        const uint32_t mask = (0xffu >> skip) & ~(0xffu >> (skip + n));
        uint8_t *const byte = (uint8_t *)row + (x_in_row >> 3);
        *byte = (uint8_t)((*byte & ~mask) | bits << (room - n));
        x_in_row += n;
        x += n;
        colours += n;
        count -= n;
    }
}
