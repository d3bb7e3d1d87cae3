/* SPDX-License-Identifier: MIT */
/* Names and sizes of the pixel formats, the palette, conversion of stored pixels back to
 * colours, and checksums of bytes and of the colours of a row. */
#include "base/base.h"
#include "base/error.h"
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

/* Repeats the high bits of each channel in its low bits: full intensity stays full. */
static uint32_t expand_rgb565(uint32_t pixel)
{
    const uint32_t r = pixel >> 11, g = pixel >> 5 & 63, b = pixel & 31;
    return (r << 3 | r >> 2) << 16 | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2);
}

uint32_t tp_pixel_read(tp_format format, const void *row, int x)
{
    TP_ASSERT(row != NULL && x >= 0);
    const uint8_t *const bytes = row;
    switch (format) {
    case TP_FORMAT_XRGB8888:
        return ((const uint32_t *)row)[x] & 0xffffff;
    case TP_FORMAT_RGB565:
        return expand_rgb565(((const uint16_t *)row)[x]);
    case TP_FORMAT_RGB565BE:
        return expand_rgb565((uint32_t)bytes[2 * x] << 8 | bytes[2 * x + 1]);
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
