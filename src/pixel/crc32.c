/* SPDX-License-Identifier: MIT */
/* CRC-32 (IEEE 802.3), one byte at a time, by a table. */
#include "base/assert.h"
#include "pixel/pixel.h"

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
