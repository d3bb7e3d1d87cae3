/* SPDX-License-Identifier: MIT */
/*
 * Stored pixels: names and sizes of the formats, the palette, conversion of stored pixels
 * back to colours, checksums of bytes and of the colours of a row, and the conversion of
 * final colours to stored pixels.
 */
#include "base/base.h"
#include "pixel/pixel.h"

/* -- formats ------------------------------------------------------------------------- */

static const struct { const char *name; int bits; } formats[TP_FORMAT_COUNT] = {
#define X(format, name, bits, text) [TP_FORMAT_##format] = { #name, bits },
    TP_FORMAT_LIST(X)
#undef X
};

/* The palette is a colour cube of 6 x 7 x 6 levels, spread evenly: i 255/5 or i 255/6,
 * rounded.  The only greys of the cube are black and white; the four entries left over are
 * greys at even steps between black and white. */
#define LEVEL_5(i)  ((uint32_t)(i) * 51u)
#define LEVEL_6(i)  (((uint32_t)(i) * 85u + 1u) / 2u)
#define CELL(r, g, b) LEVEL_5(r) << 16 | LEVEL_6(g) << 8 | LEVEL_5(b)
#define BLUES(r, g) CELL(r, g, 0), CELL(r, g, 1), CELL(r, g, 2), \
                    CELL(r, g, 3), CELL(r, g, 4), CELL(r, g, 5)
#define GREENS(r)   BLUES(r, 0), BLUES(r, 1), BLUES(r, 2), BLUES(r, 3), \
                    BLUES(r, 4), BLUES(r, 5), BLUES(r, 6)

const uint32_t tp_palette[256] = {
    GREENS(0), GREENS(1), GREENS(2), GREENS(3), GREENS(4), GREENS(5),
    0x333333, 0x666666, 0x999999, 0xcccccc,
};

const char *tp_format_name(tp_format format)
{
    return (unsigned)format < TP_FORMAT_COUNT ? formats[format].name : "";
}

int tp_format_bits(tp_format format)
{
    return (unsigned)format < TP_FORMAT_COUNT ? formats[format].bits : 0;
}

int tp_format_find(const char *name, uint32_t bytes)
{
    TP_ASSERT(name != NULL || bytes == 0);
    for (int i = 0; i < TP_FORMAT_COUNT; i++)
        if (tp_string_length(formats[i].name) == bytes
            && memcmp(formats[i].name, name, bytes) == 0)
            return i;
    return -1;
}

size_t tp_format_row_bytes(tp_format format, int width)
{
    return width <= 0 ? 0 : ((size_t)width * (size_t)tp_format_bits(format) + 7) / 8;
}

uint32_t tp_pixel_read(tp_format format, const void *row, int x)
{
    TP_ASSERT(row != NULL && x >= 0);
    const uint8_t *const bytes = row;
    switch (format) {
    case TP_FORMAT_XRGB8888:
        return ((const uint32_t *)row)[x] & 0xffffff;
    case TP_FORMAT_RGB565:
        return tp_rgb565_expand(((const uint16_t *)row)[x]);
    case TP_FORMAT_RGB565BE:
        return tp_rgb565_expand((uint32_t)bytes[2 * x] << 8 | bytes[2 * x + 1]);
    case TP_FORMAT_P8:
        return tp_palette[bytes[x]];
    case TP_FORMAT_L8:
        return bytes[x] * 0x010101u;
    case TP_FORMAT_I1:
        return bytes[x >> 3] & 0x80 >> (x & 7) ? 0xffffff : 0;
    case TP_FORMAT_COUNT:
        break;
    }
    return 0;
}

/* -- checksums ----------------------------------------------------------------------- */

/* CRC-32 (IEEE 802.3), one byte at a time, by a table. */

static const uint32_t of_byte[256] = {
#include "pixel/crc32_table.inc"
};

static inline uint32_t crc_add_byte(uint32_t crc, uint32_t byte)
{
    return crc >> 8 ^ of_byte[(crc ^ byte) & 0xff];
}

uint32_t tp_crc32(uint32_t crc, const void *data, size_t bytes)
{
    TP_ASSERT(data != NULL || bytes == 0);
    const uint8_t *at = data;
    crc = ~crc;
    for (; bytes > 0; bytes--)
        crc = crc_add_byte(crc, *at++);
    return ~crc;
}

