/* SPDX-License-Identifier: MIT */
/* Converts rows of pictures to rows in a described pixel layout.  The two most common
 * layouts, 8 bits per channel in a 32-bit word and 565, are copies; all others are
 * converted per channel. */
#include "pixel_layout.h"
#include <string.h>
#include "pixel/pixel.h"

static uint32_t channel_mask(pixel_channel c)
{
    return c.length ? (uint32_t)((((uint64_t)1 << c.length) - 1) << c.offset) : 0;
}

static bool fits(const pixel_layout *l, pixel_channel c)
{
    return c.length <= 16 && c.offset + c.length <= l->bits;
}

static bool overlap(const pixel_layout *l)
{
    const uint32_t of[] = { channel_mask(l->red), channel_mask(l->green),
                            channel_mask(l->blue), channel_mask(l->spare) };
    uint32_t seen = 0;
    for (int i = 0; i < 4; i++) {
        if (seen & of[i])
            return true;
        seen |= of[i];
    }
    return false;
}

bool pixel_layout_is_supported(const pixel_layout *l)
{
    if (l->bits != 8 && l->bits != 16 && l->bits != 24 && l->bits != 32)
        return false;
    if (l->indexed || l->grey)
        return l->bits == 8;
    return l->red.length && l->green.length && l->blue.length && fits(l, l->red)
        && fits(l, l->green) && fits(l, l->blue)
        && l->spare.offset + l->spare.length <= l->bits && !overlap(l);
}

static bool same(pixel_channel c, int offset, int length)
{
    return c.offset == offset && c.length == length;
}

static bool is_565(const pixel_layout *l)
{
    return l->bits == 16 && same(l->red, 11, 5) && same(l->green, 5, 6)
        && same(l->blue, 0, 5);
}

tp_format pixel_layout_format(const pixel_layout *l)
{
    if (l->grey)
        return TP_FORMAT_L8;
    if (l->indexed)
        return TP_FORMAT_P8;
    return is_565(l) ? TP_FORMAT_RGB565 : TP_FORMAT_XRGB8888;
}

bool pixel_layout_accepts(const pixel_layout *l, tp_format format)
{
    if (l->grey)
        return format == TP_FORMAT_L8 || format == TP_FORMAT_I1;
    return !l->indexed || format == TP_FORMAT_P8 || format == TP_FORMAT_L8
        || format == TP_FORMAT_I1;
}

uint32_t pixel_layout_colour(tp_format format, uint32_t i)
{
    return format == TP_FORMAT_P8 ? tp_palette[i] : i * 0x010101u;
}

void pixel_layout_table(tp_format format, uint16_t *red, uint16_t *green, uint16_t *blue)
{
    for (uint32_t i = 0; i < 256; i++) {
        const uint32_t rgb = pixel_layout_colour(format, i);
        red[i] = (uint16_t)((rgb >> 16 & 255) * 257);
        green[i] = (uint16_t)((rgb >> 8 & 255) * 257);
        blue[i] = (uint16_t)((rgb & 255) * 257);
    }
}

/* Scales 8 bits to the channel's length and shifts them to its offset. */
static uint32_t put(pixel_channel c, uint32_t value)
{
    const uint32_t wide = value << 8 | value;
    return wide >> (16 - c.length) << c.offset;
}

static uint32_t pack(const pixel_layout *l, uint32_t rgb)
{
    return put(l->red, rgb >> 16 & 255) | put(l->green, rgb >> 8 & 255)
           | put(l->blue, rgb & 255) | channel_mask(l->spare);
}

static void store(const pixel_layout *l, uint8_t *to, uint32_t pixel)
{
    const uint32_t bytes = l->bits / 8;
    for (uint32_t i = 0; i < bytes; i++)
        to[l->big ? bytes - 1 - i : i] = (uint8_t)(pixel >> 8 * i);
}

bool machine_is_big(void)
{
    const uint16_t one = 1;
    uint8_t first;
    memcpy(&first, &one, 1);
    return first == 0;
}

static bool is_words(const pixel_layout *l, tp_format format)
{
    return format == TP_FORMAT_XRGB8888 && l->bits == 32 && l->big == machine_is_big()
        && same(l->red, 16, 8) && same(l->green, 8, 8) && same(l->blue, 0, 8);
}

static bool is_copy(const pixel_layout *l, tp_format format)
{
    if (l->indexed || l->grey)
        return format != TP_FORMAT_I1;
    return format == TP_FORMAT_RGB565 && is_565(l) && l->big == machine_is_big();
}

static void copy_words(void *to, const uint8_t *row, uint32_t width, uint32_t spare)
{
    uint8_t *at = to;
    for (uint32_t x = 0; x < width; x++, at += 4, row += 4) {
        uint32_t pixel;
        memcpy(&pixel, row, 4);
        pixel |= spare;
        memcpy(at, &pixel, 4);
    }
}

void pixel_layout_row(const pixel_layout *l, void *to, const picture *p, uint32_t y)
{
    const uint8_t *row = picture_row(p, y);
    const uint32_t bytes = l->bits / 8;
    uint8_t *at = to;
    if (is_copy(l, p->format)) {
        memcpy(to, row, p->width * bytes);
        return;
    }
    if (is_words(l, p->format)) {
        copy_words(to, row, p->width, channel_mask(l->spare));
        return;
    }
    for (uint32_t x = 0; x < p->width; x++, at += bytes) {
        const uint32_t rgb = tp_pixel_read(p->format, row, (int)x);
        store(l, at, l->indexed || l->grey ? rgb & 255 : pack(l, rgb));
    }
}
