/* SPDX-License-Identifier: MIT */
/*
 * Stored pixels: names of formats, conversion back to colours, checksums; conversion of
 * colours to RGB565, and the same after tone mapping, by a table.  A colour inside the
 * core is 0x00RRGGBB in a uint32_t; the channels are sRGB values.
 */
#ifndef TP_PIXEL_PIXEL_H
#define TP_PIXEL_PIXEL_H
#include "base/dsp.h"
#include "tidepool/frame.h"
#include "tidepool/modules.h"

const char *tp_format_name(tp_format format);           /* e.g. "xrgb8888" */
int         tp_format_bits(tp_format format);
int         tp_format_find(const char *name, uint32_t bytes);   /* -1: no such name */

/* Returns pixel x of a row as 0x00RRGGBB.  565 is expanded by bit replication; a grey fills
 * all three channels. */
uint32_t tp_pixel_read(tp_format format, const void *row, int x);

/* CRC-32 (IEEE) of `bytes`, continued from `crc` (0 to begin). */
uint32_t tp_crc32(uint32_t crc, const void *data, size_t bytes);

/* -- conversion ---------------------------------------------------------------------- */

/* Conversion of colours to RGB565: the nearest level of each channel.
 *
 * (31 c + 127)/255 = (249 c + 1014) >> 11 and (63 c + 127)/255 = (253 c + 505) >> 10 for
 * all c = 0..255.  Both sums are below 2^16: one multiply converts both halves of a word,
 * either red and blue of one colour or the same channel of two colours. */

#define TP_RB_SCALE 249u
#define TP_RB_HALF  (1014u << 16 | 1014u)
#define TP_G_SCALE  253u
#define TP_G_HALF   505u

TP_ALWAYS_INLINE uint32_t tp_rgb565(uint32_t colour)
{
    const uint32_t red_blue = (colour & 0xff00ff) * TP_RB_SCALE + TP_RB_HALF;
    const uint32_t green = (colour >> 8 & 0xff) * TP_G_SCALE + TP_G_HALF;
    return (red_blue >> 16 & 0xf800) | (green >> 5 & 0x7e0) | (red_blue >> 11 & 0x1f);
}

/* Returns a pixel as 0x00RRGGBB.  Repeats the high bits of each channel in its low bits: full
 * intensity stays full. */
TP_ALWAYS_INLINE uint32_t tp_rgb565_expand(uint32_t pixel)
{
    const uint32_t r = pixel >> 11, g = pixel >> 5 & 63, b = pixel & 31;
    return (r << 3 | r >> 2) << 16 | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2);
}

/* Constants of tp_rgb565_pack_pair, kept in registers during a loop. */
typedef struct {
    uint32_t rb_scale, rb_half, g_scale, g_half, red, green, blue;
} tp_rgb565_kept;

TP_ALWAYS_INLINE tp_rgb565_kept tp_rgb565_load_constants(void)
{
    return (tp_rgb565_kept){
        tp_keep_in_register(TP_RB_SCALE),
        tp_keep_in_register(TP_RB_HALF),
        tp_keep_in_register(TP_G_SCALE),
        tp_keep_in_register(TP_G_HALF << 16 | TP_G_HALF),
        0xf800f800,
        tp_keep_in_register(0x07e007e0),
        tp_keep_in_register(0x001f001f),
    };
}

/* Returns two pixels in a word; the first colour takes the low half. */
TP_ALWAYS_INLINE uint32_t tp_rgb565_pack_pair(const tp_rgb565_kept *constants,
                                              uint32_t first, uint32_t second)
{
    const uint32_t a = tp_even_bytes(first) * constants->rb_scale + constants->rb_half;
    const uint32_t b = tp_even_bytes(second) * constants->rb_scale + constants->rb_half;
    const uint32_t green = tp_pack_low_halves(tp_odd_bytes(first), tp_odd_bytes(second))
                         * constants->g_scale + constants->g_half;

    return (tp_pack_high_halves(a, b) & constants->red) | (green >> 5 & constants->green)
           | (tp_pack_low_halves(a, b) >> 11 & constants->blue);
}

/* -- tone mapping -------------------------------------------------------------------- */

/* RGB565 with tone mapping by a table: each entry holds the RGB565 level of a channel after
 * the camera's exposure.  One look-up per channel gives the same pixels as tone mapping
 * followed by conversion. */

typedef struct {
    tp_entry8 five[256], six[256];      /* five: levels of red and blue;
                                         * six: levels of green */
} tp_rgb565_tone_map;

/* Sets entry i to the RGB565 levels of the tone-mapped channel value `tone`. */
static inline void tp_rgb565_tone_map_set(tp_rgb565_tone_map *tone_map, uint32_t i,
                                          uint32_t tone)
{
    const uint32_t pixel = tp_rgb565(tone << 16 | tone << 8 | tone);

    tone_map->five[i] = (uint8_t)(pixel & 31);
    tone_map->six[i] = (uint8_t)(pixel >> 5 & 63);
}

/* Stores pixels from the address `to` on; rgb565 pixels at an even address. */
typedef void tp_tone_mapped_store(const tp_rgb565_tone_map *tone_map, void *to,
                                  const uint32_t *colours, int count);
tp_tone_mapped_store tp_store_rgb565_tone_mapped, tp_store_rgb565be_tone_mapped;

#endif