uint32_t tp_crc32_pixels(uint32_t crc, tp_format format, const void *row, int count)
{
    TP_ASSERT((unsigned)format < TP_FORMAT_COUNT && (row != NULL || count == 0));
    crc = ~crc;
    for (int x = 0; x < count; x++) {
        const uint32_t colour = tp_pixel_read(format, row, x);
        crc = crc_add_byte(crc, colour);
        crc = crc_add_byte(crc, colour >> 8);
        crc = crc_add_byte(crc, colour >> 16);
        crc = crc_add_byte(crc, 0);
    }
    return ~crc;
}

/* -- stores -------------------------------------------------------------------------- */

/* One tight loop per format.
 *
 * Formats of few colours are dithered by Bayer's ordered 8x8 pattern, fixed to the picture.
 * The rank k = 0..63 of a pixel becomes a threshold in the middle of the k-th of 64 equal
 * parts of a level.  Over a tile of one flat colour the mean is then the colour to half a
 * 64th of a level, and both ends of the range stay free of dots.  Source: B. E. Bayer, An
 * optimum method for two-level rendition of continuous-tone pictures, ICC 1973. */

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
        pair = tp_swap_bytes_of_halves(pair);
    __builtin_memcpy(to, &pair, sizeof pair);
}
#endif

TP_ALWAYS_INLINE void put_pixel(uint8_t *to, uint32_t pixel, int be)
{
    if (be) {
        to[0] = (uint8_t)(pixel >> 8);
        to[1] = (uint8_t)pixel;
    } else {
        *(uint16_t *)(void *)to = (uint16_t)pixel;
    }
}

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
        put_pair(to + 2 * i, tp_rgb565_pack_pair(&kept, c[0], c[1]), be);
        put_pair(to + 2 * i + 4, tp_rgb565_pack_pair(&kept, c[2], c[3]), be);
    }
#endif
    for (; i < count; i++)
        put_pixel(to + 2 * i, tp_rgb565(colours[i]), be);
}

void tp_store_rgb565(void *row, int x_in_row, int x, int y, const uint32_t *colours,
                     int count)
{
    TP_ASSERT((uintptr_t)row % 2 == 0 && x_in_row >= 0 && count >= 0);
    (void)x;
    (void)y;
    store_rgb565((uint8_t *)row + 2 * x_in_row, colours, count, 0);
}

TP_ALWAYS_INLINE uint32_t tone_map_rgb565(const tp_entry8 *restrict five,
                                          const tp_entry8 *restrict six, uint32_t c)
{
    return ((uint32_t)five[c >> 16 & 0xff] << 6 | (uint32_t)six[c >> 8 & 0xff]) << 5
         | (uint32_t)five[c & 0xff];
}

/* Each table has a register of its own, or compilers would add twice for an address. */
TP_ALWAYS_INLINE void store_tone_mapped(const tp_entry8 *restrict five,
                                        const tp_entry8 *restrict six, uint8_t *restrict to,
                                        const uint32_t *restrict colours, int count, int be)
{
    int i = 0;

#if TP_DSP
    six = tp_keep_pointer(six);
    for (; i + 3 < count; i += 4) {
        const uint32_t *c = colours + i;
        put_pair(to + 2 * i, tone_map_rgb565(five, six, c[0])
                             | tone_map_rgb565(five, six, c[1]) << 16, be);
        put_pair(to + 2 * i + 4, tone_map_rgb565(five, six, c[2])
                                 | tone_map_rgb565(five, six, c[3]) << 16, be);
    }
#endif
    for (; i < count; i++)
        put_pixel(to + 2 * i, tone_map_rgb565(five, six, colours[i]), be);
}

void tp_store_rgb565_tone_mapped(const tp_rgb565_tone_map *restrict t, void *restrict to,
                                 const uint32_t *colours, int count)
{
    TP_ASSERT((uintptr_t)to % 2 == 0);
    store_tone_mapped(t->five, t->six, to, colours, count, 0);
}

void tp_store_rgb565be_tone_mapped(const tp_rgb565_tone_map *restrict t, void *restrict to,
                                   const uint32_t *colours, int count)
{
    store_tone_mapped(t->five, t->six, to, colours, count, 1);
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
